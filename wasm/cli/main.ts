import { createWriteStream } from 'node:fs';
import { readFile } from 'node:fs/promises';
import type { Readable, Writable } from 'node:stream';
import { finished } from 'node:stream/promises';
import { Arguments } from './arguments.js';
import { bench } from './bench.js';
import { circle, ellipse } from './circle.js';
import { type Command, meshOptions, outOption } from './command.js';
import { compare } from './compare.js';
import { cut } from './cut.js';
import { distance } from './distance.js';
import { edit } from './edit.js';
import { UsageError } from './errors.js';
import { commandHelp, generalHelp } from './help.js';
import { info } from './info.js';
import { mean } from './mean.js';
import { jsonLine, polylinesAsObj, print, printable } from './output.js';
import { path } from './path.js';
import { regions } from './regions.js';
import { trace } from './trace.js';
import { weights } from './weights.js';

const commands: readonly Command[] = [
  info,
  distance,
  path,
  mean,
  weights,
  trace,
  edit,
  circle,
  ellipse,
  regions,
  cut,
  bench,
  compare,
].map((command) => {
  const own = command.options.some(({ name }) => name === outOption.name);
  const options = [...command.options, ...meshOptions, ...(own ? [] : [outOption])];
  return { ...command, options };
});

/** What a command reads for '-', and where it writes: its result, and what went wrong. */
export interface Streams {
  stdin: Readable;
  stdout: Writable;
  stderr: Writable;
}

/** Runs `karcher` with these arguments, as a shell would, and gives its exit status. */
export async function main(
  args: readonly string[],
  { stdin, stdout, stderr }: Streams,
): Promise<number> {
  // A closed standard error leaves nobody to tell.
  stderr.on('error', () => {});
  const tell = (sentence: string) => stderr.write(`karcher: ${printable(sentence)}\n`);
  try {
    const { pieces, out } = await run(args, stdin, tell);
    if (out === undefined || out === '-') await print(pieces, stdout);
    else await printToFile(pieces, out);
    return 0;
  } catch (error) {
    tell(error instanceof Error ? error.message : String(error));
    return 1;
  }
}

/** A text in pieces, and the file that it goes to, if not to standard output. */
interface Written {
  pieces: Iterable<string>;
  out?: string;
}

async function run(
  [name, ...rest]: readonly string[],
  stdin: Readable,
  tell: (sentence: string) => void,
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
  const commandArguments = new Arguments(command, rest, stdin);
  const drawn =
    command.options.some((option) => option.name === 'format') &&
    commandArguments.choice('format') === 'obj';
  const { json, polylines } = await command.run(commandArguments, tell);
  const toFile = command.options.includes(outOption) && commandArguments.given('out');
  return {
    pieces: drawn ? polylinesAsObj(polylines!) : jsonLine(json),
    ...(toFile && { out: commandArguments.text('out') }),
  };
}

function commandNamed(name: string | undefined): Command {
  const names = commands.map((command) => command.name).join(', ');
  if (name === undefined) throw new UsageError(`karcher needs a command: ${names}`);
  const command = commands.find((candidate) => candidate.name === name);
  if (command === undefined) {
    throw new UsageError(`karcher has no command '${name}'; it has ${names}`);
  }
  return command;
}

async function printToFile(pieces: Iterable<string>, path: string): Promise<void> {
  const file = createWriteStream(path);
  const closed = finished(file);
  // Awaited below; what fails before is said by `print`.
  closed.catch(() => {});
  await print(pieces, file, path);
  file.end();
  await closed;
}

/** The package's. */
async function version(): Promise<string> {
  const text = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  return JSON.parse(text).version;
}
