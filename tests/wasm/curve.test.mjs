import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { distancesOf, exactFields, fields, grid, partsOf, square } from './meshes.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const paper = { method: 'paper', solver: 'exact' };
const cells = 14;
const vertex = (i, j) => ({ vertex: i + (cells + 1) * j });
const inner = [vertex(4, 4), vertex(6, 9), vertex(9, 10), vertex(10, 6), vertex(7, 4)];

const closeTo = (actual, expected, tolerance, what) =>
  expected.forEach((value, k) => {
    assert.ok(Math.abs(actual[k] - value) < tolerance, `${what}: ${actual} not ${expected}`);
  });

const cubic = (t) => [
  (1 - t) ** 3 / 6,
  (3 * t ** 3 - 6 * t ** 2 + 4) / 6,
  (-3 * t ** 3 + 3 * t ** 2 + 3 * t + 1) / 6,
  t ** 3 / 6,
];

function bernstein(degree, t) {
  let binomial = 1;
  return Array.from({ length: degree + 1 }, (_, i) => {
    const value = binomial * t ** i * (1 - t) ** (degree - i);
    binomial = (binomial * (degree - i)) / (i + 1);
    return value;
  });
}

/** The curve's point in the plane. */
function planePoint(mesh, points, weights) {
  const places = points.map((point) => mesh.position(point));
  return [0, 1, 2].map((k) => places.reduce((sum, place, i) => sum + weights[i] * place[k], 0));
}

/** The visible properties of a curve, without its timings. */
const shown = (curve) => ({
  points: curve.points(),
  samples: curve.samples(),
  polyline: curve.polyline(),
  marks: curve.unconverged(),
  path: partsOf(curve.path()),
  length: curve.length,
});

test('a B-spline on a plane, at t = i / (samples - 1)', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const traced = exactFields.map((field) =>
    mesh.curve({ kind: 'bspline', points: inner, samples: 9, ...field }).samples(),
  );
  for (const [i, samples] of traced.flatMap((all) => Array.from(all.t, (_, i) => [i, all]))) {
    assert.equal(samples.count, 18);
    assert.equal(samples.bary.length, 3 * 18);
    const segment = Math.floor(i / 9);
    const t = (i % 9) / 8;
    assert.equal(samples.segment[i], segment);
    assert.equal(samples.t[i], t);
    assert.equal(samples.status[i], 'converged');
    const expected = planePoint(mesh, inner.slice(segment, segment + 4), cubic(t));
    const place = samples.position.slice(3 * i, 3 * i + 3);
    closeTo(place, expected, 1e-9, `sample ${i}`);
    const bary = Array.from(samples.bary.slice(3 * i, 3 * i + 3));
    closeTo(place, mesh.position({ face: samples.face[i], bary }), 1e-12, `point ${i}`);
  }
});

test('a Bezier curve on a plane runs from its first to its last point', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  for (const field of exactFields) {
    const curve = mesh.curve({ kind: 'bezier', points: inner, samples: 17, ...field });
    const samples = curve.samples();
    assert.equal(samples.count, 17);
    for (let i = 0; i < 17; i++) {
      const expected = planePoint(mesh, inner, bernstein(4, i / 16));
      closeTo(samples.position.slice(3 * i, 3 * i + 3), expected, 1e-9, `sample ${i}`);
    }
    const polyline = curve.polyline({ bits: 64 });
    closeTo(polyline.slice(0, 3), mesh.position(inner[0]), 1e-9, 'start');
    closeTo(polyline.slice(-3), mesh.position(inner[4]), 1e-9, 'end');
  }
  const straight = mesh.curve({ kind: 'bezier', points: [inner[0], inner[2]], ...paper });
  assert.equal(straight.samples().count, 128);
  assert.ok(Math.abs(straight.length - Math.hypot(5, 6)) < 1e-9);
});

