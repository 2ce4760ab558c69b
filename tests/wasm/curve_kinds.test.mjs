import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { grid } from './meshes.mjs';

let karcher;
let mesh;
before(async () => {
  karcher = await load();
  mesh = karcher.meshFromObj(grid(cells));
});

const cells = 14;
const vertex = (i, j) => ({ vertex: i + (cells + 1) * j });
const places = [
  [4, 4],
  [6, 9],
  [9, 10],
  [10, 6],
  [7, 4],
];
const points = places.map(([i, j]) => vertex(i, j));
const exact = { solver: 'exact', samples: 9 };
// Options with a field for each control point.
const unrefined = { ...exact, levels: 0 };

const near = (actual, expected, tolerance, what) =>
  expected.forEach((value, k) => {
    assert.ok(Math.abs(actual[k] - value) < tolerance, `${what}: ${actual} not ${expected}`);
  });

/** The positions of a curve's samples, with the segment and t of each. */
function samplesOf(curve) {
  const samples = curve.samples();
  return Array.from(samples.t, (t, i) => ({
    t,
    segment: samples.segment[i],
    status: samples.status[i],
    place: samples.position.slice(3 * i, 3 * i + 2),
  }));
}

const blended = (weights, of = places) =>
  [0, 1].map((k) => weights.reduce((sum, weight, i) => sum + weight * of[i][k], 0));

function expectPlane(options, weightsAt) {
  const curve = mesh.curve({ points, ...exact, ...options });
  for (const { segment, t, status, place } of samplesOf(curve)) {
    assert.equal(status, 'converged');
    near(place, blended(weightsAt(segment, t)), 1e-9, `${options.kind} ${segment} + ${t}`);
  }
  return curve;
}

const normalised = (weights) => {
  const sum = weights.reduce((a, b) => a + b, 0);
  return weights.map((weight) => weight / sum);
};

const bernstein = (t) => {
  const s = 1 - t;
  return [s ** 4, 4 * s ** 3 * t, 6 * s * s * t * t, 4 * s * t ** 3, t ** 4];
};

const cubic = (t) => [
  (1 - t) ** 3 / 6,
  (3 * t ** 3 - 6 * t ** 2 + 4) / 6,
  (-3 * t ** 3 + 3 * t ** 2 + 3 * t + 1) / 6,
  t ** 3 / 6,
];

/** Weights for consecutive ones of the five points, from index `first` on, cyclically. */
const around = (first, weights) => {
  const all = [0, 0, 0, 0, 0];
  weights.forEach((weight, k) => {
    all[(first + k) % 5] += weight;
  });
  return all;
};

test('every kind on a plane is the affine average of its points', () => {
  const weights = [1, 3, 0.5, 2, 1];
  expectPlane({ kind: 'bspline', closed: true }, (j, t) => around(j, cubic(t)));
  expectPlane({ kind: 'bspline', degree: 1 }, (j, t) => around(j, [1 - t, t]));
  expectPlane({ kind: 'bspline', weights }, (j, t) => {
    const local = cubic(t).map((value, k) => value * weights[j + k]);
    return around(j, normalised(local));
  });
  const bezierKnots = [0, 0, 0, 0, 0, 1, 1, 1, 1, 1];
  expectPlane({ kind: 'bspline', degree: 4, knots: bezierKnots }, (_, t) => bernstein(t));
  expectPlane({ kind: 'bspline', degree: 4, knots: 'clamped' }, (_, t) => bernstein(t));
  expectPlane({ kind: 'rational', weights }, (_, t) =>
    normalised(bernstein(t).map((value, i) => value * weights[i])),
  );
  expectPlane({ kind: 'barycentric', betas: weights }, (_, t) => {
    const at = weights.findIndex((_, i) => t === i / 4);
    if (at >= 0) return weights.map((_, i) => (i === at ? 1 : 0));
    return normalised(weights.map((beta, i) => ((-1) ** i * beta) / (t - i / 4)));
  });
  expectPlane({ kind: 'catmullrom', closed: true, parametrization: 'uniform' }, (j, t) =>
    around(j + 4, [
      (-(t ** 3) + 2 * t ** 2 - t) / 2,
      (3 * t ** 3 - 5 * t ** 2 + 2) / 2,
      (-3 * t ** 3 + 4 * t ** 2 + t) / 2,
      (t ** 3 - t ** 2) / 2,
    ]),
  );
  expectPlane({ kind: 'polyline', closed: true }, (j, t) => around(j, [1 - t, t]));
  expectPlane({ kind: 'custom', basis: bernstein }, (_, t) => bernstein(t));
});

