import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { exactFields, grid, square } from './meshes.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const paper = { method: 'paper', solver: 'exact' };
const cells = 12;
// The points are inner ones: their neighbourhoods on the grid are symmetric, so that the paper's
// estimator of the gradient is exact.
const inner = [
  { vertex: 4 + (cells + 1) * 4 },
  { vertex: 8 + (cells + 1) * 5 },
  { face: 2 * (6 + cells * 7), bary: [0.3, 0.3, 0.4] },
  { face: 2 * (5 + cells * 6) + 1, bary: [0.6, 0.3, 0.1] },
];

/** The vertex that is farthest along an axis. */
function extreme(mesh, axis) {
  const positions = mesh.positions();
  let best = 0;
  for (let v = 1; 3 * v < positions.length; v++) {
    if (positions[3 * v + axis] > positions[3 * best + axis]) best = v;
  }
  return best;
}

const weightedSum = (mesh, points, weights) =>
  [0, 1, 2].map((k) =>
    points.reduce((sum, point, i) => sum + weights[i] * mesh.position(point)[k], 0),
  );

const closeTo = (actual, expected, tolerance) =>
  actual.forEach((value, k) => {
    assert.ok(Math.abs(value - expected[k]) < tolerance, `${actual} instead of ${expected}`);
  });

test('on a plane the center of mass is the weighted mean', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const lists = [
    [0.25, 0.25, 0.25, 0.25],
    [0.1, 0.2, 0.3, 0.4],
    [0.5, 0.6, -0.2, 0.1],
    [0, 0, 1, 0],
  ];
  for (const [field, weights] of exactFields.flatMap((f) => lists.map((list) => [f, list]))) {
    const expected = weightedSum(mesh, inner, weights);
    const center = mesh.centerOfMass(inner, weights, field);
    // A point with all the weight is its own center, without any search.
    const single = weights.filter((weight) => weight !== 0).length === 1;
    const known = single ? ['certain', []] : ['notLooked', 'notLooked'];
    assert.deepEqual([center.uniqueness, center.otherMinima], known);
    assert.equal(center.status, 'converged');
    closeTo(center.position, expected, 1e-9);
    closeTo(mesh.position(center.point), center.position, 1e-12);
    assert.ok(Number.isInteger(center.iterations) && center.iterations >= 0);
    const energy = inner.reduce((sum, point, i) => {
      const step = mesh.position(point).map((value, k) => value - expected[k]);
      return sum + weights[i] * Math.hypot(...step) ** 2;
    }, 0);
    assert.ok(Math.abs(center.energy - energy) < 1e-8, `${center.energy} instead of ${energy}`);
  }
});

test('says on request whether it is the only one', () => {
  const plane = karcher.meshFromObj(grid(cells));
  const only = plane.centerOfMass(inner, [0.1, 0.2, 0.3, 0.4], { uniqueness: true });
  assert.deepEqual([only.uniqueness, only.otherMinima], ['certain', []]);

  const sphere = karcher.shape('sphere', 2000);
  // Points a little north of the equator: each pole is a minimum.
  const north = [0, 1, 2, 3].map((k) => {
    const way = [Math.cos((k * Math.PI) / 2), Math.sin((k * Math.PI) / 2), 0];
    const pole = { vertex: extreme(sphere, 2) };
    return sphere.straightest(pole, way, 1.45).end;
  });
  const weights = [0.25, 0.25, 0.25, 0.25];
  // No search looked for the other pole.
  assert.equal(sphere.centerOfMass(north, weights).otherMinima, 'notLooked');
  const center = sphere.centerOfMass(north, weights, { uniqueness: true });
  assert.equal(center.uniqueness, 'notUnique');
  assert.ok(center.position[2] > 0.99);
  const last = center.otherMinima.at(-1);
  assert.ok(last.position[2] < -0.99 && last.energy > center.energy, `${last.energy}`);
  closeTo(sphere.position(last.point), last.position, 1e-12);
  for (const { point, energy } of center.otherMinima) {
    const there = sphere.centerOfMass(north, weights, { start: point });
    assert.ok(Math.abs(there.energy - energy) <= 1e-9 * energy);
  }
  const near = north.map((point) => sphere.straightest(point, [0, 0, 1], 1.2).end);
  assert.equal(sphere.centerOfMass(near, weights, { uniqueness: true }).uniqueness, 'certain');
  assert.throws(() => sphere.centerOfMass(near, weights, { uniqueness: 1 }), /uniqueness/);
});

