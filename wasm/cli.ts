#!/usr/bin/env node
import { readFile } from 'node:fs/promises';
import { Arguments } from './cli/arguments.js';
import { bench } from './cli/bench.js';
import { circle, ellipse } from './cli/circle.js';
import { type Command, meshOptions } from './cli/command.js';
import { compare } from './cli/compare.js';
import { distance } from './cli/distance.js';
import { edit } from './cli/edit.js';
import { UsageError } from './cli/errors.js';
import { commandHelp, generalHelp } from './cli/help.js';
import { info } from './cli/info.js';
import { mean } from './cli/mean.js';
import { jsonPieces, polylinesAsObj, print } from './cli/output.js';
import { path } from './cli/path.js';
import { trace } from './cli/trace.js';
import { weights } from './cli/weights.js';

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

async function run(args: string[]): Promise<void> {
  const [name, ...rest] = args;
  if (name === '--help' || name === '-h' || name === 'help') return print([generalHelp(commands)]);
  if (name === '--version') return print([`${await version()}\n`]);
  const names = commands.map((command) => command.name).join(', ');
  if (name === undefined) throw new UsageError(`karcher needs a command: ${names}`);
  const command = commands.find((candidate) => candidate.name === name);
  if (command === undefined) {
    throw new UsageError(`karcher has no command '${name}'; it has ${names}`);
  }
  if (rest.includes('--help') || rest.includes('-h')) return print([commandHelp(command)]);
  const commandArguments = new Arguments(command, rest);
  const drawn =
    command.options.some((option) => option.name === 'format') &&
    commandArguments.choice('format') === 'obj';
  const { json, polylines } = await command.run(commandArguments);
  await print(drawn ? polylinesAsObj(polylines!) : jsonPieces(json));
  if (!drawn) await print(['\n']);
}

/** The package's. */
async function version(): Promise<string> {
  const text = await readFile(new URL('../package.json', import.meta.url), 'utf8');
  return JSON.parse(text).version;
}

// A closed standard error leaves nobody to tell.
process.stderr.on('error', () => {});
try {
  await run(process.argv.slice(2));
} catch (error) {
  process.stderr.write(`karcher: ${error instanceof Error ? error.message : String(error)}\n`);
  process.exitCode = 1;
}
