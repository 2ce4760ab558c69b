// `npm test`: sets up, builds everything and runs the tests, always the same ones. --long adds the tests that
// are too long for `npm test`, and the large numbers of random cases of KARCHER_LONG=1, except those of the
// engine with the sanitizers, which would take hours. `--meshes FOLDER` names the folder of the meshes for
// saved studies, which then run again. With names of files of tests/wasm, tests/paper and tests/web, only these
// files run. With --whole, everything runs, in the named files also the tests that are too long for `npm test`.
import { mkdirSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { buildBook, buildFacade, buildNative, buildPage, buildWasm, writeBunny } from './build.mjs';
import { runGoogleTest } from './gtest.mjs';
import { alone, dealt, runGroups } from './node_test.mjs';
import { chromiumPath, setUp } from './setup.mjs';
import { closeWith, cores, filesBelow, inRoot, runStages } from './shell.mjs';

const { values: options, positionals: named } = parseArgs({
  options: { long: { type: 'boolean' }, meshes: { type: 'string' }, whole: { type: 'boolean' } },
  allowPositionals: true,
});
const { long, meshes } = options;
const whole = options.whole ? named.map(inRoot) : [];
const longCases = {
  ...(long && { KARCHER_LONG: '1' }),
  ...(meshes && { KARCHER_MESHES: resolve(process.env.INIT_CWD ?? '.', meshes) }),
};
// The limit for a stage, in minutes. A stage that takes longer hangs, even on a busy machine.
const minutes = long ? 120 : 40;
const reports = inRoot('build/reports');

const runNative = (preset, more, program = 'karcher_tests') =>
  runGoogleTest(inRoot(`build/${preset}/${program}`), {
    ...{ reports: `${reports}/${preset}`, minutes },
    ...more,
  });

const nodeFiles = (folder) => filesBelow(folder, /\.test\.m?js$/);

/** Whether a file's tests drive the page by browser.mjs. */
const drivesPage = (file) => readFileSync(file, 'utf8').includes("from './browser.mjs'");

/** The number of files that share a process and browsers: a start costs three page openings. */
const sharing = 5;

/** Runs files of node:test and returns their counts. */
function runNode(folder, env = {}, files = nodeFiles(folder)) {
  if (files.length === 0) throw new Error(`there are no tests in ${folder}`);
  const asWhole = files.filter((file) => whole.includes(file));
  const others = files.filter((file) => !whole.includes(file));
  const pages = others.filter(drivesPage);
  const groups = [
    ...alone(asWhole, { KARCHER_LONG: '1' }),
    ...alone(others.filter((file) => !pages.includes(file))),
    ...(long ? alone(pages) : dealt(pages, sharing)),
  ];
  return runGroups(groups, {
    reports: `${reports}/${folder.replaceAll('/', '-')}`,
    env,
    minutes,
    // A page waits for frames and timers, so that one more keeps the cores busy.
    ...(pages.length > 0 && { atOnce: cores + 1 }),
  });
}

const build = (what, work, more) => ({
  name: `build of ${what}`,
  run: work,
  isBuild: true,
  ...more,
});
const tests = (what, work, more) => ({ name: `tests of ${what}`, run: work, ...more });
async function buildNativeTests(preset) {
  await writeBunny();
  await buildNative(preset, 'karcher_tests');
}

const longestSanitized = long ? { KARCHER_SANITIZED: 'all' } : {};
const sanitized = { UBSAN_OPTIONS: 'print_stacktrace=1', ...longestSanitized };
const setUpStage = { name: 'set-up', run: () => setUp('build', 'test'), isBuild: true };
const packageBuilds = [
  build('the WebAssembly module', buildWasm),
  build('the facade', buildFacade),
  build('the page', buildPage),
  build('the book', buildBook),
];
/** The tests of threads, too long for `npm test`: they compile the engine once more. */
const threads = [
  build('the engine’s tests of threads, g++ with ThreadSanitizer', () =>
    buildNative('threads', 'karcher_thread_tests'),
  ),
  tests('threads, g++ with ThreadSanitizer', () =>
    runNative('threads', {}, 'karcher_thread_tests'),
  ),
];
const everything = [
  setUpStage,
  build('the engine’s tests, g++', () => buildNativeTests('native')),
  build('the engine’s tests, clang++ with sanitizers', () => buildNativeTests('sanitize')),
  ...packageBuilds,
  ...(long ? threads : []),
  tests('the tools', () => runNode('tests/tools')),
  tests('the engine, g++', () => runNative('native', { env: longCases })),
  tests('the engine, clang++ with sanitizers', () => runNative('sanitize', { env: sanitized })),
  tests('the module and the command line', () => runNode('tests/wasm', longCases)),
  tests('the figures', () => runNode('tests/paper', longCases)),
  tests('the page', () => runNode('tests/web', { CHROMIUM_PATH: chromiumPath(), ...longCases })),
];

/** Throws if a name is no file of tests/wasm, tests/paper or tests/web. */
function checkNames() {
  const known = ['tests/wasm', 'tests/paper', 'tests/web'].flatMap(nodeFiles);
  const unknown = named.find((file) => !known.includes(inRoot(file)));
  if (unknown)
    throw new Error(`${unknown} is no file of tests in tests/wasm, tests/paper or tests/web`);
}

/** The stages of some files of tests/wasm, tests/paper and tests/web alone. */
function stagesOf(files) {
  const run = () =>
    runNode(
      'long',
      { CHROMIUM_PATH: chromiumPath(), ...longCases },
      files.map((file) => inRoot(file)),
    );
  return [setUpStage, ...packageBuilds, tests(files.join(', '), run)];
}

mkdirSync(reports, { recursive: true });
checkNames();
const some = named.length > 0 && !options.whole;
closeWith(await runStages(some ? stagesOf(named) : everything));
