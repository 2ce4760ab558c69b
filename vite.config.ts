import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';

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

/**
 * What the built pages may do: nothing but run their own scripts and WebAssembly, and read what lies
 * beside them. Pictures and files are made as blobs.
 */
const contentSecurityPolicy = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "worker-src 'self'",
  "connect-src 'self'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "base-uri 'none'",
  "form-action 'none'",
];

/** Says it in each page, for hosts that set no headers. */
const policyInPages: Plugin = {
  name: 'content-security-policy',
  apply: 'build',
  transformIndexHtml: () => [
    {
      tag: 'meta',
      attrs: {
        'http-equiv': 'Content-Security-Policy',
        content: contentSecurityPolicy.join('; '),
      },
      injectTo: 'head-prepend',
    },
  ],
};

export default defineConfig({
  root: here('./web'),
  // Relative addresses: the built page can be put in any folder of any static host.
  base: './',
  resolve: {
    alias: [
      { find: /^karcher$/, replacement: here('./dist/index.js') },
      { find: /^karcher\/peers$/, replacement: here('./dist/peers/index.js') },
      { find: /^karcher\/formats$/, replacement: here('./dist/formats/index.js') },
      { find: /^karcher\/own-worker$/, replacement: here('./dist/worker/own.js') },
    ],
  },
  define: { __KARCHER_BUILD__: JSON.stringify(buildName()) },
  worker: { format: 'es' },
  plugins: [policyInPages],
  preview: {
    headers: {
      'content-security-policy': [...contentSecurityPolicy, "frame-ancestors 'none'"].join('; '),
    },
  },
  server: { fs: { allow: [here('.')] } },
  build: {
    outDir: here('./build/page'),
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 1000,
    rollupOptions: { input: [here('./web/index.html'), here('./web/paper.html')] },
  },
});
