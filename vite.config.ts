import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here('./web'),
  // Relative addresses: the built page can be put in any folder of any static host.
  base: './',
  resolve: {
    alias: [
      { find: /^karcher$/, replacement: here('./dist/index.js') },
      { find: /^karcher\/peers$/, replacement: here('./dist/peers/index.js') },
    ],
  },
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
