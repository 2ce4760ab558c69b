// The book's code: its programs run, and the types allow its calls; each error has an entry, and
// each public name a sentence.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { basename, dirname } from 'node:path';
import { before, describe, test } from 'node:test';
import { filesBelow, inRoot, root } from '../../.tools/shell.mjs';

// The folder lies within the project, as code that imports the package by its name must.
const folder = inRoot('build/book/code');
const pages = [...filesBelow('docs', /\.md$/), inRoot('README.md')];

/** A page's pieces of code in a language. */
const piecesOf = (path, language) => {
  const pattern = new RegExp(`^\`\`\`${language}\\n([\\s\\S]*?)^\`\`\`$`, 'gm');
  return [...readFileSync(path, 'utf8').matchAll(pattern)].map(([, code]) => code);
};

/** Names that pieces of TypeScript use without a declaration. */
const left = `
import type { CenterOfMass, Karcher, Mesh as Surface, SurfacePoint, PointLike, Region } from 'karcher';
import type { BufferGeometry, WebGLRenderer, PerspectiveCamera, Mesh as Drawn, Raycaster } from 'three';
declare global {
  const karcher: Karcher;
  const mesh: Surface;
  const points: PointLike[];
  const point: SurfacePoint;
  const rows: number[];
  const weights: number[];
  const density: Float64Array;
  const center: CenterOfMass;
  const region: Region;
  const text: string;
  const bytes: Uint8Array;
  const signal: AbortSignal;
  const progress: (part: number) => void;
  const object: Drawn;
  const geometry: BufferGeometry;
  const keep: (curve: unknown) => void;
  const camera: PerspectiveCamera;
  const renderer: WebGLRenderer;
  const raycaster: Raycaster;
}
`;

/** More such names in the examples of the reference: of the folder, or of all. */
const leftInReference = (folder) => `
import type * as karcherPackage from 'karcher';
import type * as three from 'karcher/three';
declare const a: PointLike, b: PointLike, path: karcherPackage.Path, outline: karcherPackage.Path;
declare const paths: karcherPackage.Path[];
${
  folder === 'three'
    ? 'declare const curve: three.SurfaceCurve, surface: three.Surface<karcherPackage.Mesh>, tube: three.TubeOnSurface, material: import("three").Material;'
    : 'declare const curve: karcherPackage.Curve;'
}
type PointLike = karcherPackage.PointLike;
`;

/**
 * A module with an example of the reference, which may use all names of the package. `entryOf` has
 * the entry of each name.
 */
function exampleModule(code, own, entryOf) {
  const imports = code.match(/^import .*$/gm) ?? [];
  const names = new Set([...code.matchAll(/(?<!\w|[^.]\.)[A-Za-z]\w*/g)].map(([name]) => name));
  for (const name of names) {
    const isMissing = !imports.some((line) => new RegExp(`\\b${name}\\b`).test(line));
    if (entryOf.has(name) && isMissing) {
      imports.push(`import { ${name} } from '${entryOf.get(name)}';`);
    }
  }
  // In a block the example may declare names again.
  return `${imports.join('\n')}\n${own}{\n${code.replace(/^import .*$/gm, '')}}\n`;
}

/** A component for react-three-fiber with a piece of code as its body. */
const componentOf = (body) => `
import '@react-three/fiber';
import { useCurveDrag, useSurface, useSurfaceCurve } from 'karcher/react';
export function Component() {
${body}}
`;

/** Compiles the files of the folder without writing anything. */
function checkTypes() {
  writeFileSync(`${folder}/left.d.ts`, left);
  const compilerOptions = {
    ...{ target: 'ES2022', module: 'ESNext', moduleResolution: 'bundler', strict: true },
    ...{ noEmit: true, lib: ['ES2023', 'DOM', 'DOM.Iterable'], types: [], skipLibCheck: true },
    ...{ exactOptionalPropertyTypes: true, jsx: 'react-jsx' },
  };
  writeFileSync(`${folder}/tsconfig.json`, JSON.stringify({ compilerOptions, include: ['.'] }));
  const tsc = `${root}node_modules/typescript/bin/tsc`;
  const { status, stdout } = spawnSync(process.execPath, [tsc, '-p', folder], {
    encoding: 'utf8',
  });
  assert.equal(status, 0, stdout);
}

describe('the book', () => {
  before(() => {
    rmSync(folder, { recursive: true, force: true });
    mkdirSync(folder, { recursive: true });
  });

  // The pieces of a page continue each other.
  for (const page of pages.filter((path) => piecesOf(path, 'js').length > 0)) {
    test(`${basename(page)}: its program runs`, () => {
      const file = `${folder}/${basename(page, '.md')}.mjs`;
      writeFileSync(file, piecesOf(page, 'js').join('\n'));
      const { status, stdout, stderr } = spawnSync(process.execPath, [file], { encoding: 'utf8' });
      assert.equal(status, 0, stderr);
      assert.ok(!/NaN|undefined/.test(stdout), stdout);
    });
  }

  test('the types allow its TypeScript, even of components', () => {
    let pieces = 0;
    for (const page of pages) {
      for (const code of piecesOf(page, 'ts')) {
        writeFileSync(`${folder}/${basename(page, '.md')}-${pieces++}.ts`, `${code}\nexport {};\n`);
      }
      for (const code of piecesOf(page, 'tsx')) {
        writeFileSync(`${folder}/${basename(page, '.md')}-${pieces++}.tsx`, componentOf(code));
      }
    }
    assert.ok(pieces >= 20, `${pieces} pieces`);
    checkTypes();
  });

  test('the types allow the examples of its reference', async () => {
    const entryOf = new Map();
    for (const entry of ['karcher/three', 'karcher/statistics', 'karcher/formats', 'karcher']) {
      for (const name of Object.keys(await import(entry))) entryOf.set(name, entry);
    }
    let pieces = 0;
    for (const file of filesBelow('wasm', /\.ts$/)) {
      const text = readFileSync(file, 'utf8').replace(/^ *\* ?/gm, '');
      for (const [, code] of text.matchAll(/@example\n```ts\n([\s\S]*?)```$/gm)) {
        const own = leftInReference(basename(dirname(file)));
        const name = `${folder}/${basename(file, '.ts')}-example-${pieces++}.ts`;
        writeFileSync(name, exampleModule(code, own, entryOf));
      }
    }
    assert.ok(pieces >= 40, `${pieces} examples`);
    checkTypes();
  });

  test('has an entry for each error, and no other', () => {
    const types = readFileSync(inRoot('wasm/types.ts'), 'utf8');
    const [, union] = /export type ErrorCode =([^;]*);/.exec(types);
    const codes = [...union.matchAll(/'(\w+)'/g)].map(([, code]) => code);
    const entries = [...readFileSync(inRoot('docs/errors.md'), 'utf8').matchAll(/^## (\w+)$/gm)];
    assert.deepEqual(
      entries.map(([, code]) => code),
      codes,
    );
  });

  test('has an example for each call, and a sentence for each name', () => {
    const said = JSON.parse(readFileSync(inRoot('build/book/reference.json'), 'utf8'));
    assert.ok(said.names > 500);
    for (const what of ['withoutSentence', 'withoutExample'])
      assert.deepEqual(said[what], [], what);
  });
});
