// `npm run paper`: computes the figures of the Paper page in Node and writes their numbers to
// build/paper.md.
//
//   npm run paper -- [--figure ID] [--detail PART] [--table TRIANGLES] [--samples N] [--built]
//
// One figure only (or none); meshes of a part of the triangles; Table 1 too, up to so many triangles
// and with so many samples a segment; what is in dist/ as it is. Where there is nothing to write, the
// last report stays.
import { mkdirSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
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
  const { runnerImport } = await import('vite');
  const config = { configFile: inRoot('vite.config.ts'), logLevel: 'error' };
  return (await runnerImport(inRoot(`web/paper/${path}`), config)).module;
};

/** An option's number. Throws an error that says what it should be. */
function numberOf(options, name, fits, what) {
  const value = Number(options[name].trim() || Number.NaN);
  if (fits(value)) return value;
  throw new Error(`--${name} is to be ${what}, not '${options[name]}'.\n${usage}`);
}

/** The command line's options, checked before anything is built. */
function readOptions() {
  const options = parseArgs({ options: known }).values;
  const count = (least) => (value) => Number.isInteger(value) && value >= least;
  return {
    ...options,
    detail: numberOf(options, 'detail', (value) => value > 0 && value <= 1, 'over 0 and up to 1'),
    table: numberOf(options, 'table', count(0), 'a number of triangles'),
    samples: numberOf(options, 'samples', count(2), 'a number of samples from 2 on'),
  };
}

const tell = (what) => console.error(what);

async function figuresPart({ figure, detail }) {
  const { figures, smallFigures } = await load('figures/index.ts');
  const { report } = await load('report.ts');
  const all = detail < 1 ? smallFigures(detail, 33) : figures;
  if (figure === 'none') return '';
  const chosen = all.filter(({ id }) => figure === undefined || figure === id);
  if (chosen.length > 0) return report(chosen, tell);
  throw new Error(`There is no figure '${figure}': ${all.map(({ id }) => id).join(', ')}.`);
}

async function tablePart({ table, samples }) {
  const { expectedTriangles, tableRows } = await load('table/rows.ts');
  const { tableReport } = await load('report.ts');
  const rows = tableRows.filter(({ mesh }) => expectedTriangles(mesh) <= table);
  return rows.length > 0 ? tableReport({ rows, samples, budgetMs }, tell) : '';
}

try {
  const options = readOptions();
  await setUp('build');
  if (!options.built) {
    await buildWasm();
    await buildFacade();
  }
  const parts = [await figuresPart(options), await tablePart(options)].filter(Boolean);
  if (parts.length === 0) {
    throw new Error('There is nothing to write: no figure, and no row of Table 1 so small.');
  }
  mkdirSync(inRoot('build'), { recursive: true });
  writeFileSync(inRoot('build/paper.md'), parts.join('\n'));
  console.log('Written to build/paper.md.');
} catch (error) {
  const wrongArguments = error.code?.startsWith('ERR_PARSE_ARGS');
  console.error(wrongArguments ? `${error.message}\n${usage}` : error.message);
  process.exit(1);
}
