// An interrupted call of a worker loses nothing else.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Worker } from 'node:worker_threads';
import { long, randoms, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';
import { loadForTest } from './workers.mjs';

const endless = () => new Worker(new URL('./endless_worker.mjs', import.meta.url));
const minutes = { timeout: 600_000 };
const reason = new Error('not wanted');

/** Aborts a call while the worker runs it; resolves once another worker has replaced it. */
async function interrupt(karcher, begin) {
  const controller = new AbortController();
  const restarted = new Promise((resolve) => {
    karcher.client.onRestart = resolve;
  });
  let begun;
  const isBegun = new Promise((resolve) => {
    begun = resolve;
  });
  const call = begin({ signal: controller.signal, progress: begun });
  await isBegun;
  controller.abort(reason);
  await assert.rejects(call, reason);
  return restarted;
}

const spin = (karcher) => (work) => karcher.client.call('spin', [], undefined, work);

test('an endless call is interrupted, and all objects are unchanged', minutes, async (t) => {
  const karcher = await loadForTest(t, { worker: endless });
  const text = grid(12);
  const places = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2] };
  const coordinates = Float64Array.from(places.positions);
  const file = Buffer.from(text);
  const meshes = [
    await karcher.meshFromObj(text),
    await karcher.meshFromObj(file),
    await karcher.meshFromArrays(coordinates, places.triangles),
    await karcher.shape('torus', 2000),
  ];
  // Later changes by the caller, or disposals, do not affect them.
  coordinates.fill(7);
  file.fill(7);
  const coarse = await karcher.shape('sphere', 500);
  meshes.push(await coarse.subdivide(2));
  await coarse.dispose();
  const [mesh] = meshes;
  const random = randoms(seed);
  const vertex = () => ({ vertex: Math.floor(random.next().value * 100) });
  const first = await mesh.curve({ kind: 'bspline', points: Array.from({ length: 5 }, vertex) });
  await first.movePoint(1, vertex());
  await first.dragPoint(2, vertex());
  await first.setWeights([1, 2, 3, 4, 5]);
  await first.insertOnCurve(0.7);
  const second = await mesh.curve({
    ...{ kind: 'catmullrom', points: Array.from({ length: 4 }, vertex), levels: 2, samples: 9 },
    ...{ solver: 'exact', closed: true },
  });
  await second.set({ ...(await second.value()), closed: false });
  const parts = await second.split(0.5);
  const gone = await mesh.curve({ kind: 'polyline', points: [vertex(), vertex()] });
  await gone.dispose();
  const curves = [first, second, ...parts];
  const all = async () => ({
    positions: await Promise.all(meshes.map((one) => one.positions())),
    triangles: await Promise.all(meshes.map((one) => one.triangles())),
    values: await Promise.all(curves.map((one) => one.value())),
    lines: await Promise.all(curves.map((one) => one.polyline({ bits: 64 }))),
    distance: await mesh.distance({ vertex: 3 }),
  });
  const before = await all();
  for (let times = 0; times < 2; times++) {
    await interrupt(karcher, spin(karcher));
    assert.deepEqual(await all(), before);
    await assert.rejects(coarse.positions(), { code: 'disposed' });
    await assert.rejects(gone.points(), { code: 'disposed' });
    await gone.dispose();
  }
  // Objects are unchanged: on a separate mesh the same edit leads to the same curve.
  await first.movePoint(0, { vertex: 40 });
  const other = await karcher.meshFromObj(text);
  const anew = await other.curve(await first.value());
  assert.deepEqual(await first.polyline({ bits: 64 }), await anew.polyline({ bits: 64 }));
  await mesh.dispose();
  await interrupt(karcher, spin(karcher));
  await assert.rejects(first.points(), { code: 'disposed' });
  assert.deepEqual(await meshes[3].positions(), before.positions[3]);
});

test('calls that wait behind an interrupted one are made once each', minutes, async (t) => {
  const karcher = await loadForTest(t, { worker: endless });
  const mesh = await karcher.meshFromObj(grid(12));
  const curve = await mesh.curve({ kind: 'polyline', points: [{ vertex: 0 }, { vertex: 9 }] });
  const waiting = [];
  await interrupt(karcher, (work) => {
    const call = spin(karcher)(work);
    waiting.push(curve.addPoint({ vertex: 20 }), curve.addPoint({ vertex: 30 }), curve.points());
    waiting.push(karcher.shape('sphere', 500), mesh.curve({ kind: 'polyline', points: [{}] }));
    waiting[4].catch(() => {});
    return call;
  });
  const [, , points, sphere] = await Promise.all(waiting.slice(0, 4));
  assert.equal(points.length, 4);
  assert.equal(sphere.info.genus, 0);
  await assert.rejects(waiting[4], { name: 'KarcherError' });
  const end = karcher.client.call('spin', []);
  karcher.dispose();
  await assert.rejects(end, { code: 'disposed' });
});

