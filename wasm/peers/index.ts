import { instantiate } from '../instantiate.js';
import type { LoadOptions } from '../types.js';
import createPeers from './karcher-peers.mjs';
import { Peers } from './peers.js';

export * from '../index.js';
/** Vectors in space, for programs that measure and draw curves. */
export * as vectors from '../vectors.js';
export * from './compare.js';
export * from './drag.js';
export * from './measure.js';
export type { Peers } from './peers.js';
export * from './ruler.js';
export { isThere } from './status.js';
export type * from './types.js';
export { warm } from './warm.js';

/**
 * Loads the engine together with the methods that it is compared with. The loaded module is larger
 * than the module of `load`, and is for comparisons only. The property `karcher` of the result
 * creates the meshes. Rejects with `KarcherError` notLoaded if WebAssembly is missing or the module
 * does not load.
 */
export async function loadPeers(options: LoadOptions = {}): Promise<Peers> {
  const url = new URL('./karcher-peers.wasm', import.meta.url);
  return new Peers(await instantiate(createPeers, url, options));
}