test('the properties of a curve can be read and changed', () => {
  // The mesh is separate: curves of one mesh share their fields.
  const curve = karcher.meshFromObj(grid(cells)).curve({ kind: 'bspline', points, ...unrefined });
  assert.deepEqual(Array.from(curve.knots()), [-3, -2, -1, 0, 1, 2, 3, 4, 5]);
  assert.deepEqual(Array.from(curve.weights()), [1, 1, 1, 1, 1]);
  assert.equal(curve.segmentCount, 2);
  curve.setClosed(true);
  assert.equal(curve.closed, true);
  assert.equal(curve.segmentCount, 5);
  curve.setWeight(1, 3);
  assert.deepEqual(Array.from(curve.weights()), [1, 3, 1, 1, 1]);
  assert.equal(curve.fieldsComputed, 5);
  curve.movePointInOrder(1, 3);
  assert.deepEqual(Array.from(curve.weights()), [1, 1, 1, 3, 1]);
  near(mesh.position(curve.points()[3]), [6, 9, 0], 1e-12, 'the moved point');
  curve.reverse();
  assert.deepEqual(Array.from(curve.weights()), [1, 1, 3, 1, 1]);
  near(mesh.position(curve.points()[0]), [4, 4, 0], 1e-12, 'the first point');
  curve.setKind('barycentric');
  curve.setBeta(0, 2);
  assert.deepEqual(Array.from(curve.betas()), [2, 1, 1, 1, 1]);
  assert.equal(curve.kind, 'barycentric');
  assert.equal(curve.knots().length, 0);
  assert.equal(curve.fieldsComputed, 5);
});

test('setting all points, weights or betas at once equals setting them one by one', () => {
  const [one, all] = [1, 2].map(() =>
    karcher.meshFromObj(grid(cells)).curve({ kind: 'bspline', points, ...unrefined }),
  );
  const same = () => {
    assert.deepEqual(all.points(), one.points());
    assert.deepEqual(all.samples(), one.samples());
    assert.deepEqual(all.polyline({ bits: 64 }), one.polyline({ bits: 64 }));
  };
  const moved = [...points];
  moved[1] = { vertex: 70 };
  moved[3] = { face: 12, bary: [0.2, 0.3, 0.5] };
  one.movePoint(1, moved[1]);
  one.movePoint(3, moved[3]);
  all.setPoints(moved);
  assert.equal(all.fieldsComputed, points.length + 2, 'the others stay where they are');
  same();
  one.setWeight(0, 2);
  one.setWeight(4, 3);
  all.setWeights(Float64Array.of(2, 1, 1, 1, 3));
  same();
  for (const curve of [one, all]) curve.setKind('barycentric');
  one.setBeta(2, 5);
  all.setBetas([1, 1, 5, 1, 1]);
  same();
  for (const [wrong, code, message] of [
    [() => all.setBetas([1, 2]), 'badArgument', /5 control points but 2 betas/],
    [() => all.setBetas([]), 'badArgument', /empty/],
    [() => all.setWeights([1, 1, 1, 1, 1]), 'badArgument', /has no weights/],
    [() => all.setPoints(points.slice(0, 4)), 'badArgument', /4 control points but 5 betas/],
  ]) {
    assert.throws(wrong, { code, message });
    same();
  }
});

test('a curve copies its options', () => {
  const own = points.map((point) => ({ ...point }));
  const options = { kind: 'bspline', points: own, weights: [1, 2, 1, 2, 1], ...exact };
  const curve = mesh.curve(options);
  const [samples, parts] = [curve.samples(), curve.split(0.5)];
  const part = parts[0].samples();
  own[0].vertex = 3;
  own.length = 1;
  options.weights[1] = 7;
  Object.assign(options, { samples: 3, solver: 'fast', kind: 'bezier' });
  curve.setWeight(1, 3);
  curve.setWeight(1, 2);
  assert.deepEqual(curve.samples(), samples);
  assert.deepEqual(curve.split(0.5)[0].samples(), part);
});

