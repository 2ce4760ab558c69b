import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { notices } from './.tools/notices.mjs';
import { sourcesDigest } from './.tools/sources.mjs';

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

const serviceWorker = 'service-worker.js';

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

/** Tells the service worker which files it keeps: all that are built, and those that are copied. */
const filesInServiceWorker: Plugin = {
  name: 'files-in-service-worker',
  apply: 'build',
  enforce: 'post',
  generateBundle: {
    order: 'post',
    handler(_, bundle) {
      const worker = bundle[serviceWorker];
      if (worker?.type !== 'chunk') this.error('there is no service worker');
      const hash = createHash('sha256');
      const contents = new Map<string, string | Uint8Array>();
      for (const file of Object.values(bundle)) {
        contents.set(file.fileName, file.type === 'chunk' ? file.code : file.source);
      }
      for (const name of readdirSync(here('./web/public'))) {
        contents.set(name, readFileSync(here(`./web/public/${name}`)));
      }
      contents.delete(serviceWorker);
      const files = [...contents.keys()].filter((name) => !name.endsWith('.map')).sort();
      for (const name of files) hash.update(name).update(contents.get(name)!);
      const told = { version: hash.digest('hex').slice(0, 16), files };
      const code = worker.code.replaceAll('__KARCHER_FILES__', JSON.stringify(told));
      if (code === worker.code) this.error('the service worker asks for no files');
      worker.code = code;
    },
  },
};

/** The terms of what others wrote of the page, which its help leads to. */
const thirdPartyNotices: Plugin = {
  name: 'third-party-notices',
  apply: 'build',
  buildStart() {
    const fileName = 'third-party-notices.txt';
    this.emitFile({ type: 'asset', fileName, source: notices('page') });
  },
};

/** The same as a header while the page is served; the book's pages have a policy of their own. */
const policyInPreview: Plugin = {
  name: 'policy-in-preview',
  configurePreviewServer(server) {
    server.middlewares.use((request, response, next) => {
      const inBook = request.url?.startsWith('/book/');
      const policy = inBook
        ? "frame-ancestors 'self'"
        : [...contentSecurityPolicy, "frame-ancestors 'none'"].join('; ');
      response.setHeader('content-security-policy', policy);
      next();
    });
  },
};

export default defineConfig({
  root: here('./web'),
  // Relative addresses: the built page can be put in any folder of any static host.
  base: './',
  resolve: {
    alias: [
      { find: /^karcher$/, replacement: here('./dist/index.js') },
      { find: /^karcher\/peers$/, replacement: here('./dist/peers/index.js') },
      { find: /^karcher\/checkup$/, replacement: here('./dist/checkup/index.js') },
      { find: /^karcher\/formats$/, replacement: here('./dist/formats/index.js') },
      { find: /^karcher\/own-worker$/, replacement: here('./dist/worker/own.js') },
    ],
  },
  define: {
    __KARCHER_BUILD__: JSON.stringify(buildName()),
    __KARCHER_SOURCES__: JSON.stringify(sourcesDigest()),
  },
  worker: { format: 'es', rollupOptions: { checks: { pluginTimings: false } } },
  plugins: [policyInPages, policyInPreview, thirdPartyNotices, filesInServiceWorker],
  server: { fs: { allow: [here('.')] } },
  build: {
    outDir: here('./build/page'),
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 1000,
    rollupOptions: {
      input: {
        index: here('./web/index.html'),
        paper: here('./web/paper.html'),
        service: here('./web/service_worker.ts'),
      },
      output: {
        // A service worker has power over what lies beside it, and keeps its name.
        entryFileNames: ({ name }) =>
          name === 'service' ? serviceWorker : 'assets/[name]-[hash].js',
      },
      checks: { pluginTimings: false },
    },
  },
});
