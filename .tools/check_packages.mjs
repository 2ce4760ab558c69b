// `npm run check:packages`: packs what would be published, installs it into fresh folders as a new user would,
// tries it there and prints a table. With --short only what needs no other package, as `npm test` does.
//
// CMake projects of users are tried by tests/tools/cpp_users.test.mjs.
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { inRoot, root } from './shell.mjs';

const program = `import { load } from 'karcher';
const karcher = await load();
const mesh = karcher.shape('torus', 2000);
const points = [1, 3, 5, 7].map((vertex) => ({ vertex }));
console.log(mesh.centerOfMass(points, [0.1, 0.4, 0.4, 0.1]).status, mesh.curve({ kind: 'bspline', points }).length > 0);
`;
const required = `const { load } = require('karcher');
load().then((karcher) => console.log(karcher.shape('torus', 2000).info.triangles > 0));
`;
const typed = `import { type Curve, KarcherError, load } from 'karcher';
import { checkUp } from 'karcher/checkup';
import { meshFromFile } from 'karcher/formats';
import { loadInWorker } from 'karcher/worker';
const karcher = await load();
const mesh = karcher.shape('torus', 2000);
export const curve: Curve = mesh.curve({ kind: 'bspline', points: [1, 3, 5, 7].map((vertex) => ({ vertex })) });
export const tried = [checkUp(mesh), meshFromFile, loadInWorker, KarcherError];
`;
const page =
  '<!doctype html><title>Karcher</title><script type="module" src="./main.mjs"></script>\n';

/** Runs a program there; its output, or an error that has it. */
function run(folder, command, ...args) {
  const options = { cwd: folder, encoding: 'utf8', timeout: 300_000 };
  const { status, stdout, stderr, error } = spawnSync(command, args, options);
  if (status !== 0) throw new Error(`${command} ${args.join(' ')}: ${error ?? stderr + stdout}`);
  return stdout;
}

const node = (folder, file) => run(folder, process.execPath, file);
const npmx = (folder, name, ...args) => run(folder, join('node_modules', '.bin', name), ...args);

function check(output, expected) {
  if (!output.includes(expected)) throw new Error(`it printed ${output}, not ${expected}`);
}

/** The engine's module lies beside what the bundler wrote. */
function checkWasm(folder) {
  const files = readdirSync(folder, { recursive: true }).map(String);
  if (!files.some((file) => file.endsWith('.wasm'))) throw new Error(`no .wasm in ${files}`);
}

function compile(folder, lib, types = []) {
  writeFileSync(join(folder, 'main.ts'), typed);
  const compilerOptions = {
    ...{ target: 'ES2022', module: 'NodeNext', strict: true, exactOptionalPropertyTypes: true },
    ...{ noUncheckedIndexedAccess: true, skipLibCheck: false, noEmit: true, lib, types },
    typeRoots: [inRoot('node_modules/@types')],
  };
  const config = { compilerOptions, files: ['main.ts'] };
  writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(config));
  run(folder, process.execPath, inRoot('node_modules/typescript/bin/tsc'), '-p', folder);
}

const trials = [
  { name: 'Node, import', try: (folder) => check(node(folder, 'main.mjs'), 'converged true') },
  {
    name: 'Node, require',
    try(folder) {
      writeFileSync(join(folder, 'main.cjs'), required);
      check(node(folder, 'main.cjs'), 'true');
    },
  },
  {
    name: 'command line',
    try: (folder) => check(npmx(folder, 'karcher', '--help'), 'karcher'),
  },
  {
    name: 'TypeScript, strict, skipLibCheck: false',
    try: (folder) => compile(folder, ['ES2022', 'DOM', 'DOM.Iterable']),
  },
  {
    name: 'TypeScript without DOM, with the types of Node',
    known: 'the types name WebAssembly, which the types of Node 20 do not have',
    try: (folder) => compile(folder, ['ES2022'], ['node']),
  },
  {
    name: 'Vite, build',
    packages: ['vite'],
    try(folder) {
      npmx(folder, 'vite', 'build', '--target', 'es2022', '--logLevel', 'error');
      checkWasm(join(folder, 'dist'));
    },
  },
  {
    name: 'webpack',
    packages: ['webpack', 'webpack-cli'],
    try(folder) {
      npmx(folder, 'webpack', './main.mjs', '--mode', 'production');
      checkWasm(join(folder, 'dist'));
    },
  },
  {
    name: 'esbuild, the module copied',
    packages: ['esbuild'],
    try(folder) {
      npmx(
        folder,
        'esbuild',
        'main.mjs',
        '--bundle',
        '--format=esm',
        '--platform=node',
        '--outfile=dist/main.mjs',
      );
      const wasm = readFileSync(join(folder, 'node_modules/karcher/dist/karcher-engine.wasm'));
      writeFileSync(join(folder, 'dist/karcher-engine.wasm'), wasm);
      check(node(folder, 'dist/main.mjs'), 'converged true');
    },
  },
  {
    name: 'rollup, the module copied',
    packages: ['rollup', '@rollup/plugin-node-resolve'],
    try(folder) {
      npmx(folder, 'rollup', 'main.mjs', '-p', 'node-resolve', '-f', 'es', '-o', 'dist/main.mjs');
      const wasm = readFileSync(join(folder, 'node_modules/karcher/dist/karcher-engine.wasm'));
      writeFileSync(join(folder, 'dist/karcher-engine.wasm'), wasm);
      check(node(folder, 'dist/main.mjs'), 'converged true');
    },
  },
  {
    name: 'Parcel',
    packages: ['parcel'],
    try(folder) {
      npmx(folder, 'parcel', 'build', 'index.html', '--no-cache');
      checkWasm(join(folder, 'dist'));
    },
  },
];

/** What would be published, and how each trial of it went: `problem` is empty where it did; `known` is why not. */
export function checkPackages({ short = false } = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'karcher packages '));
  try {
    const args = ['pack', '--ignore-scripts', '--json', '--pack-destination', folder, root];
    const [packed] = JSON.parse(run(folder, 'npm', ...args));
    const rows = trials
      .filter(({ packages }) => !short || !packages)
      .map(({ name, packages = [], known, try: attempt }, at) => {
        const own = join(folder, `user-${at}`);
        mkdirSync(own);
        writeFileSync(
          join(own, 'package.json'),
          '{ "name": "user", "private": true, "type": "module" }',
        );
        writeFileSync(join(own, 'main.mjs'), program);
        writeFileSync(join(own, 'index.html'), page);
        try {
          const tarball = join(folder, packed.filename);
          const quiet = ['--no-audit', '--no-fund', '--ignore-scripts=false'];
          const offline = packages.length === 0 ? ['--offline'] : [];
          run(own, 'npm', 'install', ...quiet, ...offline, tarball, ...packages);
          attempt(own);
          return { name, problem: '' };
        } catch ({ message }) {
          return { name, problem: message, known };
        }
      });
    const files = packed.files.map(({ path }) => path);
    return { name: packed.id, bytes: packed.size, files, rows };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const { name, bytes, files, rows } = checkPackages({ short: process.argv.includes('--short') });
  console.log(`${name}: ${files.length} files, ${bytes} bytes packed. As a new user:\n`);
  for (const { name, problem, known } of rows) {
    console.log(`  ${problem ? 'no ' : 'yes'}  ${name}${problem && known ? `: ${known}` : ''}`);
  }
  const unknown = rows.filter(({ problem, known }) => problem && !known);
  for (const row of unknown) console.log(`\n${row.name}: ${row.problem.slice(0, 2000)}`);
  process.exit(unknown.length > 0 ? 1 : 0);
}
