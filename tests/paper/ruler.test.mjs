// One ruler for all methods: the page, `karcher compare` and an independent computation agree on
// the same curves.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { loadPeers, Ruler, runMethod, standardOptions } from 'karcher/peers';
import { printed, temporaryFolder } from '../wasm/run_cli.mjs';
import { residualsByBruteForce } from './brute_force.mjs';
import { load } from './load.mjs';

const samples = 33;
/** The names of `compare` with the page's lines of the same settings. */
const alike = {
  vectorHeat: 'vectorHeat',
  affineHeat: 'affineHeat',
  weightedAverages: 'weightedAverages',
  bSurf: 'bSurf',
  paper: 'paperGraph6',
  karcher: 'karcher',
  leveled: 'leveled',
};

const folder = temporaryFolder();
let lab;
let panel;
let figure;
let drawn;
let placed;
let compared;
before(async () => {
  const { figures } = await load('figures/index.ts');
  const { Lab } = await load('lab/lab.ts');
  lab = new Lab(await loadPeers());
  figure = figures.find(({ id }) => id === 'resolution');
  // The coarse mesh of Fig. 4: far from smooth, so that methods differ.
  panel = { ...figure.panels[0], samples, lines: [...Object.values(alike), 'exactLogs'] };
  const { arraysOf } = await load('../model/mesh_blobs.ts');
  drawn = await arraysOf((await lab.mesh(panel.mesh)).arrays);
  placed = await lab.place(panel.mesh, figure.points[panel.points]);
  const { positions, triangles } = drawn;
  const rows = (name, values, add) =>
    Array.from({ length: values.length / 3 }, (_, i) =>
      [name, ...[0, 1, 2].map((c) => values[3 * i + c] + add)].join(' '),
    );
  const meshFile = folder.write(
    'mesh.obj',
    [...rows('v', positions, 0), ...rows('f', triangles, 1)].join('\n'),
  );
  const pointsFile = folder.write(
    'points.txt',
    placed.points.map(({ face, bary }) => [face, bary[1], bary[2]].join(' ')).join('\n'),
  );
  const options = ['--points', pointsFile, '--samples', `${samples}`];
  compared = await printed('compare', meshFile, ...options);
});
after(() => folder.remove());

test('page, command line and brute force agree to 1e-9 h', async () => {
  const lines = await lab.lines(panel, figure.points[panel.points]);
  const mesh = lab.peers.karcher.meshFromArrays(drawn.positions, drawn.triangles);
  const plan = lab.peers.plan(placed.points, samples);
  for (const [method, id] of Object.entries(alike)) {
    const { ruler: onPage, lost } = lines.find((line) => line.id === id);
    const inCli = compared.methods[method].ruler;
    const run = await runMethod(lab.peers, mesh, plan, standardOptions(method, plan), null, {
      once: true,
    });
    const brute = residualsByBruteForce(mesh, placed.points, run.curve.samples);
    const near = (a, b, what) =>
      assert.ok(Math.abs(a - b) <= 1e-9, `${method}, ${what}: ${a} and ${b}`);
    for (const { residual, energy, measured, of } of [onPage, inCli]) {
      assert.equal(of, 33, method);
      assert.equal(measured, brute.residual.length, method);
      near(residual.median, brute.residual[Math.floor(measured / 2)], 'median');
      near(residual.max, brute.residual.at(-1), 'largest');
      // The values are some hundred squared edges, with limited digits.
      near(energy.median / 1e3, brute.energy[Math.floor(measured / 2)] / 1e3, 'energy');
    }
    near(onPage.energy.excess, inCli.energy.excess, 'excess');
    assert.equal(compared.methods[method].lost, lost, method);
    // The ruler does not measure lost samples.
    if (lost === 0) assert.equal(brute.residual.length, 33, method);
  }
  mesh.dispose();
});

