// Runs files of node:test, each in a separate process.
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { runLongestFirst } from './longest_first.mjs';
import { run } from './shell.mjs';

/** The counts in a file's report, which node:test writes at its end. */
function countsOf(report) {
  const tap = readFileSync(report, 'utf8');
  const count = (key) => Number([...tap.matchAll(new RegExp(`^# ${key} (\\d+)$`, 'gm'))].at(-1)[1]);
  return { passed: count('pass'), failed: count('fail') + count('cancelled') };
}

/** Runs a file, prints its output, and returns the counts of its report. */
async function runFile(file, { report, env, minutes }) {
  rmSync(report, { force: true });
  const reporters = ['spec', 'stdout', 'tap', report];
  const args = reporters.map(
    (value, i) => `--test-reporter${i % 2 ? '-destination' : ''}=${value}`,
  );
  let problem;
  let output;
  try {
    output = await run(process.execPath, [...args, file], { env, quiet: true, minutes });
  } catch (error) {
    problem = error;
    output = error.output;
  }
  console.log(`${basename(file)}\n${output.replace(/^ℹ (\w+) [\d.]+\n/gm, '')}`);
  let counts = { passed: 0, failed: 0 };
  try {
    counts = countsOf(report);
  } catch {
    problem ??= new Error('it wrote no report');
  }
  if (counts.passed + counts.failed === 0) problem ??= new Error('no test ran');
  if (problem && counts.failed === 0) {
    console.error(`${basename(file)}: ${problem.message}`);
    counts.failed = 1;
  }
  return counts;
}

/**
 * Runs the files of a folder and returns their counts. `reports` is the folder for their reports.
 */
export function runNodeTests(files, { reports, env, minutes }) {
  mkdirSync(reports, { recursive: true });
  const byName = new Map(files.map((file) => [basename(file), file]));
  return runLongestFirst([...byName.keys()], join(reports, 'seconds.json'), (name) =>
    runFile(byName.get(name), { report: join(reports, `${name}.tap`), env, minutes }),
  );
}