test('a curve equals its value, whatever its kind was before', minutes, async (t) => {
  const karcher = await loadForTest(t, { worker: endless });
  const mesh = await karcher.meshFromObj(grid(12));
  const points = [3, 40, 70, 99, 120].map((vertex) => ({ vertex }));
  const curve = await mesh.curve({ kind: 'bspline', degree: 2, points, weights: [1, 2, 3, 4, 5] });
  await curve.setKind('catmullrom');
  await curve.removePoint(1);
  await interrupt(karcher, spin(karcher));
  await curve.movePoint(0, { vertex: 5 });
  await interrupt(karcher, spin(karcher));
  await curve.setKind('bspline');
  const { degree, weights } = await curve.value();
  assert.deepEqual([degree, weights], [3, undefined]);
  // A value describes the whole curve.
  await curve.set({ kind: 'polyline', points });
  await interrupt(karcher, spin(karcher));
  await curve.setKind('bspline');
  const { degree: plain, weights: none } = await curve.value();
  assert.deepEqual([plain, none], [3, undefined]);
});

test('a dragged curve continues, including its legs', minutes, async (t) => {
  const karcher = await loadForTest(t, { worker: endless });
  const mesh = await karcher.shape('torus', 2000);
  const points = [0, 40, 90].map((vertex) => ({ vertex }));
  const curve = await mesh.curve({ kind: 'polyline', points });
  const seen = async () => [await curve.value(), await curve.polyline({ bits: 64 })];
  // Steps around the tube.
  const steps = [];
  for (let i = 1; i <= 45; i++) {
    steps.push((await mesh.straightest(points[1], [0, 0, 1], 0.05 * i)).end);
  }
  let { drawnLegs } = await curve.view();
  const step = async (place) => {
    const value = { kind: 'polyline', points: points.with(1, place), legs: drawnLegs };
    ({ drawnLegs } = await curve.set(value));
  };
  for (const place of steps.slice(0, 5)) await step(place);
  const few = await seen();
  await interrupt(karcher, spin(karcher));
  assert.deepEqual(await seen(), few);
  for (const place of steps.slice(5)) await step(place);
  const many = await seen();
  assert.ok(
    many[0].legs.some((leg) => leg?.length > 0),
    'the legs are not the shortest',
  );
  await interrupt(karcher, spin(karcher));
  assert.deepEqual(await seen(), many);
  await curve.set({ kind: 'polyline', points });
  const shortest = await seen();
  await interrupt(karcher, spin(karcher));
  assert.deepEqual(await seen(), shortest);
});

test('an edit that ends although it was cancelled stays', minutes, async (t) => {
  const karcher = await loadForTest(t, { worker: endless });
  const mesh = await karcher.meshFromObj(grid(12));
  const points = [3, 40, 70].map((vertex) => ({ vertex }));
  const curve = await mesh.curve({ kind: 'polyline', points });
  const other = await mesh.curve({ kind: 'polyline', points });
  const cancelled = async (edit) => {
    const controller = new AbortController();
    const progress = () => controller.abort(reason);
    await assert.rejects(edit({ signal: controller.signal, progress }), reason);
  };
  await cancelled((work) => curve.movePoint(1, { vertex: 99 }, work));
  await cancelled((work) => other.set({ kind: 'polyline', points: points.toReversed() }, work));
  const seen = () =>
    Promise.all([curve.value(), curve.polyline(), other.value(), other.polyline()]);
  const before = await seen();
  await interrupt(karcher, spin(karcher));
  assert.deepEqual(await seen(), before);
});

test('a call is independent of the caller’s later changes', minutes, async (t) => {
  const karcher = await loadForTest(t, { worker: endless });
  const mesh = await karcher.meshFromObj(grid(12));
  class Weights {
    constructor(x, y, z) {
      Object.assign(this, { x, y, z });
    }
  }
  const bary = new Weights(0.2, 0.3, 0.5);
  const options = { kind: 'polyline', points: [{ vertex: 0 }, { face: 30, bary }] };
  const curve = await mesh.curve(options);
  await curve.set(options);
  const before = await curve.polyline();
  bary.x = 0.5;
  bary.z = 0.2;
  await interrupt(karcher, spin(karcher));
  assert.deepEqual(await curve.polyline(), before);
});

