import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';

const karcher = await load();
const badArgument = { name: 'KarcherError', code: 'badArgument' };

/** Faces spread over a torus: so far apart that means of all of them break. */
function farPoints(mesh) {
  const { triangles } = mesh.info;
  const bary = [0.2, 0.3, 0.5];
  return Array.from({ length: 7 }, (_, i) => ({ face: (i * 801 + 5) % triangles, bary }));
}

test('a curve of distant points stays connected with as many levels as it needs', () => {
  const mesh = karcher.shape('torus', 2000);
  const points = farPoints(mesh);
  const spline = (levels) => mesh.curve({ kind: 'bspline', points, samples: 64, levels });
  const mean = spline(0);
  assert.equal(mean.levels, 0);
  assert.ok(mean.bridged().length > 0);
  const steady = mesh.curve({ kind: 'bspline', points, samples: 64 });
  assert.ok(steady.levels > 0);
  assert.deepEqual(steady.bridged(), []);
  assert.ok(steady.samples().status.every((status) => status === 'converged'));
  // The same number of levels gives the same curve.
  assert.deepEqual(spline(steady.levels).polyline(), steady.polyline());
  const limit = spline('limit');
  assert.deepEqual(limit.bridged(), []);
  assert.equal(limit.samples().t.length, steady.samples().t.length);
  assert.ok(Math.abs(limit.length - steady.length) < 0.02 * steady.length);
  mesh.dispose();
});

test('a curve of near points on a smooth surface is a mean of all of them', () => {
  const mesh = karcher.shape('sphere', 5000);
  const near = [0, 1, 2, 3].map((i) => ({ face: i, bary: [0.4, 0.3, 0.3] }));
  assert.equal(mesh.curve({ kind: 'bezier', points: near }).levels, 0);
  mesh.dispose();
});

test('levels are 0 to 8, auto or limit; the paper and means of all points have none', () => {
  const mesh = karcher.shape('torus', 2000);
  const points = farPoints(mesh);
  for (const levels of [-1, 9, 1.5, 'all', null]) {
    assert.throws(() => mesh.curve({ kind: 'bezier', points, levels }), badArgument, `${levels}`);
  }
  const paper = { kind: 'bezier', points, samples: 9, method: 'paper', solver: 'exact' };
  assert.throws(() => mesh.curve({ ...paper, levels: 2 }), badArgument);
  assert.equal(mesh.curve(paper).levels, 0);
  assert.equal(mesh.curve({ kind: 'barycentric', points, samples: 9, levels: 3 }).levels, 0);
  mesh.dispose();
});

test('automatic levels are at least as many as requested', () => {
  const mesh = karcher.shape('sphere', 5000);
  const points = [0, 1, 2, 3].map((i) => ({ face: i, bary: [0.4, 0.3, 0.3] }));
  const bezier = { kind: 'bezier', points, samples: 9 };
  const curve = mesh.curve({ ...bezier, leastLevels: 2 });
  assert.equal(curve.levels, 2);
  assert.equal(curve.value().leastLevels, 2);
  // The bound stays through every edit, until a caller sets another value.
  curve.movePoint(1, { face: 5, bary: [0.4, 0.3, 0.3] });
  assert.equal(curve.levels, 2);
  curve.set({ ...curve.value(), leastLevels: 0 });
  assert.equal(curve.levels, 0);
  for (const leastLevels of [-1, 9, 1.5, 'all', null]) {
    assert.throws(() => mesh.curve({ ...bezier, leastLevels }), badArgument, `${leastLevels}`);
  }
  assert.throws(() => mesh.curve({ ...bezier, levels: 3, leastLevels: 2 }), {
    ...badArgument,
    message: "a least number of levels is for levels: 'auto', not 3",
  });
  mesh.dispose();
});