test('the polyline joins the samples on the surface', () => {
  const mesh = karcher.shape('torus', 4000);
  const points = [0, 1, 2, 3].map((i) => ({ face: 300 + 2 * i, bary: [0.2, 0.3, 0.5] }));
  const curve = mesh.curve({ kind: 'bspline', points, samples: 20, ...paper });
  const path = curve.path();
  const { length } = path;
  const polyline = path.polyline({ bits: 64 });
  assert.equal(length, curve.length);
  assert.equal(path.closed, false);
  assert.deepEqual(curve.polyline({ bits: 64 }), polyline);
  assert.deepEqual(curve.polyline(), new Float32Array(polyline));
  assert.equal(curve.unconverged().length, polyline.length / 3);
  let walked = 0;
  for (let i = 3; i < polyline.length; i += 3) {
    walked += Math.hypot(...[0, 1, 2].map((k) => polyline[i + k] - polyline[i + k - 3]));
  }
  assert.ok(Math.abs(walked - length) < 1e-9 * length);
  const samples = curve.samples();
  for (let i = 0, at = 0; i < samples.count; i++) {
    const place = samples.position.slice(3 * i, 3 * i + 3);
    while (at < polyline.length && place.some((value, k) => value !== polyline[at + k])) at += 3;
    assert.ok(at < polyline.length, `the polyline passes sample ${i}`);
  }
  assert.deepEqual(
    new Set(curve.unconverged()),
    new Set(samples.status.map((status) => (status === 'converged' ? 0 : 1))),
  );
});

for (const field of fields) {
  const name = Object.values(field).join(' ') || 'defaults';
  test(`after edits a curve equals a new curve of its points: ${name}`, () => edit(field));
}

function edit(field) {
  const mesh = karcher.shape('sphere', 2000);
  // Curves of one mesh share their fields, so the new curve is on another mesh.
  const otherMesh = karcher.shape('sphere', 2000);
  const points = [10, 40, 70, 100, 130].map((face) => ({ face, bary: [0.5, 0.25, 0.25] }));
  const edited = mesh.curve({ kind: 'bspline', points, samples: 16, ...field });
  let current = points;
  const check = (kind = 'bspline') => {
    const anew = otherMesh.curve({ kind, points: current, samples: 16, ...field });
    assert.deepEqual(shown(edited), shown(anew));
    anew.dispose();
  };
  const other = { face: 55, bary: [0.1, 0.2, 0.7] };
  for (const i of [0, 2, 4]) {
    edited.movePoint(i, other);
    current = current.with(i, other);
    check();
    edited.movePoint(i, points[i]);
    current = current.with(i, points[i]);
    check();
  }
  edited.addPoint({ vertex: 20 });
  current = [...current, mesh.surfacePoint(...pointOf(mesh, 20))];
  assert.deepEqual(mesh.position(edited.points()[5]), mesh.position({ vertex: 20 }));
  edited.removePoint(5);
  current = current.slice(0, 5);
  check();
  edited.insertPoint(1, other);
  current = current.toSpliced(1, 0, other);
  check();
  edited.insertPoint(6, other);
  current = [...current, other];
  check();
  edited.removePoint(0);
  current = current.slice(1);
  check();
  edited.setKind('bezier');
  check('bezier');
  edited.setKind('bspline');
  check();
  for (const value of Object.values(edited.times())) assert.ok(value >= 0);
}

/** A face of a vertex and weights for it there. */
function pointOf(mesh, number) {
  const corner = mesh.triangles().indexOf(number);
  const bary = [0, 0, 0];
  bary[corner % 3] = 1;
  return [Math.floor(corner / 3), bary];
}

