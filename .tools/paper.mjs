// `npm run paper`: computes the figures of the Paper page and Table 1 in Node, and judges the paper's claims
// by these numbers. It writes everything to build/paper.md, and the verdicts with their date and machine also
// to build/paper.json.
//
//   npm run paper -- [--figure ID|none] [--detail PART] [--table TRIANGLES] [--samples N]
//                    [--meshes FOLDER] [--points FOLDER] [--plots] [--study NAME] [--judge] [--save] [--built]
//
// --figure ID     computes only one figure (or none), and then no claims
// --detail PART   uses meshes with this fraction of the triangles
// --table N       computes Table 1 on up to N triangles (20,000)
// --samples N     takes N samples for each segment in Table 1
// --meshes FOLDER runs every method on each OBJ file of the folder, for the claims about meshes that the
//                 project does not have; the folder of --points has the control points of these meshes
// --plots         computes only the page's plots, and keeps the verdicts of the last report
// --study NAME    computes only one study of the claims (meant for those without times), and keeps the other
//                 numbers of the last report; rows that depend on the study then state its day
// --judge         computes only the verdicts, from the numbers of the last report (after a change of rules or words)
// --save          saves the verdicts in docs/paper-report.json, from which the page shows them
// --built         uses dist/ without a build
// If nothing is to be written, the last report stays.
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus, loadavg } from 'node:os';
import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildFacade, buildWasm } from './build.mjs';
import { aboutReport, jsonOf, kept, keptJson, measuredOf } from './paper_report.mjs';
import { setUp } from './setup.mjs';
import { inRoot } from './shell.mjs';
import { sourcesDigest } from './sources.mjs';

const usage =
  'Usage: npm run paper -- [--figure ID|none] [--detail PART] [--table TRIANGLES] [--samples N] [--meshes FOLDER] [--points FOLDER] [--plots] [--study NAME] [--judge] [--save] [--built]';
const budgetMs = 120_000;

const known = {
  figure: { type: 'string' },
  detail: { type: 'string', default: '1' },
  table: { type: 'string' },
  samples: { type: 'string', default: '4096' },
  meshes: { type: 'string' },
  points: { type: 'string' },
  plots: { type: 'boolean' },
  study: { type: 'string' },
  judge: { type: 'boolean' },
  save: { type: 'boolean' },
  built: { type: 'boolean' },
};

const load = async (path) => {
  const { runnerImport } = await import('vite');
  const config = { configFile: inRoot('vite.config.ts'), logLevel: 'error' };
  return (await runnerImport(inRoot(`web/paper/${path}`), config)).module;
};

/** The number of an option. Throws an error that describes the permitted ones. */
function numberOf(options, name, fits, what) {
  const value = Number(options[name].trim() || Number.NaN);
  if (fits(value)) return value;
  throw new Error(`--${name} must be ${what}, not '${options[name]}'.\n${usage}`);
}

/** The command line's options, checked before any build. */
function readOptions() {
  const options = parseArgs({ options: known }).values;
  // A single figure should be ready soon.
  options.table ??= options.figure === undefined ? '20000' : '0';
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
  if (figure === 'none') return { text: '', panels: {} };
  const chosen = all.filter(({ id }) => figure === undefined || figure === id);
  if (chosen.length > 0) return report(chosen, tell);
  throw new Error(`There is no figure '${figure}': ${all.map(({ id }) => id).join(', ')}.`);
}

async function tablePart({ table, samples }) {
  const { expectedTriangles, tableRows } = await load('table/rows.ts');
  const { tableReport } = await load('report.ts');
  const rows = tableRows.filter(({ mesh }) => expectedTriangles(mesh) <= table);
  if (rows.length === 0) return { text: '', cells: [] };
  return tableReport({ rows, samples, budgetMs }, tell);
}

/** The meshes of the folder; null without one. */
async function meshesPart({ meshes, points }, seed) {
  if (meshes === undefined) return { text: '', found: null };
  const names = readdirSync(meshes).filter((name) => name.endsWith('.obj'));
  if (names.length === 0) throw new Error(`There is no OBJ file in ${meshes}.`);
  const { judgeMesh } = await load('claims/meshes.ts');
  const { parsePoints } = await load('../../dist/cli/syntax.js');
  const pointsOf = (name) => {
    const path = points && join(points, `${basename(name, '.obj')}.txt`);
    return path && existsSync(path) ? parsePoints(readFileSync(path, 'utf8'), path) : undefined;
  };
  const { meshesReport } = await load('report.ts');
  const { loadPeers } = await load('../../dist/peers/index.js');
  const peers = await loadPeers();
  const found = [];
  for (const name of names.toSorted()) {
    const bytes = readFileSync(join(meshes, name));
    const options = { seed, budgetMs, points: pointsOf(name) };
    found.push(await judgeMesh(peers, name, bytes, options, tell));
  }
  return { text: meshesReport(found), found };
}

/**
 * The largest load of the machine so far: the mean number of threads that wanted to run over a
 * minute, including this program's own.
 */
let mostLoad = 0;
const lookAtLoad = () => {
  mostLoad = Math.max(mostLoad, loadavg()[0]);
  return { most: Number(mostLoad.toFixed(1)), cores: cpus().length };
};

const tellBusy = (what) => {
  lookAtLoad();
  tell(what);
};

/** The digest is computed at the start, since the sources may change during the measurements. */
const sources = sourcesDigest();

const about = (seed) => aboutReport({ seed, sources, load: lookAtLoad().most });

