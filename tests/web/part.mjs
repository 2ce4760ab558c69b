// The choice of a part of many similar cases for a run. It is always the same part, so that a fault
// does not first appear with somebody else's commit.
import { test } from 'node:test';

/** The seed of the random cases: always the same one, or KARCHER_SEED. */
export const seed = Number(process.env.KARCHER_SEED ?? 1);
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

/** A function that returns the next number of `randoms`. */
export function randomFrom(start) {
  const numbers = randoms(start);
  return () => numbers.next().value;
}

/**
 * All cases in a long run (`npm run check:long`), else `count` of them: the first, the last and
 * evenly spaced ones between.
 */
export function part(cases, count) {
  if (long || cases.length <= count) return cases;
  const apart = (cases.length - 1) / Math.max(count - 1, 1);
  return Array.from({ length: count }, (_, i) => cases[Math.round(i * apart)]);
}

/** A test that runs only in a long run, since it resembles others or takes many steps. */
export function inLongRun(name, run) {
  test(name, { skip: !long && 'in a long run' }, run);
}
