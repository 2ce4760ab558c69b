// `npm test`: sets up, builds everything and runs every test. With --long, the optimised builds
// only, and the engine's tests draw the large numbers of random cases that they keep for
// KARCHER_LONG=1.
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { buildFacade, buildNative, buildPage, buildWasm, writeBunny } from './build.mjs';
import { chromiumPath, setUp } from './setup.mjs';
import { closeWith, cores, filesBelow, inRoot, run, runStages } from './shell.mjs';

const long = process.argv.includes('--long');
const longCases = long ? { KARCHER_LONG: '1' } : {};
const minutes = long ? 120 : 15;
const reports = inRoot('build/reports');

/** Runs one part of a GoogleTest program and returns what its report counted. */
async function runShard(preset, shard, shards) {
  const report = `${reports}/${preset}-${shard}.json`;
  rmSync(report, { force: true });
  const env = {
    GTEST_TOTAL_SHARDS: `${shards}`,
    GTEST_SHARD_INDEX: `${shard}`,
    UBSAN_OPTIONS: 'print_stacktrace=1',
    ...longCases,
  };
  const args = [`--gtest_output=json:${report}`];
  let problem;
  let output;
  try {
    output = await run(inRoot(`build/${preset}/karcher_tests`), args, {
      env,
      quiet: true,
      minutes,
    });
  } catch (error) {
    problem = error;
    output = error.output ?? '';
  }
  // Of a good run only what the tests print themselves; of a bad one also which test was last.
  const lines = output
    .split('\n')
    .filter((line) => line && (problem || !/^\[[ =\-A-Z]+\]/.test(line)));
  console.log(lines.join('\n'));
  let counts = { passed: 0, failed: 0 };
  try {
    const { testsuites } = JSON.parse(readFileSync(report, 'utf8'));
    const tests = testsuites.flatMap((suite) => suite.testsuite);
    const ran = tests.filter((test) => test.status === 'RUN' && test.result !== 'SKIPPED');
    const failed = ran.filter((test) => test.failures?.length > 0).length;
    counts = { passed: ran.length - failed, failed };
  } catch {
    problem ??= new Error(`${preset}: the tests wrote no report`);
  }
  if (problem && counts.failed === 0) {
    console.error(problem.message);
    counts.failed = 1;
  }
  return counts;
}

async function runNative(preset) {
  // More than there are cores: some take longer than others.
  const shards = 2 * cores;
  const running = Array.from({ length: shards }, (_, shard) => runShard(preset, shard, shards));
  const counts = await Promise.all(running);
  const sum = (key) => counts.reduce((total, count) => total + count[key], 0);
  return { passed: sum('passed'), failed: sum('failed') };
}

/** Runs the node:test files of a folder and returns what they counted. */
async function runNode(folder, env = {}) {
  const files = filesBelow(folder, /\.test\.m?js$/);
  if (files.length === 0) throw new Error(`there are no tests in ${folder}`);
  const report = `${reports}/${folder.replaceAll('/', '-')}.tap`;
  rmSync(report, { force: true });
  const reporters = ['spec', 'stdout', 'tap', report];
  const args = reporters.map(
    (value, i) => `--test-reporter${i % 2 ? '-destination' : ''}=${value}`,
  );
  let problem;
  try {
    await run(process.execPath, ['--test', `--test-concurrency=${cores}`, ...args, ...files], {
      env,
      minutes,
    });
  } catch (error) {
    problem = error;
  }
  const tap = readFileSync(report, 'utf8');
  const count = (key) => Number(new RegExp(`^# ${key} (\\d+)$`, 'm').exec(tap)?.[1] ?? 0);
  const counts = { passed: count('pass'), failed: count('fail') + count('cancelled') };
  if (problem && counts.failed === 0) {
    console.error(problem.message);
    counts.failed = 1;
  }
  return counts;
}

const nativeTests = (preset) => async () => {
  await writeBunny();
  await buildNative(preset, 'karcher_tests');
  return runNative(preset);
};

await setUp('build', 'test');
mkdirSync(reports, { recursive: true });

const stages = [
  { name: 'native tests, g++', run: nativeTests('native') },
  { name: 'native tests, clang++ with sanitizers', run: nativeTests('sanitize'), short: true },
  { name: 'build of the WebAssembly module', run: buildWasm },
  { name: 'build of the facade', run: buildFacade },
  { name: 'build of the page', run: buildPage },
  { name: 'tests of the module and the command line', run: () => runNode('tests/wasm') },
  { name: 'tests of the figures', run: () => runNode('tests/paper') },
  {
    name: 'tests of the page',
    run: () => runNode('tests/web', { CHROMIUM_PATH: chromiumPath(), ...longCases }),
  },
];
closeWith(await runStages(stages.filter((stage) => !long || !stage.short)));
