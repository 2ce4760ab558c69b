import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const program = fileURLToPath(new URL('./cli.js', import.meta.resolve('karcher')));

/** Runs `karcher` as a shell would: {status, stdout, stderr}. */
export function karcher(...args) {
  return spawnSync(process.execPath, [program, ...args], {
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
  });
}

// How far a command is that has taken two seconds: on a slow machine others print it too.
const progress = /^karcher: \w+: [^\n]+, \d+ %\n/gm;

/**
 * The JSON object that a command printed. Throws if it failed or printed anything else but its
 * progress.
 */
export function printed(...args) {
  const { status, stdout, stderr } = karcher(...args);
  if (status !== 0 || stderr.replace(progress, '') !== '')
    throw new Error(`karcher ${args.join(' ')}: ${stderr}`);
  return JSON.parse(stdout);
}

/** The sentence with which a command failed: alone on standard error, with exit status 1. */
export function failure(...args) {
  const { status, stdout, stderr } = karcher(...args);
  if (status !== 1 || stdout !== '' || !/^karcher: [^\n]+\n$/.test(stderr)) {
    throw new Error(`karcher ${args.join(' ')}: status ${status}, '${stdout}', '${stderr}'`);
  }
  return stderr.slice('karcher: '.length, -1);
}

/** A folder of files for a test file: `folder.write(name, text)` gives the path. */
export function temporaryFolder() {
  const path = mkdtempSync(join(tmpdir(), 'karcher-'));
  return {
    path,
    write(name, text) {
      const file = join(path, name);
      writeFileSync(file, text);
      return file;
    },
    remove: () => rmSync(path, { recursive: true }),
  };
}

export { program };
