// Tables of docs that quote the output of a study: the place of each, and its rows, computed from
// the saved study. A test compares both (tests/paper/quoted.test.mjs). The options `--save` and
// `--again` of `npm run study` write the tables.
import { readFileSync, writeFileSync } from 'node:fs';
import { rowsOf, savedLines } from './saved_study.mjs';
import { inRoot } from './shell.mjs';

/**
 * The parts of the output of a study of several meshes. Each begins with a head, the mesh's name.
 */
function meshesOf(lines) {
  const heads = lines.flatMap((line, i) => (line.startsWith('## ') ? [i] : []));
  return heads.map((from, k) => {
    const part = lines.slice(from, heads[k + 1]);
    const triangles = part.find((line) => /^\d+ triangles/.test(line));
    return { name: part[0].slice(3), triangles: Number.parseInt(triangles, 10), part };
  });
}

const printed = (name, args) => () => rowsOf(savedLines(name, args));

/** The rows of a mesh, with its name only in the first. */
const onceNamed = (name, rows) => rows.map((row, i) => [i === 0 ? name : '', ...row]);

const everywhere = () =>
  meshesOf(savedLines('everywhere', ['of-files'])).flatMap(({ name, triangles, part }) => {
    const veryFirst = /very first curve takes (\S+) ms/.exec(part.join(' '))[1];
    const size = triangles.toLocaleString('en');
    return onceNamed(`${name} (${size}; ${veryFirst})`, rowsOf(part));
  });

/**
 * For each spacing, the levels of the default, and the turning and bridges of each kind of curve.
 */
const steadiness = () =>
  meshesOf(
    savedLines('steadiness', ['--drags', '0', '--levels', '0,auto,limit', 'torus', 'of-files']),
  ).flatMap(({ name, part }) => {
    const rows = rowsOf(part);
    const spacings = [...new Set(rows.map(([spacing]) => spacing))];
    const table = spacings.map((spacing) => {
      const of = (levels) => rows.find((row) => row[0] === spacing && row[1].startsWith(levels));
      const [zero, auto, limit] = ['0 (', 'auto', 'limit'].map(of);
      const turning = [zero, auto, limit].map((row) => row[2]).join(' / ');
      return [spacing, /\((.*)\)/.exec(auto[1])[1], turning, `${zero[5]} / ${auto[5]}`];
    });
    return onceNamed(name, table);
  });

/**
 * Numbers in the form of running text: without a zero before the point, and without trailing zeros.
 */
const short = (cell) =>
  cell.replaceAll(/\d+\.\d+(?!\d*e)/g, (value) => `${Number(value)}`.replace(/^0\./, '.'));

const withoutSuffix = (name) => name.replace(/\.obj$/, '');
const thousands = (count) => Number(count).toLocaleString('en');

/**
 * The distances of `auto` from level 0 and from the truth, from a study of at most 200 polygons for
 * each row.
 */
const levels = (args) => () =>
  rowsOf(savedLines('levels', args)).map((row) => {
    const [name, triangles, spacing, mean, zeros, unsafe, fromZero, , ours, theirs, ms] = row;
    const median = (cell) => cell.split(' / ')[0];
    const truth = ours === '-' ? '-' : `${median(ours)}; ${median(theirs)}`;
    const safe = unsafe.replaceAll(/[\d.]+/g, (value) => `${value} %`);
    return [
      ...[name, thousands(triangles), short(spacing), mean, `${zeros.split(' ')[0]} %`, safe],
      ...[short(fromZero), truth, ms.replace(' /', ';')],
    ];
  });

/**
 * The curves that the fast and the exact solver break, and the reasons, for each mesh and spacing.
 */
const breaks = () => {
  const rows = rowsOf(savedLines('breaks', ['--polygons', '20', 'of-files']));
  const fast = rows.filter(([, , solver]) => solver === 'fast');
  return fast.map((row, i) => {
    const exact = rows[rows.indexOf(row) + 1];
    const both = [3, 4, 5, 6].map((k) => `${short(row[k])} / ${short(exact[k])}`);
    const isFirst = fast[i - 1]?.[0] !== row[0];
    return [isFirst ? withoutSuffix(row[0]) : '', short(row[1]), ...both];
  });
};

const steps = '--polygons 0 --drags 30 --steps 20 --levels auto,averages,limit torus of-files';
const roughSteps =
  '--polygons 0 --drags 20 --steps 20 --rough 4 --levels auto,averages,limit of-files';
const manyDrags = '--polygons 0 --drags 200 --levels auto torus of-files';

/** The results of studies of drags for each mesh. Roughened meshes have another name. */
const dragged = (args) =>
  meshesOf(savedLines('steadiness', args.split(' '))).map(({ name, triangles, part }) => {
    const isRough = args.includes('--rough');
    const rough = `${(triangles / 1e6).toFixed(2)} million rough triangles, 20 drags`;
    return { name: isRough ? `${name}, ${rough}` : name, rows: rowsOf(part) };
  });

/**
 * The median times of a drag's steps at all spacings for each mesh, beside those of the subdivision
 * curve.
 */
