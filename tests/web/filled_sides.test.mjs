// Regions as triangles: neighbors share whole edges, so that no pixel between them stays empty.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { load as loadEngine } from 'karcher';
import { load } from './figures.mjs';

const seed = Number(process.env.KARCHER_SEED ?? 1);
/** Numbers from 0 to 1 (mulberry32). */
function randomsFrom(start) {
  let state = start >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

const turn = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
const edgeOf = (a, b) => (a < b ? `${a} ${b}` : `${b} ${a}`);

describe('parts of faces', () => {
  const random = randomsFrom(seed);
  const star = (corners, least, most, snap) =>
    Array.from({ length: corners }, (_, i) => {
      const angle = (2 * Math.PI * (i + 0.3 * random())) / corners;
      const far = least + (most - least) * random();
      const on = (x) => Math.round((0.5 + x) * snap) / snap;
      return [on(far * Math.cos(angle)), on(far * Math.sin(angle))];
    });
  const sidesOf = (loop) => loop.map((end, i) => [end, loop[(i + 1) % loop.length]]);

  /** Whether two sides share at most a common end. */
  function areApart(sides) {
    return sides.every(([a, b], i) =>
      sides.slice(i + 1).every(([p, q]) => {
        const [s, t, u, v] = [turn(a, b, p), turn(a, b, q), turn(p, q, a), turn(p, q, b)];
        const common = [a, b].some((one) => `${one}` === `${p}` || `${one}` === `${q}`);
        return common ? s !== 0 || t !== 0 : s * t > 0 || u * v > 0;
      }),
    );
  }

  test('are filled by triangles without other corners, of which each edge has two, or is a side', async () => {
    const { filledSides } = await load('worker/filled_sides.ts');
    let drawn = 0;
    for (let round = 0; drawn < 600 && round < 100_000; round++) {
      // On a coarse grid many corners lie above each other.
      const snap = [2 ** 5, 2 ** 8, 2 ** 40][round % 3];
      const loops = [star(3 + Math.floor(20 * random()), 0.3, 0.5, snap)];
      if (random() < 0.6) loops.push(star(3 + Math.floor(9 * random()), 0.05, 0.13, snap));
      const sides = loops.flatMap(sidesOf);
      if (!areApart(sides)) continue;
      drawn++;
      const { parts, corners } = filledSides(
        new Int32Array(sides.length),
        Float64Array.from(sides.flat(2)),
      );
      const borders = new Set(sides.map(([a, b]) => edgeOf(`${a}`, `${b}`)));
      const uses = new Map();
      let area = 0;
      for (let i = 0; i < parts.length; i++) {
        const triangle = [0, 2, 4].map((k) =>
          Array.from(corners.subarray(6 * i + k, 6 * i + k + 2)),
        );
        const twice = turn(...triangle);
        assert.ok(twice > 0, `seed ${seed}, round ${round}: a triangle of ${twice / 2}`);
        area += twice / 2;
        for (const [k, corner] of triangle.entries()) {
          const edge = edgeOf(`${corner}`, `${triangle[(k + 1) % 3]}`);
          uses.set(edge, (uses.get(edge) ?? 0) + 1);
        }
      }
      const areas = loops.map((loop) =>
        Math.abs(sidesOf(loop).reduce((sum, [[x, y], [u, v]]) => sum + (x * v - y * u) / 2, 0)),
      );
      const wanted = areas[0] - (areas[1] ?? 0);
      assert.ok(Math.abs(area - wanted) < 1e-12, `seed ${seed}, round ${round}: ${area - wanted}`);
      for (const side of borders) assert.equal(uses.get(side), 1, `seed ${seed}, round ${round}`);
      for (const [edge, count] of uses) {
        assert.equal(count, borders.has(edge) ? 1 : 2, `seed ${seed}, round ${round}`);
      }
    }
    assert.equal(drawn, 600);
  });
});

describe('regions of surfaces', () => {
  let karcher;
  before(async () => {
    karcher = await loadEngine();
  });

  /** The length of the edges that belong to only one triangle, and the area of all triangles. */
  function measured(mesh, { whole, parts, corners }) {
    const [positions, triangles] = [mesh.positions(), mesh.triangles()];
    const uses = new Map();
    let area = 0;
    const add = (face, weights) => {
      const vertices = triangles.subarray(3 * face, 3 * face + 3);
      const ends = weights.map((w) => {
        const order = [0, 1, 2].filter((k) => w[k] !== 0).sort((a, b) => vertices[a] - vertices[b]);
        const name = order.map((k) => `${vertices[k]}:${w[k]}`).join();
        const place = [0, 1, 2].map((axis) =>
          order.reduce((sum, k) => sum + w[k] * positions[3 * vertices[k] + axis], 0),
        );
        return { name, place };
      });
      const [a, b, c] = ends.map(({ place }) => place);
      const [u, v] = [b, c].map((to) => to.map((x, axis) => x - a[axis]));
      area +=
        Math.hypot(
          u[1] * v[2] - u[2] * v[1],
          u[2] * v[0] - u[0] * v[2],
          u[0] * v[1] - u[1] * v[0],
        ) / 2;
      for (const [k, end] of ends.entries()) {
        const next = ends[(k + 1) % 3];
        const edge = edgeOf(end.name, next.name);
        const length = Math.hypot(...end.place.map((x, axis) => x - next.place[axis]));
        const known = uses.get(edge) ?? { count: 0, length };
        uses.set(edge, { ...known, count: known.count + 1 });
      }
    };
    for (const face of whole)
      add(face, [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ]);
    for (const [i, face] of parts.entries()) {
      add(
        face,
        [0, 2, 4].map((k) => {
          const [b, c] = corners.subarray(6 * i + k, 6 * i + k + 2);
          return [1 - b - c, b, c];
        }),
      );
    }
    const all = [...uses.values()];
    assert.ok(all.every(({ count }) => count <= 2));
    return {
      area,
      border: all.reduce((sum, { count, length }) => sum + (count === 1 ? length : 0), 0),
    };
  }

  test('have triangles with whole edges in common, but for those of their borders', async () => {
    const { fillOf } = await load('worker/fills.ts');
    const random = randomsFrom(seed + 1);
    let filled = 0;
    for (const [shape, count] of [
      ['sphere', 600],
      ['torus', 1200],
      ['knot', 2500],
    ]) {
      const mesh = karcher.shape(shape, count);
      const triangles = mesh.triangles();
      for (let round = 0; round < 40; round++) {
        // Some points are vertices or lie on edges, so that lines run along edges and through vertices.
        const points = Array.from({ length: 3 + Math.floor(3 * random()) }, () => {
          const face = Math.floor((random() * triangles.length) / 3);
          const kind = Math.floor(3 * random());
          const part = random();
          const bary = [
            [1, 0, 0],
            [1 - part, part, 0],
            [0.3, 0.3, 0.4],
          ][kind];
          return mesh.surfacePoint(face, bary);
        });
        const line = points.flatMap((point, i) =>
          mesh
            .shortestPath(point, points[(i + 1) % points.length])
            .points()
            .slice(0, -1),
        );
        const { region, problem } = fillOf(mesh, [[...line, line[0]]], null);
        if (!region) {
          assert.match(problem, /./);
          continue;
        }
        filled++;
        const { area, border } = measured(mesh, region);
        const perimeter = region.boundary.reduce((sum, path) => sum + path.length, 0);
        const where = `seed ${seed}, ${shape}, round ${round}`;
        assert.ok(Math.abs(area - region.area) < 1e-9 * region.area, `${where}: area ${area}`);
        assert.ok(
          Math.abs(border - perimeter) < 1e-9 * perimeter,
          `${where}: ${border} of edges of one triangle, a border of ${perimeter}`,
        );
      }
    }
    assert.ok(filled > 60, `${filled} regions`);
  });
});