test('invalid curves say why', () => {
  const good = { points, ...exact };
  const wrong = [
    [{ kind: 'bspline', degree: 6 }, 'badArgument', /degree 1 to 5, not 6/],
    [{ kind: 'bspline', degree: 2.5 }, 'badArgument', /the degree must be a whole number/],
    [{ kind: 'bspline', degree: 5 }, 'tooFewPoints', /quintic B-spline needs at least 6/],
    [{ kind: 'bspline', knots: [0, 1, 2] }, 'badArgument', /takes 9 knots, not 3/],
    [{ kind: 'bspline', knots: 'even' }, 'badArgument', /knots must be one of uniform, clamped/],
    [{ kind: 'bspline', knots: [] }, 'badArgument', /empty/],
    [
      { kind: 'bspline', knots: [0, 1, 2, 3, 2, 5, 6, 7, 8] },
      'badArgument',
      /knot 4 is 2, less than knot 3, which is 3/,
    ],
    [{ kind: 'bspline', knots: 'clamped', closed: true }, 'badArgument', /no ends to clamp/],
    [{ kind: 'bspline', closed: 'yes' }, 'badArgument', /closed must be true or false/],
    [{ kind: 'bspline', weights: [1, 2] }, 'badArgument', /5 control points but 2 weights/],
    [
      { kind: 'bspline', weights: [1, 2, -1, 1, 1] },
      'badArgument',
      /the weight of point 2 must be from 1e-12 to 1e12, not -1$/,
    ],
    [{ kind: 'bspline', weights: [1, Number.NaN, 1, 1, 1] }, 'notFinite', /weight of point 1/],
    [{ kind: 'bezier', weights: [1, 1, 1, 1, 1] }, 'badArgument', /Bezier curve has no weights/],
    [{ kind: 'bezier', betas: [1, 1, 1, 1, 1] }, 'badArgument', /has no betas/],
    [
      { kind: 'bezier', knots: 'clamped' },
      'badArgument',
      /'bezier' takes no knots; 'bspline' does/,
    ],
    [{ kind: 'polyline', knots: 'uniform' }, 'badArgument', /takes no knots/],
    [{ kind: 'bezier', degree: 2 }, 'badArgument', /'bezier' takes no degree; 'bspline' does/],
    [{ kind: 'bspline', parametrization: 'uniform' }, 'badArgument', /takes no parametrization/],
    [{ kind: 'bezier', basis: bernstein }, 'badArgument', /takes no basis; 'custom' does/],
    [{ kind: 'bspline', weights: [] }, 'badArgument', /weights must not be an empty array/],
    [{ kind: 'bspline', rings: 3 }, 'badArgument', /'exact' has no rings; 'graph' has/],
    [{ kind: 'catmullrom', parametrization: 'chord' }, 'badArgument', /parametrization/],
    [{ kind: 'polyline', points: points.slice(0, 2), closed: true }, 'tooFewPoints', /at least 3/],
    [{ kind: 'custom' }, 'badArgument', /needs a basis/],
    [{ kind: 'custom', basis: () => [1, 2] }, 'badWeights', /gives 2 weights of sum 3/],
    [{ kind: 'custom', basis: () => 'no' }, 'badArgument', /weights of the basis/],
    [{ kind: 'custom', basis: 5 }, 'badArgument', /basis must be a function, not 5/],
    [{ kind: 'bspline', tolerance: 0.1 }, 'badArgument', /not both/],
    [{ kind: 'bspline', samples: 'adaptive', tolerance: 0 }, 'badArgument', /positive/],
    [{ kind: 'bspline', samples: 'adaptive', tolerance: 2 }, 'badArgument', /1e-7 to 1, not 2/],
  ];
  const refuseAll = () => {
    for (const [change, code, message] of wrong) {
      const make = () => mesh.curve({ ...good, ...change });
      assert.throws(make, { name: 'KarcherError', code, message });
    }
  };
  // The allocator may round a block up the first time.
  refuseAll();
  const bytes = karcher.allocatedBytes();
  refuseAll();
  assert.equal(karcher.allocatedBytes(), bytes);
  const thrown = new Error('mine');
  const basis = () => {
    throw thrown;
  };
  assert.throws(() => mesh.curve({ ...good, kind: 'custom', basis }), thrown);

  const curve = mesh.curve({ kind: 'bezier', ...good });
  assert.throws(() => curve.setWeight(0, 2), { code: 'badArgument', message: /no weights/ });
  assert.throws(() => curve.setBeta(0, 2), { code: 'badArgument', message: /no betas/ });
  assert.throws(() => curve.setKind('custom'), { code: 'badArgument', message: /basis/ });
  assert.throws(() => curve.setClosed(1), { code: 'badArgument', message: /true or false/ });
  assert.throws(() => curve.movePointInOrder(0, 5), { code: 'badIndex' });
  curve.setKind('rational');
  assert.throws(() => curve.setWeight(5, 2), { code: 'badIndex' });
  assert.throws(() => curve.setWeight(0, 0), {
    code: 'badArgument',
    message: /from 1e-12 to 1e12/,
  });
});

