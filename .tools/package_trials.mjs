// The trials of a new user with the packed file: in Node and other runtimes, with TypeScript,
// bundlers and a plain page. Each trial has a separate folder with the packed file and the trial's
// packages.
import { spawn, spawnSync } from 'node:child_process';
import {
  copyFileSync,
  cpSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { stripVTControlCharacters } from 'node:util';
import { chromium } from 'playwright-core';
import { chromiumPath } from './setup.mjs';
import { inRoot } from './shell.mjs';

const said = 'converged true';
const calls = `import { load } from 'karcher';
const karcher = await load();
const mesh = karcher.shape('torus', 2000);
const points = [1, 3, 5, 7].map((vertex) => ({ vertex }));
const status = mesh.centerOfMass(points, [0.1, 0.4, 0.4, 0.1]).status;
`;
const program = `${calls}console.log(status + ' ' + (mesh.curve({ kind: 'bspline', points }).length > 0));
`;
const required = `const { load } = require('karcher');
load().then((karcher) => console.log('converged ' + (karcher.shape('torus', 2000).info.triangles > 0)));
`;
const inWorker = `import { loadInWorker } from 'karcher/worker';
const karcher = await loadInWorker();
const mesh = await karcher.shape('torus', 2000);
const { status } = await mesh.centerOfMass([{ vertex: 1 }, { vertex: 5 }], [0.5, 0.5]);
console.log(status + ' ' + (mesh.info.triangles > 0));
karcher.dispose();
`;
/** The trial in a page: the engine, a file's reader and a worker. The title shows the result. */
const paged = `import { loadInWorker } from 'karcher/worker';
import { meshFromFile } from 'karcher/formats';
async function tried() {
  ${calls
    .split('\n')
    .filter((line) => !line.startsWith('import'))
    .join('\n  ')}
  const stl = 'solid a\\n' + [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]].map((face) => 'facet normal 0 0 0\\nouter loop\\n'
    + face.map((at) => 'vertex ' + ['0 0 0', '1 0 0', '0 1 0', '0 0 1'][at] + '\\n').join('')
    + 'endloop\\nendfacet\\n').join('') + 'endsolid a\\n';
  const read = await meshFromFile(karcher, new TextEncoder().encode(stl), { name: 'a.stl' });
  const remote = await loadInWorker();
  const there = await remote.shape('torus', 2000);
  const far = await there.centerOfMass(points, [0.1, 0.4, 0.4, 0.1]);
  return status + ' ' + (far.status === status && read.mesh.info.triangles === 4);
}
tried().then((text) => (document.title = text), (error) => (document.title = 'failed: ' + error + error.stack));
`;
const pageProgram = `import { load } from 'karcher';\n${paged}`;
const html = (head = '') =>
  `<!doctype html><title>Karcher</title>${head}<script type="module" src="./page.mjs"></script>\n`;

const typed = `import { type Curve, KarcherError, load } from 'karcher';
import { checkUp } from 'karcher/checkup';
import { meshFromFile } from 'karcher/formats';
import { loadPeers } from 'karcher/peers';
import { huberMean, median } from 'karcher/statistics';
import { loadInWorker } from 'karcher/worker';
const karcher = await load();
const mesh = karcher.shape('torus', 2000);
export const curve: Curve = mesh.curve({ kind: 'bspline', points: [1, 3, 5, 7].map((vertex) => ({ vertex })) });
export const tried = [checkUp(mesh), meshFromFile, loadInWorker, KarcherError, loadPeers, huberMean, median];
`;
// The types of `DOM` and of Node declare a compiled module without members, so that any value would
// pass as one.
const refused = `// @ts-expect-error
export const wrong = load({ wasm: 3 });
`;
const typedThree = `import { Surface, SurfaceCurve } from 'karcher/three';
import { useKarcher } from 'karcher/react';
export const tried = [Surface, SurfaceCurve, useKarcher];
`;

/** Runs a program in a folder. Returns its output, or throws an error that contains it. */
export function run(folder, command, ...args) {
  const env = { ...process.env, NEXT_TELEMETRY_DISABLED: '1' };
  const options = { cwd: folder, encoding: 'utf8', timeout: 300_000, env };
  const { status, stdout, stderr, error } = spawnSync(command, args, options);
  if (status !== 0) throw new Error(`${command} ${args.join(' ')}: ${error ?? stderr + stdout}`);
  return stdout;
}

const node = (folder, file) => run(folder, process.execPath, file);
const binary = (folder, name) => join(folder, 'node_modules', '.bin', name);
const npmx = (folder, name, ...args) => run(folder, binary(folder, name), ...args);

function check(output) {
  if (!output.includes(said)) throw new Error(`it printed ${output}, not ${said}`);
}

function write(folder, files) {
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(join(folder, name, '..'), { recursive: true });
    writeFileSync(join(folder, name), text);
  }
}

