import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { grid, partsOf, square } from './meshes.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const cells = 6;
/** The plane's distance from (x, y) to vertex v of the grid. */
const planeDistance = (x, y, v) =>
  Math.hypot((v % (cells + 1)) - x, Math.floor(v / (cells + 1)) - y);

test('on a plane, exact and fast distances are those of the plane', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const from = { face: 20, bary: [0.5, 0.2, 0.3] };
  const [x, y] = mesh.position(from);
  for (const solver of ['exact', 'fast']) {
    const distances = mesh.distance(from, { solver });
    assert.equal(distances.length, (cells + 1) ** 2);
    distances.forEach((distance, v) => {
      assert.ok(Math.abs(distance - planeDistance(x, y, v)) < 1e-12, `${solver}, vertex ${v}`);
    });
  }
  assert.deepEqual(mesh.distance(from), mesh.distance(from, { solver: 'exact' }));
  assert.equal(mesh.distance({ vertex: 8 }, { solver: 'exact' })[8], 0);
});

test('graph distances are at least the exact ones, and exact where vertices see each other', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const graph = mesh.distance({ vertex: 0 }, { solver: 'graph', rings: 2 });
  const coarse = mesh.distance({ vertex: 0 }, { solver: 'graph', rings: 1 });
  graph.forEach((distance, v) => {
    assert.ok(distance >= planeDistance(0, 0, v) - 1e-12);
    assert.ok(coarse[v] >= distance - 1e-12);
  });
  // The first vertex lies along an edge, the other one across it.
  assert.ok(Math.abs(graph[1] - 1) < 1e-12);
  assert.ok(Math.abs(graph[cells + 3] - Math.sqrt(5)) < 1e-12);
});

test('welded vertices repeat their distance; dropped and unreachable ones have none', () => {
  // The mesh is two squares joined along an edge with doubled vertices, a vertex without a face,
  // and a separate square.
  const apart = square.replace(/^v (.)/gm, 'v 5$1').replace('f 1 2 3 4', 'f 10 11 12 13');
  const mesh = karcher.meshFromObj(
    `${square}v 7 8 9\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 6 7 8 9\n${apart}`,
  );
  for (const solver of ['exact', 'fast', 'graph']) {
    const distances = mesh.distance({ vertex: 0 }, { solver });
    const near = [0, 1, Math.SQRT2, 1, Number.NaN, 1, 2, Math.sqrt(5), Math.SQRT2];
    assert.equal(distances.length, 13);
    near.forEach((expected, v) => {
      if (Number.isNaN(expected)) assert.ok(Number.isNaN(distances[v]));
      else assert.ok(Math.abs(distances[v] - expected) < 1e-12, `${solver}, vertex ${v}`);
    });
    assert.ok(distances.slice(9).every(Number.isNaN));
  }
});

test('a vertex where parts touch has the distance and log vector of the nearest fan of faces', () => {
  const places = [0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0];
  const mesh = karcher.meshFromArrays(places, [0, 1, 2, 0, 3, 4]);
  for (const [face, sign] of [1, -1].entries()) {
    const from = { face, bary: [0.25, 0.5, 0.25] };
    for (const solver of ['exact', 'fast', 'graph']) {
      const [there, ...others] = mesh.distance(from, { solver });
      assert.ok(Math.abs(there - Math.hypot(0.5, 0.25)) < 1e-15);
      assert.deepEqual(others.map(Number.isNaN), [face > 0, face > 0, face < 1, face < 1]);
    }
    const [x, y, z] = mesh.logMap(from).vectors;
    assert.ok(Math.hypot(x + sign * 0.5, y + sign * 0.25, z) < 1e-15);
  }
});

test('the shortest path on a plane is a straight line', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const from = { face: 0, bary: [0.5, 0.25, 0.25] };
  const path = mesh.shortestPath(from, { vertex: 47 });
  const { length } = path;
  const polyline = path.polyline({ bits: 64 });
  const direct = Math.hypot(5 - 0.5, 6 - 0.25);
  assert.ok(Math.abs(length - direct) < 1e-12);
  assert.deepEqual(Array.from(polyline.slice(0, 3)), [0.5, 0.25, 0]);
  assert.deepEqual(Array.from(polyline.slice(-3)), [5, 6, 0]);
  let walked = 0;
  for (let i = 3; i < polyline.length; i += 3) {
    walked += Math.hypot(...[0, 1, 2].map((k) => polyline[i + k] - polyline[i + k - 3]));
  }
  assert.ok(Math.abs(walked - direct) < 1e-12);
});

