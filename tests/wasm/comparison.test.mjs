// Comparisons of methods: their distances from the reference, their behaviour in a drag, and the
// reasons for failures.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import {
  CurveMeter,
  measureDrag,
  Ruler,
  runMethod,
  standardOptions,
  traceReference,
} from 'karcher/peers';
import { distance, grid, nearestVertex } from './meshes.mjs';
import { peersOnPlane, side } from './peers_on_plane.mjs';

let peers;
let plane;
let points;
before(async () => {
  ({ peers, plane, points } = await peersOnPlane());
});

describe('a drag', () => {
  test('moves a B-spline on the plane by its largest weight, and without leaps', async () => {
    for (const name of ['karcher', 'leveled', 'bSurf', 'affineHeat', 'weightedAverages']) {
      const method = await peers.prepare(plane, { method: name, landmarks: 40 });
      const plan = peers.plan(points, 17);
      const curve = method.curve(plan);
      await curve.trace();
      const { steps, leaps, most } = await measureDrag(curve, plane, plan, 10);
      assert.deepEqual([steps, leaps], [10, 0], name);
      // The weight is 2/3 at a knot. Averages are those of an embedding that differs slightly from
      // the plane.
      const tolerance = name === 'weightedAverages' ? 0.05 : 1e-6;
      assert.ok(Math.abs(most - 2 / 3) < tolerance, `${name}: ${most}`);
      method.dispose();
    }
  });

  test('counts the steps in which a sample leaps', async () => {
    const plan = peers.plan(points, 2);
    const start = plane.position(points[2]);
    // The drag follows a cell's diagonal to the next control point, which is nearer than two edges.
    const hand = Math.SQRT2 / 10;
    /**
     * A curve of two samples: one follows the pointer but leaps once forth and back, the other is
     * lost.
     */
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

test('a curve has its samples on bridges and subdivided pieces, and they are measured', async () => {
  const plan = peers.plan(points.slice(0, 4), 5);
  const method = await peers.prepare(plane, { method: 'karcher' });
  const curve = method.curve(plan);
  await curve.trace();
  const whole = curve.samples();
  const status = ['converged', 'bridged', 'subdivided', 'noProgress', 'indefinite'];
  const marked = { ...whole, status };
  const measures = new CurveMeter(plane).measure(marked, whole);
  assert.deepEqual([measures.lost, measures.deviation.samples], [2, 3]);
  assert.equal(measures.sharpestTurn.t, whole.t[1]);
  const { measured, of } = await new Ruler(plane, plan).measure(marked);
  assert.deepEqual([measured, of], [3, 5]);
  const still = (status) => ({
    movePoint() {},
    trace: async () => 0,
    samples: () => ({ ...whole, status: whole.status.map(() => status) }),
  });
  for (const [one, most] of status.map((name, i) => [name, i < 3 ? 0 : null])) {
    assert.equal((await measureDrag(still(one), plane, plan, 2)).most, most, one);
  }
  method.dispose();
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

  test('gives a reason for a failure, and no number without a measurement', async () => {
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

  test('measures a path from the exact one', async () => {
    // The path crosses the ridge of a roof: there the shortest path bends, unlike the segment in
    // space.
    const text = grid(side).replace(
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

  test('counts a result that lost most of its samples as failed', async () => {
    // Around a sphere, points so far apart have no center of mass.
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

  test('ends when it is aborted', async () => {
    const plan = peers.plan(points, 5);
    const signal = AbortSignal.abort(new Error('enough'));
    const run = runMethod(peers, plane, plan, { method: 'karcher' }, null, { signal });
    await assert.rejects(run, /enough/);
  });
});
