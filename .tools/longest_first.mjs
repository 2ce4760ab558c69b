// Runs files of tests, as many at a time as there are cores, the longest first, so that every core
// stays busy until the end of a stage.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { countAll } from './shell.mjs';

/**
 * Calls `runFile` with each name and returns the sums of its results, `{ passed, failed }`. Saves
 * the duration of each at `timesPath` for the next run's order; names without a time there come
 * first. `atOnce` run at a time, by default as many as there are cores.
 */
export async function runLongestFirst(names, timesPath, runFile, atOnce) {
  const before = existsSync(timesPath) ? JSON.parse(readFileSync(timesPath, 'utf8')) : {};
  const expected = (name) => before[name] ?? Number.POSITIVE_INFINITY;
  const seconds = {};
  const sums = await countAll(
    names.toSorted((a, b) => expected(b) - expected(a) || 0),
    async (name) => {
      const start = performance.now();
      const counts = await runFile(name);
      seconds[name] = Math.round(performance.now() - start) / 1000;
      return counts;
    },
    atOnce,
  );
  writeFileSync(timesPath, JSON.stringify(seconds));
  const longest = Object.entries(seconds).sort(([, a], [, b]) => b - a);
  const named = longest.slice(0, 5).map(([name, time]) => `${name} ${time.toFixed(1)} s`);
  console.log(`Longest: ${named.join(', ')}`);
  return sums;
}
