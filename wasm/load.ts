import { Engine } from './engine.js';
import { instantiate } from './instantiate.js';
import { Karcher } from './karcher.js';
import createEngine from './karcher-engine.mjs';
import type { LoadOptions } from './types.js';

/**
 * Loads the engine. The call is the same in Node, in a page and in a worker. Each call creates an
 * engine with its own memory.
 *
 * Rejects with `KarcherError` notLoaded if WebAssembly is missing or the module does not load.
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