test('a certificate measures the center by exact shortest paths, whatever the method', () => {
  const plane = karcher.meshFromObj(grid(cells));
  const weights = [0.1, 0.2, 0.3, 0.4];
  assert.equal('certificate' in plane.centerOfMass(inner, weights), false);
  const expected = weightedSum(plane, inner, weights);
  const squares = inner.map((point) =>
    plane.position(point).reduce((sum, value, k) => sum + (value - expected[k]) ** 2, 0),
  );
  const least = squares.reduce((sum, square, i) => sum + weights[i] * square, 0);
  for (const field of [...exactFields, { solver: 'graph', rings: 2 }]) {
    const options = { ...field, certificate: true };
    const { certificate, position } = plane.centerOfMass(inner, weights, options);
    // On a plane the energy is the minimum plus the squared distance from the mean, and the
    // residual is that distance.
    const away = Math.hypot(...position.map((value, k) => value - expected[k]));
    assert.ok(Math.abs(certificate.energy - least - away ** 2) < 1e-9, `${certificate.energy}`);
    assert.ok(Math.abs(certificate.residual - away) < 1e-9, `${certificate.residual}`);
    const same = plane.centerOfMass(inner, [1, 2, 3, 4], { ...options, normalize: true });
    assert.ok(Math.abs(same.certificate.energy - certificate.energy) < 1e-9);
  }

  const torus = karcher.shape('torus', 2000);
  const points = [3, 90, 400, 720].map((face) => ({ face, bary: [0.2, 0.3, 0.5] }));
  for (const field of [{}, paper, { method: 'paper', solver: 'graph', rings: 3 }]) {
    const center = torus.centerOfMass(points, weights, { ...field, certificate: true });
    const lengths = points.map((point) => torus.shortestPath(center.point, point).length);
    const energy = lengths.reduce((sum, length, i) => sum + weights[i] * length ** 2, 0);
    assert.ok(Math.abs(center.certificate.energy - energy) < 1e-9 * energy);
    // The paths of the log map are mostly the shortest ones.
    const { vectors } = torus.logMap(center.point, points);
    const sum = [0, 1, 2].map((k) =>
      weights.reduce((total, weight, i) => total + weight * vectors[3 * i + k], 0),
    );
    closeTo([center.certificate.residual], [Math.hypot(...sum)], 1e-3 * torus.info.meanEdge);
  }
  assert.throws(() => plane.centerOfMass(inner, weights, { certificate: 1 }), /certificate/);
});

test('does not depend on earlier centers', () => {
  const mesh = karcher.shape('torus', 2000);
  const points = [3, 90, 400, 720].map((face) => ({ face, bary: [0.2, 0.3, 0.5] }));
  const weights = [1, 2, 3, 4];
  const questions = [
    [points, weights],
    [points, [4, 1, 1, 1]],
    [points.with(1, { face: 95, bary: [0.6, 0.3, 0.1] }), weights],
    [points.toReversed(), weights],
    [points.slice(1), weights.slice(1)],
    [[points[0], points[0], points[2]], weights.slice(1)],
    [points, weights],
  ];
  for (const field of exactFields) {
    for (const [places, masses] of questions) {
      const options = { ...field, normalize: true };
      const afresh = karcher.shape('torus', 2000);
      const expected = afresh.centerOfMass(places, masses, options);
      assert.deepEqual(mesh.centerOfMass(places, masses, options), expected);
      afresh.dispose();
    }
    // A failure leaves no trace.
    assert.throws(() => mesh.centerOfMass(points, [1], field), { code: 'badWeights' });
  }
});

