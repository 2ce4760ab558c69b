// Studies whose numbers docs quote, as they are kept in docs/studies: what was run, when, where, of which
// sources, and what it printed. A test compares the docs with them (tests/paper/quoted.test.mjs), and
// `npm run check:long` runs the studies anew and compares them with it (tests/paper/anew.test.mjs).
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { basename } from 'node:path';
import { aboutReport, jsonOf } from './paper_report.mjs';
import { inRoot, run } from './shell.mjs';
import { sourcesDigest } from './sources.mjs';

const folder = 'docs/studies';
/** What a study's numbers depend on. Its seeds are constants there. */
const sourcesOf = () => sourcesDigest(['src', 'tests/bench', 'tests/generators', 'tests/measures']);

/** Studies of files are told by their names, which stand for them: they are not the project's. */
const fileOf = (name, args) =>
  `${[name, ...args]
    .join('-')
    .replaceAll(/[^\w.]+/g, '-')
    .toLowerCase()}.json`;

const program = (name) => inRoot(`build/native/tests/bench/${name}_study`);

/** Runs a study that is built, and returns the lines that it printed. */
export async function studyLines(name, args) {
  const output = await run(program(name), args, { quiet: true, minutes: Infinity });
  return output.trimEnd().split('\n');
}

/** Runs a study and keeps what it printed; returns where. */
export async function saveStudy(name, args) {
  const sources = sourcesOf();
  const load = loadavg()[0];
  const lines = await studyLines(name, args);
  const { seed: _, ...about } = aboutReport({ sources, load: Math.max(load, loadavg()[0]) });
  mkdirSync(inRoot(folder), { recursive: true });
  const names = args.map((argument) => basename(argument));
  const path = `${folder}/${fileOf(name, names)}`;
  writeFileSync(inRoot(path), jsonOf({ ...about, study: name, arguments: names, lines }));
  return path;
}

/** All that are kept. */
export function savedStudies() {
  if (!existsSync(inRoot(folder))) return [];
  const names = readdirSync(inRoot(folder)).filter((name) => name.endsWith('.json'));
  return names
    .toSorted()
    .map((name) => JSON.parse(readFileSync(inRoot(`${folder}/${name}`), 'utf8')));
}

/** What a study with these arguments printed when it was kept. */
export function savedLines(name, args = []) {
  return JSON.parse(readFileSync(inRoot(`${folder}/${fileOf(name, args)}`), 'utf8')).lines;
}

/** The rows of the tables in lines of Markdown, without their heads: cells as they are. */
export function rowsOf(lines) {
  const isRule = (line) => /^\|[\s|:-]+$/.test(line);
  return lines.flatMap((line, i) => {
    if (!line.startsWith('|') || isRule(line) || isRule(lines[i + 1] ?? '')) return [];
    return [
      line
        .split('|')
        .slice(1, -1)
        .map((cell) => cell.trim()),
    ];
  });
}
