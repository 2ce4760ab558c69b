// The works of others that the package and the page contain, with their licences.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { inRoot } from './shell.mjs';

const mpl = 'Mozilla Public License, version 2.0: https://www.mozilla.org/MPL/2.0/';
const apache = 'Apache License, version 2.0: https://www.apache.org/licenses/LICENSE-2.0';
const mit = 'MIT License: https://opensource.org/license/mit';
const llvm = 'Apache License, version 2.0, with LLVM exceptions: https://llvm.org/LICENSE.txt';

/**
 * The works in the engine's module. `file` is the path of the terms on a system, and `otherwise`
 * names the terms for systems without it.
 */
const ofEngine = [
  {
    ...{ name: 'Eigen', where: 'https://eigen.tuxfamily.org' },
    ...{ file: '/usr/share/doc/libeigen3-dev/copyright', otherwise: mpl },
  },
  {
    ...{ name: 'tinyobjloader', where: 'https://github.com/tinyobjloader/tinyobjloader' },
    ...{ file: '/usr/share/doc/libtinyobjloader-dev/copyright', otherwise: mit },
  },
  {
    name: "Emscripten's runtime, with musl, dlmalloc, libc++, libc++abi and compiler-rt",
    where: 'https://emscripten.org',
    file: '/usr/share/doc/emscripten/copyright',
    otherwise: `Emscripten and musl: ${mit}\nlibc++, libc++abi and compiler-rt: ${llvm}\ndlmalloc: public domain`,
  },
];

/** The decoders of compressed glTF files, which are packages of npm. */
const ofFormats = ['draco3d', 'meshoptimizer'];

/** The works in the page. `bunny` is the mesh with which it opens. */
const ofPage = [
  ...['three', 'three-mesh-bvh', 'uplot', 'delaunator', 'robust-predicates'],
  'bunny',
  // The book's own scripts.
  ...['typedoc', 'lunr'],
];

function termsOf(name) {
  const folders = [inRoot(`node_modules/${name}`), inRoot(`docs/book/node_modules/${name}`)];
  const folder = folders.find(existsSync);
  const file = readdirSync(folder).find((one) => /^licen[cs]e(\.|$)/i.test(one));
  const { license, homepage, repository } = JSON.parse(
    readFileSync(`${folder}/package.json`, 'utf8'),
  );
  const where = homepage ?? repository?.url ?? '';
  const named = license === 'Apache-2.0' ? apache : license;
  return { where, terms: file ? readFileSync(`${folder}/${file}`, 'utf8') : named };
}

const entry = (name, where, terms) =>
  [`${'='.repeat(78)}\n${name}`, where, '', terms.trim(), ''].join('\n');

/** The notices as text: of the package, or of the page, which also contains the package's works. */
export function notices(what) {
  const engine = ofEngine.map(({ name, where, file, otherwise }) =>
    entry(name, where, existsSync(file) ? readFileSync(file, 'utf8') : otherwise),
  );
  const packages = [...ofFormats, ...(what === 'page' ? ofPage : [])].map((name) => {
    const { where, terms } = termsOf(name);
    return entry(name, where, terms);
  });
  const head = `What others wrote of Karcher's ${what}, and the terms that it is under.\n`;
  return [head, ...engine, ...packages].join('\n');
}
