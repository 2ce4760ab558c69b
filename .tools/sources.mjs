// The sources that determine the numbers of the Paper page, or of a study, as one digest. Numbers
// saved with another digest belong to another version of the code. Comments do not count.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { relative, sep } from 'node:path';
import { filesBelow, root } from './shell.mjs';

/**
 * The engine, the methods that it is compared with, and the studies. The bindings between them only
 * pass values on.
 */
const ofReport = ['src', 'wasm/peers', 'web/paper'];

/** Strings, which may look like comments, then comments and space. */
const stringOrRest =
  /"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`|\/\/[^\n]*|\/\*[\s\S]*?\*\/|\s+/g;

/** A file without comments and without space outside strings. */
const codeOf = (text) => text.replace(stringOrRest, (part) => (/^[/\s]/.test(part) ? '' : part));

/** The SHA-256 of the code of files: `[name, text]` pairs, in any order. */
export function digestOf(files) {
  const hash = createHash('sha256');
  const byName = (a, b) => (a[0] < b[0] ? -1 : 1);
  for (const [name, text] of files.toSorted(byName)) {
    const code = codeOf(text);
    // Lengths keep the end of one file from being mistaken for the beginning of the next.
    hash.update(`${name}\n${code.length}\n${code}`);
  }
  return hash.digest('hex');
}

/** The digest of this checkout's sources. It needs no Git and is the same on every machine. */
export function sourcesDigest(folders = ofReport) {
  const paths = folders.flatMap((folder) => filesBelow(folder, /\.(cpp|h|ts)$/));
  const nameOf = (path) => relative(root, path).replaceAll(sep, '/');
  return digestOf(paths.map((path) => [nameOf(path), readFileSync(path, 'utf8')]));
}
