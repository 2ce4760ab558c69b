// What others wrote is named with its terms, in the package and on the page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { notices } from '../../.tools/notices.mjs';
import { inRoot } from '../../.tools/shell.mjs';

const engine = ['Eigen', 'tinyobjloader', 'Emscripten', 'musl', 'libc\\+\\+'];
const page = [
  ...['three', 'three-mesh-bvh', 'uplot', 'meshoptimizer', 'delaunator', 'robust-predicates'],
  'bunny',
];

test('the package and the page have the terms of what others wrote', () => {
  for (const [what, names, file] of [
    ['package', engine, 'dist/third-party-notices.txt'],
    ['page', [...engine, ...page], 'build/page/third-party-notices.txt'],
  ]) {
    const text = notices(what);
    for (const name of names) assert.match(text, new RegExp(`^.*\\b${name}`, 'm'), name);
    assert.equal(readFileSync(inRoot(file), 'utf8'), text);
  }
});
