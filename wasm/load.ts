import { Engine } from './engine.js';
import { instantiate } from './instantiate.js';
import { Karcher } from './karcher.js';
import createEngine from './karcher-engine.mjs';
import type { LoadOptions } from './types.js';

/**
 * Loads the engine. The same call in Node, in a page and in a worker; each call makes an engine
 * with a memory of its own.
 *
 * Rejects with `KarcherError` notLoaded where WebAssembly is missing or the module cannot be had.
 *
 * @example
 * ```ts
 * const karcher = await load();
 * const mesh = karcher.shape('torus', 20_000);
 * ```
 */
export async function load(options: LoadOptions = {}): Promise<Karcher> {
  const url = new URL('./karcher-engine.wasm', import.meta.url);
  return new Karcher(new Engine(await instantiate(createEngine, url, options)));
}
