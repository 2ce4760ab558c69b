// The methods that Karcher is compared with, through their module.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { load } from 'karcher';
import { CurveMeter, comparedMethods } from 'karcher/peers';
import { distance, grid } from './meshes.mjs';
import { peersOnPlane, side } from './peers_on_plane.mjs';

let peers;
let plane;
let points;
before(async () => {
  ({ peers, plane, points } = await peersOnPlane());
});

const prepared = (method, mesh = plane, options = {}) =>
  peers.prepare(mesh, { method, landmarks: 40, ...options });

test("ours and the paper's are the curves of the engine, sample by sample", async () => {
  for (const options of [
    { method: 'karcher', solver: 'fast' },
    { method: 'karcher', solver: 'exact' },
    { method: 'paper', solver: 'exact' },
    { method: 'paper', solver: 'graph', rings: 3 },
  ]) {
    const expected = plane.curve({ kind: 'bspline', points, samples: 9, levels: 0, ...options });
    const method = await peers.prepare(plane, options);
    const curve = method.curve(peers.plan(points, 9));
    curve.finish();
    assert.deepEqual(curve.samples(), expected.samples());
    assert.deepEqual(curve.line().path.polyline(), expected.polyline());
    curve.movePoint(2, { vertex: 71 });
    expected.movePoint(2, { vertex: 71 });
    assert.ok((await curve.trace()) >= 0);
    assert.deepEqual(curve.samples(), expected.samples());
    method.dispose();
    expected.dispose();
  }
});

describe('every method', () => {
  const curved = comparedMethods.filter((name) => !['descent', 'bSurf', 'leveled'].includes(name));

  test('returns a control point with all the weight', async () => {
    for (const name of curved) {
      const method = await prepared(name);
      const { position, status } = method.centerOfMass(points, [0, 0, 1, 0, 0]);
      assert.equal(status, 'converged', name);
      assert.ok(distance(position, plane.position(points[2])) < 1e-6, name);
      method.dispose();
    }
  });

  test('averages points of the plane, up to its error', async () => {
    // The largest error in edges. Affine heat is exact except for the heat that the boundary
    // reflects; the embedding of 40 landmarks is no isometry; vector heat is not linearly precise.
    const most = {
      affineHeat: 0.01,
      weightedAverages: 0.2,
      vectorHeat: 0.5,
      karcher: 1e-9,
      paper: 1e-9,
    };
    const weights = [0.1, 0.3, 0.2, 0.3, 0.1];
    const places = points.map((point) => plane.position(point));
    const expected = [0, 1, 2].map((c) =>
      places.reduce((sum, place, i) => sum + weights[i] * place[c], 0),
    );
    for (const name of curved) {
      const method = await prepared(name, plane, name === 'paper' ? { solver: 'exact' } : {});
      const { position, status } = method.centerOfMass(points, weights);
      assert.equal(status, 'converged', name);
      const error = distance(position, expected);
      assert.ok(error <= most[name], `${name}: ${error}`);
      method.dispose();
    }
  });

  test('finds points on the shortest path between two', async () => {
    const pair = [{ vertex: 30 }, { vertex: 107 }];
    for (const name of comparedMethods) {
      const method = await prepared(name);
      const plan = peers.plan(pair, 5);
      const curve = method.curve(plan);
      curve.finish();
      const { position, status } = curve.samples();
      const [from, to] = pair.map((point) => plane.position(point));
      for (let i = 0; i < 5; i++) {
        assert.equal(status[i], 'converged', `${name}, sample ${i}`);
        const expected = from.map((x, c) => x + (i / 4) * (to[c] - x));
        const error = distance(Array.from(position.slice(3 * i, 3 * i + 3)), expected);
        // Constant gradients of exact distances point up to 2 edges past a source this near.
        assert.ok(
          error < (name === 'descent' ? 2 : 0.6),
          `${name}, sample ${i}: ${error} edges away`,
        );
      }
      method.dispose();
    }
  });

  test('joins two points beside another part of the mesh', async () => {
    const other = [170, 171, 172];
    const text = `${grid(side)}\nv 99 0 0\nv 99 1 0\nv 98 0 0\nf ${other.join(' ')}\n`;
    const mesh = peers.karcher.meshFromObj(text);
    assert.equal(mesh.info.components, 2);
    const pair = [{ vertex: 30 }, { vertex: 107 }];
    for (const name of comparedMethods) {
      if (name === 'weightedAverages') continue; // This method embeds the whole mesh.
      const method = await prepared(name, mesh);
      const curve = method.curve(peers.plan(pair, 5));
      curve.finish();
      assert.equal(curve.samples().status[2], 'converged', name);
      method.dispose();
    }
  });

  test('starts at a given point', async () => {
    for (const name of curved) {
      const method = await prepared(name);
      const there = method.centerOfMass(points, [0.2, 0.2, 0.2, 0.2, 0.2], {
        start: { vertex: 71 },
      });
      assert.equal(there.status, 'converged', name);
      method.dispose();
    }
  });
});

