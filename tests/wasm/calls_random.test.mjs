// Calls of the facade in any order, with right and wrong arguments, after dispose and from within a
// basis: every failure is a KarcherError, and earlier objects still work.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import fc from 'fast-check';
import { Curve, load, Mesh } from 'karcher';
import { loadInWorker } from 'karcher/worker';
import { checkMeant, draws } from './draws.mjs';
import { tube } from './meshes.mjs';

let karcher;
let remote;
before(async () => {
  karcher = await load();
  remote = await loadInWorker();
});
after(() => remote.dispose());

const methodsOf = (prototype) =>
  Object.getOwnPropertyNames(prototype).filter((name) => {
    const { value } = Object.getOwnPropertyDescriptor(prototype, name);
    return typeof value === 'function' && name !== 'constructor' && name !== 'benchmark';
  });

const number = fc.oneof(
  fc.constantFrom(0, 1, 2, 3, -1, 0.5, 1e9, 2 ** 31, Number.NaN, Infinity),
  fc.double({ min: -10, max: 10, noNaN: true }),
);
const point = fc.oneof(
  fc.record({ vertex: fc.oneof(fc.nat(40), number) }),
  fc.record({
    face: fc.oneof(fc.nat(70), number),
    bary: fc.oneof(
      fc.constantFrom([1, 0, 0], [0.2, 0.3, 0.5], [0, 0.5, 0.5]),
      fc.array(number, { maxLength: 4 }),
    ),
  }),
);
const points = fc.array(point, { maxLength: 6 });
const wrong = fc.oneof(
  fc.constantFrom(null, undefined, '', 'x', true, {}, [], Symbol.iterator, 10n, () => 1),
  fc.object({ maxDepth: 1 }),
  fc.constantFrom(Object.create(null), new Map(), new Date(0), new Float32Array(3)),
);
const kind = fc.constantFrom(
  ...['bspline', 'bezier', 'rational', 'barycentric', 'catmullrom', 'polyline', 'custom', 'none'],
);
const options = fc.record(
  {
    kind,
    points,
    samples: fc.oneof(fc.constantFrom(2, 9, 'adaptive'), number),
    closed: fc.boolean(),
    degree: number,
    levels: fc.oneof(fc.constantFrom('auto', 'limit', 0, 2), number),
    knots: fc.oneof(fc.constantFrom('uniform', 'clamped'), fc.array(number, { maxLength: 9 })),
    weights: fc.array(number, { maxLength: 6 }),
    betas: fc.array(number, { maxLength: 6 }),
    method: fc.constantFrom('karcher', 'paper', 'other'),
    solver: fc.constantFrom('fast', 'exact', 'graph'),
    radius: number,
    radii: fc.array(number, { maxLength: 3 }),
    direction: fc.array(number, { maxLength: 3 }),
    normalize: fc.boolean(),
    rings: number,
  },
  { requiredKeys: [] },
);
const argument = fc.oneof(
  number,
  point,
  points,
  options,
  wrong,
  fc.array(number, { maxLength: 6 }),
);
/** Whether a curve takes too long for this test: adaptive with many samples or large numbers. */
const tooLong = ({ samples, tolerance }) =>
  (typeof samples === 'number' && samples > 200) ||
  (samples === 'adaptive' && tolerance !== undefined);

const call = (names) =>
  fc.record({
    name: fc.constantFrom(...names),
    args: fc.array(argument, { maxLength: 4 }),
  });

/** The value of a valid curve. */
const good = {
  kind: 'bspline',
  points: [{ vertex: 0 }, { vertex: 5 }, { vertex: 14 }, { vertex: 20 }],
  samples: 5,
};

const isHuge = (args) =>
  args.some((arg) => typeof arg === 'number' && arg > 1e6) ||
  args.some((arg) => typeof arg === 'object' && arg !== null && tooLong(arg));

/** Runs a call, and catches an expected failure. */
function tried(work) {
  try {
    return work();
  } catch (error) {
    checkMeant(error);
    return undefined;
  }
}

const meshMethods = methodsOf(Mesh.prototype).filter(
  (name) => !['prepare', 'subdivide'].includes(name),
);
const curveMethods = methodsOf(Curve.prototype);

