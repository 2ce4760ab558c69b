import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';
import { CurveView, KarcherError, load, Path } from 'karcher';
import { WorkerClient } from 'karcher/own-worker';
import { loadInWorker, CurveView as ViewOfWorker } from 'karcher/worker';
import { noted } from './engine_calls.mjs';
import { grid, partsOf } from './meshes.mjs';

const points = [16, 40, 97, 120].map((vertex) => ({ vertex }));
const text = grid(12);
const gone = { name: 'KarcherError', code: 'disposed' };
let karcherHere;
let here;
let remote;
let mesh;
before(async () => {
  [karcherHere, remote] = [await load(), await loadInWorker()];
  here = karcherHere.meshFromObj(text);
  mesh = await remote.meshFromObj(text);
});
after(() => remote.dispose());

test('a mesh in a worker answers like one here', async () => {
  assert.deepEqual(mesh.info, here.info);
  assert.deepEqual(await mesh.positions(), here.positions());
  assert.deepEqual(await mesh.triangles(), here.triangles());
  const weights = [0.25, 0.25, 0.25, 0.25];
  assert.deepEqual(await mesh.centerOfMass(points, weights), here.centerOfMass(points, weights));
  const certified = { certificate: true };
  assert.deepEqual(
    await mesh.centerOfMass(points, weights, certified),
    here.centerOfMass(points, weights, certified),
  );
  assert.deepEqual(await mesh.distance(points[0]), here.distance(points[0]));
  const [from, to] = points;
  assert.deepEqual(
    partsOf(await mesh.shortestPath(from, to)),
    partsOf(here.shortestPath(from, to)),
  );
  const [line] = await mesh.isolines(points[1], { radius: 2 });
  assert.deepEqual(partsOf(line), partsOf(here.isolines(points[1], { radius: 2 })[0]));
  const direction = { x: 1, y: 2, z: 0 };
  const [walked, expected] = [
    await mesh.straightest(from, direction, 2),
    here.straightest(from, direction, 2),
  ];
  assert.deepEqual(partsOf(walked.path), partsOf(expected.path));
  assert.deepEqual(walked.end, expected.end);
  const finer = await mesh.subdivide();
  assert.equal(finer.info.triangles, 4 * here.info.triangles);
  await finer.dispose();
  await assert.rejects(finer.positions(), { name: 'KarcherError', code: 'disposed' });
});

/** The names of the readable properties of an object and its class. */
function propertiesOf(object) {
  const prototype = Object.getPrototypeOf(object);
  const getters = Object.entries(Object.getOwnPropertyDescriptors(prototype)).filter(
    ([, { get }]) => get !== undefined,
  );
  return [...Object.keys(object), ...getters.map(([name]) => name)];
}

test('a mesh and a curve in a worker have all members of those here', async () => {
  const [curve, expected] = [
    await mesh.curve({ kind: 'bspline', points }),
    here.curve({ kind: 'bspline', points }),
  ];
  // Internal members, and those of the engine itself.
  const own = ['constructor', 'handle', 'edits'];
  for (const [remotely, local] of [
    [curve, expected],
    [mesh, here],
    [remote, karcherHere],
  ]) {
    for (const name of Reflect.ownKeys(Object.getPrototypeOf(local))) {
      if (!own.includes(name)) assert.ok(name in remotely, `there is no ${String(name)}`);
    }
  }
  assert.equal(propertiesOf(expected).length, 9);
  curve[Symbol.dispose]();
  expected.dispose();
  for (const name of ['points', 'polyline']) await assert.rejects(curve[name](), gone);
  await assert.rejects(curve.length, gone);
  const other = await loadInWorker();
  const sphere = await other.shape('sphere', 500);
  other[Symbol.dispose]();
  // The disposal of objects that ended with their worker is silent.
  sphere[Symbol.dispose]();
  await assert.rejects(sphere.positions(), gone);
});

test('results of a worker have the classes that its entry exports', async () => {
  const curve = await mesh.curve({ kind: 'bspline', points });
  const error = await curve.pointAt(99).catch((reason) => reason);
  assert.ok(error instanceof KarcherError);
  assert.ok((await curve.path()) instanceof Path);
  assert.ok((await curve.view()) instanceof CurveView);
  assert.equal(ViewOfWorker, CurveView);
  await curve.dispose();
});