test('a center of mass has a residual of 0 on a plane, another point has its distance', async () => {
  const { karcher } = lab.peers;
  const positions = Float64Array.of(0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0);
  const mesh = karcher.meshFromArrays(positions, Int32Array.of(0, 1, 2, 0, 2, 3));
  const corners = [0, 1, 2, 3].map((vertex) => ({ vertex }));
  const table = { points: 4, t: Float64Array.of(0), weights: Float64Array.of(0.1, 0.4, 0.3, 0.2) };
  const ruler = new Ruler(mesh, { points: corners, first: [0], table });
  // The average is (2.8, 2), inside face 0; the other point is 1 to the right of it.
  const at = (x, y) => ({
    count: 1,
    segment: Int32Array.of(0),
    t: Float64Array.of(0),
    face: Int32Array.of(0),
    bary: Float64Array.of(1 - x / 4, (x - y) / 4, y / 4),
    position: Float64Array.of(x, y, 0),
    status: ['converged'],
  });
  const { meanEdge } = mesh.info;
  for (const [x, y, residual] of [
    [2.8, 2, 0],
    [3.8, 2, 1],
    // On the common side of both faces, from which paths leave on both sides.
    [2.5, 2.5, Math.hypot(0.3, 0.5)],
  ]) {
    const read = await ruler.measure(at(x, y));
    assert.ok(Math.abs(read.residual.median * meanEdge - residual) < 1e-12, `${x}, ${y}`);
    const energy = [0.1, 0.4, 0.3, 0.2].reduce((sum, weight, i) => {
      const [dx, dy] = [positions[3 * i] - x, positions[3 * i + 1] - y];
      return sum + weight * (dx * dx + dy * dy);
    }, 0);
    assert.ok(Math.abs(read.energy.median * meanEdge ** 2 - energy) < 1e-12);
  }
  const lost = await ruler.measure({ ...at(2.8, 2), status: ['noProgress'] });
  assert.deepEqual([lost.residual, lost.measured, lost.of], [null, 0, 1]);
  mesh.dispose();
});

test('across a sharp edge, directions are unfolded', async () => {
  const { karcher } = lab.peers;
  // A roof with a right angle: two squares that meet along the y axis.
  const positions = Float64Array.of(0, 0, 0, 0, 4, 0, 4, 0, 0, 4, 4, 0, 0, 0, 4, 0, 4, 4);
  const triangles = Int32Array.of(0, 2, 1, 1, 2, 3, 0, 1, 4, 1, 5, 4);
  const mesh = karcher.meshFromArrays(positions, triangles);
  const table = { points: 2, t: Float64Array.of(0), weights: Float64Array.of(0.5, 0.5) };
  const ruler = new Ruler(mesh, { points: [{ vertex: 3 }, { vertex: 5 }], first: [0], table });
  // The middle of the edge: unfolded, the corners are at (4, 2) and (-4, 2) from there.
  const middle = {
    count: 1,
    segment: Int32Array.of(0),
    t: Float64Array.of(0),
    face: Int32Array.of(0),
    bary: Float64Array.of(0.5, 0, 0.5),
    position: Float64Array.of(0, 2, 0),
    status: ['converged'],
  };
  const { residual } = await ruler.measure(middle);
  assert.ok(Math.abs(residual.median * mesh.info.meanEdge - 2) < 1e-12, `${residual.median}`);
  mesh.dispose();
});

test('compare reports the solver of distances, and what was left out', () => {
  const { methods, reference } = compared;
  assert.equal(
    methods.paper.solver,
    'graph distances, k = 6; gradients of the faces around a vertex and beyond; authors’ seeds',
  );
  assert.match(methods.karcher.solver, /^(fast|exact) distances$/);
  assert.equal(reference, 'our method, exact distances');
  for (const [
    name,
    { deviation, samples: all, lost, lostByOwnRule, logMaps, drag },
  ] of Object.entries(methods)) {
    if (name === 'descent') continue;
    assert.ok(deviation.samples <= all - lost, name);
    assert.ok(lostByOwnRule <= lost, name);
    // A curve that lost half of its samples has no drags.
    assert.equal(drag?.steps, lost > all / 2 ? undefined : 20, name);
    if (!drag) continue;
    assert.ok(drag.leaps <= drag.steps && (drag.most > 5 || drag.leaps === 0), name);
    assert.equal(logMaps !== null, /Heat/.test(name), name);
  }
  // A search evaluates far more log maps than it passes vertices.
  assert.ok(methods.vectorHeat.logMaps.asked > 2 * methods.vectorHeat.logMaps.made);
});
