// Offsets: lines at a distance from paths.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { load, Path } from 'karcher';
import { loadInWorker } from 'karcher/worker';
import { grid } from './meshes.mjs';
import { karcher as command, failure, printed, temporaryFolder } from './run_cli.mjs';

const karcher = await load();
const remote = await loadInWorker();
const folder = temporaryFolder();
after(() => {
  remote.dispose();
  folder.remove();
});

const near = (actual, expected, tolerance = 1e-9) =>
  assert.ok(Math.abs(actual - expected) < tolerance, `${actual} is not ${expected}`);

const cells = 10;
const mesh = karcher.meshFromObj(grid(cells));

/** The point of the grid at (x, y). */
function at([x, y]) {
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const [u, v] = [x - i, y - j];
  const face = 2 * (i + cells * j) + (u >= v ? 0 : 1);
  return { face, bary: u >= v ? [1 - u, u - v, v] : [1 - v, u, v - u] };
}

const corners = [
  [2.3, 2.2],
  [7.4, 2.2],
  [7.4, 6.5],
  [2.3, 6.5],
].map(at);
const square = corners.flatMap((corner, i) =>
  mesh
    .shortestPath(corner, corners[(i + 1) % 4])
    .points()
    .slice(i > 0 ? 1 : 0),
);

test('inwards, outwards and both of a rectangle', () => {
  const around = 2 * (5.1 + 4.3);
  const [inner, ...more] = mesh.offset([square], { distance: 0.6, side: 'left' });
  assert.ok(inner instanceof Path && inner.closed && more.length === 0);
  near(inner.length, around - 8 * 0.6, 1e-3);
  const [outer] = mesh.offset([square], { distance: 0.6, side: 'right' });
  near(outer.length, around + 2 * Math.PI * 0.6, 2e-3);
  assert.equal(mesh.offset([square], { distance: 0.6 }).length, 2);
  assert.deepEqual(mesh.offset([square], { distance: 3, side: 'left' }), []);
  // Offset lines keep the direction of the path: both have their inside on the left.
  const [ring, hole] = mesh.regions([outer, inner]);
  near(ring.area - hole.area, around * 2 * 0.6 - 4 * 0.6 ** 2 + Math.PI * 0.6 ** 2, 0.01);
});

test('of a region’s boundary have the inside on the left', () => {
  const [region] = mesh.regions([square.toReversed()]);
  const [line] = mesh.offset(region.boundary(), { distance: 0.6, side: 'left' });
  const [smaller] = mesh.regions([line]);
  near(smaller.area, (5.1 - 1.2) * (4.3 - 1.2), 5e-3);
});

test('at several distances the sides of a segment are the tangents of the disks at its ends', () => {
  const [a, b] = [at([3, 4]), at([7, 7])];
  const segment = mesh.shortestPath(a, b);
  for (const [start, end] of [
    [0.5, 1.7],
    [1.2, 0],
  ]) {
    const distance = [start, end];
    const tilt = Math.asin((end - start) / 5);
    for (const side of ['left', 'right']) {
      const [line, ...more] = mesh.offset([segment], { distance, side });
      assert.equal(more.length, 0);
      near(line.length, 5 * Math.cos(tilt), 2e-3);
    }
    const [around] = mesh.offset([segment], { distance });
    assert.ok(around.closed);
    const arcs = (Math.PI + 2 * tilt) * end + (Math.PI - 2 * tilt) * start;
    near(around.length, 10 * Math.cos(tilt) + arcs, 5e-3);
  }
  // On a closed path the first distance follows the last, so equal ones count as one.
  const [one] = mesh.offset([square], { distance: 0.6, side: 'right' });
  const [same] = mesh.offset([square], { distance: [0.6, 0.6, 0.6], side: 'right' });
  near(same.length, one.length, 1e-9);
  const bad = { name: 'KarcherError', code: 'badArgument' };
  assert.throws(() => mesh.offset([segment], { distance: [1, 2], corners: 'miter' }), {
    ...bad,
    message: /must be round$/,
  });
  for (const distance of [[], [0, 0], [1, -1], [1, '2']]) {
    assert.throws(() => mesh.offset([segment], { distance }), bad);
  }
  assert.throws(() => mesh.offset([segment], { distance: [1, NaN] }), { code: 'notFinite' });
});

test('report paths without an offset', () => {
  const bad = { name: 'KarcherError', code: 'badArgument' };
  assert.throws(() => mesh.offset([square], { distance: 0 }), { ...bad, message: /positive/ });
  assert.throws(() => mesh.offset([square], { distance: 1, side: 'up' }), bad);
  assert.throws(() => mesh.offset([square], { radius: 1 }), { ...bad, message: /no option/ });
  assert.throws(() => mesh.offset([[corners[0], corners[0]]], { distance: 1 }), {
    ...bad,
    message: /^path 0 has no length$/,
  });
});

test('in a worker it is the same', async () => {
  const there = await remote.meshFromObj(grid(cells));
  const [expected] = mesh.offset([square], { distance: 0.4, side: 'right' });
  const [line] = await there.offset([square], { distance: 0.4, side: 'right' });
  assert.deepEqual(line.points(), expected.points());
  const [tapered] = await there.offset([square], { distance: [0.4, 0.1] });
  assert.deepEqual(tapered.points(), mesh.offset([square], { distance: [0.4, 0.1] })[0].points());
});

test('on the command line', async () => {
  const points = folder.write(
    'points.txt',
    corners.map(({ face, bary: [, b, c] }) => `${face} ${b} ${c}\n`).join(''),
  );
  const file = folder.write('grid.obj', grid(cells));
  const args = ['offset', file, '--points', points, '--kind', 'polyline', '--closed'];
  const { lines } = await printed(...args, '--distance', '0.6', '--side', 'left');
  assert.equal(lines.length, 1);
  near(lines[0].length, mesh.offset([square], { distance: 0.6, side: 'left' })[0].length, 1e-6);
  assert.equal(lines[0].closed, true);
  for (const [x, y] of lines[0].polyline) {
    near(Math.min(x - 2.3, 7.4 - x, y - 2.2, 6.5 - y), 0.6, 6e-4);
  }
  const tapered = await printed(...args, '--distance', '0.6,0.2', '--side', 'left');
  const [inner] = mesh.offset([square], { distance: [0.6, 0.2], side: 'left' });
  near(tapered.lines[0].length, inner.length, 1e-6);
  const { stdout } = await command(...args, '--distance', '0.6', '--format', 'obj');
  assert.equal(stdout.match(/^l /gm).length, 2);
  assert.match(await failure(...args), /^offset needs --distance D$/);
  assert.match(await failure(...args, '--distance', '-1'), /must be a positive number$/);
});
