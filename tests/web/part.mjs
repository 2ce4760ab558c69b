// What a run takes of many like cases.
import { test } from 'node:test';

/** KARCHER_SEED draws others. */
export const seed = Number(process.env.KARCHER_SEED ?? 1);
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

/**
 * A test of a case that is like others of its file: run always in a long run, else by the drawing
 * of the seed in one of three.
 */
export function sometimes(name, run) {
  let hash = seed;
  for (const letter of name) hash = (Math.imul(hash, 31) + letter.charCodeAt(0)) >>> 0;
  const skip = !long && hash % 3 !== 0 && 'in a long run, or drawn with another KARCHER_SEED';
  test(name, { skip }, run);
}
