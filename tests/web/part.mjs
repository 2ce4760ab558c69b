// What a run takes of many like cases.
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** The commit's first digits as a number, so that each commit draws anew; 1 where there is no git. */
function seedOfCommit() {
  try {
    const commit = execFileSync('git', ['rev-parse', 'HEAD'], {
      cwd: root,
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'ignore'],
    });
    return Number.parseInt(commit.slice(0, 7), 16);
  } catch {
    return 1;
  }
}

/** Draws the cases of a run: KARCHER_SEED, else of the commit. */
export const seed = Number(process.env.KARCHER_SEED ?? seedOfCommit());
if (!Number.isSafeInteger(seed)) throw new Error('KARCHER_SEED must be an integer');
export const long = process.env.KARCHER_LONG === '1';

/** Numbers in [0, 1): mulberry32. */
export function* randoms(start) {
  for (let state = start; ; ) {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    yield ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  }
}

/** All cases in a long run (`npm run check:long`), else `count` of them, drawn by the printed seed. */
export function part(cases, count) {
  if (long || cases.length <= count) return cases;
  console.log(`${count} of ${cases.length} cases, drawn with KARCHER_SEED=${seed}`);
  const random = randoms(seed);
  const left = [...cases.keys()];
  const drawn = Array.from({ length: count }, () => {
    const [index] = left.splice(Math.floor(random.next().value * left.length), 1);
    return index;
  });
  return drawn.sort((a, b) => a - b).map((index) => cases[index]);
}

let told = false;

/**
 * A test of a case that is like others of its file: run always in a long run, else by the drawing
 * of the seed in one of three.
 */
export function sometimes(name, run) {
  if (!long && !told) console.log(`Tests of this file are drawn with KARCHER_SEED=${seed}`);
  told = true;
  let hash = seed;
  for (const letter of name) hash = (Math.imul(hash, 31) + letter.charCodeAt(0)) >>> 0;
  const skip = !long && hash % 3 !== 0 && 'in a long run, or drawn with another KARCHER_SEED';
  test(name, { skip }, run);
}
