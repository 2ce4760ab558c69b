import { badArgument, checkOptions, namesOf, shown } from './check.js';
import { KarcherError } from './errors.js';
import type { EngineOptions } from './karcher-engine.mjs';
import type { LoadOptions, WasmSource } from './types.js';

const loadOptionNames = namesOf<LoadOptions>({ wasm: true });

/**
 * Instantiates a module from the source in the options, by default from `url`. Node, pages and
 * workers use the same code. Rejects with `KarcherError` notLoaded, which names the address, if
 * WebAssembly is missing or the module does not load.
 */
export async function instantiate<Module>(
  create: (options: EngineOptions) => Promise<Module>,
  url: URL,
  options: LoadOptions,
): Promise<Module> {
  checkOptions(options, loadOptionNames);
  if (typeof WebAssembly !== 'object') {
    throw new KarcherError('notLoaded', 'Karcher needs WebAssembly, which is not available here');
  }
  const module = await compiled(options.wasm ?? url);
  return new Promise((resolve, reject) => {
    const fail = (cause: unknown) => reject(notLoaded('the engine does not start', cause));
    const instantiateWasm: EngineOptions['instantiateWasm'] = (imports, done) => {
      WebAssembly.instantiate(module, imports).then(done).catch(fail);
      return {};
    };
    create({ instantiateWasm }).then(resolve, fail);
  });
}

/**
 * The compiled module of a source; the source may itself be a compiled module. Rejects as
 * `instantiate` does.
 */
export async function compiled(source: WasmSource): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (typeof source === 'string' || source instanceof URL) return compiledFrom(source);
  if (typeof Response === 'function' && source instanceof Response) {
    return compiledResponse(source, source.url || 'the response');
  }
  const bytes = bytesOf(source);
  if (!bytes) {
    throw badArgument(
      `wasm must be an address, bytes, a Response or a WebAssembly.Module, not ${shown(source)}`,
    );
  }
  return compiledBytes(bytes, 'the array of bytes');
}

/**
 * A copy of a source's bytes; undefined if it has none. WebAssembly takes no bytes in shared
 * memory, since another thread may change them.
 */
function bytesOf(source: unknown): Uint8Array<ArrayBuffer> | undefined {
  if (ArrayBuffer.isView(source)) {
    return new Uint8Array(source.buffer, source.byteOffset, source.byteLength).slice();
  }
  const isShared = globalThis.SharedArrayBuffer && source instanceof SharedArrayBuffer;
  return isShared || source instanceof ArrayBuffer ? new Uint8Array(source).slice() : undefined;
}

async function compiledFrom(address: string | URL): Promise<WebAssembly.Module> {
  const nodeProcess = globalThis.process as NodeJS.Process | undefined;
  // An import would make bundlers look for the file system in a page.
  const files = nodeProcess?.versions?.node ? nodeProcess.getBuiltinModule('node:fs') : undefined;
  const place = files ? fileOf(address) : undefined;
  try {
    if (files && place !== undefined) {
      return await compiledBytes(await files.promises.readFile(place), `${address}`);
    }
    return await compiledResponse(await fetch(address), `${address}`);
  } catch (cause) {
    throw notLoaded(`the engine cannot be loaded from ${address}`, cause);
  }
}

/** The file that an address names, in Node; undefined for an address on the network. */
function fileOf(address: string | URL): string | URL | undefined {
  const text = `${address}`;
  if (text.startsWith('file:')) return new URL(text);
  return /^[a-z][a-z+.-]+:/i.test(text) ? undefined : text;
}

async function compiledResponse(response: Response, what: string): Promise<WebAssembly.Module> {
  if (!response.ok) {
    throw new KarcherError(
      'notLoaded',
      `the engine cannot be loaded from ${what}: the answer is ${response.status} ${response.statusText}`.trim(),
    );
  }
  // `compileStreaming` takes only this type, without a charset, and in Node only in lower case.
  if (response.headers.get('content-type') !== 'application/wasm') {
    return compiledBytes(await response.arrayBuffer(), what);
  }
  // The browser compiles the module while it arrives. Browsers keep modules compiled in this way.
  return whole(WebAssembly.compileStreaming(response), what);
}

const compiledBytes = (bytes: BufferSource, what: string) =>
  whole(WebAssembly.compile(bytes), what);

async function whole(
  module: Promise<WebAssembly.Module>,
  what: string,
): Promise<WebAssembly.Module> {
  try {
    return await module;
  } catch (cause) {
    throw notLoaded(`${what} is not the engine's WebAssembly`, cause);
  }
}

function notLoaded(sentence: string, cause: unknown): KarcherError {
  if (cause instanceof KarcherError) return cause;
  const reason = cause instanceof Error ? cause.message : `${cause}`;
  return new KarcherError('notLoaded', `${sentence}: ${reason}`, { cause });
}
