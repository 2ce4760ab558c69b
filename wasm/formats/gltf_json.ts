import { badFile } from './failures.js';

export type Json = Readonly<Record<string, unknown>>;

export const isJson = (value: unknown): value is Json =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** The object in member `name`; an empty object if there is none. */
export const objectOf = (json: Json, name: string): Json => {
  const value = json[name];
  return isJson(value) ? value : {};
};

export function listOf(json: Json, name: string): unknown[] {
  const value = json[name] ?? [];
  if (!Array.isArray(value)) throw badFile(`the glTF file's '${name}' is no list`);
  return value;
}

/** Entry `number` of a list of objects. Throws if it is missing. */
export function entryOf(json: Json, list: string, number: unknown): Json {
  const entry = Number.isInteger(number) ? listOf(json, list)[number as number] : undefined;
  if (isJson(entry)) return entry;
  if (typeof number === 'number')
    throw badFile(`the glTF file has no entry ${number} of '${list}'`);
  throw badFile(`the glTF file names no entry of '${list}' where one is needed`);
}

/**
 * The member `name`, or else `otherwise`: a whole number of at least 0. Throws for any other value.
 */
export function countOf(json: Json, name: string, what: string, otherwise?: number): number {
  const value = json[name] ?? otherwise;
  if (typeof value === 'number' && Number.isSafeInteger(value) && value >= 0) return value;
  throw badFile(`${what} has no whole number '${name}'`);
}
