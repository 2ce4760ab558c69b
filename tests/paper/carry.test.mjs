// A drawing carried by the weights of its points.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { loadPeers } from 'karcher/peers';
import { load } from './load.mjs';

let lab;
let carried;
before(async () => {
  const { Lab } = await load('lab/lab.ts');
  carried = await load('figures/carried.ts');
  lab = new Lab(await loadPeers());
});

const torus = { kind: 'shape', name: 'torus', triangles: 2000 };
const jobOf = (source, target, points) => ({
  source,
  target,
  middle: carried.carriedMiddle,
  points,
});

describe('a drawing', () => {
  test('carried by the same points stays where it is', async () => {
    const { points } = carried.carriedSides.source;
    const { info } = await lab.mesh(torus);
    const same = await lab.carry(jobOf(torus, torus, { source: points, target: points }));
    assert.equal(same.carried, same.points);
    assert.equal(same.reason, null);
    assert.equal(same.target.length, same.source.length);
    for (const [k, line] of same.target.entries()) {
      const most = Math.max(...line.map((x, i) => Math.abs(x - same.source[k][i])));
      // Places are stored in single precision.
      assert.ok(most < 1e-6 * info.diagonal, `${most}`);
    }
  });

  test('carried to another surface is complete, with three and with four points', async () => {
    const { source, target } = carried.carriedSides;
    for (const count of [3, 4]) {
      const places = {
        source: source.points.slice(0, count),
        target: target.points.slice(0, count),
      };
      const found = await lab.carry(jobOf(source.mesh, target.mesh, places));
      assert.equal(found.carried, found.points, found.reason);
      assert.equal(found.target.length, 2);
      for (const line of found.target) {
        // The line lies on the sphere's faces, between its vertices.
        for (let i = 0; i < line.length; i += 3) {
          const radius = Math.hypot(...line.slice(i, i + 3));
          assert.ok(radius > 0.99 && radius < 1 + 1e-6, `${radius}`);
        }
        assert.deepEqual(line.slice(0, 3), line.slice(-3));
      }
    }
  });

  test('on planes is carried by the map that is linear in the weights', async () => {
    const plane = { kind: 'plane', tessellation: 'delaunay', triangles: 1000 };
    const middle = [0.5, 0.5, 0];
    const corners = [
      [0.1, 0.1, 0],
      [0.9, 0.1, 0],
      [0.5, 0.9, 0],
    ];
    // The target is half as large, and turned by a right angle.
    const turned = corners.map(([x, y]) => [0.5 - 0.5 * (y - 0.5), 0.5 + 0.5 * (x - 0.5), 0]);
    const found = await lab.carry({
      ...jobOf(plane, plane, { source: corners, target: turned }),
      middle,
    });
    assert.equal(found.carried, found.points, found.reason);
    for (const [k, line] of found.target.entries()) {
      for (let i = 0; i < line.length; i += 3) {
        const [x, y] = found.source[k].slice(i, i + 2);
        const expected = [0.5 - 0.5 * (y - 0.5), 0.5 + 0.5 * (x - 0.5)];
        const off = Math.hypot(line[i] - expected[0], line[i + 1] - expected[1]);
        assert.ok(off < 1e-6, `${off}`);
      }
    }
  });

  test('without weights says why', async () => {
    // All points coincide: seen from elsewhere they lie in one direction.
    const { points } = carried.carriedSides.source;
    const one = [points[0], points[0], points[0]];
    const found = await lab.carry(jobOf(torus, torus, { source: one, target: points.slice(0, 3) }));
    assert.equal(found.carried, 0);
    assert.match(found.reason, /line/);
    assert.deepEqual(found.target, []);
  });
});