test('levels stay within a tolerance of the curve without levels, and report their deviation', () => {
  const mesh = karcher.shape('sphere', 20_000);
  // Legs of about 0.3: distant points.
  const points = [0, 1, 2, 3].map((i) => {
    const at = [Math.cos(0.4 * i), Math.sin(0.4 * i), 0.3 * (i % 2)];
    return mesh.nearestPoint(at).point;
  });
  const bezier = { kind: 'bezier', points, samples: 33 };
  const asked = (levels) => mesh.curve({ ...bezier, levels });
  const centers = asked(0);
  assert.deepEqual([centers.levels, centers.deviation], [0, 0]);
  const edge = mesh.info.meanEdge;
  const from = (curve) =>
    Math.max(
      ...curve.samples().position.map((x, i) => Math.abs(x - centers.samples().position[i])),
    );
  for (const tolerance of [0, 0.02]) {
    const exact = asked({ tolerance });
    assert.equal(exact.levels, 0);
    assert.deepEqual(exact.value().levels, { tolerance });
  }
  const draft = asked({ tolerance: Infinity });
  assert.ok(draft.levels > 1);
  assert.ok(from(draft) < draft.deviation && draft.deviation < 3 * edge, `${draft.deviation}`);
  assert.ok(from(draft) > 0.02 * edge);
  // The curve may move as far as requested.
  assert.equal(asked({ tolerance: (1.01 * draft.deviation) / edge }).levels, draft.levels);
  assert.equal(asked({ tolerance: (0.99 * draft.deviation) / edge }).levels, 0);
  for (const tolerance of [-1, '1', null, undefined]) {
    assert.throws(() => asked({ tolerance }), badArgument, `${tolerance}`);
  }
  assert.throws(() => asked({ tolerance: Number.NaN }), { code: 'notFinite' });
  const around = { center: points[0], radius: 0.3, levels: { tolerance: 1 } };
  assert.throws(() => mesh.circle(around.center, around), badArgument);
  mesh.dispose();
});

test('a dragged point keeps its continued legs, a moved one has the shortest', () => {
  // Half around the tube two paths are shortest; the drag continues around it.
  const mesh = karcher.shape('torus', 2000);
  const start = mesh.surfacePoint(5, [0.2, 0.3, 0.5]);
  const line = mesh.curve({ kind: 'polyline', points: [start, start], samples: 2 });
  let place = start;
  let walked = 0;
  for (let step = 1; step <= 60; step++) {
    const path = mesh.straightest(start, [0, 0, 1], step * 0.05);
    place = path.end;
    walked = step * 0.05;
    line.dragPoint(1, place);
  }
  assert.equal(line.length.toFixed(9), walked.toFixed(9));
  // A leg stays while its ends do.
  line.movePoint(1, place);
  assert.equal(line.length.toFixed(9), walked.toFixed(9));
  line.movePoint(1, { vertex: 0 });
  line.movePoint(1, place);
  const shortest = mesh.shortestPath(start, place).length;
  assert.equal(line.length.toFixed(9), shortest.toFixed(9));
  assert.ok(shortest < walked / 2);
  mesh.dispose();
});

test('several points dragged together keep their continued legs', () => {
  // An anchor of the pen with its handles, halfway around the tube and beyond.
  const mesh = karcher.shape('torus', 2000);
  const start = mesh.surfacePoint(5, [0.2, 0.3, 0.5]);
  const along = (length) =>
    mesh.straightest(start, [0, 0, Math.sign(length) || 1], Math.abs(length)).end;
  const pointsAt = (to) => [0, 0.05, to - 0.1, to, to + 0.1, -0.3, -0.4].map(along);
  const value = {
    kind: 'bspline',
    knots: [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2],
    samples: 9,
    levels: 2,
  };
  const curve = mesh.curve({ ...value, points: pointsAt(0.3) });
  const lengths = () => curve.legs().map(({ path }) => path.length);
  for (let to = 0.35; to < 1.87; to += 0.05) {
    curve.set({ ...value, points: pointsAt(to), legs: curve.view().drawnLegs });
    const legs = [0.05, to - 0.15, 0.1, 0.1, to + 0.4, 0.1];
    for (const [i, length] of lengths().entries()) {
      assert.ok(Math.abs(length - legs[i]) < 1e-6, `leg ${i} to ${to}: ${length}, not ${legs[i]}`);
    }
  }
  const { legs } = curve.value();
  assert.deepEqual(
    legs.map((leg) => leg !== null),
    [false, true, false, false, true, false],
  );
  const drawn = lengths();
  curve.set({ ...value, points: pointsAt(1.85), legs });
  for (const [i, length] of lengths().entries()) assert.ok(Math.abs(length - drawn[i]) < 1e-6);
  curve.set({ ...value, points: pointsAt(1.85) });
  assert.ok(lengths()[1] < drawn[1] - 0.3, 'none is dragged');
  mesh.dispose();
});