/** Checks that the engine's module lies beside the bundler's output. */
function checkWasm(folder) {
  const files = readdirSync(folder, { recursive: true }).map(String);
  if (!files.some((file) => file.endsWith('.wasm'))) throw new Error(`no .wasm in ${files}`);
}

/**
 * Checks that the title of a page at that address reports success. Otherwise throws the page's
 * report.
 */
async function checkPage(address) {
  const browser = await chromium.launch({
    executablePath: chromiumPath(),
    args: ['--no-sandbox', '--disable-gpu'],
  });
  try {
    const page = await browser.newPage();
    const complaints = [];
    page.on('console', (message) => complaints.push(message.text()));
    page.on('pageerror', (error) => complaints.push(`${error}`));
    page.on('response', (response) => {
      if (response.status() >= 400 && !response.url().endsWith('favicon.ico'))
        complaints.push(`${response.status()} ${response.url()}`);
    });
    await page.goto(address);
    const ended = (said) => document.title === said || document.title.startsWith('failed');
    await page.waitForFunction(ended, said, { timeout: 60_000 }).catch(() => undefined);
    const title = await page.title();
    if (title !== said) throw new Error([title, ...complaints].join('\n'));
  } finally {
    await browser.close();
  }
}

const types = { '.html': 'text/html', '.wasm': 'application/wasm', '.css': 'text/css' };

