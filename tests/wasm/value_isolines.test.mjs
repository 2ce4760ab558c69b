// Isolines of values at the vertices.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { KarcherError, load, Path } from 'karcher';
import { isolines, joinedSegments, levelLines } from 'karcher/statistics';
import { loadInWorker } from 'karcher/worker';
import { randomFrom, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';
import { failure, printed, temporaryFolder } from './run_cli.mjs';

const karcher = await load();
const folder = temporaryFolder();
after(() => folder.remove());

const triples = (numbers) =>
  Array.from({ length: numbers.length / 3 }, (_, i) => [...numbers.slice(3 * i, 3 * i + 3)]);
const double = { bits: 64 };

/** The values of a function of the place at all vertices. */
const valuesOf = (mesh, value) => triples(mesh.positions()).map((place) => value(...place));

test('isolines of a linear function on a plane are straight, from side to side', async () => {
  console.log(`drawn with KARCHER_SEED=${seed}`);
  const random = randomFrom(seed);
  const cells = 12;
  const mesh = karcher.meshFromObj(grid(cells));
  for (let round = 0; round < 20; round++) {
    const [a, b] = [random() - 0.5, random() - 0.5];
    const values = valuesOf(mesh, (x, y) => a * x + b * y);
    const [u, v] = [1, 11].map((most) => 0.5 + most * random());
    const level = a * u + b * v;
    const [[line, ...others], none] = await isolines(mesh, values, [level, 1e3]);
    assert.deepEqual([others, none], [[], []]);
    assert.ok(line instanceof Path && !line.closed);
    const places = triples(line.polyline(double));
    // The slope divides roundings of the values.
    const slope = Math.hypot(a, b);
    for (const [x, y] of places) assert.ok(Math.abs(a * x + b * y - level) < 1e-13 + 1e-14 / slope);
    const ends = [places[0], places.at(-1)];
    for (const [x, y] of ends) assert.ok([x, y, cells - x, cells - y].some((value) => value === 0));
    const far = Math.hypot(...ends[0].map((value, k) => value - ends[1][k]));
    assert.ok(Math.abs(line.length - far) < 1e-12);
    // The points of the path lie where its places are, and neighbours share a face.
    const positions = mesh.positionsOf(line.points());
    assert.deepEqual(positions, line.polyline(double));
    mesh.offset([line], { distance: 0.1 });
  }
});

test('the equator of a sphere is one closed line of its length', async () => {
  const sphere = karcher.shape('sphere', 20000);
  const height = valuesOf(sphere, (_x, _y, z) => z);
  const [[equator, ...others]] = await isolines(sphere, height, [1e-3]);
  assert.deepEqual(others, []);
  assert.ok(equator.closed);
  // Chords of 1/80 of the radius lie within a ten-thousandth of the circle.
  const radius = Math.hypot(...triples(sphere.positions())[0]);
  assert.ok(Math.abs(equator.length / (2 * Math.PI * radius) - 1) < 5e-4, `${equator.length}`);
  const [region] = sphere.regions([equator]);
  assert.ok(Math.abs(region.area / (2 * Math.PI * radius ** 2) - 1) < 5e-3);
});

test('levels may have any order and repeat, and lines cross seams of welded vertices', async () => {
  const lines = ['v 0 0 0', 'v 1 0 0', 'v 1 1 0', 'v 1 0 0', 'v 2 0 0', 'v 1 1 0'];
  const mesh = karcher.meshFromObj([...lines, 'f 1 2 3', 'f 4 5 6'].join('\n'));
  const values = valuesOf(mesh, (_x, y) => y);
  const [high, low, again] = await isolines(mesh, values, [0.75, 0.25, 0.75]);
  assert.equal(low.length, 1);
  assert.ok(Math.abs(low[0].length - 1.5) < 1e-15);
  assert.ok(Math.abs(high[0].length - 0.5) < 1e-15);
  assert.deepEqual(again[0].points(), high[0].points());
  // Of welded vertices, the value of the first counts.
  const [[line]] = await isolines(mesh, [0, 1, 1, 5, 5, 6], [3]);
  assert.ok(triples(line.polyline(double)).every(([x]) => Math.abs(x - 1.5) < 1e-15));
});

test('isolines end at values that are not finite, and wrong values are refused', async () => {
  const mesh = karcher.meshFromObj(grid(4));
  for (const other of [Number.NaN, Infinity, -Infinity]) {
    const ending = valuesOf(mesh, (x, y) => (y > 2 ? other : x));
    const [[line, ...more]] = await isolines(mesh, ending, [1.5]);
    assert.equal(more.length, 0);
    assert.ok(triples(line.polyline(double)).every(([, y]) => y <= 2));
    assert.ok(Math.abs(line.length - 2) < 1e-14);
  }
  const values = valuesOf(mesh, (x) => x);
  const refused = [
    [[1, 2], [1]],
    [values, [Number.NaN]],
    [values, 1],
    ['values', [1]],
  ];
  for (const [given, levels] of refused) {
    await assert.rejects(isolines(mesh, given, levels), KarcherError);
  }
  assert.deepEqual(
    levelLines(mesh.triangles(), () => 1, [1]),
    [[]],
  );
  assert.equal(joinedSegments([[{ edge: 1 }, { edge: 2 }]]).length, 1);
});

test('isolines in a worker and on the command line are the same', async () => {
  const remote = await loadInWorker();
  const far = await remote.shape('torus', 500);
  const mesh = karcher.shape('torus', 500);
  const values = valuesOf(mesh, (x, y, z) => x + 2 * y - z);
  const [there, here] = [await isolines(far, values, [0.2]), await isolines(mesh, values, [0.2])];
  assert.deepEqual(
    there[0].map((line) => line.points()),
    here[0].map((line) => line.points()),
  );
  remote.dispose();
  const plane = folder.write('plane.obj', grid(4));
  const onPlane = Array.from({ length: 25 }, (_, v) => v % 5);
  for (const text of [
    onPlane.join('\n'),
    JSON.stringify(onPlane),
    JSON.stringify({ values: onPlane }),
  ]) {
    const file = folder.write('values.txt', text);
    const { isolines: found } = await printed(
      'isolines',
      plane,
      '--values',
      file,
      '--levels',
      '0.5,9',
    );
    assert.deepEqual(
      found.map(({ level, lines }) => [level, lines.length]),
      [
        [0.5, 1],
        [9, 0],
      ],
    );
    assert.equal(found[0].lines[0].length, 4);
  }
  const file = folder.write('values.txt', '1 2');
  const wrong = [
    ['--values', file],
    ['--values', file, '--levels', '1'],
    ['--values', file, '--levels', '1', '--radius', '1'],
    ['--levels', '1', '--center', 'v:0', '--radius', '1'],
    ['--center', 'v:0'],
  ];
  for (const options of wrong) await failure('isolines', plane, ...options);
});
