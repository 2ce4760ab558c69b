// Studies whose numbers docs quote, as docs/studies keeps them: the command, time, machine and
// sources of each, and its output. A test compares the docs with the kept output
// (tests/paper/quoted.test.mjs). `npm run check:long` runs the studies again and compares the new
// output with the kept one (tests/paper/anew.test.mjs).
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { basename, join, parse } from 'node:path';
import { aboutReport, jsonOf } from './paper_report.mjs';
import { inRoot, run } from './shell.mjs';
import { sourcesDigest } from './sources.mjs';

const folder = 'docs/studies';
/** The digest of the sources on which a study's numbers depend. They contain its seeds, too. */
const sourcesOf = () => sourcesDigest(['src', 'tests/bench', 'tests/generators', 'tests/measures']);

/**
 * Whether an argument is the file of a mesh. Such meshes do not belong to the project; a saved
 * study has only their names.
 */
export const isMeshFile = (argument) => /\.(obj|stl|ply|off|glb|gltf)$/i.test(argument);

const fileOf = (name, args) => {
  const others = args.filter((argument) => !isMeshFile(argument) && argument !== 'of-files');
  const files = args.length > others.length ? ['of-files'] : [];
  return `${[name, ...others, ...files]
    .join('-')
    .replaceAll(/[^\w.]+/g, '-')
    .toLowerCase()}.json`;
};

const program = (name) => inRoot(`build/native/tests/bench/${name}_study`);

/**
 * The path of a mesh as an OBJ file, since the studies read OBJ files: the file itself, or one in
 * build/study with the mesh that the package reads from the file.
 */
async function toObj(path) {
  if (/\.obj$/i.test(path)) return path;
  const { load } = await import('karcher');
  const { meshFromFile } = await import('karcher/formats');
  const { mesh } = await meshFromFile(await load(), readFileSync(path), { name: basename(path) });
  const rowsOf = (values, letter, from) =>
    Array.from({ length: values.length / 3 }, (_, i) =>
      [letter, ...values.slice(3 * i, 3 * i + 3).map((value) => value + from)].join(' '),
    );
  const rows = [...rowsOf(mesh.positions(), 'v', 0), ...rowsOf(mesh.triangles(), 'f', 1)];
  mkdirSync(inRoot('build/study'), { recursive: true });
  const obj = inRoot(`build/study/${parse(path).name}.obj`);
  writeFileSync(obj, `${rows.join('\n')}\n`);
  return obj;
}

/**
 * The arguments of a study with the paths of its meshes in a folder or below it, and the names of
 * the missing ones.
 */
export function found(args, folder) {
  const files = new Map(
    folder
      ? readdirSync(folder, { recursive: true }).map((path) => [basename(path), join(folder, path)])
      : [],
  );
  const missing = args.filter((argument) => isMeshFile(argument) && !files.has(argument));
  return { args: args.map((one) => (isMeshFile(one) ? (files.get(one) ?? one) : one)), missing };
}

/** Runs a compiled study, with meshes of any format. */
export async function runStudy(name, args, options = { minutes: Infinity }) {
  const read = [];
  for (const argument of args) read.push(isMeshFile(argument) ? await toObj(argument) : argument);
  return run(program(name), read, options);
}

/** The lines that a study prints. */
export async function studyLines(name, args) {
  const output = await runStudy(name, args, { quiet: true, minutes: Infinity });
  return output.trimEnd().split('\n');
}

/** Runs a study and keeps its output. Returns the path. */
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

/** All kept studies. */
export function savedStudies() {
  if (!existsSync(inRoot(folder))) return [];
  const names = readdirSync(inRoot(folder)).filter((name) => name.endsWith('.json'));
  return names
    .toSorted()
    .map((name) => JSON.parse(readFileSync(inRoot(`${folder}/${name}`), 'utf8')));
}

/** The kept output of a study with these arguments. 'of-files' stands for any files. */
export function savedLines(name, args = []) {
  return JSON.parse(readFileSync(inRoot(`${folder}/${fileOf(name, args)}`), 'utf8')).lines;
}

/** The rows of the tables in lines of Markdown, without their heads. Cells are unchanged. */
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
