import { Karcher } from './karcher.js';
import createEngine from './karcher-engine.mjs';

/**
 * Loads the engine. The same call in Node, in a page and in a worker; each call makes an engine
 * with a memory of its own.
 *
 * Rejects with an `Error` where WebAssembly is missing or the module cannot be read.
 */
export async function load(): Promise<Karcher> {
  if (typeof WebAssembly !== 'object') {
    throw new Error('Karcher needs WebAssembly, which is not available here');
  }
  const url = new URL('./karcher-engine.wasm', import.meta.url);
  const nodeProcess = globalThis.process as NodeJS.Process | undefined;
  const inNode = typeof nodeProcess?.versions?.node === 'string' && url.protocol === 'file:';
  // Not an import: bundlers would look for the file system in a page.
  const files = inNode ? nodeProcess.getBuiltinModule('node:fs') : undefined;
  const module = await createEngine({
    locateFile: () => url.href,
    ...(files && { wasmBinary: await files.promises.readFile(url) }),
  });
  return new Karcher(module);
}