test('calls in any order, even after dispose', () => {
  let ended = 0;
  fc.assert(
    fc.property(
      fc.array(fc.tuple(fc.constantFrom('mesh', 'curve'), call(meshMethods), call(curveMethods)), {
        maxLength: 12,
      }),
      (calls) => {
        const mesh = karcher.meshFromObj(tube(6, 5));
        const curve = mesh.curve(good);
        for (const [which, ofMesh, ofCurve] of calls) {
          const { name, args } = which === 'mesh' ? ofMesh : ofCurve;
          if (isHuge(args)) continue;
          const object = which === 'mesh' ? mesh : curve;
          if (name === 'dispose') ended++;
          const made = tried(() => object[name](...args));
          // Promises of `prepare` were removed; the caller owns the results.
          if (made instanceof Curve) made.dispose();
        }
        mesh.dispose();
        assert.throws(() => curve.polyline(), { code: 'disposed' });
        // The engine still works as before.
        const fresh = karcher.meshFromObj(tube(6, 5));
        assert.equal(fresh.curve(good).samples().count, 5);
        fresh.dispose();
      },
    ),
    draws(150),
  );
  assert.ok(ended > 0, 'objects were disposed of on the way');
});

test('an invalid value changes nothing, and a randomly edited curve equals the curve of its value', () => {
  fc.assert(
    fc.property(fc.array(call(curveMethods), { maxLength: 8 }), (calls) => {
      const mesh = karcher.meshFromObj(tube(6, 5));
      const curve = mesh.curve(good);
      for (const { name, args } of calls) {
        if (name === 'dispose' || isHuge(args)) continue;
        const before = curve.value();
        try {
          curve[name](...args);
        } catch (error) {
          checkMeant(error);
          assert.deepEqual(curve.value(), before, `${name} failed and changed the curve`);
        }
      }
      const { samples } = curve.value();
      if (samples === 'adaptive' || samples > 500) return;
      // The other mesh is separate: curves of one mesh share fields.
      const other = karcher.meshFromObj(tube(6, 5));
      const anew = other.curve(curve.value());
      const [edited, made] = [curve.polyline({ bits: 64 }), anew.polyline({ bits: 64 })];
      assert.deepEqual(edited.length, made.length);
      for (const [i, x] of edited.entries()) assert.ok(Math.abs(x - made[i]) < 1e-9);
      mesh.dispose();
      other.dispose();
    }),
    draws(100),
  );
});

test('a basis cannot change anything, and the engine still works', () => {
  let asked = 0;
  let busy = 0;
  fc.assert(
    fc.property(call(meshMethods), call(curveMethods), fc.boolean(), (ofMesh, ofCurve, caught) => {
      if (isHuge(ofMesh.args) || isHuge(ofCurve.args)) return;
      const mesh = karcher.meshFromObj(tube(6, 5));
      const curve = mesh.curve(good);
      const before = [curve.value(), curve.polyline({ bits: 64 })];
      const failures = [];
      const basis = (t, count) => {
        asked++;
        for (const [object, { name, args }] of [
          [mesh, ofMesh],
          [curve, ofCurve],
        ]) {
          try {
            object[name](...args);
          } catch (error) {
            failures.push(error);
            if (!caught) throw error;
          }
        }
        return Array.from({ length: count }, (_, i) => (i === 0 ? 1 - t : i === count - 1 ? t : 0));
      };
      tried(() => mesh.curve({ ...good, kind: 'custom', basis }));
      for (const error of failures) checkMeant(error);
      // A call is not busy if it needs no engine, or is refused before it reaches the engine.
      if (failures.some(({ code }) => code === 'busy')) busy++;
      assert.deepEqual([curve.value(), curve.polyline({ bits: 64 })], before);
      mesh.dispose();
    }),
    draws(320),
  );
  assert.ok(asked > 100 && busy > 50, `asked ${asked} times, busy ${busy}`);
});

test('calls into a worker with any arguments: every failure is a KarcherError', async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(call(meshMethods), { maxLength: 6 }), async (calls) => {
      const mesh = await remote.meshFromObj(tube(6, 5));
      await Promise.all(
        calls
          .filter(({ args }) => !isHuge(args))
          .map(async ({ name, args }) => {
            try {
              const made = await mesh[name](...args);
              await made?.dispose?.();
            } catch (error) {
              checkMeant(error);
            }
          }),
      );
      await mesh.dispose().catch(checkMeant);
      assert.equal((await remote.shape('sphere', 500)).info.genus, 0);
    }),
    draws(40),
  );
});
