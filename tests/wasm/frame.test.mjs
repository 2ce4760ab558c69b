// Frames at points of surfaces.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { surfaceFromMesh } from 'karcher/three';
import { loadInWorker } from 'karcher/worker';
import { Vector3 } from 'three';
import { randomFrom, seed } from '../web/part.mjs';

const karcher = await load();

const norm = (a) => Math.hypot(...a);
const minus = (a, b) => a.map((value, i) => value - b[i]);
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const triple = (numbers, i) => [...numbers.slice(3 * i, 3 * i + 3)];

const drawn = (name) => {
  console.log(`${name}: drawn with KARCHER_SEED=${seed}`);
  return randomFrom(seed);
};

const somewhere = (mesh, random) => {
  const [u, v] = [random(), random()];
  const [a, b] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
  return { face: Math.floor(random() * mesh.info.triangles), bary: [1 - a - b, a, b] };
};

test('a frame has right angles, the first edge and the normal, as that of three.js has', () => {
  const random = drawn('frames');
  const mesh = karcher.shape('torus', 500);
  const surface = surfaceFromMesh(mesh);
  const [positions, triangles] = [mesh.positions(), mesh.triangles()];
  for (let i = 0; i < 50; i++) {
    const point = i === 0 ? { vertex: 5 } : somewhere(mesh, random);
    const frame = mesh.frame(point);
    frame.forEach((axis, k) => {
      frame.forEach((other, l) => {
        assert.ok(Math.abs(dot(axis, other) - (k === l ? 1 : 0)) < 1e-14);
      });
    });
    assert.deepEqual(frame[2], mesh.normal(point));
    const axes = [new Vector3(), new Vector3(), new Vector3()];
    if (i === 0) continue;
    surface.frame(point).extractBasis(...axes);
    axes.forEach((axis, k) => {
      // The axes in three.js come from places in single precision and edges a 30th as long.
      assert.ok(norm(minus(frame[k], axis.toArray())) < 1e-5);
    });
    const [a, b] = [0, 1].map((k) => triple(positions, triangles[3 * point.face + k]));
    assert.ok(Math.abs(dot(frame[0], minus(b, a)) - norm(minus(b, a))) < 1e-14);
  }
  assert.throws(() => mesh.frame({ vertex: 1e6 }), { code: 'badIndex' });
});

test('a worker has the same frames', async () => {
  const remote = await loadInWorker();
  const far = await remote.shape('torus', 500);
  assert.deepEqual(
    await far.frame({ vertex: 7 }),
    karcher.shape('torus', 500).frame({ vertex: 7 }),
  );
  remote.dispose();
});
