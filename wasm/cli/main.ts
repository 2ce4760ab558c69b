import { readFile } from 'node:fs/promises';
import type { Writable } from 'node:stream';
import { Arguments } from './arguments.js';
import { bench } from './bench.js';
import { circle, ellipse } from './circle.js';
import { type Command, meshOptions } from './command.js';
import { compare } from './compare.js';
import { distance } from './distance.js';
import { edit } from './edit.js';
import { UsageError } from './errors.js';
import { commandHelp, generalHelp } from './help.js';
import { info } from './info.js';
import { mean } from './mean.js';
import { jsonLine, polylinesAsObj, print, printable } from './output.js';
import { path } from './path.js';
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
  bench,
  compare,
].map((command) => ({ ...command, options: [...command.options, ...meshOptions] }));

/** Where a command writes: its result, and what went wrong. */
export interface Streams {
  stdout: Writable;
  stderr: Writable;
}

/** Runs `karcher` with these arguments, as a shell would, and gives its exit status. */
export async function main(args: readonly string[], { stdout, stderr }: Streams): Promise<number> {
  // A closed standard error leaves nobody to tell.
  stderr.on('error', () => {});
  const tell = (sentence: string) => stderr.write(`karcher: ${printable(sentence)}\n`);
  try {
    await print(await run(args, tell), stdout);
    return 0;
  } catch (error) {
    tell(error instanceof Error ? error.message : String(error));
    return 1;
  }
}

/** What is written to standard output, in pieces. */
async function run(
  [name, ...rest]: readonly string[],
  tell: (sentence: string) => void,
): Promise<Iterable<string>> {
  if (name === '--help' || name === '-h' || name === 'help') return [generalHelp(commands)];
  if (name === '--version') return [`${await version()}\n`];
  const names = commands.map((command) => command.name).join(', ');
  if (name === undefined) throw new UsageError(`karcher needs a command: ${names}`);
  const command = commands.find((candidate) => candidate.name === name);
  if (command === undefined) {
    throw new UsageError(`karcher has no command '${name}'; it has ${names}`);
  }
  if (rest.includes('--help') || rest.includes('-h')) return [commandHelp(command)];
  const commandArguments = new Arguments(command, rest);
  const drawn =
    command.options.some((option) => option.name === 'format') &&
    commandArguments.choice('format') === 'obj';
  const { json, polylines } = await command.run(commandArguments, tell);
  return drawn ? polylinesAsObj(polylines!) : jsonLine(json);
}

/** The package's. */
async function version(): Promise<string> {
  const text = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  return JSON.parse(text).version;
}