/** Checks that the files of a folder work in a browser, from a plain file server. */
async function checkServed(folder) {
  const server = createServer(({ url }, response) => {
    const path = decodeURIComponent(new URL(url, 'http://page').pathname);
    const file = join(folder, path === '/' ? 'index.html' : path);
    try {
      const body = readFileSync(file);
      response.writeHead(200, { 'content-type': types[extname(file)] ?? 'text/javascript' });
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  try {
    await checkPage(`http://127.0.0.1:${server.address().port}/`);
  } finally {
    server.close();
  }
}

/**
 * Checks that the files of a development server work in a browser. The server prints its address
 * when it has started.
 */
async function checkServer(folder, command, ...args) {
  const child = spawn(command, args, { cwd: folder, detached: true });
  let output = '';
  try {
    const address = await new Promise((resolve, reject) => {
      const hear = (data) => {
        output += stripVTControlCharacters(`${data}`);
        const found = /http:\/\/(localhost|127\.0\.0\.1):\d+/.exec(output);
        if (found) resolve(found[0]);
      };
      child.stdout.on('data', hear);
      child.stderr.on('data', hear);
      child.on('error', reject);
      child.on('exit', () => reject(new Error(`it ended: ${output}`)));
      setTimeout(() => reject(new Error(`it said no address: ${output}`)), 60_000).unref();
    });
    await checkPage(`${address}/`);
  } finally {
    process.kill(-child.pid, 'SIGTERM');
  }
}

function compile(folder, text, lib, types) {
  const compilerOptions = {
    ...{ target: 'ES2022', module: 'NodeNext', strict: true, exactOptionalPropertyTypes: true },
    ...{ noUncheckedIndexedAccess: true, skipLibCheck: false, noEmit: true, lib, types },
    typeRoots: [inRoot('node_modules/@types')],
  };
  const config = { compilerOptions, files: ['main.ts'] };
  write(folder, { 'main.ts': text, 'tsconfig.json': JSON.stringify(config) });
  run(folder, process.execPath, inRoot('node_modules/typescript/bin/tsc'), '-p', folder);
}

/** Runs a bundle for Node beside the files that it loads from its own folder. */
function runBundle(folder) {
  const wasm = 'karcher-engine.wasm';
  copyFileSync(join(folder, 'node_modules/karcher/dist', wasm), join(folder, 'dist', wasm));
  check(node(folder, 'dist/main.mjs'));
}

const dom = ['ES2022', 'DOM', 'DOM.Iterable'];

/**
 * The trials, each with the packages that it needs beside Karcher. `npm test` runs those without
 * packages.
 */
export const trials = [
  { name: 'Node, import', try: (folder) => check(node(folder, 'main.mjs')) },
  {
    name: 'Node, require',
    try(folder) {
      write(folder, { 'main.cjs': required });
      check(node(folder, 'main.cjs'));
    },
  },
  {
    name: 'Node, worker',
    try(folder) {
      write(folder, { 'worker.mjs': inWorker });
      check(node(folder, 'worker.mjs'));
    },
  },
  {
    name: 'command line',
    try(folder) {
      if (!npmx(folder, 'karcher', '--help').includes('karcher COMMAND'))
        throw new Error('no help');
    },
  },
  {
    name: 'TypeScript, strict, skipLibCheck: false',
    try: (folder) => compile(folder, typed, dom, []),
  },
  {
    name: 'TypeScript without DOM, with the types of Node',
    try: (folder) => compile(folder, typed, ['ES2022'], ['node']),
  },
  {
    name: 'TypeScript without DOM and without any types',
    try: (folder) => compile(folder, typed + refused, ['ES2022'], []),
  },
  {
    name: 'plain page with an import map',
    async try(folder) {
      const imports = { karcher: './karcher/index.js' };
      for (const part of ['formats', 'worker'])
        imports[`karcher/${part}`] = `./karcher/${part}/index.js`;
      const map = `<script type="importmap">${JSON.stringify({ imports })}</script>`;
      write(folder, { 'site/index.html': html(map), 'site/page.mjs': pageProgram });
      cpSync(join(folder, 'node_modules/karcher/dist'), join(folder, 'site/karcher'), {
        recursive: true,
      });
      await checkServed(join(folder, 'site'));
    },
  },
  {
    name: 'TypeScript, three.js and React, strict',
    packages: [
      'three',
      '@types/three',
      'react',
      '@types/react',
      'react-dom',
      '@react-three/fiber',
      '@react-three/drei', // Most users have this package, with its own peers.
    ],
    try(folder) {
      try {
        compile(folder, typedThree, dom, []);
      } catch ({ message }) {
        // The types of other packages may have faults of their own.
        if (/^(main\.ts|node_modules\/karcher)/m.test(message)) throw new Error(message);
      }
    },
  },
  {
    name: 'Vite, development server',
    packages: ['vite'],
    try: (folder) => checkServer(folder, binary(folder, 'vite'), '--port', '0'),
  },
  {
    name: 'Vite, build',
    packages: ['vite'],
    async try(folder) {
      npmx(folder, 'vite', 'build', '--logLevel', 'error');
      await checkServed(join(folder, 'dist'));
    },
  },
  {
    name: 'Vite 6, development server, with optimizeDeps.exclude',
    packages: ['vite@6'],
    async try(folder) {
      const config = "export default { optimizeDeps: { exclude: ['karcher'] } };\n";
      write(folder, { 'vite.config.mjs': config });
      await checkServer(folder, binary(folder, 'vite'), '--port', '0');
    },
  },
  {
    name: 'webpack',
    packages: ['webpack', 'webpack-cli'],
    async try(folder) {
      npmx(folder, 'webpack', './page.mjs', '--mode', 'production');
      const page = html().replace('type="module" src="./page.mjs"', 'defer src="./main.js"');
      write(folder, { 'dist/index.html': page });
      await checkServed(join(folder, 'dist'));
    },
  },
  {
    name: 'Parcel, with packageExports and --no-scope-hoist',
    packages: ['parcel'],
    async try(folder) {
      const own = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
      own['@parcel/resolver-default'] = { packageExports: true };
      write(folder, { 'package.json': JSON.stringify(own) });
      npmx(folder, 'parcel', 'build', 'index.html', '--no-cache', '--no-scope-hoist');
      checkWasm(join(folder, 'dist'));
      await checkServed(join(folder, 'dist'));
    },
  },
  {
    name: 'esbuild for Node, the module copied',
    packages: ['esbuild'],
    try(folder) {
      const options = ['--bundle', '--format=esm', '--platform=node', '--outfile=dist/main.mjs'];
      npmx(folder, 'esbuild', 'main.mjs', ...options);
      runBundle(folder);
    },
  },
  {
    name: 'rollup for Node, the module copied',
    packages: ['rollup', '@rollup/plugin-node-resolve'],
    try(folder) {
      npmx(folder, 'rollup', 'main.mjs', '-p', 'node-resolve', '-f', 'es', '-o', 'dist/main.mjs');
      runBundle(folder);
    },
  },
  {
    name: 'Next, a page in the browser, and one of the server with serverExternalPackages',
    packages: ['next', 'react', 'react-dom'],
    async try(folder) {
      write(folder, {
        'next.config.mjs': "export default { serverExternalPackages: ['karcher'] };\n",
        'app/layout.jsx':
          'export default ({ children }) => <html><head><title>Karcher</title></head><body>{children}</body></html>;\n',
        'app/page.jsx': `import Tried from './tried';
${calls.replace('const karcher', 'export default async function Page() {\n  const karcher')}  return <p id="server">{status}<Tried /></p>;
}
`,
        'app/tried.jsx': `'use client';
import { useEffect } from 'react';
export default function Tried() {
  useEffect(() => void import('../page.mjs'), []);
  return null;
}
`,
      });
      npmx(folder, 'next', 'build');
      await checkServer(folder, binary(folder, 'next'), 'start', '--port', '0');
    },
  },
  {
    name: 'Bun',
    packages: ['bun'],
    try: (folder) => check(npmx(folder, 'bun', 'main.mjs')),
  },
  {
    name: 'Bun, worker',
    packages: ['bun'],
    try(folder) {
      write(folder, { 'worker.mjs': inWorker });
      check(npmx(folder, 'bun', 'worker.mjs'));
    },
  },
  {
    name: 'Deno',
    packages: ['deno'],
    try: (folder) => check(npmx(folder, 'deno', 'run', '--allow-read', 'main.mjs')),
  },
  {
    name: 'Deno, worker',
    packages: ['deno'],
    try(folder) {
      write(folder, { 'worker.mjs': inWorker });
      check(npmx(folder, 'deno', 'run', '--allow-read', 'worker.mjs'));
    },
  },
];

/** Installs the packed file and a trial's packages into a fresh folder, and tries it there. */
export async function attempt({ packages = [], try: attempted }, folder, tarball) {
  write(folder, {
    'package.json': '{ "name": "user", "private": true, "type": "module" }',
    'main.mjs': program,
    'page.mjs': pageProgram,
    'index.html': html(),
  });
  const offline = packages.length === 0 ? ['--offline'] : [];
  run(folder, 'npm', 'install', '--no-audit', '--no-fund', ...offline, tarball, ...packages);
  await attempted(folder);
  // The packages of a trial take hundreds of MB.
  rmSync(folder, { recursive: true, force: true });
}
