import { badFile, counted } from './failures.js';
import type { GltfContent } from './glb.js';

type Json = Readonly<Record<string, unknown>>;

const isJson = (value: unknown): value is Json =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Member `name` of an object, or an empty one. */
export const objectOf = (json: Json, name: string): Json => {
  const value = json[name];
  return isJson(value) ? value : {};
};

export function listOf(json: Json, name: string): unknown[] {
  const value = json[name] ?? [];
  if (!Array.isArray(value)) throw badFile(`the glTF file's '${name}' is no list`);
  return value;
}

/** Entry `number` of a list of objects. Throws where there is none. */
export function entryOf(json: Json, list: string, number: unknown): Json {
  const entry = Number.isInteger(number) ? listOf(json, list)[number as number] : undefined;
  if (isJson(entry)) return entry;
  if (typeof number === 'number')
    throw badFile(`the glTF file has no entry ${number} of '${list}'`);
  throw badFile(`the glTF file names no entry of '${list}' where one is needed`);
}

/** A whole number of at least 0. */
export function countOf(json: Json, name: string, what: string, otherwise?: number): number {
  const value = json[name] ?? otherwise;
  if (typeof value === 'number' && Number.isSafeInteger(value) && value >= 0) return value;
  throw badFile(`${what} has no whole number '${name}'`);
}

const componentBytes = new Map([
  [5120, 1],
  [5121, 1],
  [5122, 2],
  [5123, 2],
  [5125, 4],
  [5126, 4],
]);
/** What a whole number is divided by where it stands for one from -1 or 0 to 1. */
const most = new Map([
  [5120, 127],
  [5121, 255],
  [5122, 32767],
  [5123, 65535],
]);
/** The types of numbers that count: whole and at least 0. */
const counting: readonly unknown[] = [5121, 5123, 5125];

const components = { SCALAR: 1, VEC3: 3, VEC4: 4 } as const;
type RowType = keyof typeof components;

export interface Accessor {
  count: number;
  fill(row: number, values: Float64Array): void;
}

/** Rows of numbers in a buffer. */
interface Rows {
  view: DataView;
  at: number;
  stride: number;
  type: number;
}

/** Reads the accessors of a glTF file: lists of numbers in its buffers. */
export class Accessors {
  readonly #json: Json;
  readonly #content: GltfContent;
  readonly #beside: Readonly<Record<string, Uint8Array>>;
  readonly #buffers = new Map<unknown, Uint8Array>();
  readonly #known = new Map<string, Accessor>();

  constructor(content: GltfContent, beside: Readonly<Record<string, Uint8Array>>) {
    if (!isJson(content.json)) throw badFile("the glTF file's JSON is no object");
    this.#json = content.json;
    this.#content = content;
    this.#beside = beside;
  }

  get json(): Json {
    return this.#json;
  }

  /** An accessor of places, whose rows are all in their buffers. */
  places(number: unknown): Accessor {
    return this.#accessor(number, 'VEC3');
  }

  /** One of rows of three or four numbers. */
  vectors(number: unknown, size: 3 | 4): Accessor {
    return this.#accessor(number, size === 3 ? 'VEC3' : 'VEC4');
  }

  /** One of numbers of vertices. */
  indices(number: unknown): Accessor {
    return this.#accessor(number, 'SCALAR');
  }

  #accessor(number: unknown, type: RowType): Accessor {
    const accessor = entryOf(this.#json, 'accessors', number);
    const key = `${type} ${number}`;
    let known = this.#known.get(key);
    if (!known) {
      known = this.#made(accessor, `accessor ${number}`, type);
      this.#known.set(key, known);
    }
    return known;
  }