test('a path has points of the surface, with lengths from its start, and returns copies', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const path = mesh.shortestPath({ vertex: 0 }, { face: 40, bary: [0.5, 0.25, 0.25] });
  const before = partsOf(path);
  const { points, lengths, polyline } = before;
  assert.equal(path.closed, false);
  assert.equal(points.length, path.count);
  assert.equal(lengths[0], 0);
  assert.equal(lengths.at(-1), path.length);
  points.forEach((point, i) => {
    assert.deepEqual(mesh.position(point), Array.from(polyline.slice(3 * i, 3 * i + 3)));
    const away = Math.hypot(...polyline.slice(3 * i, 3 * i + 2));
    assert.ok(Math.abs(lengths[i] - away) < 1e-12);
  });
  assert.deepEqual(path.polyline(), new Float32Array(polyline));
  assert.deepEqual(path.polyline({ bits: 32 }), new Float32Array(polyline));
  for (const copy of [path.polyline(), path.polyline({ bits: 64 }), path.lengths()]) copy.fill(7);
  path.points()[0].bary[0] = 7;
  assert.deepEqual(partsOf(path), before);
  assert.throws(() => path.polyline({ bits: 16 }), { code: 'badArgument', message: /32, 64/ });
  assert.throws(() => path.polyline({ bit: 64 }), { code: 'badArgument', message: /'bit'/ });
  // The points of a path are valid for further calls.
  assert.ok(mesh.shortestPath(points[0], points.at(-1)).length - path.length < 1e-12);
});

test('a path from a point to itself has two ends and no length', () => {
  const mesh = karcher.meshFromObj(grid(cells));
  const path = mesh.shortestPath({ vertex: 9 }, { vertex: 9 });
  assert.equal(path.length, 0);
  assert.deepEqual(Array.from(path.polyline()), [2, 1, 0, 2, 1, 0]);
  assert.deepEqual(Array.from(path.lengths()), [0, 0]);
});

test('no path leads to another component', () => {
  const apart = square.replace(/^v (.)/gm, 'v 5$1').replace('f 1 2 3 4', 'f 5 6 7 8');
  const mesh = karcher.meshFromObj(square + apart);
  assert.throws(() => mesh.shortestPath({ vertex: 0 }, { vertex: 4 }), { code: 'unreachable' });
  assert.ok(mesh.shortestPath({ vertex: 0 }, { vertex: 2 }).length > 1.4);
});

test('wrong options are refused', () => {
  const mesh = karcher.meshFromObj(square);
  const wrong = [
    [{ solver: 'slow' }, /the solver must be one of/],
    [{ solver: 'graph', rings: 0 }, /1 to 10 rings/],
    [{ solver: 'graph', rings: 11 }, /1 to 10 rings/],
    [{ solver: 'graph', rings: 1.5 }, /whole number/],
    [null, /must be an object/],
  ];
  for (const [options, message] of wrong) {
    assert.throws(() => mesh.distance({ vertex: 0 }, options), { code: 'badArgument', message });
  }
});

test('the graph can be prepared in slices, with progress', async () => {
  const mesh = karcher.shape('sphere', 20_000);
  const parts = [];
  let turns = 0;
  const timer = setInterval(() => {
    turns += 1;
  }, 0);
  await mesh.prepare(
    { method: 'paper', solver: 'graph' },
    { progress: (done, stage) => parts.push([done, stage]) },
  );
  clearInterval(timer);
  assert.ok(turns > 0, 'the thread was free in between');
  assert.ok(parts.length > 1);
  assert.deepEqual(parts.at(-1), [1, 'graph']);
  for (let i = 1; i < parts.length; i++) assert.ok(parts[i][0] >= parts[i - 1][0]);
  // Now the graph exists.
  const again = [];
  await mesh.prepare(
    { method: 'paper', solver: 'graph' },
    { progress: (done) => again.push(done) },
  );
  assert.deepEqual(again, []);
  const other = karcher.shape('sphere', 20_000);
  assert.deepEqual(
    mesh.distance({ vertex: 5 }, { solver: 'graph' }),
    other.distance({ vertex: 5 }, { solver: 'graph' }),
  );
  mesh.dispose();
  other.dispose();
});

test('preparing can be stopped, and frees its memory', async () => {
  // The engine is separate: objects that other tests forgot may be freed at any time.
  const own = await load();
  const mesh = own.shape('sphere', 20_000);
  const bytes = own.allocatedBytes();
  const controller = new AbortController();
  const progress = () => controller.abort(new Error('enough'));
  await assert.rejects(
    mesh.prepare({ method: 'paper', solver: 'graph' }, { progress, signal: controller.signal }),
    { message: 'enough' },
  );
  assert.equal(own.allocatedBytes(), bytes);
  await assert.rejects(
    mesh.prepare({ method: 'paper', solver: 'graph' }, { progress: () => mesh.dispose() }),
    { code: 'disposed' },
  );
  assert.ok(own.allocatedBytes() < bytes);
});