const stepCosts = () =>
  [steps, roughSteps].flatMap(dragged).map(({ name, rows }) => {
    const of = (variant, column) =>
      rows
        .filter((row) => row[1] === variant)
        .map((row) => short(row[column].replace(' ms', '')))
        .join(' / ');
    return [
      ...[name, of('auto', 0)],
      ...['auto', 'averages', 'limit'].map((variant) => of(variant, 15)),
      of('auto', 17),
    ];
  });

/** The steps that leap for each mesh and spacing, by whether passed vertices allow the leap. */
const leaps = () =>
  [manyDrags, roughSteps].flatMap(dragged).flatMap(({ name, rows }) => {
    const auto = rows.filter((row) => row[1] === 'auto');
    const table = auto.map((row) => [0, 4, 7, 6, 9, 10].map((column) => short(row[column])));
    return onceNamed(name, table);
  });

/** The deviations of offsets for each mesh, relative to their distances. */
const offsets = () => {
  const rows = rowsOf(savedLines('offsets', ['of-files']));
  const names = [...new Set(rows.map(([name]) => name))];
  return names.map((name) => {
    const own = rows.filter((row) => row[0] === name);
    const of = (column) => own.map((row) => row[column]);
    return [withoutSuffix(name), thousands(own[0][1]), ...of(6), of(7).join('; ')];
  });
};

const memoryStudies = [
  ['--memory', '--triangles', '100000'],
  ['--memory', 'of-files'],
  ['--memory', '--triangles', '1000000'],
  ['--memory', '--triangles', '10000000'],
];

/** The memory that the first and the second refined curve on a mesh take. */
const memory = () =>
  memoryStudies.flatMap((args) => {
    const rows = rowsOf(savedLines('joints', args));
    const firsts = rows.filter(([, , curve]) => curve === 'first');
    return firsts.map((first) => {
      const second = rows[rows.indexOf(first) + 1];
      const both = [3, 4, 5].map((k) => `${first[k]} / ${second[k]}`);
      return [first[0], thousands(first[1]), ...both];
    });
  });

const steady = 'docs/steady-curves.md';
const levelsOf = '| surface | triangles | spacing';

export const quotedTables = [
  { doc: 'docs/methods.md', head: '| mesh | triangles | at .002', rows: offsets },
  { doc: 'docs/gallery.md', head: '| mesh | triangles | worst', rows: printed('gallery') },
  {
    doc: 'docs/convergence.md',
    head: '| mesh | triangles | `paper`',
    rows: printed('convergence'),
  },
  { doc: 'docs/everywhere.md', head: '| mesh | spacing | curves', rows: everywhere },
  { doc: steady, head: '| mesh | spacing | levels of `auto`', rows: steadiness },
  { doc: steady, head: levelsOf, rows: levels([]) },
  {
    ...{ doc: steady, head: levelsOf, at: 1 },
    rows: levels(['--polygons', '30', '--triangles', '300000']),
  },
  { doc: steady, head: '| mesh | spacing | bridged', rows: breaks },
  { doc: steady, head: '| mesh | spacing | `auto`', rows: stepCosts },
  { doc: steady, head: '| mesh | spacing | a leg passes', rows: leaps },
  { doc: steady, head: '| mesh | triangles | levels, first', rows: memory },
  { doc: 'docs/repairs-study.md', head: '| defect | opened', rows: printed('repairs') },
  { doc: steady, head: '| mesh | triangles | curve', rows: printed('joints') },
  {
    ...{ doc: steady, head: '| mesh | triangles | curve', at: 1 },
    rows: printed('joints', ['none', 'of-files']),
  },
  {
    doc: 'docs/compare.md',
    head: '| mesh | triangles | edge Dijkstra',
    rows: printed('fields', ['of-files']),
  },
];

/** The place of a table's rows in lines: the first, and the one after the last. */
function placeOf(lines, { doc, head, at = 0 }) {
  const heads = lines.flatMap((line, i) => (line.startsWith(head) ? [i] : []));
  if (heads[at] === undefined) throw new Error(`${doc} has no table '${head}'.`);
  const first = heads[at] + 2;
  const count = lines.slice(first).findIndex((line) => !line.startsWith('|'));
  return [first, count < 0 ? lines.length : first + count];
}

/** The rows in the doc. */
export function quotedRows(table) {
  const lines = readFileSync(inRoot(table.doc), 'utf8').split('\n');
  return rowsOf(['', ...lines.slice(...placeOf(lines, table))]);
}

/** Writes the tables from the saved studies. Returns the docs that changed. */
export function quoteStudies() {
  const changed = new Set();
  for (const table of quotedTables) {
    const text = readFileSync(inRoot(table.doc), 'utf8');
    const lines = text.split('\n');
    const [first, end] = placeOf(lines, table);
    const rows = table.rows().map((row) => `| ${row.join(' | ')} |`);
    const written = lines.toSpliced(first, end - first, ...rows).join('\n');
    if (written === text) continue;
    writeFileSync(inRoot(table.doc), written);
    changed.add(table.doc);
  }
  return [...changed];
}
