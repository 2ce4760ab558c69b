import type { EngineOptions } from './karcher-engine.mjs';

/**
 * Instantiates a module whose bytes lie at `url`, the same in Node, in a page and in a worker.
 *
 * Rejects with an `Error` where WebAssembly is missing or the module cannot be read.
 */
export async function instantiate<Module>(
  create: (options: EngineOptions) => Promise<Module>,
  url: URL,
): Promise<Module> {
  if (typeof WebAssembly !== 'object') {
    throw new Error('Karcher needs WebAssembly, which is not available here');
  }
  const nodeProcess = globalThis.process as NodeJS.Process | undefined;
  const inNode = typeof nodeProcess?.versions?.node === 'string' && url.protocol === 'file:';
  // Not an import: bundlers would look for the file system in a page.
  const files = inNode ? nodeProcess.getBuiltinModule('node:fs') : undefined;
  return create({
    locateFile: () => url.href,
    ...(files && { wasmBinary: await files.promises.readFile(url) }),
  });
}