test('a curve in a worker is edited like one here', async () => {
  const options = { kind: 'bspline', points, samples: 9 };
  const [curve, expected] = [await mesh.curve(options), here.curve(options)];
  const same = async () => {
    assert.deepEqual(await curve.points(), expected.points());
    assert.deepEqual(await curve.samples(), expected.samples());
    assert.deepEqual(await curve.polyline(), expected.polyline());
    assert.deepEqual(await curve.polyline({ bits: 64 }), expected.polyline({ bits: 64 }));
    for (const name of propertiesOf(expected)) {
      // The number of computed fields depends on the fields that other curves of the mesh have
      // left.
      if (name !== 'fieldsComputed') assert.equal(await curve[name], expected[name], name);
    }
  };
  await same();
  const place = { face: 30, bary: [0.2, 0.3, 0.5] };
  await curve.movePoint(2, place);
  expected.movePoint(2, place);
  await same();
  assert.equal(await curve.insertOnCurve(0.5), expected.insertOnCurve(0.5));
  await same();
  const value = { ...options, points: points.with(1, place), weights: [1, 2, 1, 1] };
  const [view, seen] = [await curve.set(value), expected.set(value)];
  const { polyline, samples, bridged, knots, lengths, length, unconverged } = view;
  assert.deepEqual(
    { polyline, samples, bridged, knots, lengths, length, unconverged },
    Object.fromEntries(
      ['polyline', 'samples', 'bridged', 'knots', 'lengths', 'length', 'unconverged'].map(
        (name) => [name, seen[name]],
      ),
    ),
  );
  assert.equal(view.lengths.buffer, view.polyline.buffer, 'one buffer is transferred');
  assert.deepEqual(await curve.value(), expected.value());
  await same();
  const parts = await curve.split(0.5);
  const whole = await parts[0].join(parts[1]);
  const [first, second] = expected.split(0.5);
  assert.deepEqual(await whole.samples(), first.join(second).samples());
  await assert.rejects(curve.removePoint(99), { name: 'KarcherError', code: 'badIndex' });
  await same();
  await curve.dispose();
  await curve.dispose();
  await assert.rejects(curve.samples(), { code: 'disposed' });
});

test('errors of the engine arrive as such, and arguments that cannot be sent are refused', async () => {
  const wrong = mesh.circle(points[0], { radius: -1 });
  await assert.rejects(wrong, (error) => {
    assert.ok(error instanceof KarcherError);
    assert.throws(() => here.circle(points[0], { radius: -1 }), error);
    return true;
  });
  const basis = () => [1, 0, 0, 0];
  await assert.rejects(mesh.curve({ kind: 'custom', points, basis }), {
    code: 'badArgument',
    message: /a function, which cannot be sent/,
  });
  const plain = await mesh.curve({ kind: 'bspline', points });
  await assert.rejects(plain.set({ kind: 'custom', points, basis }), { code: 'badArgument' });
  await assert.rejects(mesh.distance(Symbol('vertex')), { code: 'badArgument' });
  await assert.rejects(remote.client.call('constructr', []), /no call 'constructr'/);
});

test('a path that is sent to a worker keeps its length', async () => {
  const [isoline] = here.isolines(points[1], { radius: 3 });
  const lengths = [isoline.length / 3, isoline.length];
  assert.deepEqual(
    await mesh.pointsAtLengths(isoline, lengths),
    here.pointsAtLengths(isoline, lengths),
  );
  assert.deepEqual(await mesh.equallySpaced(isoline, 7), here.equallySpaced(isoline, 7));
  // The path itself stays.
  assert.equal(isoline.points().length, isoline.count);
});

test('long work reports its progress, and ends when it is aborted', async () => {
  const large = await remote.shape('sphere', 20000);
  const told = [];
  const controller = new AbortController();
  const options = { solver: 'graph', rings: 3 };
  const work = large.prepare(options, {
    signal: controller.signal,
    progress(done, stage) {
      told.push([done, stage]);
      controller.abort(new Error('enough'));
    },
  });
  await assert.rejects(work, /enough/);
  const heard = told.length;
  assert.ok(told[0][0] > 0 && told[0][0] < 1);
  assert.equal(told[0][1], 'graph');
  await large.prepare(options);
  assert.equal(told.length, heard, 'nothing is told of what was aborted');
  const aborted = AbortSignal.abort(new Error('never begun'));
  await assert.rejects(large.prepare(options, { signal: aborted }), /never begun/);
  await large.dispose();
});