test('adaptive samples keep their tolerance', () => {
  const plane = { kind: 'bezier', points, solver: 'exact', samples: 'adaptive' };
  const diagonal = cells * Math.SQRT2;
  let last = 0;
  for (const tolerance of [1e-2, 1e-3, undefined]) {
    const curve = mesh.curve({ ...plane, ...(tolerance ? { tolerance } : {}) });
    const polyline = curve.polyline({ bits: 64 });
    let worst = 0;
    for (let i = 0; i <= 500; i++) {
      const [x, y] = blended(bernstein(i / 500));
      let nearest = Number.POSITIVE_INFINITY;
      for (let k = 3; k < polyline.length; k += 3) {
        const [ax, ay, , bx, by] = polyline.slice(k - 3, k + 2);
        const squared = (bx - ax) ** 2 + (by - ay) ** 2;
        const s = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / squared;
        const at = Math.min(Math.max(s, 0), 1);
        nearest = Math.min(nearest, Math.hypot(ax + at * (bx - ax) - x, ay + at * (by - ay) - y));
      }
      worst = Math.max(worst, nearest);
    }
    assert.ok(worst <= (tolerance ?? 1e-4) * diagonal);
    assert.ok(curve.samples().count >= last);
    last = curve.samples().count;
  }
});

test('with exact geometry the polyline bends only on the curve, even with few samples', () => {
  const away = ([x, y]) => {
    const distance = (t) => {
      const [cx, cy] = blended(bernstein(t));
      return Math.hypot(cx - x, cy - y);
    };
    const ts = Array.from({ length: 401 }, (_, i) => i / 400);
    const nearest = ts.reduce((best, t) => (distance(t) < distance(best) ? t : best));
    let [from, to] = [Math.max(nearest - 1 / 400, 0), Math.min(nearest + 1 / 400, 1)];
    for (let step = 0; step < 100; step++) {
      const third = (to - from) / 3;
      if (distance(from + third) < distance(to - third)) to -= third;
      else from += third;
    }
    return distance((from + to) / 2);
  };
  const worst = (geometry) => {
    const curve = mesh.curve({ kind: 'bezier', points, solver: 'exact', samples: 5, geometry });
    const polyline = curve.polyline({ bits: 64 });
    const vertices = Array.from({ length: polyline.length / 3 }, (_, i) =>
      polyline.slice(3 * i, 3 * i + 2),
    );
    assert.ok(vertices.length > 8);
    return Math.max(...vertices.map(away));
  };
  assert.ok(worst('exact') < 1e-7);
  assert.ok(worst('geodesic') > 1e-3);
  assert.throws(() => mesh.curve({ kind: 'bezier', points, geometry: 'straight' }), {
    code: 'badArgument',
    message: /geodesic, exact, not 'straight'/,
  });
});

