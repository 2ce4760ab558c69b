// The check-up of meshes whose lengths, angles and boundaries are known.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { checkUp } from 'karcher/checkup';
import { loadInWorker } from 'karcher/worker';
import { grid, tetrahedron, tube } from './meshes.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const near = (value, wanted) =>
  assert.ok(Math.abs(value - wanted) < 1e-9, `${value}, not ${wanted}`);

test('edges and angles of a tetrahedron with right angles', async () => {
  const found = await checkUp(karcher.meshFromObj(tetrahedron));
  near(found.shortestEdge, 1);
  near(found.longestEdge, Math.SQRT2);
  near(found.smallestAngle, 45);
  near(found.largestAngle, 90);
  const { needles, caps, boundary, nearBoundaries, expected } = found;
  assert.deepEqual([needles.length, caps.length, boundary.length, nearBoundaries], [0, 0, 0, null]);
  // So few corners are no surface for the fast solver.
  assert.match(expected.join(), /^Its triangles do not suit the fast solver/);
  const sphere = await checkUp(karcher.shape('sphere', 2000));
  assert.deepEqual(sphere.expected, ['Nothing is in a curve’s way.']);
});

test('needles and caps are found by their angles, and by their numbers', async () => {
  // A fan at vertex 0: angles of 1 degree (a needle), 90, and one whose largest is 172 degrees.
  const at = (angle, radius) => [
    radius * Math.cos((angle * Math.PI) / 180),
    radius * Math.sin((angle * Math.PI) / 180),
    0,
  ];
  const positions = [0, 0, 0, ...at(0, 1), ...at(1, 1), ...at(91, 1), ...at(263, 1)];
  const triangles = [0, 1, 2, 0, 2, 3, 0, 3, 4];
  const found = await checkUp(karcher.meshFromArrays(positions, triangles));
  assert.deepEqual([Array.from(found.needles), Array.from(found.caps)], [[0], [2]]);
  near(found.smallestAngle, 1);
  near(found.largestAngle, 172);
  near(found.shortestEdge, 2 * Math.sin(Math.PI / 360));
  assert.ok(found.expected.some((sentence) => sentence.includes('thin triangles')));
});

test('the boundary edges are those of one face', async () => {
  const sheet = await checkUp(karcher.meshFromObj(grid(5)));
  assert.equal(sheet.boundary.length / 6, 20);
  let length = 0;
  for (let at = 0; at < sheet.boundary.length; at += 6) {
    const [x, y, z, X, Y, Z] = sheet.boundary.subarray(at, at + 6);
    length += Math.hypot(X - x, Y - y, Z - z);
    assert.ok([x, y].some((value) => value === 0 || value === 5));
  }
  near(length, 20);
  const open = await checkUp(karcher.meshFromObj(tube(12, 3)));
  assert.equal(open.boundary.length / 6, 24);
  assert.match(open.expected.join(), /keep to the boundary/);
});

test('what the file has twice, or without area, is passed over', async () => {
  const twice = `${tetrahedron}f 1 1 2\n`;
  const mesh = karcher.meshFromObj(twice);
  const found = await checkUp(mesh);
  near(found.smallestAngle, 45);
  near(found.shortestEdge, 1);
});

test('boundaries that lie on each other: how many vertices, and the weld that joins them', async () => {
  const gap = 3.3e-4;
  const right = grid(4)
    .split('\n')
    .map((line) => {
      const [word, ...numbers] = line.split(' ').map((part, i) => (i === 0 ? part : Number(part)));
      if (word === 'v') return `v ${numbers[0] + 4 + gap} ${numbers[1]} 0`;
      return word === 'f' ? `f ${numbers.map((number) => number + 25).join(' ')}` : line;
    })
    .join('\n');
  const text = grid(4) + right;
  const apart = karcher.meshFromObj(text);
  assert.equal(apart.info.components, 2);
  const { nearBoundaries, expected } = await checkUp(apart);
  assert.equal(nearBoundaries.places.length / 3, 10);
  assert.ok(
    nearBoundaries.weld >= gap && nearBoundaries.weld < 1.2 * gap,
    `${nearBoundaries.weld}`,
  );
  assert.match(expected.join(' '), /not joined.*weld of 0\.00034/);
  const joined = karcher.meshFromObj(text, { weld: nearBoundaries.weld });
  assert.equal(joined.info.components, 1);
  assert.equal((await checkUp(joined)).nearBoundaries, null);
  // Farther apart they are two parts, each with its boundary.
  const far = karcher.meshFromObj(text.replaceAll(`.${'00033'}`, '.01'));
  assert.equal((await checkUp(far)).nearBoundaries, null);
});

test('in slices, with progress and an end; of a mesh in a worker, too', async () => {
  const mesh = karcher.shape('openSheet', 200_000);
  const told = [];
  await checkUp(mesh, { progress: (done, stage) => told.push([done, stage]) });
  assert.ok(told.length > 2);
  assert.ok(
    told.every(([done, stage], i) => stage === 'checking' && (i === 0 || done >= told[i - 1][0])),
  );
  const reason = new Error('enough');
  await assert.rejects(checkUp(mesh, { signal: AbortSignal.abort(reason) }), reason);
  mesh.dispose();
  await assert.rejects(checkUp(mesh), { code: 'disposed' });
  await assert.rejects(checkUp(mesh, { signal: 1 }), { code: 'badArgument' });

  const remote = await loadInWorker();
  const found = await checkUp(await remote.meshFromObj(tetrahedron));
  near(found.largestAngle, 90);
  remote.dispose();
});