test('results that nobody awaits leave no memory behind', async () => {
  const before = await remote.allocatedBytes();
  const controller = new AbortController();
  const late = remote.client.call('shape', ['sphere', 2000, controller.signal]);
  controller.abort(new Error('too late'));
  await assert.rejects(late, /too late/);
  await remote.allocatedBytes();
  assert.equal(await remote.allocatedBytes(), before);
});

test('after dispose every call fails, even one under way', async () => {
  const other = await loadInWorker();
  const making = other.shape('sphere', 2000);
  other.dispose();
  other.dispose();
  await assert.rejects(making, { name: 'KarcherError', code: 'disposed' });
  await assert.rejects(other.shape('sphere', 2000), { code: 'disposed' });
  assert.equal(other.client.disposed, true);
  const signal = AbortSignal.abort(new Error('not now'));
  await assert.rejects(loadInWorker({ signal }), /not now/);
});

/** A worker whose answers the test gives. */
function scripted() {
  const heard = {};
  const posted = [];
  const worker = {
    posted,
    ended: false,
    on: (type, hear) => {
      heard[type] = hear;
    },
    postMessage: (message) => posted.push(structuredClone(message)),
    terminate: () => {
      worker.ended = true;
    },
    tell: (type, value) => heard[type](value),
  };
  return worker;
}

test('a worker that ends, or whose engine fails, ends every call with the reason', async () => {
  for (const end of [
    (worker) => worker.tell('error', new Error('out of memory')),
    (worker) => {
      const failure = { message: 'out of memory', code: 'internal', fatal: true };
      worker.tell('message', { id: 1, failure });
    },
  ]) {
    const worker = scripted();
    const client = new WorkerClient(worker);
    const told = [];
    client.onFatal = (error) => told.push(error.message);
    const calls = [client.call('first', []), client.call('second', [])];
    end(worker);
    for (const call of calls) await assert.rejects(call, { code: 'internal', message: /memory/ });
    await assert.rejects(client.call('third', []), { code: 'internal' });
    assert.deepEqual(told, ['out of memory']);
    assert.ok(worker.ended && client.disposed);
  }
});