test('an impossible change leaves the curve unchanged', () => {
  const apart = square.replace(/^v (.)/gm, 'v 5$1');
  const count = (cells + 1) ** 2;
  const face = [1, 2, 3, 4].map((i) => count + i).join(' ');
  const mesh = karcher.meshFromObj(`${grid(cells)}${apart.replace('f 1 2 3 4', `f ${face}`)}`);
  const elsewhere = { vertex: count };
  const curve = mesh.curve({ kind: 'bspline', points: inner.slice(0, 4), samples: 5, ...paper });
  const before = shown(curve);
  const wrong = [
    [() => curve.removePoint(0), 'tooFewPoints', /at least 4 control points, not 3/],
    [() => curve.removePoint(4), 'badIndex', /no control point 4/],
    [() => curve.removePoint(-1), 'badIndex', /no control point -1/],
    [() => curve.removePoint(0.5), 'badArgument', /whole number/],
    [() => curve.movePoint(4, inner[0]), 'badIndex', /no control point 4/],
    [() => curve.movePoint(0, elsewhere), 'unreachable', /components/],
    [() => curve.movePoint(0, { vertex: 10_000 }), 'badIndex', /vertex 10000/],
    [() => curve.movePoint(0, { face: 0, bary: [2, 0, -1] }), 'badPoint', /face 0/],
    [() => curve.addPoint(elsewhere), 'unreachable', /components/],
    [() => curve.insertPoint(6, inner[0]), 'badIndex', /control point 6/],
    [() => curve.setKind('circle'), 'badArgument', /kind/],
  ];
  for (const [change, code, message] of wrong) {
    assert.throws(change, { name: 'KarcherError', code, message });
    assert.deepEqual(shown(curve), before);
  }
});

test('invalid curves are refused', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const good = { kind: 'bspline', points: inner, samples: 5, ...paper };
  const expected = shown(mesh.curve(good));
  const wrong = [
    [{ points: inner.slice(0, 3) }, 'tooFewPoints', /B-spline .* at least 4/],
    [{ points: [] }, 'tooFewPoints', /at least 4/],
    [{ kind: 'bezier', points: inner.slice(0, 1) }, 'tooFewPoints', /at least 2/],
    [{ kind: 'line' }, 'badArgument', /one of bspline, bezier/],
    [{ points: undefined }, 'badArgument', /the points/],
    [{ points: [...inner, 7] }, 'badArgument', /point 5/],
    [{ samples: 1 }, 'badArgument', /2 to 100000 samples/],
    [{ samples: 100_001 }, 'badArgument', /2 to 100000 samples/],
    [{ samples: 2.5 }, 'badArgument', /whole number/],
    [{ solver: 'graph', rings: 99 }, 'badArgument', /rings/],
    [{ solver: 'fast' }, 'badArgument', /paper's method takes/],
  ];
  const refuseAll = () => {
    for (const [change, code, message] of wrong) {
      assert.throws(() => mesh.curve({ ...good, ...change }), {
        name: 'KarcherError',
        code,
        message,
      });
    }
  };
  // The allocator may round a block up the first time.
  refuseAll();
  const bytes = karcher.allocatedBytes();
  refuseAll();
  assert.equal(karcher.allocatedBytes(), bytes);
  assert.throws(() => mesh.curve(), { code: 'badArgument' });
  assert.deepEqual(shown(mesh.curve(good)), expected);
});

test('curves are disposed of with their mesh', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const options = { kind: 'bspline', points: inner, samples: 5, ...paper };
  const [one, two] = [mesh.curve(options), mesh.curve(options)];
  one.dispose();
  one.dispose();
  assert.throws(() => one.samples(), { code: 'disposed', message: /the curve/ });
  assert.equal(two.samples().count, 10);
  mesh.dispose();
  for (const use of [
    () => two.points(),
    () => two.samples(),
    () => two.polyline(),
    () => two.length,
    () => two.times(),
    () => two.movePoint(0, inner[0]),
    () => two.removePoint(0),
    () => mesh.curve(options),
    () => mesh.distance(inner[0]),
  ]) {
    assert.throws(use, { code: 'disposed' });
  }
  two.dispose();
});

test('the same calls return the same numbers, even in another engine', async () => {
  const engines = [karcher, karcher, await load()];
  const results = engines.map((engine) => {
    const mesh = engine.shape('torus', 3000);
    const points = [100, 130, 160, 200].map((face) => ({ face, bary: [0.4, 0.35, 0.25] }));
    const result = [];
    for (const field of fields) {
      result.push(shown(mesh.curve({ kind: 'bspline', points, samples: 33, ...field })));
      result.push(mesh.centerOfMass(points, [0.1, 0.2, 0.3, 0.4], field));
      result.push(mesh.distance(points[1], distancesOf(field)));
    }
    mesh.dispose();
    return result;
  });
  assert.deepEqual(results[1], results[0]);
  assert.deepEqual(results[2], results[0]);
});