describe('the paper’s authors', () => {
  const authors = { method: 'paper', solver: 'exact', seeds: 'authors' };
  const traced = async (mesh, plan, options) => {
    const method = await peers.prepare(mesh, options);
    const curve = method.curve(plan);
    curve.finish();
    const samples = curve.samples();
    method.dispose();
    return samples;
  };

  test('end a Bézier curve at its control points, which gradients alone miss', async () => {
    const mesh = peers.karcher.shape('torus', 500);
    const inside = (face) => ({ face, bary: [0.2, 0.5, 0.3] });
    const ends = [inside(20), inside(47), inside(60)];
    const plan = peers.plan(ends, 9);
    const away = ({ position, count }) =>
      [
        [0, 0],
        [count - 1, 2],
      ].map(([i, k]) =>
        distance(Array.from(position.slice(3 * i, 3 * i + 3)), mesh.position(ends[k])),
      );
    for (const error of away(await traced(mesh, plan, authors))) assert.ok(error < 1e-12);
    const heaviest = away(await traced(mesh, plan, { ...authors, seeds: 'heaviest' }));
    assert.ok(Math.max(...heaviest) > 1e-3, `${heaviest}`);
  });

  test('find the same centers if they are unique, and continue through all segments', async () => {
    const plan = peers.plan(points, 9);
    const [one, other] = [
      await traced(plane, plan, authors),
      await traced(plane, plan, { ...authors, seeds: 'heaviest' }),
    ];
    assert.ok(one.status.every((status) => status === 'converged'));
    for (let i = 0; i < 3 * one.count; i++) {
      assert.ok(Math.abs(one.position[i] - other.position[i]) < 1e-9);
    }
    // The next search starts at a lost sample, so that no search from a control point finds a later
    // one.
    const torus = peers.karcher.shape('torus', 2000);
    const around = [565, 684, 85, 922].map((vertex) => ({ vertex }));
    const far = peers.plan(around, 33);
    const lost = ({ status }) => status.filter((name) => name !== 'converged').length;
    const theirs = lost(await traced(torus, far, authors));
    const ours = lost(await traced(torus, far, { ...authors, seeds: 'heaviest' }));
    assert.ok(theirs >= ours && theirs > 0, `${theirs} and ${ours}`);
  });

  test('average more faces than Eq. 3 prints: outside of regular grids the result differs', async () => {
    const mesh = peers.karcher.shape('genus3', 1000);
    const inside = [0, 40, 90, 130].map((face) => ({ face, bary: [0.2, 0.5, 0.3] }));
    const plan = peers.plan(inside, 5);
    const wide = await traced(mesh, plan, { ...authors, star: 'wide' });
    const ring = await traced(mesh, plan, { ...authors, star: 'ring' });
    assert.deepEqual(wide, await traced(mesh, plan, authors));
    assert.notDeepEqual(wide.position, ring.position);
    // On the plane's regular grid both stars are exact.
    const flat = await traced(plane, peers.plan(points, 5), { ...authors, star: 'ring' });
    const expected = await traced(plane, peers.plan(points, 5), { method: 'karcher' });
    for (let i = 0; i < 3 * flat.count; i++) {
      assert.ok(Math.abs(flat.position[i] - expected.position[i]) < 1e-6);
    }
  });
});

