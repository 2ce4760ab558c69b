// Runs files of node:test, each in its own process, or together where they share slow modules.
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { runLongestFirst } from './longest_first.mjs';
import { inRoot, run } from './shell.mjs';

/** The counts in a file's report, which node:test writes at its end. */
function countsOf(report) {
  const tap = readFileSync(report, 'utf8');
  const count = (key) => Number([...tap.matchAll(new RegExp(`^# ${key} (\\d+)$`, 'gm'))].at(-1)[1]);
  return { passed: count('pass'), failed: count('fail') + count('cancelled') };
}

/** Runs files in one process, prints their output, and returns the counts of their report. */
async function runFiles(files, { report, env, minutes }) {
  const names = files.map((file) => basename(file)).join(', ');
  rmSync(report, { force: true });
  const reporters = ['spec', 'stdout', 'tap', report];
  const args = reporters.map(
    (value, i) => `--test-reporter${i % 2 ? '-destination' : ''}=${value}`,
  );
  let problem;
  let output;
  try {
    const started = files.length === 1 ? files : [inRoot('.tools/together.mjs'), ...files];
    output = await run(process.execPath, [...args, ...started], { env, quiet: true, minutes });
  } catch (error) {
    problem = error;
    output = error.output;
  }
  console.log(`${names}\n${output.replace(/^ℹ (\w+) [\d.]+\n/gm, '')}`);
  let counts = { passed: 0, failed: 0 };
  try {
    counts = countsOf(report);
  } catch {
    problem ??= new Error('it wrote no report');
  }
  if (counts.passed + counts.failed === 0) problem ??= new Error('no test ran');
  if (problem && counts.failed === 0) {
    console.error(`${names}: ${problem.message}`);
    counts.failed = 1;
  }
  return counts;
}

/**
 * Runs groups of files, each a name and files that share a process. Returns their counts. Reports
 * go to the folder `reports`; `atOnce` groups run at a time, by default as many as there are cores.
 */
export function runGroups(groups, { reports, env, minutes, atOnce }) {
  mkdirSync(reports, { recursive: true });
  const byName = new Map(groups.map((group) => [group.name, group]));
  const runGroup = (name) => {
    const group = byName.get(name);
    const report = join(reports, `${name}.tap`);
    return runFiles(group.files, { report, env: { ...env, ...group.env }, minutes });
  };
  return runLongestFirst([...byName.keys()], join(reports, 'seconds.json'), runGroup, atOnce);
}

/** One group for each file, with additional environment variables. */
export const alone = (files, env = {}) =>
  files.map((file) => ({ name: basename(file), files: [file], env }));

/** Files dealt out to groups of about `size`. */
export function dealt(files, size) {
  const count = Math.ceil(files.length / size);
  return Array.from({ length: count }, (_, group) => ({
    name: `group-${group + 1}-of-${count}`,
    files: files.filter((_, i) => i % count === group),
  }));
}
