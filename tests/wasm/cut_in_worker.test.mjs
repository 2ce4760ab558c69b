// A cut of a large mesh in a worker reports its progress, can be canceled, and loses nothing.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { loadForTest } from './workers.mjs';

const patience = { timeout: 600_000 };
const reason = new Error('not wanted');

/** A sphere, on which every closed curve bounds, and a triangle of shortest paths on it. */
async function sphere(t, triangles) {
  const karcher = await loadForTest(t);
  const mesh = await karcher.shape('sphere', triangles);
  const { vertices } = mesh.info;
  const corners = [0, 0.03, 0.3].map((part) => ({ vertex: Math.floor(part * vertices) }));
  const outline = await mesh.curve({ kind: 'polyline', points: corners, closed: true });
  return { mesh, path: await outline.path() };
}

test('a cut reports its progress in stages', patience, async (t) => {
  const { mesh, path } = await sphere(t, 20_000);
  const reports = [];
  const parts = await mesh.cut([path], { progress: (...report) => reports.push(report) });
  assert.ok(parts.length > 0);
  const done = reports.map(([value]) => value);
  assert.ok(done.length > 2, 'it reports between its begin and its end');
  assert.deepEqual([done[0], done.at(-1)], [0, 1]);
  for (let i = 1; i < done.length; i++) assert.ok(done[i] > done[i - 1]);
  for (const [, stage] of reports) assert.equal(stage, 'cut');
});

test('in the thread of the engine, progress may end a cut: by its own error, or by the signal', async () => {
  const mesh = (await load()).shape('sphere', 2000);
  const outline = mesh.circle({ vertex: 7 }, { radius: 0.3 }).path;
  const own = new RangeError('of the progress function');
  const fail = (done) => {
    if (done > 0) throw own;
  };
  assert.throws(() => mesh.cut([outline], { progress: fail }), own);
  const controller = new AbortController();
  const abort = () => controller.abort(reason);
  assert.throws(() => mesh.cut([outline], { progress: abort, signal: controller.signal }), reason);
  assert.equal(mesh.cut([outline]).length, 2, 'and the mesh goes on');
  assert.throws(() => mesh.cut([outline], { progress: 3 }), { code: 'badArgument' });
});

test(
  'a cut of a large mesh is given up at once, and the worker answers as before',
  patience,
  async (t) => {
    const { mesh, path } = await sphere(t, 100_000);
    const controller = new AbortController();
    let begin;
    const begun = new Promise((resolve) => {
      begin = resolve;
    });
    const told = [];
    const started = performance.now();
    const cut = mesh.cut([path], {
      signal: controller.signal,
      progress(done) {
        told.push(done);
        begin();
      },
    });
    let cutEnded = false;
    cut.then(
      () => {
        cutEnded = true;
      },
      () => {},
    );
    await begun;
    const aborted = performance.now();
    controller.abort(reason);
    await assert.rejects(cut, reason);
    const rejected = performance.now();
    assert.equal(cutEnded, false);
    assert.deepEqual(told, [0], 'it does not say that it has ended');
    const { area } = await mesh.regions([path]).then(([region]) => region);
    assert.ok(area > 0);
    const answered = performance.now();
    const parts = await mesh.cut([path]);
    const count = parts.reduce((sum, part) => sum + part.faces.length, 0);
    assert.ok(count > mesh.info.triangles, 'the whole surface and its new triangles');
    t.diagnostic(
      `begun after ${Math.round(aborted - started)} ms, given up in ${Math.round(rejected - aborted)} ms, ` +
        `the next answer ${Math.round(answered - rejected)} ms later, a whole cut ${Math.round(performance.now() - answered)} ms`,
    );
  },
);
