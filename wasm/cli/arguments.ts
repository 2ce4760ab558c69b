import { readFile } from 'node:fs/promises';
import { basename, dirname, extname, join } from 'node:path';
import type { Readable } from 'node:stream';
import { buffer } from 'node:stream/consumers';
import { parseArgs } from 'node:util';
import type { FileInfo } from '../formats/index.js';
import type { Karcher } from '../karcher.js';
import { load } from '../load.js';
import type { Mesh } from '../mesh.js';
import type {
  CurveLevels,
  FieldOptions,
  MeshOptions,
  Method,
  PointLike,
  Progress,
  Solver,
  Star,
} from '../types.js';
import { fileError, UsageError } from './errors.js';
import { type Described, formatOption, type Option, outOption } from './options.js';
import { decimalOf, isJson, parseNumber, parsePoint, parsePoints, parseRows } from './syntax.js';

/**
 * The checked arguments of one command: only known options, each at most once, with a value if the
 * option takes one.
 */
export class Arguments {
  /** The files of the meshes. */
  readonly meshes: readonly string[];
  /** The mesh for which the command is running. */
  #meshPath: string;
  readonly #command: Described;
  readonly #values: ReadonlyMap<string, string>;
  readonly #stdin: Readable;
  #read: Buffer | undefined;
  readonly #progress: Progress;

  /** `progress` receives the progress of reading a mesh. */
  constructor(command: Described, args: string[], stdin: Readable, progress: Progress) {
    const { values, positionals } = readTokens(command, args);
    for (const option of command.options) {
      if (option.required && !values.has(option.name)) {
        throw new UsageError(`${command.name} needs --${option.name} ${option.value}`);
      }
    }
    takeFormatOfName(command, values);
    const [meshPath, ...more] = positionals;
    if (meshPath === undefined) throw new UsageError(`${command.name} needs a mesh: a file`);
    if (more.length > 0) checkBatch(command, values, positionals);
    const files = command.options.filter(({ name, value }) => value === 'FILE' && name !== 'out');
    const read = [...positionals, ...files.map(({ name }) => values.get(name))];
    if (read.filter((path) => path === '-').length > 1) {
      throw new UsageError("standard input can be read once, and '-' is given twice");
    }
    this.meshes = positionals;
    this.#meshPath = meshPath;
    this.#command = command;
    this.#values = values;
    this.#stdin = stdin;
    this.#progress = progress;
  }

  /** Sets the mesh for which the command runs next. */
  take(mesh: string): void {
    this.#meshPath = mesh;
  }

  /** The name of the command. */
  get command(): string {
    return this.#command.name;
  }

  /** Whether the arguments contain this flag or option. A default does not count. */
  given(name: string): boolean {
    return this.#values.has(name);
  }

