// Loads the page's own code in Node, as Vite reads it.
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';

export const inRoot = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));

export async function load(path) {
  const options = { configFile: inRoot('vite.config.ts'), logLevel: 'error' };
  const { module } = await runnerImport(inRoot(`web/paper/${path}`), options);
  return module;
}
