// The methods that Karcher is compared with, through their module.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { load } from 'karcher';
import {
  CurveMeter,
  comparedMethods,
  loadPeers,
  measureDrag,
  runMethod,
  standardOptions,
  traceReference,
} from 'karcher/peers';
import { grid } from './meshes.mjs';

const cells = 12;
const points = [53, 58, 84, 98, 110].map((vertex) => ({ vertex }));

let peers;
let plane;
before(async () => {
  peers = await loadPeers();
  plane = peers.karcher.meshFromObj(grid(cells));
});

const prepared = (method, mesh = plane, options = {}) =>
  peers.prepare(mesh, { method, landmarks: 40, ...options });

function nearestVertex(mesh, place) {
  const positions = mesh.positions();
  let nearest = 0;
  const away = (v) => distance(Array.from(positions.slice(3 * v, 3 * v + 3)), place);
  for (let v = 1; 3 * v < positions.length; v++) if (away(v) < away(nearest)) nearest = v;
  return nearest;
}

function distance(a, b) {
  return Math.hypot(...a.map((x, i) => x - b[i]));
}

test("ours and the paper's are the curves of the engine, sample by sample", async () => {
  for (const options of [
    { method: 'karcher', solver: 'fast' },
    { method: 'karcher', solver: 'exact' },
    { method: 'paper', solver: 'exact' },
    { method: 'paper', solver: 'graph', rings: 3 },
  ]) {
    const expected = plane.curve({ kind: 'bspline', points, samples: 9, ...options });
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
  const curved = comparedMethods.filter((name) => name !== 'descent' && name !== 'bSurf');

  test('gives a control point that has all the weight', async () => {
    for (const name of curved) {
      const method = await prepared(name);
      const { position, status } = method.centerOfMass(points, [0, 0, 1, 0, 0]);
      assert.equal(status, 'converged', name);
      assert.ok(distance(position, plane.position(points[2])) < 1e-6, name);
      method.dispose();
    }
  });

  test('averages points of the plane, as far as its error allows', async () => {
    // In edges. Affine heat is exact but for the heat that the boundary reflects; the embedding of
    // 40 landmarks is no isometry; vector heat is not linearly precise.
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
        // Constant gradients of exact distances point up to 2 edges past a source so near.
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
    const text = `${grid(cells)}\nv 99 0 0\nv 99 1 0\nv 98 0 0\nf ${other.join(' ')}\n`;
    const mesh = peers.karcher.meshFromObj(text);
    assert.equal(mesh.info.components, 2);
    const pair = [{ vertex: 30 }, { vertex: 107 }];
    for (const name of comparedMethods) {
      if (name === 'weightedAverages') continue; // it embeds the whole mesh
      const method = await prepared(name, mesh);
      const curve = method.curve(peers.plan(pair, 5));
      curve.finish();
      assert.equal(curve.samples().status[2], 'converged', name);
      method.dispose();
    }
  });

  test('starts where it is told to', async () => {
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

  test('find the same centers where there is only one, and go on through all segments', async () => {
    const plan = peers.plan(points, 9);
    const [one, other] = [
      await traced(plane, plan, authors),
      await traced(plane, plan, { ...authors, seeds: 'heaviest' }),
    ];
    assert.ok(one.status.every((status) => status === 'converged'));
    for (let i = 0; i < 3 * one.count; i++) {
      assert.ok(Math.abs(one.position[i] - other.position[i]) < 1e-9);
    }
    // A lost sample is where the next search starts, so that none is found again from a control point.
    const sphere = peers.karcher.shape('sphere', 2000);
    const around = [
      [1, 0, 0],
      [0, 1, 0],
      [-1, 0, 0.1],
      [0, -1, 0],
    ].map((place) => ({ vertex: nearestVertex(sphere, place) }));
    const far = peers.plan(around, 33);
    const lost = ({ status }) => status.filter((name) => name !== 'converged').length;
    const theirs = lost(await traced(sphere, far, authors));
    const ours = lost(await traced(sphere, far, { ...authors, seeds: 'heaviest' }));
    assert.ok(theirs >= ours && theirs > 0, `${theirs} and ${ours}`);
  });

  test('average more faces than Eq. 3 prints: elsewhere than on a regular grid it differs', async () => {
    const mesh = peers.karcher.shape('genus3', 1000);
    const inside = [0, 40, 90, 130].map((face) => ({ face, bary: [0.2, 0.5, 0.3] }));
    const plan = peers.plan(inside, 5);
    const wide = await traced(mesh, plan, { ...authors, star: 'wide' });
    const ring = await traced(mesh, plan, { ...authors, star: 'ring' });
    assert.deepEqual(wide, await traced(mesh, plan, authors));
    assert.notDeepEqual(wide.position, ring.position);
    // On the plane's regular grid both are exact.
    const flat = await traced(plane, peers.plan(points, 5), { ...authors, star: 'ring' });
    const expected = await traced(plane, peers.plan(points, 5), { method: 'karcher' });
    for (let i = 0; i < 3 * flat.count; i++) {
      assert.ok(Math.abs(flat.position[i] - expected.position[i]) < 1e-6);
    }
  });
});

describe('b/Surf', () => {
  test('is the engine’s limit curve, and is dragged', async () => {
    const method = await peers.prepare(plane, { method: 'bSurf' });
    const curve = method.curve(peers.plan(points, 9));
    assert.ok((await curve.trace()) >= 0);
    const limit = (all) =>
      plane.curve({ kind: 'bspline', points: all, samples: 9, levels: 'limit' });
    assert.deepEqual(curve.samples(), limit(points).samples());
    curve.movePoint(2, { vertex: 71 });
    const moved = limit(points.with(2, { vertex: 71 }));
    assert.deepEqual(curve.samples(), moved.samples());
    assert.deepEqual(curve.line().path.polyline(), moved.polyline());
    assert.deepEqual([curve.lostByOwnRule(), curve.logMaps()], [0, null]);
    method.dispose();
  });

  test('is gone once it is disposed of, and checks what it is given', async () => {
    const method = await peers.prepare(plane, { method: 'bSurf' });
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

  test('makes no curves of other kinds, and no centers', async () => {
    const method = await peers.prepare(plane, { method: 'bSurf' });
    const table = peers.barycentric([1, 2, 1], 5);
    const badArgument = { name: 'KarcherError', code: 'badArgument' };
    assert.throws(
      () => method.curve({ points: points.slice(0, 3), first: [0], table }),
      badArgument,
    );
    assert.throws(() => method.centerOfMass(points, [0, 0, 1, 0, 0]), badArgument);
  });
});

test('options are for the methods that have a use for them', async () => {
  for (const options of [
    { method: 'vectorHeat', seeds: 'authors' },
    { method: 'bSurf', seeds: 'heaviest' },
    { method: 'karcher', star: 'ring' },
    { method: 'weightedAverages', star: 'wide' },
  ]) {
    await assert.rejects(peers.prepare(plane, options), {
      code: 'badArgument',
      message: /the option '(seeds|star)' is for the method/,
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
  // Ever faster, and slower again.
  assert.equal(breaks(row([0, 0.5, 1.5, 4, 9, 11.5, 12.5])), 0);
  const lost = ['converged', 'converged', 'noProgress', 'converged', 'converged', 'converged'];
  assert.equal(breaks(row([0, 0.1, 9, 0.3, 0.4, 0.5], lost)), 0);
  // A step between lost samples is measured against none, and one beside them against the other.
  const around = lost.with(5, 'noProgress');
  assert.equal(breaks(row([0, 0.1, 9, 3, 8, 20], around)), 0);
  assert.equal(breaks(row([0, 0.1, 9, 3, 3.1, 8], lost)), 1);
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

  test('points on several parts', async () => {
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

  test('a mesh of another engine, an unknown method, a mesh that is gone', async () => {
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

describe('a drag', () => {
  test('moves a B-spline on the plane by its largest weight, and without leaps', async () => {
    for (const name of ['karcher', 'bSurf', 'affineHeat', 'weightedAverages']) {
      const method = await prepared(name);
      const plan = peers.plan(points, 17);
      const curve = method.curve(plan);
      await curve.trace();
      const { steps, leaps, most } = await measureDrag(curve, plane, plan, 10);
      assert.deepEqual([steps, leaps], [10, 0], name);
      // 2/3 at a knot; averages are taken in an embedding that is not quite the plane.
      const tolerance = name === 'weightedAverages' ? 0.05 : 1e-6;
      assert.ok(Math.abs(most - 2 / 3) < tolerance, `${name}: ${most}`);
      method.dispose();
    }
  });

  test('counts the steps in which a sample leaps', async () => {
    const plan = peers.plan(points, 2);
    const start = plane.position(points[2]);
    // Along a cell's diagonal to the next control point, which is nearer than two edges.
    const hand = Math.SQRT2 / 10;
    /** Follows the hand, but for a leap forth and back of a part of an edge; its other sample is lost. */
    const curve = (leap) => {
      let moves = 0;
      let place = start;
      return {
        movePoint(i, point) {
          assert.equal(i, 2);
          moves++;
          place = plane.position(point);
        },
        trace: async () => 0,
        samples: () => ({
          count: 2,
          position: [...place.with(1, place[1] + (moves === 4 ? leap : 0)), 99 * moves, 0, 0],
          status: ['converged', 'noProgress'],
        }),
      };
    };
    const steady = await measureDrag(curve(4 * hand), plane, plan, 10);
    assert.equal(steady.leaps, 0);
    const leaping = await measureDrag(curve(8 * hand), plane, plan, 10);
    assert.equal(leaping.leaps, 2);
    assert.ok(leaping.most > 5 && leaping.most < 9.1, `${leaping.most}`);
    assert.ok(steady.most > 3 && steady.most < 5, `${steady.most}`);
  });
});

describe('a comparison', () => {
  test('measures the reference as itself', async () => {
    const plan = peers.plan(points, 17);
    const reference = await traceReference(peers, plane, plan);
    const options = { method: 'karcher', solver: 'exact' };
    const run = await runMethod(peers, plane, plan, options, reference.samples);
    assert.equal(run.ok, true);
    assert.deepEqual(run.deviation, { median: 0, max: 0, samples: 34 });
    assert.equal(run.turningNoise, 0);
    assert.equal(run.samples, 34);
    assert.equal(run.lost, 0);
    for (const key of ['prepareMs', 'traceMs', 'dragMs']) assert.ok(run[key] >= 0, key);
  });

  test('gives a reason for what fails, and no number that was not measured', async () => {
    const plan = peers.plan(points, 5);
    const descent = await runMethod(peers, plane, plan, standardOptions('descent', plan), null);
    const { ok, reason, traceMs, dragMs, samples, deviation, curve } = descent;
    assert.equal(ok, false);
    assert.match(reason, /two points/);
    assert.deepEqual([traceMs, dragMs, samples, deviation, curve], [null, null, null, null, null]);
    const long = peers.plan(points, 20_000);
    const late = await runMethod(peers, plane, long, { method: 'vectorHeat' }, null, {
      budgetMs: -1,
    });
    assert.equal(late.ok, false);
    assert.match(late.reason, /stopped after/);
    assert.equal(late.traceMs, null);
  });

  test('a path is measured from the exact one', async () => {
    // Over the edge of a roof: there the shortest path bends, unlike what joins its ends in space.
    const text = grid(cells).replace(
      /v (\d+) (\d+) 0/g,
      (_, x, y) => `v ${x} ${y} ${Math.abs(x - 6)}`,
    );
    const roof = peers.karcher.meshFromObj(text);
    const plan = peers.plan([{ vertex: 2 + 3 * 13 }, { vertex: 10 + 8 * 13 }], 5);
    const { samples, path } = await traceReference(peers, roof, plan);
    // Unfolded, the slopes are longer by the square root of 2.
    assert.ok(Math.abs(path.length - Math.hypot(8 * Math.SQRT2, 5)) < 1e-9);
    const middle = Array.from(samples.position.slice(6, 9));
    assert.ok(distance(middle, [6, 5.5, 0]) < 1e-9, `${middle}`);
    const quarter = Array.from(samples.position.slice(3, 6));
    assert.ok(distance(quarter, [4, 4.25, 2]) < 1e-9, `${quarter}`);
    const run = await runMethod(peers, roof, plan, { method: 'karcher' }, samples);
    assert.ok(run.deviation.max < 1e-6, `${run.deviation.max}`);
  });

  test('what lost most of its samples is no curve', async () => {
    // Around a sphere there is no center of mass of points so far apart.
    const sphere = peers.karcher.shape('sphere', 2000);
    const [top, bottom] = [
      [0, 0, 1],
      [0, 0, -1],
    ].map((place) => nearestVertex(sphere, place));
    const far = [top, bottom, top, bottom].map((vertex) => ({ vertex }));
    const plan = peers.plan(far, 17);
    const run = await runMethod(peers, sphere, plan, { method: 'paper', solver: 'exact' }, null);
    assert.ok(run.lost > 8, `${run.lost}`);
    assert.equal(run.ok, false);
    assert.match(run.reason, /of 17 samples did not converge/);
  });

  test('ends when it is told to', async () => {
    const plan = peers.plan(points, 5);
    const signal = AbortSignal.abort(new Error('enough'));
    const run = runMethod(peers, plane, plan, { method: 'karcher' }, null, { signal });
    await assert.rejects(run, /enough/);
  });
});

test('methods and curves give all their memory back', async () => {
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
