// Builds the parts of Karcher: native libraries and tests, the WebAssembly module, its TypeScript
// facade, the page, the book beside it, and a mesh to try them on.
//
//   node .tools/build.mjs [wasm] [facade] [page] [book] [bunny] [native]    (without arguments all but the last)
import {
  chmodSync,
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { dirname } from 'node:path';
import { pathToFileURL } from 'node:url';
import { notices } from './notices.mjs';
import { setUp } from './setup.mjs';
import { cores, filesBelow, inRoot, root, run } from './shell.mjs';

// The folder in which Debian's Emscripten finds its JavaScript optimizer's libraries, if Node is
// not Debian's own.
const debianNodeModules = '/usr/share/nodejs';

/** Runs the program of an npm package with this Node. */
const runNpmProgram = (path, ...args) =>
  run(process.execPath, [inRoot(`node_modules/${path}`), ...args]);

/** Configures and builds one of CMakePresets.json's native presets. */
export async function buildNative(preset, ...targets) {
  await run('cmake', ['--preset', preset]);
  const named = targets.length > 0 ? ['--target', ...targets] : [];
  await compile(preset, named);
}

/**
 * The limit for compiling, in minutes. On two cores that 25 programs share it takes more than half
 * an hour.
 */
const compileMinutes = 240;

async function compile(preset, more, env) {
  const args = ['--build', '--preset', preset, '--parallel', `${cores}`, ...more];
  await run('cmake', args, { env, minutes: compileMinutes });
}

const emscriptenEnv = () => (existsSync(debianNodeModules) ? { NODE_PATH: debianNodeModules } : {});

/** Configures the preset of the WebAssembly module, with more arguments for CMake. */
export const configureWasm = (...args) =>
  run('emcmake', ['cmake', '--preset', 'wasm', ...args], { env: emscriptenEnv() });

/** Builds the engine as dist/karcher-engine.mjs and .wasm. */
export async function buildWasm() {
  const env = emscriptenEnv();
  await configureWasm();
  await compile('wasm', [], env);
  await minify('dist/karcher-engine.mjs', 'dist/peers/karcher-peers.mjs');
}

/** Minifies the JavaScript that Emscripten writes. */
async function minify(...names) {
  const { minifySync } = await import('rolldown/utils');
  for (const name of names) {
    const { code, errors } = minifySync(name, readFileSync(inRoot(name), 'utf8'), { module: true });
    if (errors.length > 0) throw new Error(`${name}: ${errors[0].message}`);
    writeFileSync(inRoot(name), code);
  }
}

/**
 * Builds the facade and the command line program: wasm/*.ts to dist/*.js and .d.ts. Only the types
 * keep comments and indentation, since a page need not load them. No string of the facade contains
 * line breaks, so that no string loses indentation.
 */
export async function buildFacade() {
  // The package contains all of dist, so that outputs of deleted sources must not stay there.
  for (const file of filesBelow('dist', /\.js$|\.d\.ts$/)) rmSync(file);
  const typescript = 'typescript/bin/tsc';
  await runNpmProgram(typescript, '-p', 'wasm', '--emitDeclarationOnly');
  await runNpmProgram(
    ...[typescript, '-p', 'wasm', '--declaration', 'false', '--removeComments', '--noCheck'],
  );
  for (const name of readdirSync(inRoot('dist')).filter((file) => file.endsWith('.js'))) {
    const file = inRoot(`dist/${name}`);
    writeFileSync(file, readFileSync(file, 'utf8').replace(/^ +/gm, ''));
  }
  // The declarations name types of the modules, but the compiler does not write the modules' own
  // declarations.
  const modules = ['karcher-engine', 'peers/karcher-peers'];
  for (const name of [...modules, 'formats/draco_decoder', 'formats/meshopt_decoder']) {
    copyFileSync(inRoot(`wasm/${name}.d.mts`), inRoot(`dist/${name}.d.mts`));
  }
  writeDecoders();
  chmodSync(inRoot('dist/cli.js'), 0o755);
  writeFileSync(inRoot('dist/third-party-notices.txt'), notices('package'));
}

/**
 * Writes the decoders of compressed glTF files as modules without dependencies, for Node and
 * browsers. Draco's decoder is a script that runs in both. The module around it passes it Node's
 * built-in modules, and its WebAssembly module from a base64 text.
 */
function writeDecoders() {
  const from = (path) => inRoot(`node_modules/${path}`);
  copyFileSync(
    from('meshoptimizer/meshopt_decoder.mjs'),
    inRoot('dist/formats/meshopt_decoder.mjs'),
  );
  const script = readFileSync(from('draco3d/draco_decoder_nodejs.js'), 'utf8');
  const wasm = readFileSync(from('draco3d/draco_decoder.wasm')).toString('base64');
  const module = [
    `const create = ((require, __dirname, __filename, module, exports, define) => {\n${script}`,
    "return DracoDecoderModule;\n})((name) => process.getBuiltinModule(name), '');",
    `const wasm = '${wasm}';`,
    'export default () =>',
    '  create({ wasmBinary: Uint8Array.from(atob(wasm), (one) => one.charCodeAt(0)) });\n',
  ];
  writeFileSync(inRoot('dist/formats/draco_decoder.mjs'), module.join('\n'));
}

/** Builds the page in build/page. */
export async function buildPage() {
  await runNpmProgram('vite/bin/vite.js', 'build', '--logLevel', 'warn');
}

/**
 * Builds the book in build/page/book, from the facade's types and docs/. A later build of the page
 * removes it.
 */
export async function buildBook() {
  const { makeBook } = await import('../docs/book/make.mjs');
  await makeBook();
}

/** Writes the npm package's bunny to build/data/bunny.obj, with all digits. */
export async function writeBunny() {
  const { default: bunny } = await import('bunny');
  const lines = [
    ...bunny.positions.map((position) => `v ${position.join(' ')}`),
    ...bunny.cells.map((cell) => `f ${cell.map((vertex) => vertex + 1).join(' ')}`),
  ];
  const path = inRoot('build/data/bunny.obj');
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, `${lines.join('\n')}\n`);
}

const parts = {
  wasm: buildWasm,
  facade: buildFacade,
  page: buildPage,
  book: buildBook,
  bunny: writeBunny,
  native: async () => {
    await writeBunny();
    await buildNative('native');
  },
};

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const names = process.argv.slice(2);
  const unknown = names.find((name) => !(name in parts));
  if (unknown) {
    console.error(`There is no part '${unknown}' to build: ${Object.keys(parts).join(', ')}.`);
    process.exit(1);
  }
  await setUp('build', ...(names.includes('native') ? ['native'] : []));
  try {
    for (const name of names.length > 0
      ? names
      : Object.keys(parts).filter((name) => name !== 'native'))
      await parts[name]();
  } catch (error) {
    console.error(error.message);
    process.exit(1);
  }
  console.log(`Built in ${root}: dist/ and build/.`);
}
