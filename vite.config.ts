import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The version, and the commit where there is one. */
function buildName(): string {
  const { version } = JSON.parse(readFileSync(here('./package.json'), 'utf8'));
  const git = spawnSync('git', ['rev-parse', '--short', 'HEAD'], {
    cwd: here('.'),
    encoding: 'utf8',
  });
  return git.status === 0 ? `${version} ${git.stdout.trim()}` : version;
}

export default defineConfig({
  root: here('./web'),
  // Relative addresses: the built page can be put in any folder of any static host.
  base: './',
  resolve: {
    alias: [
      { find: /^karcher$/, replacement: here('./dist/index.js') },
      { find: /^karcher\/peers$/, replacement: here('./dist/peers/index.js') },
      { find: /^karcher\/own-worker$/, replacement: here('./dist/worker/own.js') },
    ],
  },
  define: { __KARCHER_BUILD__: JSON.stringify(buildName()) },
  worker: { format: 'es' },
  server: { fs: { allow: [here('.')] } },
  build: {
    outDir: here('./build/page'),
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 1000,
    rollupOptions: { input: [here('./web/index.html'), here('./web/paper.html')] },
  },
});
