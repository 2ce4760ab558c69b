// `set` changes a curve into another one, and keeps its unaffected parts.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { curveInModule, noted } from './engine_calls.mjs';
import { fields, partsOf } from './meshes.mjs';

const karcher = await load();
const mesh = karcher.shape('torus', 4000);
// Curves of one mesh share their fields, so new curves are on another mesh.
const otherMesh = karcher.shape('torus', 4000);
const points = [0, 1, 2, 3, 4].map((i) => ({ face: 300 + 2 * i, bary: [0.2, 0.3, 0.5] }));
const added = { face: 305, bary: [0.5, 0.25, 0.25] };
// The curve has no levels, so that its fields are those of the control points.
const plain = { kind: 'bspline', points, samples: 9, levels: 0 };

const shown = (curve) => ({
  points: curve.points(),
  samples: curve.samples(),
  path: partsOf(curve.path()),
  marks: curve.unconverged(),
  bridged: curve.bridged(),
  knots: curve.knots(),
  weights: curve.weights(),
  betas: curve.betas(),
  told: [curve.kind, curve.closed, curve.degree, curve.length, curve.segmentCount],
});

/** The new values, and the number of fields that each may cost. */
const changes = {
  nothing: [{}, {}, 0],
  'a point that moves': [{}, { points: points.with(2, added) }, 1],
  'a point at the end': [{}, { points: [...points, added] }, 1],
  'a point at the start': [{}, { points: [added, ...points] }, 1],
  'a point among others': [{}, { points: points.toSpliced(2, 0, added) }, 1],
  'a point that goes': [{}, { points: points.toSpliced(1, 1) }, 0],
  'another order': [{}, { points: points.toReversed() }, 0],
  'a point twice': [{}, { points: [points[0], ...points] }, 0],
  'a weight': [{}, { weights: [1, 1, 3, 1, 1] }, 0],
  'no weights': [{ weights: [1, 1, 3, 1, 1] }, {}, 0],
  'all weights': [{ weights: [1, 1, 3, 1, 1] }, { weights: [2, 2, 1, 1, 2] }, 0],
  'another kind': [{}, { kind: 'bezier' }, 0],
  betas: [{ kind: 'barycentric' }, { kind: 'barycentric', betas: [1, 2, 1, 1, 1] }, 0],
  'a parametrization': [
    { kind: 'catmullrom' },
    { kind: 'catmullrom', parametrization: 'uniform' },
    0,
  ],
  'other knots': [{}, { knots: [0, 0, 0, 0, 1.5, 2, 2, 2, 2] }, 0],
  'ends that are reached': [{ knots: [0, 0, 0, 0, 1.5, 2, 2, 2, 2] }, { knots: 'clamped' }, 0],
  'another degree': [{}, { degree: 2 }, 0],
  'closing it': [{}, { closed: true }, 0],
  'opening it': [{ closed: true }, {}, 0],
  'other levels': [{}, { levels: 2 }, 20],
  'the limit': [{ levels: 2 }, { levels: 'limit' }, 0],
  'other samples': [{}, { samples: 17 }, 0],
  'samples by tolerance': [{}, { samples: 'adaptive', tolerance: 1e-3 }, 0],
  'exact geometry': [{}, { geometry: 'exact' }, 0],
  'a point, its weight and the kind': [
    { kind: 'rational' },
    { points: points.with(4, added), weights: [1, 1, 1, 1, 5] },
    1,
  ],
};

for (const [name, [from, to, cost]] of Object.entries(changes)) {
  test(`a curve that is set to ${name} equals a new one, and keeps unaffected parts`, () => {
    const curve = mesh.curve({ ...plain, ...from });
    const made = curve.fieldsComputed;
    curve.set({ ...plain, ...to });
    assert.ok(curve.fieldsComputed - made <= cost, `${curve.fieldsComputed - made} fields`);
    const anew = otherMesh.curve({ ...plain, ...to });
    assert.deepEqual(shown(curve), shown(anew));
    // The curve's value leads to the same curve again.
    const again = otherMesh.curve(curve.value());
    assert.deepEqual(shown(again), shown(anew));
    const before = curve.fieldsComputed;
    curve.set(curve.value());
    assert.equal(curve.fieldsComputed, before);
    for (const one of [curve, anew, again]) one.dispose();
  });
}