test('the search can start anywhere', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const weights = [0.1, 0.2, 0.3, 0.4];
  for (const field of exactFields) {
    const center = mesh.centerOfMass(inner, weights, { ...field, start: { vertex: 60 } });
    closeTo(center.position, weightedSum(mesh, inner, weights), 1e-9);
  }
});

test('weights: their sum must be 1, or they are normalised', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const weights = [1, 2, 3, 4];
  const center = mesh.centerOfMass(inner, weights, { ...paper, normalize: true });
  const same = mesh.centerOfMass(inner, [0.1, 0.2, 0.3, 0.4], paper);
  closeTo(center.position, same.position, 1e-12);
  mesh.centerOfMass(inner, [0.1, 0.2, 0.3, 0.4 + 5e-10], paper);
  const wrong = [
    [inner, weights, {}, 'badWeights', /sum to 10/],
    [inner, [0.1, 0.2, 0.3, 0.4 + 1e-8], {}, 'badWeights', /1e-9/],
    [inner, [0.5, 0.5], {}, 'badWeights', /4 points.* 2 weights/],
    [inner, [1, -1, 1, -1], { normalize: true }, 'badWeights', /positive/],
    [inner, [Number.NaN, 0, 0, 1], {}, 'notFinite', /weight 0/],
    [inner, ['1', 0, 0, 0], {}, 'badArgument', /entry 0 of the weights/],
    [[], [], {}, 'tooFewPoints', /at least one/],
    [[], [1], {}, 'tooFewPoints', /at least one/],
    [inner[0], [1], {}, 'badArgument', /the points must be an array/],
    [[...inner.slice(0, 3), { vertex: 9999 }], weights, {}, 'badIndex', /vertex 9999/],
    [[...inner.slice(0, 3), {}], weights, {}, 'badArgument', /point 3/],
    [inner, [0.1, 0.2, 0.3, 0.4], { start: { vertex: -1 } }, 'badIndex', /vertex -1/],
    [inner, [0.1, 0.2, 0.3, 0.4], { method: 'guess' }, 'badArgument', /the method/],
    [inner, [0.1, 0.2, 0.3, 0.4], { solver: 'fast' }, 'badArgument', /paper's method takes/],
    [inner, [0.1, 0.2, 0.3, 0.4], { star: 'wider' }, 'badArgument', /the star/],
  ];
  for (const [points, numbers, options, code, message] of wrong) {
    assert.throws(() => mesh.centerOfMass(points, numbers, { ...paper, ...options }), {
      code,
      message,
    });
    closeTo(mesh.centerOfMass(inner, [0.1, 0.2, 0.3, 0.4], paper).position, same.position, 1e-15);
  }
});

test('the paper’s method accepts Eq. 3 as printed; other methods have no star', () => {
  const torus = karcher.shape('torus', 2000);
  const points = [3, 5, 9, 12].map((face) => ({ face, bary: [0.2, 0.3, 0.5] }));
  const weights = [0.1, 0.2, 0.3, 0.4];
  const at = (options) => {
    const center = torus.centerOfMass(points, weights, { ...paper, ...options });
    assert.equal(center.status, 'converged');
    return center.position;
  };
  const [wide, ring] = [at({ star: 'wide' }), at({ star: 'ring' })];
  assert.deepEqual(at({}), wide);
  const apart = Math.hypot(...wide.map((value, k) => value - ring[k]));
  assert.ok(apart > 0 && apart < 0.3 * torus.info.meanEdge, `${apart}`);
  assert.throws(() => torus.centerOfMass(points, weights, { star: 'ring' }), {
    code: 'badArgument',
    message: /only the paper's method/,
  });
  torus.dispose();
});

test('points on several components have no center of mass', () => {
  const apart = square.replace(/^v (.)/gm, 'v 5$1').replace('f 1 2 3 4', 'f 5 6 7 8');
  const mesh = karcher.meshFromObj(square + apart);
  assert.throws(() => mesh.centerOfMass([{ vertex: 0 }, { vertex: 4 }], [0.5, 0.5], paper), {
    code: 'unreachable',
  });
});

