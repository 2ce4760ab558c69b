// `npm run coverage`: builds the engine with gcov's counters and runs its tests. It prints the
// share of the lines of src that they run, by folder, and each line that they do not run, with the
// reason that docs/coverage.md gives for its function. It fails under 95 %, and if a function with
// such lines has no reason. The last lines of functions and the heads of classes need none: there
// gcov counts the clean-up after an error.
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { dirname, relative, resolve } from 'node:path';
import { buildNative, writeBunny } from './build.mjs';
import { runGoogleTest } from './gtest.mjs';
import { setUp } from './setup.mjs';
import { filesBelow, inRoot, root } from './shell.mjs';

const leastPercent = 95;
const folder = 'build/coverage';
const mostOutput = 1 << 30;

/**
 * The function of each line of src, and the number of times that the line ran, by file and line.
 */
function readCounts() {
  const counts = new Map();
  for (const data of filesBelow(folder, /\.gcda$/)) {
    const { stdout, status } = spawnSync(
      'gcov',
      ['--json-format', '--stdout', '--demangled-names', data],
      { cwd: dirname(data), encoding: 'utf8', maxBuffer: mostOutput },
    );
    if (status !== 0) throw new Error(`gcov cannot read ${data}`);
    const report = JSON.parse(stdout.slice(0, stdout.lastIndexOf('}') + 1));
    for (const { file, lines, functions } of report.files) {
      const path = relative(root, resolve(report.current_working_directory, file));
      if (!path.startsWith('src/')) continue;
      const names = new Map(functions.map(({ name, demangled_name }) => [name, demangled_name]));
      if (!counts.has(path)) counts.set(path, new Map());
      const ofFile = counts.get(path);
      for (const { line_number, count, function_name } of lines) {
        const known = ofFile.get(line_number);
        const name = shortName(names.get(function_name) ?? '') || 'inlined';
        ofFile.set(line_number, { count: (known?.count ?? 0) + count, name });
      }
    }
  }
  return counts;
}

/** The name of a function without its parameters, its result and our namespace. */
function shortName(demangled) {
  const plain = demangled
    .replaceAll('(anonymous namespace)::', '')
    .replaceAll('karcher::', '')
    .replace(/\[abi:cxx11\]/g, '');
  const [head] = plain.split('(');
  return head.replace(/<.*>/g, '').split(' ').at(-1);
}

/** The reasons of docs/coverage.md, by 'file function'. */
function readReasons() {
  const path = inRoot('docs/coverage.md');
  if (!existsSync(path)) return new Map();
  const rows = readFileSync(path, 'utf8').matchAll(/^\| `(src\/[^`]+)` \| `([^`]+)` \| (.+) \|$/gm);
  return new Map([...rows].map(([, file, name, reason]) => [`${file} ${name}`, reason]));
}

function percent(covered, all) {
  return ((100 * covered) / all).toFixed(2);
}

function printFolders(counts) {
  const folders = new Map();
  for (const [file, lines] of counts) {
    const name = dirname(file);
    const sums = folders.get(name) ?? { all: 0, covered: 0 };
    for (const { count } of lines.values()) {
      sums.all++;
      sums.covered += count > 0;
    }
    folders.set(name, sums);
  }
  console.log('| folder | lines | run | % |\n| --- | --- | --- | --- |');
  const whole = { all: 0, covered: 0 };
  for (const [name, { all, covered }] of [...folders].sort()) {
    console.log(`| ${name} | ${all} | ${covered} | ${percent(covered, all)} |`);
    whole.all += all;
    whole.covered += covered;
  }
  return whole;
}

/** Prints each function with lines that do not run, and counts those without a reason. */
function printUncovered(counts) {
  const reasons = readReasons();
  let without = 0;
  console.log('\nNot run:');
  for (const [file, lines] of [...counts].sort()) {
    const byFunction = new Map();
    const source = readFileSync(inRoot(file), 'utf8').split('\n');
    for (const [line, { count, name }] of [...lines].sort(([a], [b]) => a - b)) {
      if (count > 0 || /^\s*(\}|class |struct )/.test(source[line - 1])) continue;
      byFunction.set(name, [...(byFunction.get(name) ?? []), line]);
    }
    for (const [name, numbers] of byFunction) {
      const reason = reasons.get(`${file} ${name}`);
      without += !reason;
      console.log(`${file}:${numbers.join(',')} ${name}: ${reason ?? 'NO REASON'}`);
    }
  }
  return without;
}

async function main() {
  await setUp('build', 'native');
  await writeBunny();
  await buildNative('coverage', 'karcher_tests');
  for (const data of filesBelow(folder, /\.gcda$/)) rmSync(data);
  // Processes that end at the same time wait for each other, since they add to the same counters.
  const { failed } = await runGoogleTest(inRoot(`${folder}/karcher_tests`), {
    reports: inRoot('build/reports/coverage'),
    minutes: 60,
  });
  if (failed > 0) throw new Error(`${failed} tests failed`);
  const counts = readCounts();
  const { all, covered } = printFolders(counts);
  const without = printUncovered(counts);
  const share = percent(covered, all);
  console.log(`\n${share} % of ${all} lines of src run in the engine's tests`);
  if (without > 0) throw new Error(`${without} functions have no reason in docs/coverage.md`);
  if (Number(share) < leastPercent)
    throw new Error(`the tests run less than ${leastPercent} % of the lines`);
}

try {
  await main();
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
