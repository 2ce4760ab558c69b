// Regions that curves enclose, on the command line.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { grid } from './meshes.mjs';
import { failure, karcher, printed, temporaryFolder } from './run_cli.mjs';

const folder = temporaryFolder();
after(() => folder.remove());

const near = (actual, expected, tolerance = 1e-9) =>
  assert.ok(Math.abs(actual - expected) < tolerance, `${actual} is not ${expected}`);

const cells = 10;
const gridFile = folder.write('grid.obj', grid(cells));

/** The grid's point at (x, y), in the square on its upper right. */
function at([x, y]) {
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const [u, v] = [x - i, y - j];
  const face = 2 * (i + cells * j) + (u >= v ? 0 : 1);
  return { face, bary: u >= v ? [1 - u, u - v, v] : [1 - v, u, v - u] };
}

const rectangle = (left, low, right, high) => [
  [left, low],
  [right, low],
  [right, high],
  [left, high],
];

const linesOf = (points) =>
  points.map(({ face, bary: [, b, c] }) => `${face} ${b} ${c}\n`).join('');
const polygonOf = (corners) => ({ kind: 'polyline', closed: true, points: corners.map(at) });

const corners = rectangle(1.25, 1.25, 4.75, 4.25);
const pointsFile = folder.write('points.txt', linesOf(corners.map(at)));
const square = ['--points', pointsFile, '--kind', 'polyline', '--closed'];
const curves = [corners, rectangle(3, 2.25, 7.25, 6.5)].map(polygonOf);
const twoFile = folder.write('two.json', JSON.stringify({ curves }));
const hole = [corners, rectangle(2.25, 2.25, 3.25, 3.5)].map(polygonOf);
const holeFile = folder.write('hole.json', JSON.stringify({ curves: hole }));

// An octahedron whose corners have distance 1 from its middle; each face has the area sqrt(3) / 2.
const octahedron = folder.write(
  'octahedron.obj',
  'v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n' +
    [1, 2, 3, 4].map((a) => `f ${a} ${(a % 4) + 1} 5\nf ${(a % 4) + 1} ${a} 6\n`).join(''),
);
const upper = [0, 2, 4, 6];
/** A line around the octahedron at a height: the sides of a square. */
const parallel = folder.write(
  'parallel.txt',
  linesOf(upper.map((face) => ({ face, bary: [0.75, 0, 0.25] }))),
);
const parallelCircle = ['--points', parallel, '--kind', 'polyline', '--closed'];

test('regions of a rectangle on a plane', async () => {
  const { regions } = await printed('regions', gridFile, ...square);
  assert.equal(regions.length, 1);
  const [{ area, perimeter, boundary }] = regions;
  near(area, 3.5 * 3);
  near(perimeter, 2 * (3.5 + 3));
  assert.equal(boundary.length, 1);
  near(boundary[0].length, perimeter);
  const { polyline } = boundary[0];
  assert.deepEqual(polyline[0], polyline.at(-1));
  // The line runs counterclockwise: the region lies on its left.
  const turned = polyline.slice(1).map(([x, y], i) => polyline[i][0] * y - x * polyline[i][1]);
  near(turned.reduce((sum, value) => sum + value) / 2, area);
});

test('regions of several curves, and their combinations', async () => {
  const [a, b, both] = [3.5 * 3, 4.25 * 4.25, 1.75 * 2];
  const areas = async (...args) =>
    (await printed('regions', gridFile, '--curve', twoFile, ...args)).regions.map(
      ({ area }) => area,
    );
  const expected = {
    none: [a, b],
    union: [a + b - both],
    intersection: [both],
    difference: [a - both],
    exclusion: [a + b - 2 * both],
  };
  for (const [combine, sums] of Object.entries(expected)) {
    const found = await areas('--combine', combine);
    assert.equal(found.length, sums.length);
    for (const [i, sum] of sums.entries()) near(found[i], sum);
  }
  const [second, ...more] = await areas('--number', '1');
  near(second, b);
  assert.equal(more.length, 0);
});

test('a region with a hole', async () => {
  const args = ['regions', gridFile, '--curve', holeFile];
  const { regions } = await printed(...args, '--inside', `${at([1.5, 1.5]).face}:0.25,0.25`);
  assert.equal(regions.length, 1);
  near(regions[0].area, 3.5 * 3 - 1.25);
  near(regions[0].perimeter, 13 + 4.5);
  const lengths = regions[0].boundary.map(({ length }) => length);
  lengths.sort((x, y) => x - y);
  assert.equal(lengths.length, 2);
  near(lengths[0], 4.5);
  near(lengths[1], 13);
  assert.match(await failure(...args, '--inside', 'v:0', '--combine', 'union'), /--combine has no/);
});

test('both sides of a parallel circle make up the sphere', async () => {
  const side = async (inside) =>
    (await printed('regions', octahedron, ...parallelCircle, '--inside', inside)).regions[0];
  const [cap, rest] = [await side('v:4'), await side('v:5')];
  // The cap is a pyramid whose edges are 3/4 as long as those of the upper half.
  near(cap.area, 2 * Math.sqrt(3) * 0.75 ** 2);
  near(cap.area + rest.area, 4 * Math.sqrt(3));
  near(cap.perimeter, 4 * 0.75 * Math.SQRT2);
  near(rest.perimeter, cap.perimeter);
  // The region is the smaller side, unless a point selects the other one.
  near((await printed('regions', octahedron, ...parallelCircle)).regions[0].area, cap.area);
});

test('a side of each curve is inside', async () => {
  const areas = async (...args) =>
    (await printed('regions', ...args)).regions.map(({ area }) => area);
  const plane = cells ** 2;
  const of = { left: [3.5 * 3, 4.25 * 4.25], right: [plane - 3.5 * 3, plane - 4.25 * 4.25] };
  for (const [side, expected] of Object.entries(of)) {
    const found = await areas(gridFile, '--curve', twoFile, '--side', side);
    assert.equal(found.length, 2);
    for (const [i, area] of expected.entries()) near(found[i], area);
  }
  const args = ['regions', gridFile, '--curve', twoFile];
  const [outside] = await areas(...args.slice(1), '--side', 'right', '--combine', 'intersection');
  near(outside, plane - 3.5 * 3 - 4.25 * 4.25 + 1.75 * 2);
  assert.match(await failure(...args, '--side', 'up'), /^--side must be one of left, right/);
  assert.match(await failure(...args, '--side', 'left', '--inside', 'v:0'), /--side has no/);
});

test('regions as an OBJ file are written as their boundaries', async () => {
  const { status, stdout } = await karcher('regions', gridFile, ...square, '--format', 'obj');
  assert.equal(status, 0);
  const { regions } = await printed('regions', gridFile, ...square);
  const count = regions[0].boundary[0].polyline.length;
  assert.equal([...stdout.matchAll(/^v /gm)].length, count);
  assert.match(stdout, /^l( \d+)+$/m);
});

test('curves that enclose no region, and invalid arguments, are refused', async () => {
  const open = ['regions', gridFile, '--points', pointsFile, '--kind', 'polyline'];
  assert.match(await failure(...open), /^the curve does not bound a region: /);
  assert.match(await failure('regions', gridFile), /^regions needs --points FILE or --curve FILE$/);
  assert.match(
    await failure('regions', gridFile, ...square, '--rule', 'odd'),
    /^--rule must be one of evenOdd, nonZero, not 'odd'$/,
  );
  assert.match(
    await failure('regions', gridFile, ...square, '--samples', '9', '--tolerance', '1e-3'),
    /^regions takes --samples or --tolerance, not both$/,
  );
});
