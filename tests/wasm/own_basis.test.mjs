import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { partsOf } from './meshes.mjs';

const karcher = await load();
const mesh = karcher.shape('sphere', 2000);
const points = [0, 50, 100, 150].map((vertex) => ({ vertex }));

/** A Bernstein basis that counts its calls and throws from call `failsFrom` on. */
function countedBasis() {
  const counted = {
    calls: 0,
    failsFrom: Number.POSITIVE_INFINITY,
    basis(t, count) {
      if (counted.calls++ >= counted.failsFrom) throw counted.failure;
      let weights = [1];
      for (let degree = 1; degree < count; degree++) {
        weights = [...weights, 0].map(
          (weight, i) => (1 - t) * weight + t * (i > 0 ? weights[i - 1] : 0),
        );
      }
      return weights;
    },
    failure: new Error('mine'),
  };
  return counted;
}

const stateOf = (curve) => ({
  points: curve.points(),
  kind: curve.kind,
  samples: curve.samples(),
  bridged: curve.bridged(),
  path: partsOf(curve.path()),
  length: curve.length,
  marks: curve.unconverged(),
  segments: curve.segmentCount,
  at: curve.pointAt(0.37),
  tangent: curve.tangentAt(0.37),
  far: curve.lengthAt(0.37),
});

const edits = {
  movePoint: (curve) => curve.movePoint(0, { vertex: 9 }),
  addPoint: (curve) => curve.addPoint({ vertex: 200 }),
  insertPoint: (curve) => curve.insertPoint(1, { vertex: 200 }),
  removePoint: (curve) => curve.removePoint(1),
  movePointInOrder: (curve) => curve.movePointInOrder(0, 2),
  reverse: (curve) => curve.reverse(),
};

for (const settings of [{ samples: 9 }, { samples: 'adaptive', tolerance: 1e-3 }]) {
  for (const geometry of ['geodesic', 'exact']) {
    test(`an edit fails with its basis, and changes nothing: ${settings.samples}, ${geometry}`, () => {
      for (const [name, edit] of Object.entries(edits)) {
        const counted = countedBasis();
        const options = { kind: 'custom', points, basis: counted.basis, geometry, ...settings };
        const model = mesh.curve(options);
        const callsBefore = counted.calls;
        edit(model);
        const calls = counted.calls - callsBefore;
        const edited = stateOf(model);

        const curve = mesh.curve(options);
        const before = stateOf(curve);
        for (const part of [0, 0.25, 0.5, 0.75, 1]) {
          counted.failsFrom = counted.calls + Math.round(part * (calls - 1));
          if (calls > 0) assert.throws(() => edit(curve), counted.failure, name);
          counted.failsFrom = Number.POSITIVE_INFINITY;
          assert.deepEqual(stateOf(curve), before, `${name}, failed at ${part}`);
        }
        edit(curve);
        assert.deepEqual(stateOf(curve), edited, name);
        model.dispose();
        curve.dispose();
      }
    });
  }
}

test('a basis that calls the engine, or disposes of its mesh, is refused', async () => {
  const engine = await load();
  const own = engine.shape('sphere', 2000);
  let act = () => {};
  const basis = (t, count) => {
    act();
    return countedBasis().basis(t, count);
  };
  const curve = own.curve({ kind: 'custom', points, basis, samples: 9 });
  const before = stateOf(curve);
  const acts = {
    insertPoint: () => curve.insertPoint(1, { vertex: 200 }),
    setKind: () => curve.setKind('bezier'),
    set: () => curve.set({ kind: 'bezier', points }),
    polyline: () => curve.polyline(),
    'curve.dispose': () => curve.dispose(),
    'mesh.dispose': () => own.dispose(),
    'another curve': () => own.curve({ kind: 'bezier', points }),
    'another mesh': () => engine.shape('torus', 600),
  };
  for (const [name, reenter] of Object.entries(acts)) {
    act = reenter;
    const busy = { name: 'KarcherError', code: 'busy', message: /at work/ };
    assert.throws(() => curve.movePoint(0, { vertex: 9 }), busy, name);
    act = () => {};
    assert.deepEqual(stateOf(curve), before, name);
  }
  own.dispose();
});

test('a reversed curve has the mirrored basis, and so has its value', () => {
  // A quadratic through the three points, at 0, 0.2 and 1.
  const basis = (t) => [(1 - t / 0.2) * (1 - t), (t * (1 - t)) / 0.16, (t * (t - 0.2)) / 0.8];
  const curve = mesh.curve({ kind: 'custom', points: points.slice(1), basis, samples: 9 });
  const before = Array.from(curve.polyline({ bits: 64 }));
  const place = curve.pointAt(0.3).position;
  curve.reverse();
  const isThere = (a) =>
    assert.ok(
      a.every((x, i) => Math.abs(x - place[i]) < 1e-9),
      `${a} ${place}`,
    );
  isThere(curve.pointAt(0.7).position);
  isThere(mesh.curve(curve.value()).pointAt(0.7).position);
  curve.set({ ...curve.value(), samples: 17 });
  isThere(curve.pointAt(0.7).position);
  curve.reverse();
  isThere(mesh.curve(curve.value()).pointAt(0.3).position);
  curve.set({ kind: 'custom', points: points.slice(1), basis, samples: 9 });
  assert.deepEqual(Array.from(curve.polyline({ bits: 64 })), before);
  curve.reverse();
  curve.reverse();
  assert.deepEqual(Array.from(curve.polyline({ bits: 64 })), before);
});
