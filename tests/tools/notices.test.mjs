// The package and the page name the works of others, with their terms.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { notices } from '../../.tools/notices.mjs';
import { inRoot } from '../../.tools/shell.mjs';

const engine = ['Eigen', 'tinyobjloader', 'Emscripten', 'musl', 'libc\\+\\+'];
const formats = ['draco3d', 'meshoptimizer'];
const page = [...['three', 'three-mesh-bvh', 'uplot', 'delaunator', 'robust-predicates'], 'bunny'];

test('the package and the page have the terms of third-party work', () => {
  for (const [what, names, file] of [
    ['package', [...engine, ...formats], 'dist/third-party-notices.txt'],
    ['page', [...engine, ...formats, ...page], 'build/page/third-party-notices.txt'],
  ]) {
    const text = notices(what);
    for (const name of names) assert.match(text, new RegExp(`^.*\\b${name}`, 'm'), name);
    assert.equal(readFileSync(inRoot(file), 'utf8'), text);
  }
});