/** The parts of the report that the page plots. */
async function plotsOnly() {
  const { studySeed } = await load('claims/seed.ts');
  const { convergence } = await load('claims/convergence.ts');
  const { roughness } = await load('claims/roughness.ts');
  const { loadPeers } = await load('../../dist/peers/index.js');
  const peers = await loadPeers();
  const told = (what) => (points) => tell(`${what}: ${points.length}`);
  return {
    ...about(studySeed),
    convergence: await convergence(peers, { tell: told('convergence') }),
    roughness: await roughness(peers, { tell: told('rough surfaces') }),
  };
}

/** Measures the plotted numbers again. The full report keeps its other numbers. */
async function renewPlots({ save }) {
  const plots = await plotsOnly();
  mkdirSync(inRoot('build'), { recursive: true });
  writeFileSync(inRoot('build/paper-plots.json'), jsonOf(plots));
  console.log('Written to build/paper-plots.json.');
  if (!save) return;
  const path = inRoot('docs/paper-report.json');
  const report = JSON.parse(readFileSync(path, 'utf8'));
  writeFileSync(path, keptJson({ ...report, plots }));
}

/**
 * Measures one study again. The full report keeps the other studies, and its rows that depend on
 * this study name its day.
 */
async function renewStudy({ study }) {
  const { runStudies, studyNames } = await load('claims/studies.ts');
  if (!studyNames.includes(study)) {
    throw new Error(`There is no study '${study}': ${studyNames.join(', ')}.`);
  }
  if (['convergence', 'roughness'].includes(study)) throw new Error('--plots measures it.');
  const { studySeed } = await load('claims/seed.ts');
  const { loadPeers } = await load('../../dist/peers/index.js');
  const found = await runStudies(await loadPeers(), tell, [study]);
  const { date, version, sources } = about(studySeed);
  const path = inRoot('docs/paper-report.json');
  const report = JSON.parse(readFileSync(path, 'utf8'));
  const { studies } = kept({ studies: { ...report.studies, ...found } });
  await judgeAnew({ ...report, studies }, study, { date, version, sources });
}

/**
 * Judges the numbers of the last report again. A row for which they do not suffice stays unchanged.
 * Rows that depend on a newer study state its day and version.
 */
async function judgeAnew(report, study, newer) {
  const { judge } = await load('claims/judge.ts');
  const path = inRoot('docs/paper-report.json');
  const measured = measuredOf(report);
  const without = judge({ ...measured, studies: { ...measured.studies, [study]: undefined } });
  const claims = judge(measured).map((row, i) => {
    const before = report.claims.find(({ id }) => id === row.id);
    if (row.verdict === 'not measured here' && before) return before;
    const rests = without[i].verdict === 'not measured here';
    const renewed = rests && newer ? newer : before?.renewed;
    return renewed ? { ...row, renewed } : row;
  });
  writeFileSync(path, keptJson({ ...report, claims }));
  console.log('Judged anew in docs/paper-report.json.');
}

async function everything(options) {
  const { runStudies } = await load('claims/studies.ts');
  const { studySeed } = await load('claims/seed.ts');
  lookAtLoad();
  const figures = await figuresPart(options);
  lookAtLoad();
  const table = await tablePart(options);
  const meshes = await meshesPart(options, studySeed);
  lookAtLoad();
  const parts = [figures.text, table.text, meshes.text].filter(Boolean);
  const { loadPeers } = await load('../../dist/peers/index.js');
  const wantsClaims = options.figure === undefined;
  const studies = wantsClaims ? await runStudies(await loadPeers(), tellBusy) : null;
  const where = about(studySeed);
  const head = `# The paper, judged\n\n${where.date}, version ${where.version}, seed ${where.seed}, ${where.machine}.\n`;
  if (!wantsClaims) return { parts: parts.length > 0 ? [head, ...parts] : [] };
  const { judge } = await load('claims/judge.ts');
  const { claimsReport } = await load('report.ts');
  // The verdicts use the kept numbers, so that they follow from the report alone.
  const numbers = kept({
    ...{ panels: figures.panels, studies, meshes: meshes.found, load: lookAtLoad() },
    table: { samples: Number(options.samples), cells: table.cells },
  });
  const { convergence, roughness, ...otherStudies } = numbers.studies;
  const plots = { ...where, convergence, roughness };
  const whole = { ...numbers, studies: otherStudies, plots };
  const claims = judge(measuredOf(whole));
  return {
    parts: [head, claimsReport(claims), ...parts],
    verdicts: { ...where, claims, ...whole },
  };
}

try {
  const options = readOptions();
  if (options.judge) {
    await judgeAnew(JSON.parse(readFileSync(inRoot('docs/paper-report.json'), 'utf8')));
    process.exit(0);
  }
  await setUp('build');
  if (!options.built) {
    await buildWasm();
    await buildFacade();
  }
  if (options.plots) {
    await renewPlots(options);
    process.exit(0);
  }
  if (options.study !== undefined) {
    await renewStudy(options);
    process.exit(0);
  }
  const { parts, verdicts } = await everything(options);
  if (parts.length === 0) {
    throw new Error(
      'Nothing to write: no figure was chosen, and Table 1 has no row of so few triangles.',
    );
  }
  mkdirSync(inRoot('build'), { recursive: true });
  writeFileSync(inRoot('build/paper.md'), parts.join('\n'));
  console.log('Written to build/paper.md.');
  if (verdicts) {
    writeFileSync(inRoot('build/paper.json'), jsonOf(verdicts));
    if (options.save) writeFileSync(inRoot('docs/paper-report.json'), keptJson(verdicts));
  }
} catch (error) {
  const wrongArguments = error.code?.startsWith('ERR_PARSE_ARGS');
  console.error(wrongArguments ? `${error.message}\n${usage}` : error.message);
  process.exit(1);
}