test('a worker that does not start is reported, with its address and advice', async () => {
  const notLoaded =
    (...parts) =>
    (error) => {
      assert.equal(error.name, 'KarcherError');
      assert.equal(error.code, 'notLoaded');
      for (const part of parts) assert.match(error.message, part);
      return true;
    };
  const missing = () => new Worker(new URL('./missing_worker.mjs', import.meta.url));
  await assert.rejects(
    loadInWorker({ worker: missing }),
    notLoaded(/missing_worker\.mjs/, /karcher\/worker-thread/),
  );
  // Browsers give no reason.
  const blocked = scripted();
  const loading = loadInWorker({ worker: () => blocked });
  blocked.tell('error', new Event('error'));
  await assert.rejects(loading, notLoaded(/does not start\. Check/, /karcher\/worker-thread/));
  assert.ok(blocked.ended);
  // A worker that has answered has started.
  const broken = scripted();
  const breaking = loadInWorker({ worker: () => broken });
  broken.tell('message', { id: 1, begun: true });
  broken.tell('error', new Error('out of memory'));
  await assert.rejects(breaking, { code: 'internal', message: 'out of memory' });

  const folder = mkdtempSync(join(tmpdir(), 'karcher-'));
  try {
    const dist = dirname(fileURLToPath(import.meta.resolve('karcher')));
    cpSync(dist, folder, { recursive: true });
    rmSync(join(folder, 'worker/thread.js'));
    writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
    const own = await import(pathToFileURL(join(folder, 'worker/index.js')));
    const address = pathToFileURL(join(folder, 'worker/thread.js')).href;
    await assert.rejects(own.loadInWorker(), (error) => {
      assert.ok(error.message.includes(`Check that its script ${address} can be loaded`));
      return notLoaded(/worker-src/)(error);
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

test('arguments are copied when a call is made', async () => {
  const place = { face: 3, bary: [0.2, 0.3, 0.5] };
  const expected = here.position(place);
  const asked = mesh.position(place);
  place.face = 7;
  place.bary[0] = 9;
  assert.deepEqual(await asked, expected);
  const arrays = [here.positions(), here.triangles()];
  const making = remote.meshFromArrays(...arrays);
  arrays[0].fill(0);
  const copy = await making;
  assert.deepEqual(await copy.positions(), here.positions());
  assert.equal(arrays[0].length, here.positions().length, 'and stay the caller’s');
});

test('an error of a progress function ends only its own call, with that error', async () => {
  const worker = scripted();
  const client = new WorkerClient(worker);
  const mine = new Error('mine');
  const fail = () => {
    throw mine;
  };
  const first = client.call('first', [{ progress: fail }]);
  const second = client.call('second', []);
  const third = client.call('third', [], undefined, { progress: fail });
  worker.tell('message', { id: 1, callback: 0, args: [0.5, 'reading'] });
  await assert.rejects(first, mine);
  assert.deepEqual(worker.posted.at(-1), { cancel: 1 });
  worker.tell('message', { id: 1, callback: 0, args: [0.6, 'reading'] });
  worker.tell('message', { id: 3, result: 1 });
  await assert.rejects(third, mine);
  worker.tell('message', { id: 2, result: 7 });
  assert.equal(await second, 7);
  client.dispose();
});

test('a signal has a listener only during its call', async () => {
  const worker = scripted();
  const client = new WorkerClient(worker);
  const { signal } = new AbortController();
  const heard = new Set();
  const { addEventListener } = signal;
  signal.addEventListener = (type, hear, options) => {
    heard.add(hear);
    options.signal.addEventListener('abort', () => heard.delete(hear));
    addEventListener.call(signal, type, hear, options);
  };
  const calls = Array.from({ length: 20 }, (_, i) => client.call('square', [i, { signal }]));
  assert.equal(heard.size, 20);
  for (const { id } of worker.posted.slice(0, 10)) worker.tell('message', { id, result: id });
  for (const { id } of worker.posted.slice(10)) {
    worker.tell('message', { id, failure: { message: 'no', code: 'badArgument', fatal: false } });
  }
  await Promise.allSettled(calls);
  assert.equal(heard.size, 0);
  client.dispose();
});

/** The worker's end in this thread: it receives requests, and its posts go to `hear`. */
async function servedHere(root, hear) {
  const { serve } = await import('karcher/own-worker');
  const { addEventListener, postMessage } = globalThis;
  let served;
  globalThis.addEventListener = (_, listener) => {
    served = listener;
  };
  globalThis.postMessage = hear;
  serve(root);
  const end = () => Object.assign(globalThis, { addEventListener, postMessage });
  return { request: (data) => served({ data }), end };
}

test('a call cancelled while the engine loads is not made', async () => {
  const posted = [];
  let arrive;
  const made = [];
  const root = new Promise((resolve) => {
    arrive = resolve;
  });
  const { request, end } = await servedHere(root, (reply) => posted.push(reply));
  try {
    const call = (id) => ({ id, target: 0, call: 'make', args: [id], tells: true });
    request(call(1));
    request(call(2));
    await new Promise((resolve) => setTimeout(resolve));
    request({ cancel: 1 });
    arrive({ make: (i) => made.push(i) });
    while (!posted.some((reply) => 'result' in reply)) {
      await new Promise((resolve) => setImmediate(resolve));
    }
  } finally {
    end();
  }
  assert.deepEqual(made, [2]);
  const told = posted.filter((reply) => 'callback' in reply).map(({ id }) => id);
  assert.deepEqual(told, [2], 'it never began');
});

test('a step of a drag is one call into the module, even if calls can be interrupted', async () => {
  const heard = {};
  const root = { mesh: () => karcherHere.meshFromObj(text) };
  const post = (reply, transfer) => heard.message(structuredClone(reply, { transfer }));
  const { request, end } = await servedHere(root, post);
  try {
    const client = new WorkerClient(() => ({
      on(type, hear) {
        heard[type] = hear;
      },
      postMessage: (message) => request(structuredClone(message)),
      terminate() {},
    }));
    const remoteMesh = await client.call('mesh', []);
    const value = { kind: 'bspline', points };
    const curve = await remoteMesh.curve(value);
    // The value has the legs of a drag's steps, so that the client needs no further call to create
    // the curve again.
    let { drawnLegs: legs } = await curve.view();
    const { calls } = await noted(here, async () => {
      for (let vertex = 41; vertex < 75; vertex++) {
        const next = { ...value, points: points.with(1, { vertex }), legs };
        ({ drawnLegs: legs } = await curve.set(next));
      }
    });
    const names = calls.map(({ name }) => name);
    assert.deepEqual(names, Array(34).fill('set'));
  } finally {
    end();
  }
});
