import { badFile, counted } from './failures.js';
import type { GltfContent } from './glb.js';
import { meshoptOf } from './gltf_decoders.js';
import { countOf, entryOf, isJson, type Json, listOf } from './gltf_json.js';
import type { MeshoptDecoder } from './meshopt_decoder.mjs';

/**
 * The bytes of a buffer view, and the number of bytes from one row to the next if the file states
 * it.
 */
export interface View {
  bytes: Uint8Array;
  stride: number | undefined;
}

/**
 * The largest ratio of decompressed to compressed bytes of meshoptimizer: a byte encodes at most
 * 256 rows of four bytes.
 */
const longest = 1024;

/** The buffers of a glTF file, and their views. */
export class Buffers {
  readonly #json: Json;
  readonly #content: GltfContent;
  readonly #beside: Readonly<Record<string, Uint8Array>>;
  readonly #meshopt: typeof MeshoptDecoder | null;
  readonly #buffers = new Map<unknown, Uint8Array>();
  readonly #views = new Map<unknown, View>();

  constructor(
    json: Json,
    content: GltfContent,
    beside: Readonly<Record<string, Uint8Array>>,
    meshopt: typeof MeshoptDecoder | null,
  ) {
    this.#json = json;
    this.#content = content;
    this.#beside = beside;
    this.#meshopt = meshopt;
  }

  /** The bytes of a buffer view, decompressed. Throws `KarcherError` badFile. */
  view(number: unknown): View {
    let known = this.#views.get(number);
    if (!known) {
      const view = entryOf(this.#json, 'bufferViews', number);
      const what = `buffer view ${number}`;
      const compressed = this.#meshopt && meshoptOf(view);
      known = compressed ? this.#decompressed(compressed, what) : this.#part(view, what);
      this.#views.set(number, known);
    }
    return known;
  }

  #part(of: Json, what: string): View {
    const offset = countOf(of, 'byteOffset', what, 0);
    const length = countOf(of, 'byteLength', what);
    const stride = of.byteStride === undefined ? undefined : countOf(of, 'byteStride', what);
    const buffer = this.#buffer(of.buffer);
    if (offset + length > buffer.length) {
      throw badFile(
        `${what} ends at byte ${counted(offset + length)} of a buffer of ${counted(buffer.length)} bytes`,
      );
    }
    return { bytes: buffer.subarray(offset, offset + length), stride };
  }

  #decompressed(of: Json, what: string): View {
    const { bytes: source } = this.#part(of, what);
    const count = countOf(of, 'count', what);
    const stride = countOf(of, 'byteStride', what);
    const { mode, filter = 'NONE' } = of;
    const why = `${what}, which meshoptimizer compressed,`;
    if (!isMeshopt(mode, filter, stride, count)) {
      throw badFile(`${why} is of a kind that is not known: save the file uncompressed`);
    }
    const length = count * stride;
    if (length > longest * source.length) {
      throw badFile(
        `${why} declares ${counted(length)} bytes, more than ${counted(source.length)} compressed ones can hold`,
      );
    }
    const bytes = new Uint8Array(length);
    try {
      this.#meshopt!.decodeGltfBuffer(
        ...([bytes, count, stride, source] as const),
        ...([mode as string, filter as string] as const),
      );
    } catch (cause) {
      throw badFile(`${why} is damaged: ${cause instanceof Error ? cause.message : cause}`);
    }
    return { bytes, stride };
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

/**
 * Whether the decoder supports this mode, filter, length of rows and number of rows. The decoder
 * itself does not check them.
 */
function isMeshopt(mode: unknown, filter: unknown, stride: number, count: number): boolean {
  const filtered: Readonly<Record<string, boolean>> = {
    NONE: true,
    OCTAHEDRAL: stride === 4 || stride === 8,
    QUATERNION: stride === 8,
    EXPONENTIAL: true,
    COLOR: stride === 4 || stride === 8,
  };
  if (mode === 'ATTRIBUTES') {
    const isRow = stride > 0 && stride <= 256 && stride % 4 === 0;
    return isRow && typeof filter === 'string' && Object.hasOwn(filtered, filter)
      ? filtered[filter]!
      : false;
  }
  if (filter !== 'NONE' || (stride !== 2 && stride !== 4)) return false;
  return mode === 'INDICES' || (mode === 'TRIANGLES' && count % 3 === 0);
}

function embedded(uri: string): Uint8Array {
  const [head = '', data] = uri.split(',', 2);
  try {
    if (data === undefined || !head.endsWith(';base64')) throw new Error();
    const letters = atob(data);
    const bytes = new Uint8Array(letters.length);
    // `Uint8Array.from` would first build a list with a string for each letter.
    for (let i = 0; i < bytes.length; i++) bytes[i] = letters.charCodeAt(i);
    return bytes;
  } catch {
    throw badFile('a buffer within the glTF file is not in base64');
  }
}

/** The names of the files that lie beside a glTF file and contain its buffers. */
export function buffersBeside(json: unknown): string[] {
  if (!isJson(json)) return [];
  const uris = listOf(json, 'buffers')
    .filter((buffer) => meshoptOf(buffer)?.fallback !== true)
    .map((buffer) => (isJson(buffer) ? buffer.uri : undefined));
  const names = uris.filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
  return [...new Set(names.map((uri) => nameBeside(uri as string)))];
}

function nameBeside(uri: string): string {
  let name = uri;
  try {
    name = decodeURIComponent(uri);
  } catch {
    // A name that cannot be decoded stays unchanged.
  }
  if (/^[a-z][a-z+.-]*:|^[\\/]|(^|[\\/])\.\.([\\/]|$)/i.test(name)) {
    throw badFile(`the glTF file names '${name.slice(0, 60)}', which does not lie beside it`);
  }
  return name;
}
