// `npm run fuzz -- [MINUTES] [TARGET...]`: libFuzzer on the targets in tests/fuzz, with the address
// and undefined-behaviour sanitizers. Each runs for the given time (by default a minute), as many
// at a time as there are cores. Useful inputs stay in build/fuzz/corpus, where the next run
// continues; an input that is a finding goes to build/fuzz/findings.
import { mkdirSync, readdirSync } from 'node:fs';
import { basename } from 'node:path';
import { buildNative } from './build.mjs';
import { setUp } from './setup.mjs';
import { closeWith, countAll, filesBelow, inRoot, run, runStages } from './shell.mjs';

const usage = 'Usage: npm run fuzz -- [MINUTES] [TARGET...]';
/**
 * The longest time, in seconds, for an input on a busy machine. Ordinary inputs take milliseconds.
 */
const patience = 300;
/** The largest input, in bytes. No case of a target uses more. */
const mostBytes = 1024;

const targets = filesBelow('tests/fuzz/targets', /^fuzz_target_\w+\.cpp$/).map(
  (file) => /fuzz_target_(\w+)\.cpp$/.exec(basename(file))[1],
);

function readArguments() {
  const [first = '1', ...names] = process.argv.slice(2);
  const minutes = Number(first);
  if (!(minutes > 0 && minutes <= 1440)) throw new Error(usage);
  const unknown = names.find((name) => !targets.includes(name));
  if (unknown) throw new Error(`There is no target '${unknown}': ${targets.join(', ')}.`);
  return { minutes, names: names.length > 0 ? names : targets };
}

const folder = (name) => {
  const path = inRoot(`build/fuzz/${name}`);
  mkdirSync(path, { recursive: true });
  return path;
};

/** Runs a target, which counts as one check, and prints the number of inputs that it tried. */
async function fuzz(name, minutes) {
  const corpus = folder(`corpus/${name}`);
  const findings = folder('findings');
  const before = new Set(readdirSync(findings));
  const args = [
    ...[corpus, inRoot(`build/fuzz/seeds/${name}`)],
    `-max_total_time=${Math.ceil(60 * minutes)}`,
    ...[`-timeout=${patience}`, `-max_len=${mostBytes}`, '-rss_limit_mb=3072'],
    ...['-len_control=10', '-print_final_stats=1', `-artifact_prefix=${findings}/${name}-`],
  ];
  let output;
  let problem;
  try {
    const env = { UBSAN_OPTIONS: 'print_stacktrace=1' };
    output = await run(inRoot(`build/sanitize/fuzz_target_${name}`), args, {
      ...{ env, quiet: true, minutes: minutes + 10 },
    });
  } catch (error) {
    output = error.output ?? '';
    problem = error;
  }
  const tried = Number(/stat::number_of_executed_units:\s*(\d+)/.exec(output)?.[1] ?? 0);
  const kept = readdirSync(corpus).length;
  const found = readdirSync(findings).filter(
    (file) => file.startsWith(`${name}-`) && !before.has(file),
  );
  if (problem) console.error(output.split('\n').slice(-60).join('\n'));
  for (const file of found) console.error(`The input is build/fuzz/findings/${file}`);
  console.log(
    `${name}: ${tried.toLocaleString('en')} inputs in ${minutes} minutes, ${kept.toLocaleString('en')} kept, ${problem ? 'a failure' : 'no failure'}`,
  );
  if (problem) console.error(problem.message);
  else if (tried === 0) console.error(`${name} tried no input`);
  const failed = problem || tried === 0 ? 1 : 0;
  return { passed: 1 - failed, failed };
}

try {
  const { minutes, names } = readArguments();
  const build = async () => {
    await setUp('build', 'fuzz');
    // The engine is the one of the tests with sanitizers.
    await buildNative('sanitize', 'fuzz_corpus', ...targets.map((name) => `fuzz_target_${name}`));
    await run(inRoot('build/sanitize/fuzz_corpus'), [folder('seeds')]);
  };
  closeWith(
    await runStages([
      { name: 'build of the fuzz targets', run: build, isBuild: true },
      { name: 'fuzzing', run: () => countAll(names, (name) => fuzz(name, minutes)) },
    ]),
  );
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
}
