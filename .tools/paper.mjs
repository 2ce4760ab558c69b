// `npm run paper`: computes the figures of the Paper page in Node and writes their numbers to
// build/paper.md.
//
//   npm run paper -- [--figure ID] [--detail PART] [--table TRIANGLES] [--samples N] [--built]
//
// One figure only (or none); meshes of a part of the triangles; Table 1 too, up to so many triangles
// and with so many samples a segment; what is in dist/ as it is.
import { mkdirSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { runnerImport } from 'vite';
import { buildFacade, buildWasm } from './build.mjs';
import { setUp } from './setup.mjs';
import { inRoot } from './shell.mjs';

const usage =
  'Usage: npm run paper -- [--figure ID|none] [--detail PART] [--table TRIANGLES] [--samples N] [--built]';
const budgetMs = 120_000;

const known = {
  figure: { type: 'string' },
  detail: { type: 'string', default: '1' },
  table: { type: 'string', default: '0' },
  samples: { type: 'string', default: '4096' },
  built: { type: 'boolean' },
};

const load = async (path) => {
  const config = { configFile: inRoot('vite.config.ts'), logLevel: 'error' };
  return (await runnerImport(inRoot(`web/paper/${path}`), config)).module;
};
const tell = (what) => console.error(what);

async function figuresPart({ figure, detail }) {
  const { figures, smallFigures } = await load('figures/index.ts');
  const { report } = await load('report.ts');
  const all = Number(detail) < 1 ? smallFigures(Number(detail), 33) : figures;
  if (figure === 'none') return '';
  const chosen = all.filter(({ id }) => figure === undefined || figure === id);
  if (chosen.length > 0) return report(chosen, tell);
  throw new Error(`There is no figure '${figure}': ${all.map(({ id }) => id).join(', ')}.`);
}

async function tablePart({ table, samples }) {
  const { expectedTriangles, tableRows } = await load('table/rows.ts');
  const { tableReport } = await load('report.ts');
  const rows = tableRows.filter(({ mesh }) => expectedTriangles(mesh) <= Number(table));
  return rows.length > 0 ? tableReport({ rows, samples: Number(samples), budgetMs }, tell) : '';
}

try {
  const options = parseArgs({ options: known }).values;
  if (!options.built) {
    await setUp('build');
    await buildWasm();
    await buildFacade();
  }
  const parts = [await figuresPart(options), await tablePart(options)].filter(Boolean);
  mkdirSync(inRoot('build'), { recursive: true });
  writeFileSync(inRoot('build/paper.md'), parts.join('\n'));
  console.log('Written to build/paper.md.');
} catch (error) {
  const wrongArguments = error.code?.startsWith('ERR_PARSE_ARGS');
  console.error(wrongArguments ? `${error.message}\n${usage}` : error.message);
  process.exit(1);
}
