// Functions that run programs, find them, and count checks.
import { spawn } from 'node:child_process';
import { accessSync, constants, existsSync, readdirSync, statSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { basename, delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The project's folder, with a slash at its end. */
export const root = fileURLToPath(new URL('..', import.meta.url));

export const cores = availableParallelism();

/** The path of `relative` in the project. */
export const inRoot = (relative) => join(root, relative);

/** The full path of a program on PATH, or undefined. */
export function which(program) {
  for (const folder of (process.env.PATH ?? '').split(delimiter)) {
    const path = join(folder, program);
    try {
      accessSync(path, constants.X_OK);
      if (statSync(path).isFile()) return path;
    } catch {
      // The program is not in this folder.
    }
  }
  return undefined;
}

/**
 * The files below `folder` (relative to the project) whose names match, sorted; none if the folder
 * does not exist.
 */
export function filesBelow(folder, pattern) {
  if (!existsSync(inRoot(folder))) return [];
  return readdirSync(inRoot(folder), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && pattern.test(entry.name))
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
}

/** The error of a program that did not end with status 0. */
export class CommandError extends Error {}

/**
 * Runs a program in the project's folder, without standard input, and waits for it.
 *
 * Its output goes to ours. With `quiet` the output becomes the resolved string, and lines show the
 * time now and then. Throws a `CommandError` (with the collected `output`) if the program cannot
 * start, fails, or exceeds `minutes`, after which it and its children are ended.
 */
export function run(program, args, { env = {}, quiet = false, minutes = 30 } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd: root,
      env: { ...process.env, ...env },
      stdio: ['ignore', quiet ? 'pipe' : 'inherit', quiet ? 'pipe' : 'inherit'],
      detached: true,
    });
    let output = '';
    let late = false;
    child.stdout?.on('data', (data) => (output += data));
    child.stderr?.on('data', (data) => (output += data));
    const endGroup = (signal) => {
      try {
        process.kill(-child.pid, signal);
      } catch {
        // The process has already ended.
      }
    };
    // The child leads its own process group, which can end as a whole. Therefore Ctrl-C has to be
    // passed on here.
    const passOn = (signal) => {
      endGroup(signal);
      process.exit(1);
    };
    const end = () => {
      late = true;
      endGroup('SIGKILL');
    };
    const started = performance.now();
    const patience = setInterval(() => {
      const seconds = Math.round((performance.now() - started) / 1000);
      console.error(`${basename(program)} goes on: ${seconds} s`);
    }, 25_000);
    if (!quiet) clearInterval(patience);
    const timer = minutes < Infinity ? setTimeout(end, minutes * 60_000) : undefined;
    process.on('SIGINT', passOn).on('SIGTERM', passOn);
    const settle = (problem) => {
      clearTimeout(timer);
      clearInterval(patience);
      process.off('SIGINT', passOn).off('SIGTERM', passOn);
      if (!problem) return resolve(output);
      const error = new CommandError(`${program} ${args[0] ?? ''}: ${problem}`);
      error.output = output;
      reject(error);
    };
    child.on('error', (error) => settle(error.message));
    child.on('close', (status, signal) => {
      if (late) settle(`not done after ${minutes} minutes`);
      else if (signal) settle(`ended by ${signal}`);
      else settle(status === 0 ? undefined : `exit status ${status}`);
    });
  });
}

/** Calls `work` with each entry, `atOnce` at a time, and sums its counts of checks. */
export async function countAll(entries, work, atOnce = cores) {
  const counts = { passed: 0, failed: 0 };
  const waiting = [...entries];
  const worker = async () => {
    for (let next = waiting.shift(); next; next = waiting.shift()) {
      const { passed, failed } = await work(next);
      counts.passed += passed;
      counts.failed += failed;
    }
  };
  await Promise.all(Array.from({ length: atOnce }, worker));
  return counts;
}

/**
 * Runs stages one after another, prints the time of each, and a table at the end.
 *
 * A stage is `{ name, run, isBuild }`. `run` may return `{ passed, failed }`, the counts of its
 * tests; otherwise the stage counts as one. A stage that throws, or counts no test, has failed;
 * later stages still run. Returns the sums; the seconds of builds also have a sum of their own.
 */
export async function runStages(stages) {
  const rows = [];
  for (const stage of stages) {
    console.log(`\n== ${stage.name}`);
    const start = performance.now();
    let counts;
    try {
      const result = await stage.run();
      counts = typeof result === 'object' ? result : { passed: 1, failed: 0 };
      if (counts.passed + counts.failed === 0) {
        console.error(`${stage.name}: no test ran`);
        counts = { passed: 0, failed: 1 };
      }
    } catch (error) {
      console.error(error instanceof CommandError ? error.message : error);
      counts = { passed: 0, failed: 1 };
    }
    const seconds = (performance.now() - start) / 1000;
    rows.push({ name: stage.name, isBuild: stage.isBuild, seconds, ...counts });
  }
  const width = Math.max(...rows.map((row) => row.name.length));
  console.log('');
  for (const { name, seconds, passed, failed } of rows) {
    const time = seconds.toFixed(1).padStart(7);
    console.log(`${name.padEnd(width)} ${time} s  ${passed} passed, ${failed} failed`);
  }
  const sum = (key, of = rows) => of.reduce((total, row) => total + row[key], 0);
  return {
    passed: sum('passed'),
    failed: sum('failed'),
    seconds: sum('seconds'),
    buildSeconds: sum(
      'seconds',
      rows.filter(({ isBuild }) => isBuild),
    ),
  };
}

const inMinutes = (seconds) => `${(seconds / 60).toFixed(1)} minutes`;

/** Prints the closing line that scripts read, and sets the exit status. */
export function closeWith({ passed, failed, seconds, buildSeconds }) {
  const parts =
    buildSeconds > 0
      ? ` (builds ${inMinutes(buildSeconds)}, the rest ${inMinutes(seconds - buildSeconds)})`
      : '';
  console.log(`\nIn ${inMinutes(seconds)}${parts}:`);
  console.log(`${passed} passed, ${failed} failed`);
  process.exitCode = failed > 0 ? 1 : 0;
}