/** A curve whose last point was dragged far round the torus: the leg to it is not the shortest. */
function drawnOut(mesh, options) {
  const start = mesh.surfacePoint(5, [0.2, 0.3, 0.5]);
  const far = [1, 2].map((i) => mesh.surfacePoint(5 + 40 * i, [0.2, 0.3, 0.5]));
  const curve = mesh.curve({ points: [...far, start, start], samples: 17, ...options });
  for (let step = 1; step <= 50; step++) {
    const { end } = mesh.straightest(start, [0, 0, 1], step * 0.05);
    const value = curve.value();
    const legs = curve.view().drawnLegs.map((leg, i) => (i === 2 ? leg : null));
    curve.set({ ...value, points: value.points.with(-1, end), legs });
  }
  return curve;
}

test('legs are part of the value, as a few points', () => {
  const mesh = karcher.shape('torus', 2000);
  for (const options of [{ kind: 'polyline' }, { kind: 'bezier', levels: 3 }]) {
    const curve = drawnOut(mesh, options);
    const { legs } = curve.value();
    assert.deepEqual(legs.slice(0, 2), [null, null]);
    assert.ok(legs[2].length >= 1 && legs[2].length <= 7, `${legs[2].length} points`);
    // The value is written and read again.
    const again = mesh.curve(JSON.parse(JSON.stringify(curve.value())));
    assert.ok(Math.abs(again.length - curve.length) < 1e-6 * curve.length);
    const twice = mesh.curve(again.value());
    assert.ok(Math.abs(twice.length - again.length) < 1e-9 * curve.length);
    const [, , leg] = again.legs();
    assert.ok(leg.shorter.length < 0.9 * leg.path.length);
    assert.equal(again.legs()[0].shorter, undefined);
    assert.deepEqual(
      again.view({ bits: 64 }).legs.map((one) => one.length > 0),
      [true, true, true],
    );
    const straight = mesh.curve({ ...again.value(), legs: undefined });
    assert.ok(straight.length < 0.95 * again.length);
    assert.equal(straight.value().legs, undefined);
    // A reversal of the curve keeps the legs.
    again.reverse();
    assert.deepEqual(again.value().legs.slice(1), [null, null]);
    assert.ok(Math.abs(again.length - curve.length) < 1e-6 * curve.length);
  }
  mesh.dispose();
});

test('invalid legs: a sentence, and the curve is unchanged', () => {
  const mesh = karcher.shape('torus', 2000);
  const points = farPoints(mesh).slice(0, 4);
  const curve = mesh.curve({ kind: 'bezier', points, samples: 9 });
  const before = curve.polyline();
  const value = { kind: 'bezier', points, samples: 9 };
  const [place] = points;
  for (const legs of [
    [null],
    [[place], null, null, null, null],
    5,
    [5, null, null],
    [[5], null, null],
  ]) {
    assert.throws(() => curve.set({ ...value, legs }), badArgument, JSON.stringify(legs));
  }
  // The number of legs must match, whether or not some are drawn. 4 legs are those of the same
  // curve closed.
  for (const count of [1, 2, 5]) {
    const legs = Array(count).fill(null);
    const message = `the control polygon has 3 legs, not ${count}`;
    assert.throws(() => curve.set({ ...value, legs }), { ...badArgument, message });
    const drawn = Array(count).fill(curve.view().drawnLegs[0]);
    assert.throws(() => curve.set({ ...value, legs: drawn }), { ...badArgument, message });
  }
  const nowhere = [[{ face: 1e6, bary: [1, 0, 0] }], null, null];
  assert.throws(() => curve.set({ ...value, legs: nowhere }), { code: 'badIndex' });
  const away = { face: [1e6, 0], bary: [1, 0, 0, 1, 0, 0] };
  assert.throws(() => curve.set({ ...value, legs: [away, null, null] }), { code: 'badIndex' });
  for (const drawn of [{ face: [0] }, { face: [0, 1], bary: [1] }, { face: 0, bary: 0 }]) {
    assert.throws(() => curve.set({ ...value, legs: [drawn, null, null] }), badArgument);
  }
  assert.throws(() => curve.set(value, { drags: 1 }), badArgument);
  assert.deepEqual(curve.polyline(), before);
  mesh.dispose();
});
