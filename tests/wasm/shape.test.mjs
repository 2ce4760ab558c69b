import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { grid, tetrahedron } from './meshes.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const shapes = { sphere: [0, 0], torus: [1, 0], knot: [1, 0], genus3: [3, 0], openSheet: [0, 1] };

test('built-in shapes have their topology and about the requested triangles', () => {
  for (const [name, [genus, boundaryLoops]] of Object.entries(shapes)) {
    const mesh = karcher.shape(name, 5000);
    const { info } = mesh;
    assert.equal(info.components, 1);
    assert.equal(info.genus, genus, name);
    assert.equal(info.boundaryLoops, boundaryLoops, name);
    assert.deepEqual(info.repairs, []);
    assert.ok(Math.abs(info.triangles / 5000 - 1) < 0.34, `${name}: ${info.triangles}`);
    assert.equal(mesh.positions().length, 3 * info.vertices);
    mesh.dispose();
  }
});

test('unknown shapes are refused', () => {
  assert.throws(() => karcher.shape('cube'), { code: 'badArgument', message: /sphere, torus/ });
  for (const triangles of [0, -1, 1e9, 0.5, '20', Number.NaN]) {
    assert.throws(() => karcher.shape('sphere', triangles), { code: 'badArgument' });
  }
});

test('Loop subdivision: four triangles for each, as a separate mesh', () => {
  const mesh = karcher.meshFromObj(tetrahedron);
  const [once, twice] = [mesh.subdivide(), mesh.subdivide(2)];
  mesh.dispose();
  assert.equal(once.info.triangles, 16);
  assert.equal(once.info.vertices, 10);
  assert.equal(twice.info.triangles, 64);
  assert.equal(twice.info.genus, 0);
  // Two levels at once equal one level twice.
  const sorted = (positions) => Array.from(positions, (x) => x.toFixed(12)).sort();
  assert.deepEqual(sorted(once.subdivide().positions()), sorted(twice.positions()));
  const flat = karcher.meshFromObj(grid(2)).subdivide();
  assert.equal(flat.info.boundaryLoops, 1);
  for (const levels of [0, -1, 1.5, '1', 40]) {
    assert.throws(() => once.subdivide(levels), { code: 'badArgument' });
  }
});
