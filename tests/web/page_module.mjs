// Loads the page's own code in Node, as Vite reads it.
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

/** A module with its imports, by its path from this folder. */
export async function pageModule(path) {
  const file = fileURLToPath(new URL(path, import.meta.url));
  const { module } = await runnerImport(file, { configFile: false, logLevel: 'error' });
  return module;
}
