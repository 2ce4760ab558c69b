// The rectangle around places, by the log maps of a few of them, is that of all log maps.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { load } from 'karcher';
import { pageModule } from './page_module.mjs';
import { randomFrom, seed } from './part.mjs';

describe('the rectangle around places', () => {
  let karcher;
  let boxAround;
  before(async () => {
    karcher = await load();
    ({ boxAround } = await pageModule('../../web/worker/extent.ts'));
  });

  const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);

  /** Perpendicular unit vectors in the tangent plane of a point. */
  function axesAt(mesh, at) {
    const [x, y, z] = mesh.normal(at);
    const far = Math.hypot(x, y);
    const along = [y / far, -x / far, 0];
    return [along, [-z * along[1], z * along[0], y * along[0] - x * along[1]]];
  }

  /** Counts the places to which the engine finds paths. */
  const counting = (mesh) => {
    const counted = { places: 0 };
    counted.mesh = {
      positionsOf: (points) => mesh.positionsOf(points),
      triangles: () => mesh.triangles(),
      logMap(from, points) {
        if (Array.isArray(points)) counted.places += points.length;
        return mesh.logMap(from, points);
      },
    };
    return counted;
  };

  for (const [shape, triangles, count] of [
    ['sphere', 20000, 200],
    ['torus', 20000, 200],
    ['sphere', 500, 400],
    ['sphere', 5000, 3],
  ]) {
    test(`around ${count} places of a ${shape} of ${triangles} triangles, KARCHER_SEED=${seed}`, () => {
      const random = randomFrom(seed);
      const mesh = karcher.shape(shape, triangles);
      const { diagonal, meanEdge } = mesh.info;
      const face = Math.floor(random() * mesh.info.triangles);
      const at = { face, bary: [0.2, 0.3, 0.5] };
      const axes = axesAt(mesh, at);
      const [first, second] = [0, 0].map(() => 2 * Math.PI * random());
      const vectors = Array.from({ length: count }, (_, i) => {
        const angle = (2 * Math.PI * i) / count;
        const far = diagonal * (0.08 + 0.03 * Math.sin(2 * angle + first));
        const way = [Math.cos(angle + second), Math.sin(angle + second)];
        return [0, 1, 2].map((k) => far * (way[0] * axes[0][k] + way[1] * axes[1][k]));
      });
      const { points } = mesh.expMap(at, vectors.flat());
      const around = points.map((place, i) => ({ place, radius: 0.01 * diagonal * (i % 2) }));
      const logs = mesh.logMap(at, points).vectors;
      const ends = (axis, way) =>
        way *
        Math.max(
          ...around.map(
            ({ radius }, i) => way * dot(axes[axis], logs.subarray(3 * i, 3 * i + 3)) + radius,
          ),
        );
      const all = { left: ends(0, -1), right: ends(0, 1), bottom: ends(1, -1), top: ends(1, 1) };
      const counted = counting(mesh);
      const box = boxAround(counted.mesh, at, around, axes);
      const isFine = mesh.info.vertices > 20 * count;
      assert.ok(counted.places <= (isFine ? 4 : count), `${counted.places} paths`);
      for (const side of Object.keys(all)) {
        const off = Math.abs(box[side] - all[side]);
        // The choice among places that reach as far is as good as the vertices are close.
        const most = isFine ? (0.1 * meanEdge ** 2) / diagonal : 1e-12;
        assert.ok(off <= most, `${side}: ${box[side]}, not ${all[side]}; ${off} of ${most}`);
      }
    });
  }
});
