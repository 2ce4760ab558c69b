// Paths and regions as values, even points along paths, and transport along them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { KarcherError, load, Path, Region } from 'karcher';
import { centroid } from 'karcher/statistics';
import { loadInWorker } from 'karcher/worker';
import { randomFrom, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';

const karcher = await load();

const again = (value) => JSON.parse(JSON.stringify(value));
const minus = (a, b) => a.map((value, i) => value - b[i]);
const norm = (a) => Math.hypot(...a);
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const triple = (numbers, i) => [...numbers.slice(3 * i, 3 * i + 3)];
const triples = (numbers) =>
  Array.from({ length: numbers.length / 3 }, (_, i) => triple(numbers, i));

const drawn = (name) => {
  console.log(`${name}: drawn with KARCHER_SEED=${seed}`);
  return randomFrom(seed);
};

const somewhere = (mesh, random) => {
  const [u, v] = [random(), random()];
  const [a, b] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
  return { face: Math.floor(random() * mesh.info.triangles), bary: [1 - a - b, a, b] };
};

const torus = karcher.shape('torus', 2000);
const curve = torus.curve({
  kind: 'bspline',
  closed: true,
  points: [0, 40, 90, 130].map((vertex) => ({ vertex })),
});

test('a path survives JSON, and methods that take paths take its value', async () => {
  const path = torus.shortestPath({ vertex: 3 }, { vertex: 400 });
  const value = again(path);
  const copy = Path.from(value);
  assert.ok(copy instanceof Path);
  for (const name of ['length', 'closed', 'count']) assert.equal(copy[name], path[name]);
  for (const name of ['points', 'lengths', 'toJSON']) assert.deepEqual(copy[name](), path[name]());
  const double = { bits: 64 };
  assert.deepEqual(copy.polyline(double), path.polyline(double));
  const [there] = torus.offset([path], { distance: 0.03 });
  for (const taken of [value, copy]) {
    assert.deepEqual(torus.offset([taken], { distance: 0.03 })[0].points(), there.points());
  }
  const { path: circle } = torus.circle({ vertex: 12 }, { radius: 0.2 });
  const [region] = torus.regions([circle]);
  for (const shape of [again(circle), { outlines: [again(circle)] }]) {
    assert.equal(torus.regions([shape])[0].area, region.area);
  }
  const remote = await loadInWorker();
  const far = await remote.shape('torus', 2000);
  assert.equal((await far.regions([again(circle)]))[0].area, region.area);
  remote.dispose();
});

test('a region survives JSON, and its centroid is that of the region', async () => {
  const random = drawn('regions');
  const [region] = torus.regions([torus.circle({ vertex: 12 }, { radius: 0.2 }).path]);
  const copy = Region.from(again(region));
  assert.equal(copy.area, region.area);
  assert.equal(copy.perimeter, region.perimeter);
  assert.deepEqual(again(copy), again(region));
  assert.equal(copy.boundary()[0].length, region.boundary()[0].length);
  for (let i = 0; i < 500; i++) {
    const point = somewhere(torus, random);
    assert.equal(copy.contains(point), region.contains(point));
  }
  const options = { samples: 50 };
  assert.deepEqual(
    await centroid(torus, again(region), options),
    await centroid(torus, region, options),
  );
});

test('what is no value of a path or a region is refused', () => {
  const value = again(torus.shortestPath({ vertex: 3 }, { vertex: 400 }));
  const wrong = [undefined, null, 3, {}, { ...value, bary: 3 }, { ...value, lengths: ['a'] }];
  for (const each of wrong) assert.throws(() => Path.from(each), KarcherError);
  for (const each of [undefined, 3, {}]) assert.throws(() => Region.from(each), KarcherError);
  assert.throws(() => torus.offset([{ face: [0], bary: [1] }], { distance: 1 }), KarcherError);
});

test('points on a straight path of the plane divide it evenly', () => {
  const random = drawn('even points');
  const mesh = karcher.meshFromObj(grid(12));
  for (let round = 0; round < 20; round++) {
    const [from, to] = [somewhere(mesh, random), somewhere(mesh, random)];
    const path = mesh.shortestPath(from, to);
    const [start, end] = [mesh.position(from), mesh.position(to)];
    const at = (part) => start.map((value, k) => value + part * (end[k] - value));
    const count = 2 + Math.floor(10 * random());
    for (const line of [path, again(path), path.points()]) {
      const { position, lengths, ...points } = mesh.equallySpaced(line, count);
      // Some ten roundings of coordinates up to 12.
      triples(position).forEach((place, i) => {
        assert.ok(norm(minus(place, at(i / (count - 1)))) < 1e-13);
        assert.ok(Math.abs(lengths[i] - (path.length * i) / (count - 1)) < 1e-13);
      });
      assert.deepEqual(mesh.positionsOf(points), position);
    }
    const part = random();
    const { position } = mesh.pointsAtLengths(path, [part * path.length, -1, 2 * path.length]);
    const wanted = [part, 0, 1].map(at);
    triples(position).forEach((place, i) => {
      assert.ok(norm(minus(place, wanted[i])) < 1e-13);
    });
  }
  const refused = { name: 'KarcherError', code: 'badArgument' };
  assert.throws(() => mesh.equallySpaced([{ vertex: 0 }, { vertex: 1 }], 0), refused);
  assert.throws(() => mesh.pointsAtLengths([{ vertex: 0 }, { vertex: 80 }], [1]), refused);
});

test('points on a closed path begin at its start, and have equal lengths between them', () => {
  const path = curve.path();
  const { lengths, position } = torus.equallySpaced(path, 7);
  assert.deepEqual(
    [...lengths],
    Array.from({ length: 7 }, (_, i) => (path.length * i) / 7),
  );
  assert.ok(norm(minus(triple(position, 0), triple(path.polyline({ bits: 64 }), 0))) < 1e-14);
  const { position: same } = torus.pointsAtLengths(path, lengths);
  assert.deepEqual(same, position);
  // Points of the path at their own lengths are found again.
  const own = torus.pointsAtLengths(path, path.lengths());
  const all = path.polyline({ bits: 64 });
  triples(own.position).forEach((place, i) => {
    assert.ok(norm(minus(place, triple(all, i))) < 1e-12 * path.length);
  });
});

test('transport along any path of a plane changes nothing', () => {
  const random = drawn('transport');
  const mesh = karcher.meshFromObj(grid(12));
  const points = Array.from({ length: 6 }, () => somewhere(mesh, random));
  const bent = mesh.curve({ kind: 'catmullrom', points }).path();
  const vectors = [1, 0, 0, 0.3, -0.7, 0];
  const carried = mesh.transportAlong(bent, vectors);
  // Each of the path's points rounds the direction once, and more where pieces are short.
  assert.ok(norm(minus([...carried], vectors)) < 1e-9);
  for (const line of [again(bent), bent.points()]) {
    assert.deepEqual(mesh.transportAlong(line, vectors), carried);
  }
});

test('transport around a corner of a cube turns vectors by its quarter turn', () => {
  const obj = [
    ...[0, 1, 2, 3, 4, 5, 6, 7].map((i) => `v ${i & 1} ${(i >> 1) & 1} ${i >> 2}`),
    ...['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map(
      (face) => `f ${face}`,
    ),
  ].join('\n');
  const mesh = karcher.meshFromObj(new TextEncoder().encode(obj));
  const at = (...place) => mesh.nearestPoint(place).point;
  // On the three sides that meet in the corner 0 0 0, and the edges between them.
  const loop = [
    at(0.3, 0.2, 0),
    at(0.3, 0, 0),
    at(0.3, 0, 0.2),
    at(0, 0, 0.3),
    at(0, 0.2, 0.3),
    at(0, 0.3, 0),
    at(0.3, 0.2, 0),
  ];
  const joined = loop.slice(1).flatMap((to, i) => mesh.shortestPath(loop[i], to).points());
  const start = [0.6, 0.8, 0];
  const carried = [...mesh.transportAlong(joined, start)];
  assert.ok(Math.abs(dot(carried, start)) < 1e-12, `${carried}`);
  assert.ok(Math.abs(norm(carried) - 1) < 1e-12);
  const twice = mesh.transportAlong([...joined, ...joined], start);
  assert.ok(norm([...twice].map((value, k) => value + start[k])) < 1e-12);
});

test('a worker has the same points along paths, transport, frames and carried points', async () => {
  const remote = await loadInWorker();
  const far = await remote.shape('torus', 2000);
  const path = curve.path();
  const value = path.toJSON();
  assert.deepEqual(await far.equallySpaced(value, 5), torus.equallySpaced(path, 5));
  assert.deepEqual(await far.pointsAtLengths(value, [0.1]), torus.pointsAtLengths(path, [0.1]));
  // A path itself arrives as its points, whose lengths are summed again.
  const { position } = await far.equallySpaced(path, 5);
  const there = torus.equallySpaced(path, 5).position;
  position.forEach((x, i) => {
    assert.ok(Math.abs(x - there[i]) < 1e-13);
  });
  assert.deepEqual(
    await far.transportAlong(path, [1, 2, 3]),
    torus.transportAlong(path, [1, 2, 3]),
  );
  assert.deepEqual(await far.frame({ vertex: 7 }), torus.frame({ vertex: 7 }));
  assert.deepEqual(await far.carried([{ vertex: 7 }], 2), torus.carried([{ vertex: 7 }], 2));
  const near = { radius: 0.3 };
  assert.deepEqual(await far.distance({ vertex: 7 }, near), torus.distance({ vertex: 7 }, near));
  assert.deepEqual(await far.logMap({ vertex: 7 }, near), torus.logMap({ vertex: 7 }, near));
  remote.dispose();
});
