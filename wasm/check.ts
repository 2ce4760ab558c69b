import { KarcherError } from './errors.js';
import type { MeshInfo } from './types.js';

/**
 * Checks for mistakes that only JavaScript allows in arguments: wrong types, wrong lengths, and
 * numbers that are not integers. The engine checks what depends on the mesh.
 */

const largestInteger = 0x7fffffff;
/**
 * The largest number of entries of a list, such as points. An entry takes four doubles, and more
 * entries do not fit into 4 GB.
 */
const mostEntries = 2 ** 27;

/** The error for an argument that cannot be right. */
export const badArgument = (message: string) => new KarcherError('badArgument', message);

/** The text of a value for error messages, cut to a readable length. */
export function shown(value: unknown): string {
  const text = typeof value === 'string' ? `'${value}'` : textOf(value);
  return text.length > 60 ? `${text.slice(0, 57)}...` : text;
}

function textOf(value: unknown): string {
  // A function as text is its source code, which says nothing here.
  if (typeof value === 'function') return 'a function';
  try {
    return String(value);
  } catch {
    return 'an object without a text';
  }
}

export function checkNumber(value: unknown, what: string): number {
  if (typeof value !== 'number') throw badArgument(`${what} must be a number, not ${shown(value)}`);
  if (!Number.isFinite(value)) {
    throw new KarcherError('notFinite', `${what} must be a finite number, not ${value}`);
  }
  return value;
}

export function checkPositive(value: unknown, what: string): number {
  const number = checkNumber(value, what);
  if (number <= 0) throw badArgument(`${what} must be positive, not ${number}`);
  return number;
}

export function checkFunction<Given>(value: Given, what: string): Given {
  if (typeof value === 'function') return value;
  throw badArgument(`${what} must be a function, not ${shown(value)}`);
}

export function checkBoolean(value: unknown, what: string): boolean {
  if (typeof value !== 'boolean')
    throw badArgument(`${what} must be true or false, not ${shown(value)}`);
  return value;
}

/** A whole number that fits the engine's 32-bit integers. */
export function checkInteger(value: unknown, what: string): number {
  if (!Number.isInteger(value)) {
    throw badArgument(`${what} must be a whole number, not ${shown(value)}`);
  }
  if (Math.abs(value as number) > largestInteger) {
    throw badArgument(
      `${what} must be a whole number from -${largestInteger} to ${largestInteger}, not ${value}`,
    );
  }
  return value as number;
}

export function checkOneOf<Name extends string | number>(
  value: unknown,
  names: readonly Name[],
  what: string,
): Name {
  const name = names.find((candidate) => candidate === value);
  if (name === undefined) {
    throw badArgument(`${what} must be one of ${names.join(', ')}, not ${shown(value)}`);
  }
  return name;
}

function checkArrayLike(value: unknown, what: string): ArrayLike<unknown> {
  const length = (value as ArrayLike<unknown> | null | undefined)?.length;
  if (typeof value !== 'object' || !Number.isInteger(length) || length! < 0) {
    throw badArgument(`${what} must be an array of numbers, not ${shown(value)}`);
  }
  if (ArrayBuffer.isView(value)) checkAttached(value, what);
  return value as ArrayLike<unknown>;
}

/** Throws for a transferred buffer, which has lost its bytes and looks like an empty one. */
function checkAttached({ buffer }: ArrayBufferView, what: string): void {
  try {
    new Uint8Array(buffer, 0, 0);
  } catch {
    throw badArgument(`${what} must be an array of numbers, not one whose buffer was transferred`);
  }
}

/**
 * A copy as doubles. NaN and infinity pass, since the engine throws an error that names their
 * place.
 */
export function toFloat64(value: unknown, what: string): Float64Array {
  const array = checkArrayLike(value, what);
  for (let i = 0; i < array.length; i++) {
    const entry = array[i];
    if (typeof entry !== 'number') {
      throw badArgument(`entry ${i} of ${what} must be a number, not ${shown(entry)}`);
    }
  }
  return new Float64Array(array as ArrayLike<number>);
}

/** A copy as 32-bit integers. Throws for a number that is not a 32-bit integer. */
export function toInt32(value: unknown, what: string): Int32Array {
  const array = checkArrayLike(value, what);
  if (!(array instanceof Int32Array)) {
    for (let i = 0; i < array.length; i++) checkInteger(array[i], `entry ${i} of ${what}`);
  }
  return new Int32Array(array as ArrayLike<number>);
}

/** Throws if the options are no object, or have a name that is not one of `names`. */
export function checkOptions(options: unknown, names: readonly string[]): void {
  if (typeof options !== 'object' || options === null || Array.isArray(options)) {
    throw badArgument(`the options must be an object, not ${shown(options)}`);
  }
  const unknown = Object.keys(options).find((name) => !names.includes(name));
  if (unknown !== undefined) {
    throw badArgument(`there is no option ${shown(unknown)}; there are ${names.join(', ')}`);
  }
}

/** An array of entries that need not be numbers. Throws if it has more than `mostEntries`. */
export function checkArray(value: unknown, what: string): unknown[] {
  if (!Array.isArray(value)) throw badArgument(`${what} must be an array, not ${shown(value)}`);
  if (value.length <= mostEntries) return value;
  throw badArgument(`${what} must be an array of at most ${mostEntries}, not of ${value.length}`);
}

export function checkLength(array: ArrayLike<unknown>, multipleOf: number, what: string): void {
  if (array.length % multipleOf === 0) return;
  throw badArgument(`${what} must have a multiple of ${multipleOf} numbers, not ${array.length}`);
}

/** The three numbers of an array, or of an object with x, y and z; NaN and infinity pass. */
export function toTriple(value: unknown, what: string): Float64Array {
  const { x, y, z } = (value ?? {}) as Partial<Record<'x' | 'y' | 'z', unknown>>;
  const named = typeof value === 'object' && [x, y, z].some((entry) => entry !== undefined);
  const numbers = toFloat64(named ? [x, y, z] : value, what);
  if (numbers.length === 3) return numbers;
  throw badArgument(`${what} must be 3 numbers, not ${numbers.length}`);
}

/** A place or a direction: three finite numbers. `what` names it: "the direction". */
export function toVector(value: unknown, what: string): Float64Array {
  const vector = toTriple(value, what);
  vector.forEach((component, i) => {
    checkNumber(component, `component ${i} of ${what}`);
  });
  return vector;
}

/** The names of all options of a type. The compiler checks that the list is complete. */
export const namesOf = <Options>(all: Record<keyof Options, true>): readonly string[] =>
  Object.keys(all);

/** Freezes the information about a mesh and its repairs, so that nobody can change it. */
export function frozenInfo(info: MeshInfo): MeshInfo {
  info.repairs.forEach(Object.freeze);
  Object.freeze(info.repairs);
  return Object.freeze(info);
}
