// Calls for many points at once: nearest points, normals, log maps of all vertices, rows of weights.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { load } from 'karcher';
import { loadInWorker } from 'karcher/worker';
import { randomFrom, seed } from '../web/part.mjs';
import { grid, square } from './meshes.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const difference = (a, b) => a.map((x, i) => x - b[i]);
const placeIn = (array, i) => [...array.slice(3 * i, 3 * i + 3)];
/** Uniform random weights in a triangle. */
function weightsFrom(random) {
  const [u, v] = [random(), random()];
  return u + v > 1 ? [u + v - 1, 1 - u, 1 - v] : [1 - u - v, u, v];
}

describe('the nearest point', () => {
  test('to places beside a surface agrees with a search through all faces', (t) => {
    t.diagnostic(`seed ${seed}`);
    const random = randomFrom(seed);
    const mesh = karcher.shape('knot', 600);
    const positions = mesh.positions();
    const { diagonal } = mesh.info;
    for (let i = 0; i < 200; i++) {
      const place = [0, 0, 0].map(() => (random() - 0.5) * diagonal);
      const { point, position, distance } = mesh.nearestPoint(place);
      assert.deepEqual(position, mesh.position(point));
      assert.ok(Math.abs(Math.hypot(...difference(position, place)) - distance) < 1e-12);
      // No vertex and no random point of the surface is nearer.
      for (let v = 0; 3 * v < positions.length; v++) {
        assert.ok(Math.hypot(...difference(placeIn(positions, v), place)) >= distance - 1e-12);
      }
      const face = Math.floor(random() * mesh.info.triangles);
      const other = mesh.position({ face, bary: weightsFrom(random) });
      assert.ok(Math.hypot(...difference(other, place)) >= distance - 1e-12);
    }
  });

  test('to a place on the surface is that place, and takes objects with x, y and z', () => {
    const mesh = karcher.shape('torus', 2000);
    const point = { face: 77, bary: [0.2, 0.3, 0.5] };
    const [x, y, z] = mesh.position(point);
    const nearest = mesh.nearestPoint({ x, y, z });
    assert.equal(nearest.point.face, 77);
    assert.ok(nearest.distance < 1e-12);
    assert.throws(() => mesh.nearestPoint([1, 2]), { code: 'badArgument' });
    assert.throws(() => mesh.nearestPoint([1, 2, Number.NaN]), { code: 'notFinite' });
  });
});

test('a normal is orthogonal to its face, on the outside', () => {
  const mesh = karcher.shape('sphere', 2000);
  const triangles = mesh.triangles();
  for (const face of [0, 500, 1999]) {
    const point = { face, bary: [0.2, 0.3, 0.5] };
    const normal = mesh.normal(point);
    assert.ok(Math.abs(Math.hypot(...normal) - 1) < 1e-12);
    const [a, b, c] = [0, 1, 2].map((k) => mesh.position({ vertex: triangles[3 * face + k] }));
    assert.ok(Math.abs(dot(normal, difference(b, a))) < 1e-12);
    assert.ok(Math.abs(dot(normal, difference(c, a))) < 1e-12);
    assert.ok(dot(normal, mesh.position(point)) > 0);
  }
  const upright = karcher.meshFromObj(square).normal({ vertex: 0 });
  // The comparison ignores the signs of zeros.
  assert.deepEqual(
    upright.map((x) => x + 0),
    [0, 0, 1],
  );
});

test('a list of places and a flat array return the results of single points', () => {
  const mesh = karcher.shape('torus', 600);
  const points = [{ vertex: 3 }, { face: 5, bary: [0.2, 0.3, 0.5] }];
  const expected = points.flatMap((point) => mesh.position(point));
  assert.deepEqual([...mesh.positionsOf(points)], expected);
  const flat = { face: [5, 5], bary: [0.2, 0.3, 0.5, 1, 0, 0] };
  assert.deepEqual(placeIn(mesh.positionsOf(flat), 0), mesh.position(points[1]));
  assert.equal(mesh.positionsOf([]).length, 0);
  assert.throws(() => mesh.positionsOf({ face: [5], bary: [1, 0] }), { code: 'badArgument' });
  assert.throws(() => mesh.positionsOf({ face: [1e6], bary: [1, 0, 0] }), { code: 'badIndex' });
  assert.throws(() => mesh.positionsOf(null), { code: 'badArgument' });
  assert.throws(() => mesh.positionsOf({}), { code: 'badArgument' });
});

