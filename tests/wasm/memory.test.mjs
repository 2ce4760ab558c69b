import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { load } from 'karcher';
import { badFiles, distancesOf, fields, grid } from './meshes.mjs';
import { loadForTest } from './workers.mjs';

/** The bytes in use after the first 10 and after all of `times` rounds of `work`. */
function bytesAround(karcher, times, work) {
  let early = 0;
  for (let i = 0; i < times; i++) {
    if (i === 10) early = karcher.allocatedBytes();
    work();
  }
  return [early, karcher.allocatedBytes()];
}

test('a disposed mesh frees all its memory', async () => {
  const karcher = await load();
  const text = grid(6);
  const [early, late] = bytesAround(karcher, 1000, () => {
    const mesh = karcher.meshFromObj(text);
    mesh.positions();
    mesh.dispose();
  });
  assert.equal(late, early);
});

test('meshes, curves and their results free all their memory', async () => {
  const karcher = await load();
  const text = grid(6);
  const points = [16, 18, 31, 32].map((vertex) => ({ vertex }));
  const [early, late] = bytesAround(karcher, 1000, () => {
    const mesh = karcher.meshFromObj(text);
    for (const field of fields) {
      const curve = mesh.curve({ kind: 'bspline', points, samples: 8, ...field });
      curve.movePoint(1, points[2]);
      curve.samples().count;
      curve.polyline().length;
      curve.dispose();
      mesh.distance(points[0], distancesOf(field));
      mesh.centerOfMass(points, [0.25, 0.25, 0.25, 0.25], field);
    }
    mesh.shortestPath(points[0], points[3]);
    mesh.circle(points[1], { radius: 1, samples: 4 });
    mesh.curve({ kind: 'bezier', points, samples: 8 });
    mesh.dispose();
  });
  assert.equal(late, early);
});

test('errors leave no memory behind', async () => {
  const karcher = await load();
  const [early, late] = bytesAround(karcher, 200, () => {
    for (const { text, code } of badFiles) {
      assert.throws(() => karcher.meshFromObj(text, { repair: 'none' }), { code });
    }
  });
  assert.equal(late, early);
});

test('running out of memory is an error, and the program continues', async () => {
  const karcher = await load();
  const mesh = karcher.meshFromObj(grid(2));
  const bytes = karcher.allocatedBytes();
  // All bytes are zeros, which the system does not store.
  const tooMuch = new Uint8Array(2 ** 32 - 1);
  assert.throws(() => karcher.meshFromObj(tooMuch), { code: 'outOfMemory' });
  assert.equal(karcher.allocatedBytes(), bytes);
  assert.equal(mesh.info.triangles, 8);
});