for (const [name, levels] of [
  ['bSurf', 'limit'],
  ['leveled', 'auto'],
])
  describe(`the engine’s curve as the method ${name}`, () => {
    test(`equals that of levels ${levels}, and can be dragged`, async () => {
      const method = await peers.prepare(plane, { method: name });
      const curve = method.curve(peers.plan(points, 9));
      assert.ok((await curve.trace()) >= 0);
      const expected = (all) => plane.curve({ kind: 'bspline', points: all, samples: 9, levels });
      assert.deepEqual(curve.samples(), expected(points).samples());
      curve.movePoint(2, { vertex: 71 });
      const moved = expected(points.with(2, { vertex: 71 }));
      assert.deepEqual(curve.samples(), moved.samples());
      assert.deepEqual(curve.line().path.polyline(), moved.polyline());
      assert.deepEqual([curve.lostByOwnRule(), curve.logMaps()], [0, null]);
      method.dispose();
    });

    test('takes the time of all stages but the paths that join its samples', async (t) => {
      const method = await peers.prepare(plane, { method: name });
      const curve = method.curve(peers.plan(points, 9));
      // Each reading of this clock takes a millisecond.
      let readings = 0;
      t.mock.method(performance, 'now', () => ++readings);
      const expected = plane.curve({ kind: 'bspline', points, samples: 9, levels });
      const time = () => {
        const { join, ...others } = expected.times();
        assert.ok(join > 0);
        return Object.values(others).reduce((sum, one) => sum + one);
      };
      assert.equal(await curve.trace(), time());
      curve.movePoint(2, { vertex: 71 });
      expected.movePoint(2, { vertex: 71 });
      assert.equal(curve.finish(), time());
      assert.equal(curve.finish(), 0);
      method.dispose();
      expected.dispose();
    });

    test('can be disposed of, and checks its arguments', async () => {
      const method = await peers.prepare(plane, { method: name });
      const curve = method.curve(peers.plan(points, 9));
      for (const number of [-1, points.length, 99]) {
        assert.throws(() => curve.movePoint(number, { vertex: 71 }), { code: 'badIndex' });
      }
      await curve.trace();
      method.dispose();
      const bytes = peers.karcher.allocatedBytes();
      for (const use of [
        () => curve.samples(),
        () => curve.line(),
        () => curve.movePoint(0, { vertex: 71 }),
        () => curve.finish(),
        () => method.curve(peers.plan(points, 9)),
      ]) {
        assert.throws(use, { code: 'disposed' });
      }
      await assert.rejects(curve.trace(), { code: 'disposed' });
      assert.equal(peers.karcher.allocatedBytes(), bytes, 'nothing was made');
    });

    test('does not make curves of other kinds, or centers', async () => {
      const method = await peers.prepare(plane, { method: name });
      const table = peers.barycentric([1, 2, 1], 5);
      const badArgument = { name: 'KarcherError', code: 'badArgument' };
      assert.throws(
        () => method.curve({ points: points.slice(0, 3), first: [0], table }),
        badArgument,
      );
      assert.throws(() => method.centerOfMass(points, [0, 0, 1, 0, 0]), badArgument);
    });
  });

test('options are accepted only by methods that use them', async () => {
  for (const options of [
    { method: 'vectorHeat', seeds: 'authors' },
    { method: 'bSurf', seeds: 'heaviest' },
    { method: 'leveled', seeds: 'authors' },
    { method: 'karcher', levels: 0 },
    { method: 'karcher', star: 'ring' },
    { method: 'weightedAverages', star: 'wide' },
  ]) {
    await assert.rejects(peers.prepare(plane, options), {
      code: 'badArgument',
      message: /the option '(seeds|star|levels)' is for the method/,
    });
  }
});

test('a leap is counted, a bend is not', () => {
  const meter = new CurveMeter(plane);
  const row = (xs, status = xs.map(() => 'converged')) => ({
    count: xs.length,
    segment: new Int32Array(xs.length),
    t: Float64Array.from(xs, (_, i) => i),
    face: new Int32Array(xs.length),
    bary: Float64Array.from(xs.flatMap(() => [1, 0, 0])),
    position: Float64Array.from(xs.flatMap((x) => [x, 0, 0])),
    status,
  });
  const breaks = (line) => meter.measure(line, line).breaks;
  assert.equal(breaks(row([0, 1, 2, 3, 4, 5])), 0);
  assert.equal(breaks(row([0, 0.1, 0.2, 8, 8.1, 8.2])), 1);
  // The curve accelerates and slows down again.
  assert.equal(breaks(row([0, 0.5, 1.5, 4, 9, 11.5, 12.5])), 0);
  const lost = ['converged', 'converged', 'noProgress', 'converged', 'converged', 'converged'];
  assert.equal(breaks(row([0, 0.1, 9, 0.3, 0.4, 0.5], lost)), 0);
  // A step between two lost samples has no neighbor for a comparison; a step beside them has one.
  const around = lost.with(5, 'noProgress');
  assert.equal(breaks(row([0, 0.1, 9, 3, 8, 20], around)), 0);
  assert.equal(breaks(row([0, 0.1, 9, 3, 3.1, 8], lost)), 1);
  // The affine averages are equally fast, as at the ends of a rational curve, so that nothing
  // leaps.
  const fast = row([0, 8, 9, 9.2, 9.3, 9.4]);
  assert.equal(breaks(fast), 1);
  assert.equal(meter.measure(fast, fast, row([0, 16, 18, 18.3, 18.5, 18.7])).breaks, 0);
  const even = row([0, 1, 2, 3, 4, 5]);
  assert.equal(meter.measure(fast, fast, even).breaks, 1);
});

