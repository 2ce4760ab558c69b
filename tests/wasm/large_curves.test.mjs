// Far refined curves on millions of triangles: what they hold does not grow with the mesh.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { long, randomFrom, seed } from '../web/part.mjs';

/** A torus of 2 x around x along triangles. */
function torusArrays(around, along) {
  const positions = new Float64Array(3 * around * along);
  const triangles = new Int32Array(6 * around * along);
  for (let j = 0; j < along; j++) {
    for (let i = 0; i < around; i++) {
      const [u, v] = [(2 * Math.PI * j) / along, (2 * Math.PI * i) / around];
      const ring = 1 + 0.4 * Math.cos(v);
      const k = j * around + i;
      positions.set([ring * Math.cos(u), ring * Math.sin(u), 0.4 * Math.sin(v)], 3 * k);
      const at = (di, dj) => ((j + dj) % along) * around + ((i + di) % around);
      triangles.set([at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0)], 6 * k);
    }
  }
  return [positions, triangles];
}

test(`20 far refined curves, seed ${seed}`, async () => {
  const karcher = await load();
  // Four million take the module 2 of its 4 GB.
  const mesh = karcher.meshFromArrays(...torusArrays(...(long ? [1000, 2000] : [100, 200])));
  const { triangles, diagonal } = mesh.info;
  const random = randomFrom(seed);
  const before = karcher.allocatedBytes();
  const curves = Array.from({ length: 20 }, () => {
    let here = { face: Math.floor(triangles * random()), bary: [0.2, 0.3, 0.5] };
    const points = [here];
    for (let k = 1; k < 4; k++) {
      const direction = [random() - 0.5, random() - 0.5, random() - 0.5];
      here = mesh.straightest(here, direction, 0.3 * diagonal).end;
      points.push(here);
    }
    return mesh.curve({ kind: 'bezier', points });
  });
  const refined = curves.filter(({ levels }) => levels > 0);
  assert.ok(refined.length > 10, `${refined.length} of 20 are refined`);
  for (const curve of curves) {
    assert.ok(curve.samples().status.every((status) => status !== 'noSolution'));
  }
  const held = (karcher.allocatedBytes() - before) / curves.length;
  assert.ok(held < 8e6, `${held} bytes a curve`);
  mesh.dispose();
});
