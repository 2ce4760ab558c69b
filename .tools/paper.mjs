// `npm run paper`: computes the figures of the Paper page in Node and writes their numbers to
// build/paper.md.
//
//   npm run paper [-- --figure ID] [--detail PART]     one figure; meshes of a part of the triangles
import { mkdirSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { runnerImport } from 'vite';
import { buildFacade, buildWasm } from './build.mjs';
import { setUp } from './setup.mjs';
import { inRoot } from './shell.mjs';

const known = {
  figure: { type: 'string' },
  detail: { type: 'string', default: '1' },
  built: { type: 'boolean' },
};
let options;
try {
  options = parseArgs({ options: known }).values;
} catch (error) {
  console.error(
    `${error.message}\nUsage: npm run paper [-- --figure ID] [--detail PART] [--built]`,
  );
  process.exit(1);
}

const load = async (path) => {
  const config = { configFile: inRoot('vite.config.ts'), logLevel: 'error' };
  return (await runnerImport(inRoot(`web/paper/${path}`), config)).module;
};

if (!options.built) {
  await setUp('build');
  await buildWasm();
  await buildFacade();
}
const { figures, smallFigures } = await load('figures/index.ts');
const { report } = await load('report.ts');
const detail = Number(options.detail);
const all = detail < 1 ? smallFigures(detail, 33) : figures;
const chosen = all.filter(({ id }) => options.figure === undefined || options.figure === id);
if (chosen.length === 0) {
  console.error(`There is no figure '${options.figure}': ${all.map(({ id }) => id).join(', ')}.`);
  process.exit(1);
}
const text = await report(chosen, (what) => console.error(what));
mkdirSync(inRoot('build'), { recursive: true });
writeFileSync(inRoot('build/paper.md'), text);
console.log('Written to build/paper.md.');
