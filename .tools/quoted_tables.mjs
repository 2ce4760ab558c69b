// Tables of docs that are what a study printed: where each stands, and its rows by the saved study. A test holds
// docs to it (tests/paper/quoted.test.mjs), and `npm run study -- --save` and `--again` write them.
import { readFileSync, writeFileSync } from 'node:fs';
import { rowsOf, savedLines } from './saved_study.mjs';
import { inRoot } from './shell.mjs';

/** Each part of what a study of several meshes printed, below a head with the mesh's name. */
function meshesOf(lines) {
  const heads = lines.flatMap((line, i) => (line.startsWith('## ') ? [i] : []));
  return heads.map((from, k) => {
    const part = lines.slice(from, heads[k + 1]);
    const triangles = part.find((line) => /^\d+ triangles/.test(line));
    return { name: part[0].slice(3), triangles: Number.parseInt(triangles, 10), part };
  });
}

const printed = (name, args) => () => rowsOf(savedLines(name, args));

/** A name in the first row of its mesh only. */
const onceNamed = (name, rows) => rows.map((row, i) => [i === 0 ? name : '', ...row]);

const everywhere = () =>
  meshesOf(savedLines('everywhere', ['of-files'])).flatMap(({ name, triangles, part }) => {
    const veryFirst = /very first curve takes (\S+) ms/.exec(part.join(' '))[1];
    const size = triangles.toLocaleString('en');
    return onceNamed(`${name} (${size}; ${veryFirst})`, rowsOf(part));
  });

/** Of each spacing: how many levels the default has, and how the kinds of curves turn and are bridged. */
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

const steady = 'docs/steady-curves.md';

export const quotedTables = [
  { doc: 'docs/gallery.md', head: '| mesh | triangles | worst', rows: printed('gallery') },
  {
    doc: 'docs/convergence.md',
    head: '| mesh | triangles | `paper`',
    rows: printed('convergence'),
  },
  { doc: 'docs/everywhere.md', head: '| mesh | spacing | curves', rows: everywhere },
  { doc: steady, head: '| mesh | spacing | levels of `auto`', rows: steadiness },
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

/** Where a table's rows stand in lines: its first, and the one after its last. */
function placeOf(lines, { doc, head, at = 0 }) {
  const heads = lines.flatMap((line, i) => (line.startsWith(head) ? [i] : []));
  if (heads[at] === undefined) throw new Error(`${doc} has no table '${head}'.`);
  const first = heads[at] + 2;
  const count = lines.slice(first).findIndex((line) => !line.startsWith('|'));
  return [first, count < 0 ? lines.length : first + count];
}

/** The rows as the doc has them. */
export function quotedRows(table) {
  const lines = readFileSync(inRoot(table.doc), 'utf8').split('\n');
  return rowsOf(['', ...lines.slice(...placeOf(lines, table))]);
}

/** Writes the tables as the saved studies have them; returns the docs that changed. */
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
