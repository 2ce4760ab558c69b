import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Readable, Writable } from 'node:stream';
import { fileURLToPath } from 'node:url';

const { main } = await import(new URL('./cli/main.js', import.meta.resolve('karcher')));

const program = fileURLToPath(new URL('./cli.js', import.meta.resolve('karcher')));

/** A stream that keeps the written text; `text()` returns it. */
function written() {
  const pieces = [];
  const stream = new Writable({
    write(piece, _encoding, done) {
      pieces.push(piece);
      done();
    },
  });
  return { stream, text: () => Buffer.concat(pieces).toString('utf8') };
}

/** Runs `karcher` in this process, as a shell would in its own: {status, stdout, stderr}. */
export const karcher = (...args) => karcherReading('', ...args);

/** Runs it with a text as standard input. */
export async function karcherReading(text, ...args) {
  const stdin = Readable.from([Buffer.from(text)]);
  const [stdout, stderr] = [written(), written()];
  const status = await main(args, { stdin, stdout: stdout.stream, stderr: stderr.stream });
  return { status, stdout: stdout.text(), stderr: stderr.text() };
}

/** Runs `karcher` in a process of its own; `begun` receives the process once it has started. */
export async function karcherProcess(args, begun = () => {}) {
  const child = spawn(process.execPath, [program, ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
  const said = { stdout: '', stderr: '' };
  for (const name of Object.keys(said)) {
    child[name].setEncoding('utf8').on('data', (text) => {
      said[name] += text;
    });
  }
  begun(child);
  const [status, signal] = await new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('close', (...how) => resolve(how));
  });
  return { status, signal, ...said };
}

// The progress of a command after two seconds, which on a slow machine other commands print, too.
const progress = /^karcher: \w+: [^\n]+, \d+ %\n/gm;

/** The JSON output of a command. Throws if it failed or printed anything besides its progress. */
export async function printed(...args) {
  const { status, stdout, stderr } = await karcher(...args);
  if (status !== 0 || stderr.replace(progress, '') !== '')
    throw new Error(`karcher ${args.join(' ')}: ${stderr}`);
  return JSON.parse(stdout);
}

/** The sentence of a failed command: alone on standard error, with exit status 1. */
export async function failure(...args) {
  const { status, stdout, stderr } = await karcher(...args);
  if (status !== 1 || stdout !== '' || !/^karcher: [^\n]+\n$/.test(stderr)) {
    throw new Error(`karcher ${args.join(' ')}: status ${status}, '${stdout}', '${stderr}'`);
  }
  return stderr.slice('karcher: '.length, -1);
}

/** A folder of files for a test file: `folder.write(name, text)` returns the path. */
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
