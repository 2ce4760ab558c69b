// Runs a program of GoogleTest in parts. The tests of each source file run in a separate process,
// since they share data that is costly to set up.
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { runLongestFirst } from './longest_first.mjs';
import { run } from './shell.mjs';

const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'));

/** The names of the tests of each source file. */
async function testsByFile(program, report) {
  await run(program, ['--gtest_list_tests', `--gtest_output=json:${report}`], { quiet: true });
  const byFile = new Map();
  for (const suite of readJson(report).testsuites) {
    for (const { name, file } of suite.testsuite) {
      const source = basename(file);
      const test = `${suite.name}.${name}`;
      byFile.set(source, [...(byFile.get(source) ?? []), test]);
    }
  }
  return byFile;
}

/**
 * Runs some tests, prints their output or the reason of their failure, and returns the counts of
 * their report.
 */
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
  // After a good run only the tests' own output appears; after a bad one the name of the last test
  // appears, too.
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
 * Runs all tests of a program and returns their counts. `reports` is the folder for its reports.
 */
export async function runGoogleTest(program, { reports, env, minutes }) {
  mkdirSync(reports, { recursive: true });
  const byFile = await testsByFile(program, join(reports, 'list.json'));
  return runLongestFirst([...byFile.keys()], join(reports, 'seconds.json'), (file) =>
    runTests(program, byFile.get(file), { report: join(reports, `${file}.json`), env, minutes }),
  );
}