test('a worker that receives a cancellation in time continues', minutes, async (t) => {
  const karcher = await loadForTest(t);
  let restarts = 0;
  karcher.client.onRestart = () => restarts++;
  const mesh = await karcher.shape('sphere', 20_000);
  const controller = new AbortController();
  const work = mesh.prepare(
    { solver: 'graph', rings: 3 },
    { signal: controller.signal, progress: () => controller.abort(reason) },
  );
  await assert.rejects(work, reason);
  await mesh.distance({ vertex: 0 });
  const given = await loadForTest(t, { worker: endless() });
  const spinning = new AbortController();
  const call = given.client.call('spin', [], undefined, {
    signal: spinning.signal,
    progress: () => spinning.abort(reason),
  });
  await assert.rejects(call, reason);
  assert.equal(restarts, 0);
});

test(
  'long calls on a large mesh are interrupted, and surfaces and curves are unchanged',
  minutes,
  async (t) => {
    const triangles = long ? 1_000_000 : 50_000;
    const karcher = await loadForTest(t);
    const mesh = await karcher.shape('sphere', triangles);
    const vertices = [0, 9, 99, 999].map((vertex) => ({ vertex }));
    const curve = await mesh.curve({ kind: 'bspline', points: vertices });
    await curve.dragPoint(1, { vertex: 44 });
    const all = async () => ({
      value: await curve.value(),
      line: await curve.polyline({ bits: 64 }),
      path: (await mesh.shortestPath({ vertex: 0 }, { vertex: 300 })).length,
    });
    const before = await all();
    // The points are so many that the call takes longer than the start of another worker.
    const many = Array.from({ length: 400 }, (_, i) => ({ vertex: 7 * i }));
    const weights = many.map(() => 1 / many.length);
    const calls = [
      (work) => mesh.centerOfMass(many, weights, { solver: 'exact' }, work),
      (work) => mesh.curve({ kind: 'bspline', points: many, solver: 'exact' }, work),
    ];
    for (const call of calls) {
      await interrupt(karcher, call);
      assert.deepEqual(await all(), before);
      assert.equal(mesh.info.triangles, (await mesh.triangles()).length / 3);
    }
    await curve.movePoint(0, { vertex: 500 });
    const anew = await mesh.curve(await curve.value());
    assert.deepEqual(await curve.polyline({ bits: 64 }), await anew.polyline({ bits: 64 }));
  },
);

test(
  'all calls are cancelled at once; objects under disposal are made again only for waiting calls',
  minutes,
  async (t) => {
    /** The requests to each worker, in order. */
    const asked = [];
    const karcher = await loadForTest(t, {
      worker() {
        const worker = endless();
        const post = worker.postMessage.bind(worker);
        const calls = [];
        asked.push(calls);
        worker.postMessage = (request) => {
          if ('call' in request) calls.push(request.call);
          post(request);
        };
        return worker;
      },
    });
    const mesh = await karcher.meshFromObj(grid(12));
    const onOther = await karcher.meshFromObj(grid(5));
    const line = (on, from, to) =>
      on.curve({ kind: 'polyline', points: [{ vertex: from }, { vertex: to }] });
    const [kept, left, read] = [
      await line(mesh, 0, 9),
      await line(mesh, 1, 9),
      await line(mesh, 2, 9),
    ];
    await line(onOther, 0, 9);
    const before = await read.polyline();
    const waiting = [];
    await interrupt(karcher, (work) => {
      const call = spin(karcher)(work);
      waiting.push(left.dispose(), read.polyline(), read.dispose(), onOther.dispose());
      return call;
    });
    const [, seen] = await Promise.all(waiting);
    assert.deepEqual(seen, before);
    assert.equal((await kept.points()).length, 2);
    for (const ask of [left.points, read.points, onOther.positions])
      await assert.rejects(ask(), { code: 'disposed' });
    const made = asked[1].filter((call) => call === 'curve' || call === 'meshFromObj');
    assert.deepEqual(
      made,
      ['meshFromObj', 'curve', 'curve'],
      'one mesh, what is kept and what is read',
    );

    const restarted = new Promise((resolve) => {
      karcher.client.onRestart = resolve;
    });
    const calls = [];
    // A worker that receives the cancellation before it begins continues.
    await new Promise((begun) => calls.push(spin(karcher)({ progress: begun })));
    calls.push(kept.points(), mesh.positions());
    const gone = kept.dispose();
    karcher.client.giveUp(reason);
    await Promise.all(calls.map((call) => assert.rejects(call, reason)));
    await restarted;
    await gone;
    assert.equal((await mesh.positions()).length, 3 * 169);
    assert.ok(!asked[2].includes('curve'));
  },
);
