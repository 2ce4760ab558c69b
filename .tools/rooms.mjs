// Checks the includes of C++ and the imports of TypeScript against the tables of ARCHITECTURE.md.
//
// A table's first column names a room: a file, or a folder with the files directly in it. The last
// column names the uses that the room may have: rooms, packages, entries of packages such as
// `karcher/statistics`, `folder/*` for every room below a folder, and "all above" for the rooms of the
// rows above in the same table. "but" precedes exceptions, and "(types)" follows a name of which only
// types may be imported. A room may always use itself and the standard library.
import { readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { filesBelow, inRoot, root } from './shell.mjs';

const folders = ['src', 'wasm', 'web'];
const sources = /\.(h|cpp|ts|mts)$/;

const namesIn = (cell) =>
  [...cell.matchAll(/`([^`]+)`(\s*\(types\))?/g)].map(([, name, types]) => ({
    name,
    typesOnly: types !== undefined,
  }));

/**
 * The rows of every table whose first column has the head 'room', a list of rows for each table.
 */
function tablesOf(markdown) {
  const tables = [];
  let inTable = false;
  for (const line of markdown.split('\n')) {
    if (/^\|\s*room\s*\|/.test(line)) {
      inTable = true;
      tables.push([]);
    } else if (!line.startsWith('|')) inTable = false;
    else if (inTable && !/^\|[\s|:-]*$/.test(line))
      tables.at(-1).push(line.split('|').slice(1, -1));
  }
  return tables;
}

/**
 * The rooms of a text with such tables: `{ name, paths, uses }`. `uses` maps each permitted name to
 * whether only its types are. Throws an error for text that it cannot read, for a room that occurs
 * twice or not at all, and for rooms that use each other in a circle.
 */
export function readRooms(markdown) {
  const rooms = [];
  for (const table of tablesOf(markdown)) {
    const above = [];
    for (const cells of table) {
      const paths = namesIn(cells[0]).map(({ name }) => name);
      if (paths.length === 0) throw new Error(`a row names no room: ${cells.join('|')}`);
      rooms.push({ name: paths[0], paths, above: [...above], cell: cells.at(-1) });
      above.push(paths[0]);
    }
  }
  const named = new Map(rooms.flatMap((room) => room.paths.map((path) => [path, room.name])));
  if (named.size !== rooms.flatMap((room) => room.paths).length) {
    throw new Error('a room is named twice');
  }
  const roomsOf = (name) => {
    if (!folders.includes(name.split('/')[0])) return [name];
    if (name.endsWith('/*')) {
      const below = [...named].filter(([path]) => path.startsWith(name.slice(0, -1)));
      if (below.length > 0) return below.map(([, room]) => room);
    } else if (named.has(name)) return [named.get(name)];
    throw new Error(`there is no room '${name}'`);
  };
  for (const room of rooms) {
    const [with_, without = ''] = room.cell.split(/\bbut\b/);
    room.uses = new Map(/\ball above\b/.test(with_) ? room.above.map((name) => [name, false]) : []);
    for (const { name, typesOnly } of namesIn(with_)) {
      for (const used of roomsOf(name)) room.uses.set(used, typesOnly);
    }
    for (const { name } of namesIn(without)) {
      for (const used of roomsOf(name)) room.uses.delete(used);
    }
    room.uses.delete(room.name);
  }
  throwIfCircular(rooms);
  return rooms;
}

function throwIfCircular(rooms) {
  const byName = new Map(rooms.map((room) => [room.name, room]));
  const [circle] = circlesIn(byName.keys(), (name) => byName.get(name)?.uses.keys() ?? []);
  if (circle) throw new Error(`rooms use each other: ${circle.join(' -> ')}`);
}

/** The circles of uses among names, one for each use that closes one. */
function circlesIn(names, usesOf) {
  const circles = [];
  const done = new Set();
  const visit = (name, way) => {
    if (way.includes(name)) circles.push([...way.slice(way.indexOf(name)), name]);
    else if (!done.has(name)) {
      for (const used of usesOf(name)) visit(used, [...way, name]);
      done.add(name);
    }
  };
  for (const name of names) visit(name, []);
  return circles;
}

/** The includes of a C++ file: `{ target, quoted }`. */
const includesOf = (text) =>
  [...text.matchAll(/^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)/gm)].map(([, own, other]) => ({
    target: own ?? other,
    quoted: own !== undefined,
  }));

/**
 * The imports of a TypeScript file, and the files whose address it names, such as a worker that it
 * starts: `{ target, typesOnly, isStarted }`.
 */
function importsOf(text) {
  const statement =
    /^\s*(?:import|export)\s+(type\s+)?(?:([\w$*{}\s,]+?)\s+from\s+)?['"]([^'"]+)['"]/gm;
  const named = [...text.matchAll(statement)].map(([, type, names = '', target]) => {
    const list = /^\{([\s\S]*)\}$/.exec(names.trim())?.[1].split(',') ?? [''];
    const eachType = list.map((name) => name.trim()).filter(Boolean);
    const typesOnly = eachType.length > 0 && eachType.every((name) => name.startsWith('type '));
    return { target, typesOnly: type !== undefined || typesOnly };
  });
  const called = [...text.matchAll(/\b(import|new\s+URL)\(\s*['"]([^'"]+)['"]/g)].map(
    ([, how, target]) => ({ target, typesOnly: false, isStarted: how !== 'import' }),
  );
  return [...named, ...called];
}

/** The name of the package of an import or include; undefined for the standard library. */
function packageOf(target, isCpp) {
  if (target.startsWith('node:')) return 'node';
  if (target === 'tiny_obj_loader.h') return 'tinyobjloader';
  if (isCpp) return /[/.]/.test(target) ? target.split('/')[0] : undefined;
  const parts = target.split('/');
  return target.startsWith('@') ? parts.slice(0, 2).join('/') : parts[0];
}

/**
 * The faults of the files `{ path, text }` of a project with these rooms, a sentence each:
 * forbidden uses, files in no room, rooms without a file, and files that include or import each
 * other in a circle, also by types. A worker is another program.
 */
export function wrongUses(rooms, files) {
  const named = new Map(rooms.flatMap((room) => room.paths.map((path) => [path, room])));
  const roomOf = (path) => named.get(path) ?? named.get(posix.dirname(path));
  const wrong = [];
  const present = new Set(files.map(({ path }) => path));
  const inhabited = new Set(files.map(({ path }) => roomOf(path)));
  for (const room of rooms) {
    if (!inhabited.has(room)) wrong.push(`${room.name}: a room without a file`);
  }
  const usesOf = new Map(files.map(({ path }) => [path, new Set()]));
  for (const { path, text } of files) {
    const room = roomOf(path);
    if (!room) {
      wrong.push(`${path}: in no room`);
      continue;
    }
    const check = (used, target, typesOnly) => {
      if (used === undefined || used === room.name) return;
      const onlyTypes = room.uses.get(used);
      if (onlyTypes === undefined) {
        const may = [...room.uses.keys()].join(', ') || 'nothing';
        wrong.push(`${path}: uses '${target}', of ${used}; ${room.name} may use ${may}`);
      } else if (onlyTypes && !typesOnly) {
        wrong.push(`${path}: uses '${target}', of which ${room.name} may import types only`);
      }
    };
    const checkOwn = (candidates, target, typesOnly, isStarted = false) => {
      const found = candidates.find((candidate) => present.has(candidate)) ?? candidates[0];
      if (!isStarted) usesOf.get(path).add(found);
      const used = roomOf(found);
      if (used) check(used.name, target, typesOnly);
      else if (sources.test(found)) wrong.push(`${path}: uses '${target}', which is in no room`);
    };
    if (/\.(h|cpp)$/.test(path)) {
      for (const { target, quoted } of includesOf(text)) {
        if (quoted) checkOwn([`src/${target}`, `wasm/${target}`], target, false);
        else check(packageOf(target, true), target, false);
      }
    } else {
      for (const { target, typesOnly, isStarted } of importsOf(text)) {
        if (target.startsWith('.')) {
          const at = posix.join(posix.dirname(path), target);
          const endings = ['', '.ts', '.mts', '.d.mts', '/index.ts'];
          const stem = at.replace(/\.m?js$/, '');
          checkOwn(
            [at, stem].flatMap((start) => endings.map((ending) => start + ending)),
            target,
            typesOnly,
            isStarted,
          );
        } else {
          const used = room.uses.has(target) ? target : packageOf(target, false);
          check(used, target, typesOnly);
        }
      }
    }
  }
  for (const circle of circlesIn(present, (path) => usesOf.get(path) ?? [])) {
    wrong.push(`${circle[0]}: leads back to itself: ${circle.join(' -> ')}`);
  }
  return wrong;
}

/** The files that a text names in backticks, by path or name alone, but that are not in `paths`. */
export function namesOfNoFile(markdown, paths) {
  const named = [...markdown.matchAll(/`([\w./-]+\/)?([\w-]+\.(?:h|cpp|mjs|ts|cmake|html))`/g)];
  return named
    .map(([, folder = '', name]) => folder + name)
    .filter((name) => !paths.some((path) => `/${path}`.endsWith(`/${name}`)));
}

/**
 * Checks the project's own files, prints the faults, and returns the counts of sound and of faulty
 * files.
 */
export function checkRooms() {
  const markdown = readFileSync(inRoot('ARCHITECTURE.md'), 'utf8');
  const rooms = readRooms(markdown);
  const files = folders
    .flatMap((folder) => filesBelow(folder, sources))
    .map((file) => ({
      path: file.slice(root.length),
      text: readFileSync(file, 'utf8'),
    }));
  const all = [...folders, 'tests', '.tools'].flatMap((folder) => filesBelow(folder, /./));
  const wrong = [
    ...wrongUses(rooms, files),
    ...namesOfNoFile(
      markdown,
      all.map((file) => file.slice(root.length)),
    ).map((name) => `ARCHITECTURE.md: names ${name}, which is not there`),
  ];
  for (const sentence of wrong) console.error(sentence);
  const failed = new Set(wrong.map((sentence) => sentence.split(':')[0])).size;
  return { passed: files.length - failed, failed };
}