test('other fields make it anew, and its parts use them', () => {
  const curve = mesh.curve(plain);
  for (const field of fields) {
    curve.set({ ...plain, ...field });
    const anew = otherMesh.curve({ ...plain, ...field });
    assert.deepEqual(shown(curve), shown(anew));
    const [part, expected] = [curve.split(0.5)[0], anew.split(0.5)[0]];
    assert.deepEqual(part.samples(), expected.samples());
  }
});

test('an invalid value changes nothing', () => {
  const basis = (t) => [1 - t, t, 0, 0, 0];
  for (const start of [plain, { ...plain, kind: 'custom', basis }]) {
    const curve = mesh.curve(start);
    const [before, value] = [shown(curve), curve.value()];
    for (const [wrong, code] of [
      [{ points: points.slice(0, 1) }, 'tooFewPoints'],
      [{ weights: [1, 2] }, 'badArgument'],
      [{ betas: [1, 1, 1, 1, 1] }, 'badArgument'],
      [{ kind: 'bezier', degree: 2 }, 'badArgument'],
      [{ points: points.with(1, { face: 1e6, bary: [1, 0, 0] }) }, 'badIndex'],
      [{ kind: 'custom', basis: () => [1, 1, 1, 1, 1] }, 'badWeights'],
      [{ kind: 'custom', basis: 'none' }, 'badArgument'],
      [{ sample: 3 }, 'badArgument'],
    ]) {
      assert.throws(() => curve.set({ ...plain, ...wrong }), { name: 'KarcherError', code });
      assert.deepEqual(shown(curve), before);
      assert.deepEqual(curve.value(), value);
    }
    const thrown = new Error('of the basis');
    const failing = () => {
      throw thrown;
    };
    assert.throws(() => curve.set({ ...plain, kind: 'custom', basis: failing }), thrown);
    assert.deepEqual(shown(curve), before);
    curve.dispose();
    assert.throws(() => curve.set(plain), { code: 'disposed' });
  }
});

test('the module refuses an edit of an unknown name, which changes nothing', () => {
  const { curve, engineCurve } = curveInModule(mesh, plain);
  const before = shown(curve);
  assert.throws(() => mesh.handle.call(() => engineCurve.edit('insertPoints', 0, 0.5)), {
    ...{ name: 'KarcherError', code: 'badArgument' },
    message: /no edit 'insertPoints'/,
  });
  assert.deepEqual(shown(curve), before);
});

test('a view has all visible parts of a curve, in one buffer', () => {
  const curve = mesh.curve({ ...plain, closed: true });
  for (const bits of [32, 64]) {
    const view = curve.view({ bits });
    assert.deepEqual(view.polyline, curve.polyline({ bits }));
    assert.deepEqual(view.samples, curve.samples());
    assert.deepEqual(view.lengths, curve.path().lengths());
    assert.deepEqual(view.unconverged, curve.unconverged());
    assert.deepEqual(view.knots, curve.knots());
    assert.equal(view.length, curve.length);
    assert.equal(view.segmentCount, 5);
    assert.equal(view.levels, curve.levels);
    for (const time of Object.values(view.times)) assert.ok(time >= 0);
    assert.ok(view.times.trace > 0);
    const { segment, t, face, bary, position } = view.samples;
    const arrays = [view.unconverged, view.lengths, view.knots, segment, t, face, bary, position];
    for (const { buffer } of arrays) assert.equal(buffer, view.polyline.buffer);
  }
});

test('a step of a drag is one call into the module, and one copy out of it', () => {
  const curve = mesh.curve(plain);
  const { value: view, calls } = noted(mesh, () =>
    curve.set({ ...plain, points: points.with(2, added) }),
  );
  assert.deepEqual(
    calls.map(({ name }) => name),
    ['set'],
  );
  assert.equal(view.polyline.buffer, calls[0].returned.buffer);
  assert.equal(view.polyline.length, 3 * view.unconverged.length);
});

test('a value says how a curve is traced, as far as that was said', () => {
  const traced = { method: 'paper', solver: 'graph', rings: 3, star: 'ring', geometry: 'exact' };
  const curve = mesh.curve({ kind: 'polyline', points: points.slice(0, 2), ...traced });
  const { kind, closed, points: own, ...said } = curve.value();
  assert.deepEqual(said, { ...traced });
  const { kind: _, closed: open, points: all, ...none } = mesh.curve({ kind, points: own }).value();
  assert.deepEqual(none, {});
  assert.deepEqual([closed, open, all.length], [false, false, own.length]);
});