describe('errors', () => {
  const code = (name) => (error) => {
    assert.equal(error.name, 'KarcherError', String(error));
    assert.equal(error.code, name, error.message);
    return true;
  };

  test('descent joins two points only', async () => {
    const method = await prepared('descent');
    assert.throws(() => method.curve(peers.plan(points, 5)), code('badArgument'));
  });

  test('weights that do not sum to 1, points that do not exist, segments without points', async () => {
    const method = await prepared('karcher');
    const plan = peers.plan(points, 5);
    assert.throws(() => method.centerOfMass(points, [1, 1, 1, 1, 1]), code('badWeights'));
    assert.throws(() => method.curve({ ...plan, points: [{ vertex: 999 }] }), code('badIndex'));
    assert.throws(() => method.curve({ ...plan, first: [2] }), code('badIndex'));
    assert.throws(() => method.curve({ ...plan, first: [-1] }), code('badIndex'));
    assert.throws(() => peers.plan([{ vertex: 1 }], 5), code('tooFewPoints'));
    assert.throws(() => peers.rational([1, -1], 5), code('badArgument'));
    assert.throws(() => peers.bspline(1), code('badArgument'));
    method.dispose();
    assert.throws(() => method.curve(plan), code('disposed'));
  });

  test('points on several components', async () => {
    const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n';
    const mesh = peers.karcher.meshFromObj(text);
    for (const name of ['vectorHeat', 'affineHeat', 'descent', 'karcher']) {
      const method = await prepared(name, mesh);
      const pair = [{ vertex: 0 }, { vertex: 3 }];
      assert.throws(() => method.centerOfMass(pair, [0.5, 0.5]), code('unreachable'), name);
      method.dispose();
    }
    await assert.rejects(prepared('weightedAverages', mesh), code('unreachable'));
  });

  test('values of wrong types', async () => {
    const method = await prepared('karcher');
    const plan = peers.plan(points, 3);
    const weights = [1, 0, 0, 0, 0];
    const badArgument = { name: 'KarcherError', code: 'badArgument' };
    for (const value of [null, 0.5, 'x', { length: -1 }, ['a'], { more: 1 }]) {
      await assert.rejects(peers.prepare(value, { method: 'karcher' }), badArgument);
      await assert.rejects(peers.prepare(plane, value), badArgument);
      await assert.rejects(peers.prepare(plane, { method: 'karcher' }, value), badArgument);
      for (const use of [
        () => peers.bezier(value, 3),
        () => peers.rational(value, 3),
        () => peers.barycentric([1, 1], value),
        () => peers.plan(value, 3),
        () => peers.plan(points, value),
        () => method.curve(value),
        () => method.curve({ ...plan, points: value }),
        () => method.curve({ ...plan, first: value }),
        () => method.curve({ ...plan, table: value }),
        () => method.centerOfMass(value, weights),
        () => method.centerOfMass(points, value),
        () => method.centerOfMass(points, weights, value),
        () => method.centerOfMass(points, weights, { start: value }),
      ]) {
        assert.throws(use, { name: 'KarcherError' }, `${use}: ${JSON.stringify(value)}`);
      }
    }
    method.dispose();
  });

  test('a mesh of another engine, an unknown method, a disposed mesh', async () => {
    const other = (await load()).meshFromObj(grid(2));
    await assert.rejects(peers.prepare(other, { method: 'karcher' }), code('badArgument'));
    await assert.rejects(prepared('heat'), code('badArgument'));
    const mesh = peers.karcher.meshFromObj(grid(2));
    const method = await prepared('vectorHeat', mesh);
    const curve = method.curve(peers.plan([{ vertex: 0 }, { vertex: 8 }], 3));
    mesh.dispose();
    assert.throws(() => curve.finish(), code('disposed'));
    method.dispose();
  });
});

test('methods and curves free all their memory', async () => {
  let early = 0;
  for (let i = 0; i < 30; i++) {
    if (i === 10) early = peers.karcher.allocatedBytes();
    for (const name of ['vectorHeat', 'affineHeat', 'paper', 'karcher']) {
      const mesh = peers.karcher.meshFromObj(grid(6));
      const method = await prepared(name, mesh);
      method
        .curve(
          peers.plan(
            [16, 18, 31, 32].map((vertex) => ({ vertex })),
            3,
          ),
        )
        .finish();
      method.dispose();
      mesh.dispose();
    }
  }
  assert.equal(peers.karcher.allocatedBytes(), early);
});
