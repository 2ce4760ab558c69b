// Paths and regions as values.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { KarcherError, load, Path, Region } from 'karcher';
import { centroid } from 'karcher/statistics';
import { loadInWorker } from 'karcher/worker';
import { randomFrom, seed } from '../web/part.mjs';

const karcher = await load();

const again = (value) => JSON.parse(JSON.stringify(value));

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
