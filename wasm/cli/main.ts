import { createWriteStream } from 'node:fs';
import { readFile } from 'node:fs/promises';
import type { Readable, Writable } from 'node:stream';
import { finished } from 'node:stream/promises';
import { Arguments } from './arguments.js';
import { bench } from './bench.js';
import { centroid } from './centroid.js';
import { circle, ellipse } from './circle.js';
import type { Command } from './command.js';
import { compare } from './compare.js';
import { convert, repair } from './convert.js';
import { cut } from './cut.js';
import { distance } from './distance.js';
import { drawnFormat } from './drawn.js';
import { edit } from './edit.js';
import { UsageError } from './errors.js';
import { commandHelp, generalHelp } from './help.js';
import { info } from './info.js';
import { isolines } from './isolines.js';
import { exp, log, mirror, nearest, straightest, transport } from './maps.js';
import { mean } from './mean.js';
import { offset } from './offset.js';
import { formatOption, meshOptions, outOption } from './options.js';
import { jsonLine, type Pieces, print } from './output.js';
import { path } from './path.js';
import { regions } from './regions.js';
import { Terminal } from './terminal.js';
import { trace } from './trace.js';
import { voronoi } from './voronoi.js';
import { weights } from './weights.js';

const commands: readonly Command[] = [
  info,
  repair,
  convert,
  distance,
  isolines,
  path,
  straightest,
  log,
  exp,
  transport,
  mirror,
  nearest,
  mean,
  centroid,
  voronoi,
  weights,
  trace,
  edit,
  circle,
  ellipse,
  offset,
  regions,
  cut,
  bench,
  compare,
].map((command) => {
  const own = command.options.some(({ name }) => name === outOption.name);
  const options = [...command.options, ...meshOptions, ...(own ? [] : [outOption])];
  return { ...command, options };
});

/** The streams of a command: its input for '-', its result, and its messages. */
export interface Streams {
  stdin: Readable;
  stdout: Writable;
  stderr: Writable;
}

/** Runs `karcher` with these arguments, as a shell would, and returns its exit status. */
export async function main(
  args: readonly string[],
  { stdin, stdout, stderr }: Streams,
): Promise<number> {
  // If standard error is closed, nobody can read the message.
  stderr.on('error', () => {});
  const terminal = new Terminal(stderr);
  let status = 0;
  const tell = (sentence: string) => terminal.tell(sentence);
  const fail = (error: unknown, mesh?: string) => {
    const sentence = error instanceof Error ? error.message : String(error);
    tell(mesh === undefined || sentence.includes(mesh) ? sentence : `${mesh}: ${sentence}`);
    status = 1;
  };
  try {
    const { pieces, out } = await run(args, stdin, terminal, fail);
    if (out === undefined || out === '-') await print(pieces, stdout);
    else await printToFile(pieces, out);
  } catch (error) {
    fail(error);
  }
  return status;
}

/**
 * An output in pieces, and the file that receives it. Without a file, standard output receives it.
 */
interface Written {
  pieces: Pieces;
  out?: string;
}

async function run(
  [name, ...rest]: readonly string[],
  stdin: Readable,
  terminal: Terminal,
  fail: (error: unknown, mesh: string) => void,
): Promise<Written> {
  if (name === 'help' && rest[0] !== undefined) {
    return { pieces: [commandHelp(commandNamed(rest[0]))] };
  }
  if (name === '--help' || name === '-h' || name === 'help') {
    return { pieces: [generalHelp(commands)] };
  }
  if (name === '--version') return { pieces: [`${await version()}\n`] };
  const command = commandNamed(name);
  if (rest.includes('--help') || rest.includes('-h')) return { pieces: [commandHelp(command)] };
  const commandArguments = new Arguments(command, rest, stdin, (done, stage) =>
    terminal.show(done, stage),
  );
  const { meshes } = commandArguments;
  const toFile = command.options.includes(outOption) && commandArguments.given('out');
  const pieces =
    meshes.length > 1
      ? batch(command, commandArguments, terminal, fail)
      : await resultOf(command, commandArguments, terminal);
  return { pieces, ...(toFile && { out: commandArguments.text('out') }) };
}

async function resultOf(command: Command, args: Arguments, terminal: Terminal): Promise<Pieces> {
  const drawn = command.options.includes(formatOption) ? drawnFormat(args) : null;
  try {
    const { json, mesh, curves, bytes } = await command.run(args, (text) => terminal.tell(text));
    if (bytes) return [bytes];
    return drawn ? await drawn(mesh!, curves!()) : jsonLine(json);
  } finally {
    terminal.clear();
  }
}

/** A line of JSON for each mesh. If a mesh fails, `fail` reports it, and the next mesh follows. */
async function* batch(
  command: Command,
  args: Arguments,
  terminal: Terminal,
  fail: (error: unknown, mesh: string) => void,
): AsyncGenerator<string> {
  // The output for several meshes is JSON, so this call refuses the options of other formats.
  if (command.options.includes(formatOption)) drawnFormat(args);
  for (const mesh of args.meshes) {
    args.take(mesh);
    try {
      const { json } = await command.run(args, (text) => terminal.tell(text));
      terminal.clear();
      yield* jsonLine({ mesh, ...json });
    } catch (error) {
      fail(error, mesh);
    }
  }
}

function commandNamed(name: string | undefined): Command {
  const names = commands.map((command) => command.name).join(', ');
  if (name === undefined)
    throw new UsageError(`karcher needs a command: ${names}; 'karcher help' says more`);
  const command = commands.find((candidate) => candidate.name === name);
  if (command === undefined) {
    throw new UsageError(`karcher has no command '${name}'; it has ${names}`);
  }
  return command;
}

async function printToFile(pieces: Pieces, path: string): Promise<void> {
  const file = createWriteStream(path);
  const closed = finished(file);
  // `print` reports a failure that comes before the wait for `closed`.
  closed.catch(() => {});
  await print(pieces, file, path);
  file.end();
  await closed;
}

/** The version of the package. */
async function version(): Promise<string> {
  const text = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  return JSON.parse(text).version;
}
