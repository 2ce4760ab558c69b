// Curves of distant points stay connected with the default method.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { randomFrom, seed } from '../web/part.mjs';

test(`20 far curves, seed ${seed}`, async () => {
  const karcher = await load();
  const mesh = karcher.shape('torus', 40_000);
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