test('a caller’s own distances can be used', () => {
  const mesh = karcher.meshFromObj(
    `v 9 9 9\n${grid(cells).replace(/\d+/g, (n) => n)}`.replace(
      /^f (\d+) (\d+) (\d+)$/gm,
      (_, a, b, c) => `f ${+a + 1} ${+b + 1} ${+c + 1}`,
    ),
  );
  // All vertices have an index higher by one, after a vertex without a face.
  const points = inner.map((point) => ('vertex' in point ? { vertex: point.vertex + 1 } : point));
  const weights = [0.1, 0.2, 0.3, 0.4];
  const distances = points.map((point) => mesh.distance(point, { solver: 'exact' }));
  assert.ok(Number.isNaN(distances[0][0]));
  const expected = weightedSum(mesh, points, weights);
  const center = mesh.centerOfMassOfDistances(distances, weights);
  assert.equal(center.status, 'converged');
  closeTo(center.position, expected, 1e-9);
  const started = mesh.centerOfMassOfDistances(distances, [1, 2, 3, 4], {
    start: points[0],
    normalize: true,
  });
  closeTo(started.position, expected, 1e-9);
  const with9 = (value) => distances.map((array) => array.with(9, value));
  const wrong = [
    [distances, [0.5, 0.5], 'badWeights', /4 .* 2/],
    [distances.map((array) => array.slice(1)), weights, 'badArgument', /170, not 169/],
    [with9(Number.NaN), weights, 'notFinite', /vertex 9 of array 0/],
    [with9(-1), weights, 'notFinite', /vertex 9 of array 0/],
    [[], [], 'tooFewPoints', /at least one/],
    [distances[0], weights, 'badArgument', /must be an array/],
  ];
  for (const [arrays, numbers, code, message] of wrong) {
    assert.throws(() => mesh.centerOfMassOfDistances(arrays, numbers), { code, message });
  }
});

test('weights of a point carry it to other control points', () => {
  const mesh = karcher.meshFromObj(grid(12));
  const at = (vertex) => ({ vertex });
  const corners = [15, 22, 110, 140].map(at);
  const place = mesh.position({ vertex: 70 });
  const { weights, isMinimum } = mesh.weightsOf(at(70), corners);
  assert.equal(isMinimum, true);
  const sum = (of) => weights.reduce((total, weight, i) => total + weight * of(i), 0);
  assert.ok(Math.abs(sum(() => 1) - 1) < 1e-12);
  for (const axis of [0, 1, 2]) {
    const reached = sum((i) => mesh.position(corners[i])[axis]);
    assert.ok(Math.abs(reached - place[axis]) < 1e-11);
  }
  const back = mesh.centerOfMass(corners, weights, { normalize: true });
  assert.ok(back.position.every((value, axis) => Math.abs(value - place[axis]) < 1e-9));

  // Given weights stay if they are valid, and stay positive on request.
  const given = mesh.weightsOf(at(70), corners, { weights: weights.map((one) => 3 * one) });
  assert.ok(given.weights.every((weight, i) => Math.abs(weight - weights[i]) < 1e-12));
  const sound = mesh.weightsOf(at(18), [...corners, at(30)], { nonNegative: true });
  assert.ok(sound.weights.every((weight) => weight >= 0));

  const outside = { name: 'KarcherError', code: 'badArgument', message: /convex hull/ };
  assert.throws(() => mesh.weightsOf(at(168), corners, { nonNegative: true }), outside);
  const line = [14, 28].map(at);
  assert.throws(() => mesh.weightsOf(at(71), line), { message: /no weights make/ });
  assert.throws(() => mesh.weightsOf(at(70), []), { code: 'tooFewPoints' });
  assert.throws(() => mesh.weightsOf(at(70), corners, { weights: [1] }), { code: 'badWeights' });
  assert.throws(() => mesh.weightsOf(at(70), corners, { weights: [] }), { code: 'badArgument' });
  assert.throws(() => mesh.weightsOf(at(70), corners, { nonNegative: 1 }), { code: 'badArgument' });
  mesh.dispose();
});
