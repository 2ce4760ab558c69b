// Figure 2: the transport of a vector from a vertex into a face.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from './load.mjs';

let pyramid;
let transportInto;
before(async () => {
  ({ pyramid, transportInto } = await load('figures/transport.ts'));
});

/** The difference of two angles, modulo full turns. */
const apart = (a, b) => Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)));

test('on a flat star a vector is unchanged in space', () => {
  const star = pyramid(0);
  for (let t = 0; t < star.ring.length; t++) {
    const { rotation, defect } = transportInto(star, t);
    assert.ok(Math.abs(defect) < 1e-12);
    // The frame of v begins at neighbor 0, that of the face at neighbor t.
    const [x, y] = star.ring[t];
    const angle = Math.atan2(y, x) - Math.atan2(star.ring[0][1], star.ring[0][0]);
    assert.ok(apart(rotation, -angle) < 1e-12, `face ${t}`);
  }
});

test('it keeps its angle with the segment to the centroid', () => {
  const star = pyramid(0.7);
  for (let t = 0; t < star.ring.length; t++) {
    const { rotation, thetaVt, thetaTv, centroid, distance, defect } = transportInto(star, t);
    assert.ok(defect > 0.5);
    for (const angle of [0, 1, 2.5, 4]) {
      // The direction from v continues at the centroid, opposite to the direction back.
      assert.ok(apart(angle - thetaVt, angle + rotation - (thetaTv + Math.PI)) < 1e-12);
    }
    assert.ok(apart(thetaTv + Math.PI, Math.atan2(centroid[1], centroid[0])) < 1e-12);
    assert.ok(Math.abs(distance - Math.hypot(...centroid)) < 1e-12);
  }
});

test('the star laid flat has its edges’ lengths and a full turn', () => {
  const star = pyramid(0.7);
  const { ring } = transportInto(star, 0);
  star.ring.forEach(([x, y, z], i) => {
    const length = Math.hypot(x - star.apex[0], y - star.apex[1], z - star.apex[2]);
    assert.ok(Math.abs(Math.hypot(...ring[i]) - length) < 1e-12);
  });
  let turned = 0;
  ring.forEach(([x, y], i) => {
    const [nextX, nextY] = ring[(i + 1) % ring.length];
    turned += Math.atan2(x * nextY - y * nextX, x * nextX + y * nextY);
  });
  assert.ok(Math.abs(turned - 2 * Math.PI) < 1e-12);
});
