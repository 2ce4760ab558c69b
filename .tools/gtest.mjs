// Runs a program of GoogleTest in parts: the tests of each source file in a process of its own, as they
// share what is costly to set up, the longest first.
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { cores, run } from './shell.mjs';

const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'));

/** The names of the tests but those of `without`, which must be there, by the source file they are in. */
async function testsByFile(program, report, without) {
  await run(program, ['--gtest_list_tests', `--gtest_output=json:${report}`], { quiet: true });
  const byFile = new Map();
  const left = new Set(without);
  for (const suite of readJson(report).testsuites) {
    for (const { name, file } of suite.testsuite) {
      const source = basename(file);
      const test = `${suite.name}.${name}`;
      if (!left.delete(test)) byFile.set(source, [...(byFile.get(source) ?? []), test]);
    }
  }
  if (left.size > 0) throw new Error(`there is no test ${[...left].join(', ')}`);
  return byFile;
}

/** Runs some tests, prints what they say or why they failed, and returns what their report counted. */
async function runTests(program, tests, { report, env, minutes }) {
  rmSync(report, { force: true });
  const args = [`--gtest_filter=${tests.join(':')}`, `--gtest_output=json:${report}`];
  let problem;
  let output;
  try {
    output = await run(program, args, { env, quiet: true, minutes });
  } catch (error) {
    problem = error;
    output = error.output ?? '';
  }
  // Of a good run only what the tests print themselves; of a bad one also which test was last.
  const lines = output
    .split('\n')
    .filter(
      (line) =>
        line &&
        (problem || !/^(\[[ =\-A-Z]+\]|Note: Google Test filter|Running main\(\))/.test(line)),
    );
  if (lines.length > 0) console.log(lines.join('\n'));
  let counts = { passed: 0, failed: 0 };
  try {
    const ran = readJson(report)
      .testsuites.flatMap((suite) => suite.testsuite)
      .filter((test) => test.status === 'RUN' && test.result !== 'SKIPPED');
    const failed = ran.filter((test) => test.failures?.length > 0).length;
    counts = { passed: ran.length - failed, failed };
  } catch {
    problem ??= new Error(`${program}: the tests wrote no report`);
  }
  if (problem && counts.failed === 0) {
    console.error(problem.message);
    counts.failed = 1;
  }
  return counts;
}

/**
 * Runs all tests of a program but those of `without`, as many files at a time as there are cores, and
 * returns what they counted. `reports` is a folder; how long each file took is kept there for the next
 * run's order.
 */
export async function runGoogleTest(program, { reports, env, minutes, without = [] }) {
  mkdirSync(reports, { recursive: true });
  const timesPath = join(reports, 'seconds.json');
  const before = existsSync(timesPath) ? readJson(timesPath) : {};
  const byFile = await testsByFile(program, join(reports, 'list.json'), without);
  const expected = (file) => before[file] ?? Number.POSITIVE_INFINITY;
  const waiting = [...byFile.keys()].sort((a, b) => (expected(a) < expected(b) ? 1 : -1));
  const seconds = {};
  const sums = { passed: 0, failed: 0 };
  const worker = async () => {
    for (let file = waiting.shift(); file; file = waiting.shift()) {
      const start = performance.now();
      const report = join(reports, `${file}.json`);
      const counts = await runTests(program, byFile.get(file), { report, env, minutes });
      seconds[file] = Math.round(performance.now() - start) / 1000;
      sums.passed += counts.passed;
      sums.failed += counts.failed;
    }
  };
  await Promise.all(Array.from({ length: cores }, worker));
  writeFileSync(timesPath, JSON.stringify(seconds));
  const longest = Object.entries(seconds).sort(([, a], [, b]) => b - a);
  const told = longest.slice(0, 5).map(([file, time]) => `${file} ${time.toFixed(1)} s`);
  console.log(`Longest: ${told.join(', ')}`);
  return sums;
}
