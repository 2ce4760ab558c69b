// The measurements of a figure do not depend on the figure's other lines.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadPeers } from 'karcher/peers';
import { load } from './load.mjs';

const spec = { kind: 'shape', name: 'torus', triangles: 2_000 };

/** Peers that record the mesh of each preparation. */
async function notingPeers() {
  const peers = await loadPeers();
  const prepared = [];
  const noting = {
    karcher: peers.karcher,
    plan: (...values) => peers.plan(...values),
    prepare: (mesh, options, work) => {
      const key = JSON.stringify([options.method, options.solver, options.rings, options.levels]);
      prepared.push({ mesh, key, triangles: mesh.info.triangles });
      return peers.prepare(mesh, options, work);
    },
  };
  return { noting, prepared };
}

test('every method has a mesh of its own, and was run before on a small one', async () => {
  const { Scene } = await load('lab/scene.ts');
  const { lineStyles } = await load('figures/lines.ts');
  const { noting, prepared } = await notingPeers();
  const scene = await Scene.make(noting, spec);
  const chosen = ['paperGraph2', 'paper', 'karcher', 'bSurf', 'leveled', 'bridged'];
  for (const id of chosen) await scene.method(lineStyles[id].options, {});
  const own = prepared.filter(({ triangles }) => triangles === scene.mesh.info.triangles);
  assert.equal(own.length, chosen.length);
  assert.equal(new Set([scene.mesh, ...own.map(({ mesh }) => mesh)]).size, 1 + chosen.length);
  for (const { key } of own) {
    const [first] = prepared.filter((one) => one.key === key);
    assert.ok(first.triangles < 1_000, key);
  }
  // The scene has prepared each method once.
  const count = prepared.length;
  await scene.method(lineStyles.paper.options, {});
  assert.equal(prepared.length, count);
  await scene.dispose();
});

test('the engine’s curves take the time of all stages but the joining paths', async (t) => {
  const { Lab } = await load('lab/lab.ts');
  const peers = await loadPeers();
  const lab = new Lab(peers);
  const lines = ['bSurf', 'leveled', 'bridged'];
  const curve = { kind: 'bspline' };
  const panel = { id: 'a', title: '', mesh: spec, points: 'a', curve, lines, samples: 9 };
  const places = [0, 0.3, 0.6, 0.9, 1.2].map((u) => [Math.cos(u), Math.sin(u), 0.2 * u]);
  const { points } = await lab.place(spec, places);
  const torus = peers.karcher.shape(spec.name, spec.triangles);
  // Each reading of this clock takes a millisecond.
  let readings = 0;
  t.mock.method(performance, 'now', () => ++readings);
  for (const [k, levels] of ['limit', 'auto', 0].entries()) {
    const expected = torus.curve({ kind: 'bspline', points, samples: 9, levels });
    const { polygon, fields, trace, bridge } = expected.times();
    const [{ id, traceMs }] = await lab.lines({ ...panel, lines: [lines[k]] }, places);
    assert.equal(traceMs, polygon + fields + trace + bridge, id);
    expected.dispose();
  }
  torus.dispose();
});

test('lines without a method are timed after a run on a small mesh, too', async (t) => {
  const { Lab } = await load('lab/lab.ts');
  const peers = await loadPeers();
  const shape = peers.karcher.shape.bind(peers.karcher);
  const made = [];
  t.mock.method(peers.karcher, 'shape', (name, triangles) => {
    made.push(triangles);
    return shape(name, triangles);
  });
  const lab = new Lab(peers);
  const curve = { kind: 'circle', arcs: 7 };
  const panel = { id: 'a', title: '', mesh: spec, points: 'a', curve, samples: 9 };
  const places = [0, 0.4].map((u) => [1.4 * Math.cos(u), 1.4 * Math.sin(u), 0]);
  await lab.place(spec, places);
  for (const id of ['exactPath', 'circleArcs', 'circleDefault', 'isolineLinear', 'isolineExact']) {
    made.length = 0;
    const [line] = await lab.lines({ ...panel, lines: [id] }, places);
    assert.ok(line.ok && line.traceMs > 0, `${id}: ${line.reason}`);
    assert.deepEqual(made, [500], id);
  }
});

test('Table 1 measures no code that runs for the first time', async () => {
  const { runTable } = await load('table/run.ts');
  const { smallRows } = await load('table/rows.ts');
  const { noting, prepared } = await notingPeers();
  const triangles = [];
  const events = {
    row() {},
    method() {},
    progress() {},
    cell: (cell) => triangles.push(cell.triangles),
  };
  // A curve of two points on a mesh of about 1,000 triangles.
  const [, row] = smallRows(0.02);
  const methods = ['paper', 'karcher'];
  await runTable(noting, { rows: [row], methods, samples: 5, budgetMs: 60_000 }, events);
  assert.equal(triangles.length, methods.length);
  const keys = [...new Set(prepared.map(({ key }) => key))];
  // Both methods have exact distances for two points.
  assert.deepEqual(keys, ['["paper","exact",null,null]', '["karcher","exact",null,null]']);
  for (const wanted of keys) {
    const [first] = prepared.filter(({ key }) => key === wanted);
    assert.notEqual(first.triangles, triangles[0], wanted);
  }
});