test('memory is filled completely, and the program continues', async () => {
  const karcher = await load();
  const mesh = karcher.shape('torus', 6000);
  const points = [0, 100, 300, 500].map((vertex) => ({ vertex }));
  const weights = [0.25, 0.25, 0.25, 0.25];
  const given = (made, ask) => {
    const answer = ask(made);
    made.dispose();
    return answer;
  };
  const calls = [
    () => given(mesh.curve({ kind: 'bspline', points }), (curve) => curve.polyline()),
    () => given(mesh.curve({ kind: 'bspline', points, samples: 2000 }), (curve) => curve.length),
    () => mesh.centerOfMass(points, weights, { solver: 'exact' }).position,
    () => mesh.distance(points[0])[17],
    () => given(karcher.shape('sphere', 50_000), (sphere) => sphere.info.triangles),
    () => given(mesh.subdivide(2), (finer) => finer.info.triangles),
    () => mesh.shortestPath(points[0], points[3]).length,
  ];
  const right = calls.map((call) => call());
  const held = [];
  /** Fills the memory with meshes of a triangle and many unused vertices. */
  const fill = (vertices) => {
    const positions = new Float64Array(3 * vertices);
    positions.set([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    for (let i = 0; i < 4000; i++) {
      try {
        held.push(karcher.meshFromArrays(positions, [0, 1, 2]));
      } catch (error) {
        assert.equal(error.code, 'outOfMemory');
        return;
      }
    }
    assert.fail('there is always more room');
  };
  for (const vertices of [4_000_000, 300_000, 20_000]) fill(vertices);
  const full = karcher.allocatedBytes();
  assert.ok(full > 4e9, `${full} bytes are in use`);
  // Each call returns its usual result or fails for lack of memory; each round leaves more.
  let refused = 0;
  for (let round = 0; round < 6; round++) {
    for (const [i, call] of calls.entries()) {
      try {
        assert.deepEqual(call(), right[i], `call ${i} of round ${round}`);
      } catch (error) {
        if (error.code !== 'outOfMemory') throw error;
        refused++;
      }
    }
    held.pop().dispose();
  }
  assert.ok(refused > 0, 'some call had no room');
  for (const one of held) {
    assert.equal(one.info.triangles, 1);
    one.dispose();
  }
  assert.deepEqual(
    calls.map((call) => call()),
    right,
  );
});

test('a request that cannot fit is refused with its size before it is tried', async () => {
  const karcher = await load();
  const mesh = karcher.shape('sphere', 20_000);
  const refuse = () => {
    assert.throws(() => mesh.subdivide(6), {
      code: 'outOfMemory',
      message:
        /^6 levels of subdivision make 83,886,080 triangles, which take at least 29\.7 GB of memory, /,
    });
    assert.throws(() => mesh.subdivide(7), { code: 'badArgument' });
  };
  // The allocator rounds by the free space beside a block: once, not each time.
  refuse();
  const bytes = karcher.allocatedBytes();
  for (let i = 0; i < 100; i++) refuse();
  assert.equal(karcher.allocatedBytes(), bytes);
  const finer = mesh.subdivide(2);
  assert.equal(finer.info.triangles, 16 * mesh.info.triangles);
  // Requests for which no test has the memory, computed from the free space.
  const room = await import(new URL('./room.js', import.meta.resolve('karcher')));
  const full = () => 4e9;
  const told = { code: 'outOfMemory', message: /at least [\d.]+ [GM]B of memory, and .* left$/ };
  assert.throws(() => room.checkDistancesFit(6_000_000, full), told);
  assert.throws(() => room.checkGraphFits(9_000_000, 6, full), told);
  const made = { bytes: 1e9, done: 0.1 };
  assert.throws(() => room.checkGraphGoesOn(1e6, 6, made, () => 1.4e9), told);
  for (const inUse of [() => 0, () => 3e9]) {
    room.checkDistancesFit(1_000_000, inUse);
    room.checkGraphFits(1_000_000, 6, inUse);
    room.checkGraphGoesOn(1e6, 6, { bytes: 1e9, done: 0.9 }, inUse);
  }
});

test('unreachable objects are freed, in any order', async () => {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc');
  const karcher = await load();
  const text = grid(20);
  const points = [46, 48, 111, 112].map((vertex) => ({ vertex }));
  const kept = karcher.meshFromObj(text);
  const before = karcher.allocatedBytes();
  const forget = () => {
    for (let i = 0; i < 60; i++) {
      const mesh = karcher.meshFromObj(text);
      for (let k = 0; k < 3; k++) mesh.curve({ kind: 'bspline', points, samples: 8 });
      if (i % 3 === 0) mesh.dispose();
      // Only the curve becomes free, since its mesh stays.
      kept.curve({ kind: 'bspline', points, samples: 8 });
    }
  };
  forget();
  const held = karcher.allocatedBytes() - before;
  for (let round = 0; round < 100 && karcher.allocatedBytes() > before; round++) {
    collect();
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  const left = karcher.allocatedBytes() - before;
  assert.ok(held > 1e5 && left < held / 20, `${left} of ${held} bytes are left`);
  // The remaining mesh is intact.
  assert.ok(kept.curve({ kind: 'bspline', points, samples: 8 }).length > 0);
});

test('using frees the memory at the end of a block', { skip: !Symbol.dispose }, async () => {
  const karcher = await load();
  const mesh = karcher.shape('sphere', 500);
  const points = [0, 10, 20, 30].map((vertex) => ({ vertex }));
  const curve = mesh.curve({ kind: 'bspline', points });
  curve[Symbol.dispose]();
  assert.throws(() => curve.polyline(), { code: 'disposed' });
  mesh[Symbol.dispose]();
  assert.throws(() => mesh.positions(), { code: 'disposed' });
});

test('the side that calls a worker keeps nothing of meshes that are disposed of', async (t) => {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc');
  const karcher = await loadForTest(t);
  const text = new TextEncoder().encode(grid(50));
  const used = () => {
    collect();
    return process.memoryUsage().arrayBuffers;
  };
  const round = async () => {
    const mesh = await karcher.meshFromObj(text);
    // The curve, which is not disposed of itself, goes with its mesh.
    await mesh.curve({ kind: 'polyline', points: [{ vertex: 0 }, { vertex: 9 }] });
    await mesh.dispose();
  };
  await round();
  const early = used();
  for (let i = 0; i < 10; i++) await round();
  const kept = () => (used() - early) / text.length;
  // The collector frees buffers in a thread of its own.
  for (let turn = 0; turn < 200 && kept() >= 2; turn++) await pause(50);
  assert.ok(kept() < 2, `${kept()} files are kept`);
});