test('distances from several points are the minimum over these points', () => {
  const mesh = karcher.shape('torus', 600);
  const sources = [{ vertex: 3 }, { vertex: 200 }, { face: 100, bary: [0.2, 0.3, 0.5] }];
  for (const options of [{}, { solver: 'fast' }]) {
    const each = sources.map((source) => mesh.distance(source, options));
    const expected = each[0].map((_, v) => Math.min(...each.map((of) => of[v])));
    assert.deepEqual(mesh.distance(sources, options), expected);
  }
  assert.throws(() => mesh.distance([]), { code: 'tooFewPoints' });
});

describe('the log map of all vertices', () => {
  const sources = {
    'inside a face': { face: 31, bary: [0.2, 0.3, 0.5] },
    'on an edge': { face: 31, bary: [0.4, 0.6, 0] },
    'at a vertex': { vertex: 40 },
    'on the boundary': { vertex: 3 },
    'at a corner': { vertex: 0 },
  };
  for (const [where, from] of Object.entries(sources)) {
    test(`is exact on a plane, seen from a point ${where}`, () => {
      const mesh = karcher.meshFromObj(grid(8));
      const origin = mesh.position(from);
      const positions = mesh.positions();
      const { vectors } = mesh.logMap(from);
      assert.equal(vectors.length, positions.length);
      // At the boundary the tangent plane is rescaled: lengths and the order of directions stay.
      const isRescaled = where.startsWith('on the') || where.startsWith('at a corner');
      for (let v = 0; 3 * v < positions.length; v++) {
        const expected = difference(placeIn(positions, v), origin);
        const vector = placeIn(vectors, v);
        assert.ok(Math.abs(Math.hypot(...vector) - Math.hypot(...expected)) < 1e-9, `${v}`);
        if (!isRescaled) assert.ok(Math.hypot(...difference(vector, expected)) < 1e-9, `${v}`);
      }
    });
  }

  test('agrees with those of single vertices near the point, on curved surfaces', () => {
    for (const from of [{ face: 100, bary: [0.2, 0.3, 0.5] }, { vertex: 1200 }]) {
      const mesh = karcher.shape('torus', 5000);
      const distances = mesh.distance(from);
      const near = [];
      distances.forEach((distance, vertex) => {
        if (distance < 0.15 * mesh.info.diagonal) near.push({ vertex });
      });
      assert.ok(near.length > 50);
      const single = mesh.logMap(from, near).vectors;
      const { vectors } = mesh.logMap(from);
      for (const [i, { vertex }] of near.entries()) {
        const away = Math.hypot(...difference(placeIn(vectors, vertex), placeIn(single, i)));
        // Directions are interpolated, between places at most half an edge apart.
        assert.ok(away < 0.25 * mesh.info.meanEdge, `${vertex}: ${away / mesh.info.meanEdge}`);
      }
    }
  });

  test('has no vectors where no path leads, and takes no directions', () => {
    const mesh = karcher.meshFromObj(`${square}v 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\nv 9 9 9\n`);
    const { vectors } = mesh.logMap({ vertex: 0 });
    assert.equal(vectors.length, 24);
    assert.ok(vectors.slice(0, 12).every(Number.isFinite));
    assert.ok(vectors.slice(12).every(Number.isNaN));
    assert.throws(() => mesh.logMap({ vertex: 0 }, undefined, [1, 0, 0]), { code: 'badArgument' });
  });
});