  /**
   * The value of an option, or its default. If there are several meshes, a star in the command's
   * own `out` stands for the mesh's name.
   */
  text(name: string): string {
    const option = this.#command.options.find((candidate) => candidate.name === name);
    const value = this.#values.get(name) ?? option!.default!;
    if (this.meshes.length === 1 || name !== 'out' || this.#command.options.includes(outOption))
      return value;
    // A replacement given as text would read a dollar sign in it as a pattern.
    return value.replaceAll('*', () => stemOf(this.#meshPath));
  }

  choice<Name extends string>(name: string): Name {
    const names = this.#command.options
      .find((candidate) => candidate.name === name)!
      .value!.split('|');
    const value = this.text(name);
    if (!names.includes(value)) {
      throw new UsageError(`--${name} must be one of ${names.join(', ')}, not '${value}'`);
    }
    return value as Name;
  }

  number(name: string): number {
    return parseNumber(this.text(name), `--${name}`);
  }

  integer(name: string): number {
    const value = this.number(name);
    if (Number.isInteger(value)) return value;
    throw new UsageError(`--${name} must be a whole number, not '${this.text(name)}'`);
  }

  /** Numbers with commas between them. */
  numbers(name: string): number[] {
    return this.text(name)
      .split(',')
      .map((text, i) => parseNumber(text, `number ${i + 1} of --${name}`));
  }

  /** An object with `read(name)` for each of the names that the arguments contain. */
  whereGiven<Name extends string, Value>(
    names: readonly Name[],
    read: (name: Name) => Value,
  ): { [key in Name]?: Value } {
    const given = names.filter((name) => this.given(name));
    return Object.fromEntries(given.map((name) => [name, read(name)])) as { [key in Name]?: Value };
  }

  /**
   * Throws if the arguments contain one of these options. `why` ends the message: "with --type
   * exact".
   */
  refuse(names: readonly string[], why: string): void {
    const name = names.find((candidate) => this.given(candidate));
    if (name !== undefined) throw new UsageError(`--${name} has no use ${why}`);
  }

  point(name: string): PointLike {
    return parsePoint(this.text(name), `--${name}`);
  }

  /** Points with spaces between them, or one point as JSON. */
  pointList(name: string): PointLike[] {
    const text = this.text(name).trim();
    const entries = isJson(text) ? [text] : text.split(/\s+/);
    return entries.map((entry) => parsePoint(entry, `--${name}`));
  }

  /** A point of the surface, or a place in space. */
  place(name: string): PointLike | [number, number, number] {
    const text = this.text(name);
    if (text.includes(':')) return this.point(name);
    const [x, y, z, ...more] = this.numbers(name);
    if (x !== undefined && y !== undefined && z !== undefined && more.length === 0) {
      return [x, y, z];
    }
    throw new UsageError(`--${name} must be a point or a place 'x,y,z', not '${text}'`);
  }

  async points(name = 'points'): Promise<PointLike[]> {
    return parsePoints(await this.file(name), this.text(name));
  }

  async vectors(): Promise<[number, number, number][]> {
    const path = this.text('vectors');
    return parseRows(await this.file('vectors'), path, 'vectors').map((row, i) => {
      if (row.length === 3) return row as [number, number, number];
      throw new UsageError(`vector ${i} of ${path} must be three numbers`);
    });
  }

  /** Rows of numbers, which may have different lengths. */
  async rows(name: string): Promise<number[][]> {
    return parseRows(await this.file(name), this.text(name), name);
  }

  /** The text of the file that an option names, or of standard input for '-'. */
  async file(name: string): Promise<string> {
    return (await this.#bytesOf(this.text(name))).toString('utf8');
  }

  field(): FieldOptions {
    const solver = this.choice<Solver>('solver');
    return {
      method: this.choice<Method>('method'),
      // The default solver depends on the method.
      ...(this.given('solver') && { solver }),
      ...this.whereGiven(['rings'], () => this.integer('rings')),
      ...(this.given('star') && { star: this.choice<Star>('star') }),
    };
  }

  /** The levels of a curve. */
  levels(): CurveLevels {
    const text = this.text('levels');
    if (text === 'auto' || text === 'limit') return text;
    const levels = decimalOf(text);
    if (Number.isInteger(levels)) return levels;
    throw new UsageError(`--levels must be a whole number, auto or limit, not '${text}'`);
  }

  /** The options for reading the mesh. */
  meshOptions(): MeshOptions {
    return {
      repair: this.choice<'safe' | 'none'>('repair'),
      ...this.whereGiven(['weld'], () => this.number('weld')),
    };
  }

  async mesh(): Promise<Mesh> {
    const read = await this.meshFile();
    return (await read(await load())).mesh;
  }

  /** Loads the mesh's file, and returns a function that reads it into an engine. */
  async meshFile(): Promise<(karcher: Karcher) => Promise<{ mesh: Mesh; file: FileInfo }>> {
    const bytes = await this.#bytesOf(this.#meshPath);
    const { meshFromFile, namesBeside } = await import('../formats/index.js');
    const name = basename(this.#meshPath);
    const beside: Record<string, Uint8Array> = {};
    for (const other of namesBeside(bytes, name)) {
      beside[other] = await this.#bytesOf(join(dirname(this.#meshPath), other));
    }
    const progress = this.#progress;
    const options = { ...this.meshOptions(), name, beside, progress };
    const parts = this.given('parts') ? this.numbers('parts') : undefined;
    return (karcher) => meshFromFile(karcher, bytes, { ...options, ...(parts && { parts }) });
  }

  async #bytesOf(path: string): Promise<Buffer> {
    try {
      if (path !== '-') return await readFile(path);
      // One read of standard input serves several meshes.
      this.#read ??= await buffer(this.#stdin);
      return this.#read;
    } catch (cause) {
      throw fileError(path === '-' ? 'standard input' : path, cause);
    }
  }
}

/** Names of files that users would expect to hold a drawing, a mesh or a table. */
const namesOfOthers = /\.(csv|obj|svg|dxf|ply|stl|off|glb|gltf|png)$/i;

/**
 * Unless the arguments name a format, takes the format from the ending of the file name `out`.
 * Throws if the ending belongs to a format that the command does not write.
 */
function takeFormatOfName(command: Described, values: Map<string, string>): void {
  const out = values.get('out');
  if (!command.options.includes(outOption) || out === undefined || values.has('format')) return;
  const draws = command.options.includes(formatOption);
  const ending = /\.([^./\\]+)$/.exec(out)?.[1]?.toLowerCase();
  const formats = formatOption.value!.split('|');
  if (draws && formats.includes(ending!)) values.set('format', ending!);
  else if (namesOfOthers.test(out)) {
    const names = draws ? 'JSON, CSV, OBJ, PLY, GLB or STL,' : 'JSON,';
    throw new UsageError(`${command.name} writes ${names} not '${out}'`);
  }
}

/** The name of a file without its folder and its ending. */
const stemOf = (path: string) => basename(path, extname(path));

/** Throws if a command cannot run for these meshes. */
function checkBatch(
  command: Described,
  values: ReadonlyMap<string, string>,
  meshes: readonly string[],
): void {
  const format = values.get('format') ?? 'json';
  if (format !== 'json') {
    throw new UsageError(`${command.name} takes one mesh with --format ${format}`);
  }
  // A command with its own `out` writes one file for each mesh.
  if (command.options.includes(outOption) || !command.options.some(({ name }) => name === 'out'))
    return;
  if (!values.has('out')) return;
  if (!values.get('out')!.includes('*')) {
    throw new UsageError(
      `--out of ${command.name} needs a '*' for the name of each of several meshes`,
    );
  }
  const byName = new Map<string, string>();
  for (const mesh of meshes) {
    const name = stemOf(mesh);
    const other = byName.get(name);
    if (other !== undefined) {
      throw new UsageError(
        `--out of ${command.name} names a file by each mesh, but '${other}' and '${mesh}' are both named '${name}'`,
      );
    }
    byName.set(name, mesh);
  }
}

interface Read {
  values: Map<string, string>;
  positionals: string[];
}

/**
 * Reads the arguments. The parser is not `strict`: a value may begin with a dash (a negative
 * weight), and the errors are ours.
 */
function readTokens(command: Described, args: string[]): Read {
  const { tokens } = parseArgs({
    args,
    options: Object.fromEntries(
      command.options.map((option) => [
        option.name,
        { type: option.value === undefined ? ('boolean' as const) : ('string' as const) },
      ]),
    ),
    strict: false,
    allowPositionals: true,
    tokens: true,
  });
  const read: Read = { values: new Map(), positionals: [] };
  for (const token of tokens) {
    if (token.kind === 'positional') read.positionals.push(token.value);
    if (token.kind !== 'option') continue;
    const option = command.options.find((candidate) => candidate.name === token.name);
    checkOption(command, option, token.rawName, token.value, read.values.has(token.name));
    read.values.set(token.name, token.value ?? '');
  }
  return read;
}

function checkOption(
  command: Described,
  option: Option | undefined,
  rawName: string,
  value: string | undefined,
  repeated: boolean,
): void {
  if (option === undefined || !rawName.startsWith('--')) {
    const known = command.options.map(({ name }) => `--${name}`).join(', ');
    throw new UsageError(`${command.name} has no option ${rawName}; it has ${known}`);
  }
  if (repeated) throw new UsageError(`${rawName} is given twice`);
  if (option.value === undefined && value !== undefined) {
    throw new UsageError(`${rawName} takes no value`);
  }
  if (option.value !== undefined && !value) {
    throw new UsageError(`${rawName} needs a value: ${option.value}`);
  }
}