test('a curve at a parameter, by length, and near a place', () => {
  const curve = mesh.curve({ kind: 'bezier', points, solver: 'exact' });
  const at = curve.pointAt(0.3);
  near(at.position, blended(bernstein(0.3)), 1e-9, 'the point');
  near(mesh.position(at.point), at.position, 1e-12, 'the surface point');
  assert.equal(at.status, 'converged');
  const tangent = curve.tangentAt(0.3);
  const step = blended(bernstein(0.301)).map((x, k) => x - blended(bernstein(0.299))[k]);
  near(tangent.inSpace, [step[0] / 0.002, step[1] / 0.002, 0], 1e-3, 'the tangent');
  assert.ok(Math.abs(tangent.inFace.reduce((a, b) => a + b)) < 1e-12);

  const nearest = curve.nearest([at.position[0], at.position[1], 2]);
  assert.ok(Math.abs(nearest.parameter - 0.3) < 1e-6 && Math.abs(nearest.distance - 2) < 1e-9);

  const { parameter, position, face, bary } = curve.equallySpaced(5);
  assert.deepEqual([parameter.length, position.length, face.length, bary.length], [5, 15, 5, 15]);
  for (let i = 0; i < 5; i++) {
    assert.ok(Math.abs(curve.lengthAt(parameter[i]) - (i * curve.length) / 4) < 1e-9);
    const same = curve.pointAtLength(Math.min((i * curve.length) / 4, curve.length));
    near(same.position, Array.from(position.slice(3 * i, 3 * i + 3)), 1e-9, `point ${i}`);
  }
  const closed = mesh.curve({ kind: 'bspline', closed: true, points, solver: 'exact' });
  for (const whole of [curve, closed]) {
    // The lengths are the same, summed in another order.
    const off = whole.lengthAt(whole.segmentCount) - whole.length;
    assert.ok(Math.abs(off) < 1e-12 * whole.length);
  }
  const wrong = [
    [() => curve.pointAt(1.1), 'badArgument', /no parameter 1\.1/],
    [() => curve.pointAt(Number.NaN), 'notFinite', /parameter/],
    [() => curve.tangentAt(-1), 'badArgument', /no parameter/],
    [() => curve.lengthAt(2), 'badArgument', /no parameter/],
    [() => curve.pointAtLength(-1), 'badArgument', /no point at the length/],
    [() => curve.equallySpaced(1), 'badArgument', /2 to 1000000/],
    [() => curve.nearest([1, 2]), 'badArgument', /3 numbers/],
    [() => curve.nearest([1, 2, Number.NaN]), 'notFinite', /component 2 of the place/],
  ];
  for (const [use, code, message] of wrong) assert.throws(use, { code, message });
});

test('points are inserted in a curve, curves are split and joined', () => {
  const options = { kind: 'bspline', points, solver: 'exact', samples: 9 };
  const curve = mesh.curve(options);
  const whole = [0, 0.3, 1, 1.5, 2].map((at) => curve.pointAt(at).position);

  const refined = mesh.curve(options);
  const index = refined.insertOnCurve(0.3);
  assert.equal(refined.points().length, 6);
  assert.ok(index > 0 && index < 5);
  assert.equal(refined.segmentCount, 3);
  [0, 1, 2, 2.5, 3].forEach((at, i) => {
    near(refined.pointAt(at).position, whole[i], 1e-9, `with a knot, ${at}`);
  });

  const parts = curve.split(1.5);
  assert.equal(parts.length, 2);
  near(parts[0].pointAt(0).position, whole[0], 1e-9, 'the start');
  near(parts[0].pointAt(parts[0].segmentCount).position, whole[3], 1e-9, 'the cut');
  near(parts[1].pointAt(0).position, whole[3], 1e-9, 'the cut');
  const joined = parts[0].join(parts[1]);
  assert.equal(joined.segmentCount, 3);
  near(joined.pointAt(0.3).position, whole[1], 1e-9, 'joined');
  near(joined.pointAt(3).position, whole[4], 1e-9, 'the end');
  assert.equal(joined.samples().count, 27);

  const closed = mesh.curve({ kind: 'rational', closed: true, points, weights: [1, 2, 1, 2, 1] });
  closed.insertOnCurve(0.5);
  assert.equal(closed.points().length, 6);
  assert.equal(closed.closed, true);
  const elsewhere = karcher.meshFromObj(grid(cells));
  const other = elsewhere.curve(options);
  const custom = mesh.curve({ kind: 'custom', points, basis: bernstein });
  const polyline = mesh.curve({ kind: 'polyline', points });
  const wrong = [
    [() => curve.split(0), /cannot be split at 0, its end; it runs from 0 to 2/],
    [() => curve.split(3), /no parameter 3/],
    [() => curve.join(other), /same mesh/],
    [() => curve.join(null), /a curve of the same mesh, not null/],
    [() => curve.join(polyline), /bspline and polyline/],
    [() => curve.join(closed), /closed/],
    [() => polyline.insertOnCurve(1), /control point there/],
    [() => custom.insertOnCurve(0.5), /its own basis/],
  ];
  for (const [use, message] of wrong) assert.throws(use, { code: 'badArgument', message });
  const before = curve.samples();
  mesh.curve(options).dispose();
  assert.deepEqual(curve.samples(), before);
});