  #made(accessor: Json, what: string, type: RowType): Accessor {
    if (accessor.type !== type) throw badFile(`${what} has to be of type ${type}`);
    const count = countOf(accessor, 'count', what);
    const componentType = accessor.componentType as number;
    if (type === 'SCALAR') {
      checkCounting(componentType, what);
      if (accessor.normalized === true) throw badFile(`${what} is normalized, and has to count`);
    }
    const divisor = accessor.normalized === true ? (most.get(componentType) ?? 1) : 1;
    const rows =
      accessor.bufferView === undefined
        ? null
        : this.#rows(accessor, what, type, componentType, count);
    const sparse = this.#sparse(accessor, what, type, componentType, count);
    const fillRow = (row: number, values: Float64Array) => {
      const instead = sparse ? sparse.find(row) : -1;
      if (instead >= 0) fill(values, sparse!.values, instead);
      else if (rows) fill(values, rows, row);
      else values.fill(0);
      if (divisor === 1) return;
      for (let i = 0; i < values.length; i++) values[i] = Math.max(values[i]! / divisor, -1);
    };
    return { count, fill: fillRow };
  }

  /** Rows that stand instead of others: `find` gives the place among `values`, or -1. */
  #sparse(accessor: Json, what: string, type: RowType, componentType: number, rows: number) {
    if (accessor.sparse === undefined) {
      if (accessor.bufferView === undefined && rows > 0) throw badFile(`${what} has no values`);
      return null;
    }
    const sparse = objectOf(accessor, 'sparse');
    const name = `the sparse part of ${what}`;
    const count = countOf(sparse, 'count', name);
    const indices = objectOf(sparse, 'indices');
    checkCounting(indices.componentType, name);
    const at = this.#rows(indices, name, 'SCALAR', indices.componentType as number, count);
    const values = this.#rows(objectOf(sparse, 'values'), name, type, componentType, count);
    const index = new Float64Array(1);
    const indexOf = (row: number) => {
      fill(index, at, row);
      return index[0]!;
    };
    let last = -1;
    for (let row = 0; row < count; row++) {
      const changed = indexOf(row);
      if (!(changed < rows)) throw badFile(`${name} changes row ${changed} of ${rows}`);
      if (changed <= last) throw badFile(`${name} has row ${changed} after row ${last}`);
      last = changed;
    }
    const find = (row: number) => {
      let [low, high] = [0, count];
      while (low < high) {
        const middle = (low + high) >>> 1;
        if (indexOf(middle) < row) low = middle + 1;
        else high = middle;
      }
      return low < count && indexOf(low) === row ? low : -1;
    };
    return { values, find };
  }

  #rows(of: Json, what: string, type: RowType, componentType: number, count: number): Rows {
    const bytes = componentBytes.get(componentType);
    if (bytes === undefined) throw badFile(`${what} has numbers of no type that is known`);
    const view = entryOf(this.#json, 'bufferViews', of.bufferView);
    const offset = countOf(view, 'byteOffset', `buffer view ${of.bufferView}`, 0);
    const length = countOf(view, 'byteLength', `buffer view ${of.bufferView}`);
    const row = bytes * components[type];
    const stride = countOf(view, 'byteStride', `buffer view ${of.bufferView}`, row);
    const start = countOf(of, 'byteOffset', what, 0);
    const buffer = this.#buffer(view.buffer);
    const end = count === 0 ? start : start + stride * (count - 1) + row;
    if (stride < row || end > length || offset + length > buffer.length) {
      throw badFile(
        `${what} tells of ${counted(count)} rows, up to byte ${counted(offset + end)} of a buffer of ${counted(buffer.length)} bytes`,
      );
    }
    const data = new DataView(buffer.buffer, buffer.byteOffset + offset, length);
    return { view: data, at: start, stride, type: componentType };
  }

  #buffer(number: unknown): Uint8Array {
    const known = this.#buffers.get(number);
    if (known) return known;
    const { uri } = entryOf(this.#json, 'buffers', number);
    let buffer: Uint8Array | null | undefined;
    if (uri === undefined) buffer = this.#content.buffer;
    else if (typeof uri === 'string') {
      const name = uri.startsWith('data:') ? null : nameBeside(uri);
      if (name === null) buffer = embedded(uri);
      else if (Object.hasOwn(this.#beside, name)) buffer = this.#beside[name];
    }
    if (!buffer) {
      throw badFile(
        typeof uri === 'string'
          ? `the glTF file needs '${nameBeside(uri)}', which lies beside it: give both, or save it as one GLB file`
          : `buffer ${number} of the glTF file has no bytes`,
      );
    }
    this.#buffers.set(number, buffer);
    return buffer;
  }
}

function checkCounting(componentType: unknown, what: string): void {
  if (counting.includes(componentType)) return;
  throw badFile(`${what} has numbers that cannot count: they have to be whole and at least 0`);
}

function fill(values: Float64Array, { view, at, stride, type }: Rows, row: number): void {
  let place = at + stride * row;
  const bytes = componentBytes.get(type)!;
  for (let i = 0; i < values.length; i++, place += bytes) {
    switch (type) {
      case 5126:
        values[i] = view.getFloat32(place, true);
        break;
      case 5125:
        values[i] = view.getUint32(place, true);
        break;
      case 5123:
        values[i] = view.getUint16(place, true);
        break;
      case 5122:
        values[i] = view.getInt16(place, true);
        break;
      case 5121:
        values[i] = view.getUint8(place);
        break;
      case 5120:
        values[i] = view.getInt8(place);
        break;
    }
  }
}

function embedded(uri: string): Uint8Array {
  const [head = '', data] = uri.split(',', 2);
  try {
    if (data === undefined || !head.endsWith(';base64')) throw new Error();
    return Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  } catch {
    throw badFile('a buffer within the glTF file is not in base64');
  }
}

/** The names of the files beside a glTF file that its buffers are in. */
export function buffersBeside(json: unknown): string[] {
  if (!isJson(json)) return [];
  const uris = listOf(json, 'buffers').map((buffer) => (isJson(buffer) ? buffer.uri : undefined));
  const names = uris.filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
  return [...new Set(names.map((uri) => nameBeside(uri as string)))];
}

function nameBeside(uri: string): string {
  let name = uri;
  try {
    name = decodeURIComponent(uri);
  } catch {
    // As it is written.
  }
  if (/^[a-z][a-z+.-]*:|^[\\/]|(^|[\\/])\.\.([\\/]|$)/i.test(name)) {
    throw badFile(`the glTF file names '${name.slice(0, 60)}', which does not lie beside it`);
  }
  return name;
}
