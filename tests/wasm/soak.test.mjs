// Thousands of edits through a worker, and workers that are killed, slow, or answer out of order.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { Worker } from 'node:worker_threads';
import { WorkerClient } from 'karcher/own-worker';
import { long, randoms, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';
import { loadForTest } from './workers.mjs';

const threadUrl = new URL('./worker/thread.js', import.meta.resolve('karcher'));

setFlagsFromString('--expose-gc');
const collect = runInNewContext('gc');

/** The bytes of JavaScript that remain after garbage collection. */
async function heldBytes() {
  for (let i = 0; i < 3; i++) {
    collect();
    await new Promise((resolve) => setImmediate(resolve));
  }
  return process.memoryUsage().heapUsed;
}

test(`edits through a worker leave no memory behind, and the curve equals that of its value`, async (t) => {
  const edits = long ? 100_000 : 3000;
  const karcher = await loadForTest(t);
  const mesh = await karcher.meshFromObj(grid(8));
  const value = {
    kind: 'bspline',
    points: [10, 30, 50, 70].map((vertex) => ({ vertex })),
    samples: 4,
  };
  const curve = await mesh.curve(value);
  const random = randoms(seed);
  const draw = (count) => Math.floor(random.next().value * count);
  const vertex = () => ({ vertex: draw(81) });
  const kinds = ['bspline', 'bezier', 'catmullrom', 'polyline'];
  let points = 4;
  const edit = () => {
    switch (draw(8)) {
      case 0:
        if (points > 7) return curve.movePoint(draw(points), vertex());
        points++;
        return curve.addPoint(vertex());
      case 1:
        if (points < 5) return curve.setClosed(draw(2) === 1);
        points--;
        return curve.removePoint(draw(points + 1));
      case 2:
        return curve.setKind(kinds[draw(kinds.length)]);
      case 3:
        return curve.reverse();
      default:
        return curve.movePoint(draw(points), vertex());
    }
  };
  const bytes = [];
  for (let i = 0; i < edits; i++) {
    // Nine of ten edits are under way at once: nobody awaits them.
    if (i % 10 === 9) await Promise.all([edit(), curve.view(), edit(), curve.polyline()]);
    else await edit();
    if (i % (edits / 10) === edits / 10 - 1) {
      await curve.set(value);
      points = 4;
      bytes.push({ engine: await karcher.allocatedBytes(), held: await heldBytes() });
    }
  }
  // Each measurement has the same curve. Its spare fields are those of earlier edits, and differ by
  // up to 230 KB between any two, while a leak of a kilobyte an edit would be 1.5 MB.
  const most = (part) => Math.max(...part.map(({ engine }) => engine));
  const grown = most(bytes.slice(5)) - most(bytes.slice(0, 5));
  assert.ok(grown < 300e3, JSON.stringify(bytes));
  assert.ok(bytes.at(-1).held - bytes[1].held < 2e6, JSON.stringify(bytes));
  await curve.movePoint(2, { vertex: 33 });
  // The mesh is separate: curves of one mesh share fields.
  const other = await karcher.meshFromObj(grid(8));
  const anew = await other.curve(await curve.value());
  assert.deepEqual(await curve.polyline({ bits: 64 }), await anew.polyline({ bits: 64 }));
});

test('a killed worker rejects all calls, under way or later', {
  timeout: 600_000,
}, async (t) => {
  const worker = new Worker(threadUrl);
  const karcher = await loadForTest(t, { worker });
  const mesh = await karcher.shape('sphere', 20_000);
  let told = null;
  karcher.client.onFatal = (error) => {
    told = error;
  };
  const under = mesh.distance({ vertex: 0 });
  const waiting = mesh.positions();
  await worker.terminate();
  await assert.rejects(under, {
    name: 'KarcherError',
    code: 'internal',
    message: /worker has ended/,
  });
  await assert.rejects(waiting, { code: 'internal' });
  await assert.rejects(mesh.positions(), { code: 'internal' });
  assert.equal(told.code, 'internal');
  // Another worker replaces the lost one.
  const next = await loadForTest(t);
  assert.equal((await next.shape('sphere', 1000)).info.genus, 0);
});

test('a cancelled call that waits is not begun; one under way is dropped', async (t) => {
  const karcher = await loadForTest(t);
  const mesh = await karcher.shape('torus', 20_000);
  const curve = await mesh.curve({ kind: 'polyline', points: [{ vertex: 0 }, { vertex: 9 }] });
  const before = await curve.points();
  const controller = new AbortController();
  const reason = new Error('not wanted');
  const began = [];
  const work = (name) => ({
    progress: (done, stage) => began.push(`${name} ${done} ${stage}`),
    signal: controller.signal,
  });
  const busy = mesh.distance({ vertex: 0 }, {}, work('distance'));
  const moved = curve.movePoint(0, { vertex: 500 }, work('move'));
  const after = curve.points();
  controller.abort(reason);
  await assert.rejects(busy, reason);
  await assert.rejects(moved, reason);
  assert.deepEqual(await after, before, 'the move was never made');
  assert.ok(!began.some((line) => line.startsWith('move')), began.join());
  // A call that runs to its end reports its beginning and its end.
  await mesh.distance({ vertex: 1 }, { progress: (...told) => began.push(told.join(' ')) });
  assert.deepEqual(began.slice(-2), ['0 begun', '1 done']);
  await assert.rejects(mesh.positions({ signal: AbortSignal.abort(reason) }), reason);
  await assert.rejects(mesh.positions({ signal: 1 }), { code: 'badArgument' });
});

/** A worker with scripted answers. */
class Scripted extends EventTarget {
  asked = [];
  ended = false;
  postMessage(message) {
    this.asked.push(structuredClone(message));
  }
  answer(data) {
    this.dispatchEvent(Object.assign(new Event('message'), { data }));
  }
  terminate() {
    this.ended = true;
  }
}

test('answers out of order, repeated, or without a request reach only their callers', async () => {
  const worker = new Scripted();
  const client = new WorkerClient(worker);
  const calls = Array.from({ length: 50 }, (_, i) => client.call('square', [i]));
  assert.equal(worker.asked.length, 50);
  const random = randoms(seed);
  const order = worker.asked.toSorted(() => random.next().value - 0.5);
  for (const { id, args } of order) {
    worker.answer({ id, result: args[0] ** 2 });
    worker.answer({ id, result: 'again' });
    worker.answer({ id: id + 1000, result: 'to nobody' });
  }
  assert.deepEqual(
    await Promise.all(calls),
    Array.from({ length: 50 }, (_, i) => i * i),
  );
  // A call without an answer does not delay the next one, and ends with the client.
  const slow = client.call('sleep', []);
  const quick = client.call('square', [3]);
  worker.answer({ id: worker.asked.at(-1).id, result: 9 });
  assert.equal(await quick, 9);
  client.dispose();
  await assert.rejects(slow, { code: 'disposed' });
  assert.ok(worker.ended);
});