describe('centers of mass of rows of weights', () => {
  const points = [3, 40, 300, 310, 250].map((vertex) => ({ vertex }));
  const rowsFrom = (random, count) =>
    Array.from({ length: count }, () => {
      const weights = points.map(() => -Math.log(1 - random()));
      const sum = weights.reduce((a, b) => a + b);
      return weights.map((weight) => weight / sum);
    });

  test('are weighted means on a plane', (t) => {
    t.diagnostic(`seed ${seed}`);
    const mesh = karcher.meshFromObj(grid(20));
    const rows = rowsFrom(randomFrom(seed), 500);
    const centers = mesh.centersOfMass(points, rows);
    assert.equal(centers.count, 500);
    assert.ok(centers.status.every((status) => status === 'converged'));
    const places = points.map((point) => mesh.position(point));
    for (const [i, row] of rows.entries()) {
      const mean = [0, 1, 2].map((k) =>
        dot(
          row,
          places.map((place) => place[k]),
        ),
      );
      assert.ok(Math.hypot(...difference(placeIn(centers.position, i), mean)) < 1e-9);
      const squares = places.map((place) => Math.hypot(...difference(place, mean)) ** 2);
      assert.ok(Math.abs(centers.energy[i] - dot(row, squares)) < 1e-9);
    }
    assert.deepEqual(mesh.positionsOf(centers), centers.position);
  });

  test('with the check equal those of single calls, and without it their zeros', () => {
    const mesh = karcher.shape('torus', 2000);
    const rows = rowsFrom(randomFrom(seed + 1), 20);
    const checked = mesh.centersOfMass(points, rows, { check: true });
    const centers = mesh.centersOfMass(points, new Float64Array(rows.flat()));
    for (const [i, row] of rows.entries()) {
      const { point, status, energy } = mesh.centerOfMass(points, row);
      assert.deepEqual([checked.face[i], checked.status[i]], [point.face, status]);
      assert.deepEqual(placeIn(checked.bary, i), point.bary);
      assert.equal(checked.energy[i], energy);
      const away = Math.hypot(...difference(placeIn(centers.position, i), mesh.position(point)));
      assert.ok(status !== 'converged' || away < mesh.info.meanEdge, `${i}: ${away}`);
    }
  });

  test('of a row do not depend on the other rows', () => {
    const mesh = karcher.shape('knot', 3000);
    const rows = rowsFrom(randomFrom(seed + 2), 60);
    const all = mesh.centersOfMass(points, rows);
    const turned = mesh.centersOfMass(points, rows.slice().reverse());
    for (let i = 0; i < rows.length; i++) {
      assert.deepEqual(placeIn(all.position, i), placeIn(turned.position, rows.length - 1 - i));
    }
  });

  test('are refused with the index of the row', () => {
    const mesh = karcher.shape('torus', 2000);
    const good = [0.2, 0.2, 0.2, 0.2, 0.2];
    const refused = (rows, code, message) =>
      assert.throws(() => mesh.centersOfMass(points, rows), { code, message });
    refused([good, [0.3, 0.2, 0.2, 0.2, 0.2]], 'badWeights', /row 1/);
    refused([good, [1]], 'badWeights', /row 1/);
    refused([...good, 1], 'badWeights', /rows of 5/);
    refused([good, [Number.NaN, 0, 0, 0, 0]], 'notFinite', /row 1/);
    refused('no', 'badArgument', /weights/);
    assert.throws(() => mesh.centersOfMass([], []), { code: 'tooFewPoints' });
    assert.throws(() => mesh.centersOfMass(points, [good], { certificate: true }), {
      code: 'badArgument',
    });
    assert.equal(mesh.centersOfMass(points, []).count, 0);
    const one = mesh.centersOfMass(points, [[0, 2, 0, 0, 0]], { normalize: true });
    assert.deepEqual([one.status[0], one.energy[0]], ['converged', 0]);
    assert.deepEqual(placeIn(one.position, 0), mesh.position(points[1]));
  });
});

describe('in a worker', () => {
  let remote;
  before(async () => {
    remote = await loadInWorker();
  });
  after(() => remote.dispose());

  test('the calls have the same names and results', async () => {
    const [there, here] = [await remote.shape('torus', 600), karcher.shape('torus', 600)];
    const points = [{ vertex: 3 }, { vertex: 40 }];
    const calls = [
      ['nearestPoint', [0.1, 0.2, 0.3]],
      ['normal', { vertex: 3 }],
      ['positionsOf', points],
      ['distance', points],
      ['logMap', { vertex: 3 }],
      ['centersOfMass', points, [[0.5, 0.5]]],
    ];
    for (const [name, ...args] of calls) {
      assert.deepEqual(await there[name](...args), here[name](...args), name);
    }
  });
});
