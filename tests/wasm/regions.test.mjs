// Regions: the insides of outlines, and booleans.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { load, Path, Region } from 'karcher';
import { loadInWorker } from 'karcher/worker';
import { randoms, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';

const karcher = await load();
const remote = await loadInWorker();
after(() => remote.dispose());

const near = (actual, expected, tolerance = 1e-9) =>
  assert.ok(Math.abs(actual - expected) < tolerance, `${actual} is not ${expected}`);

/** The point of a grid at (x, y); squares are cut from their lower left. */
function at(cells, [x, y]) {
  const [i, j] = [x, y].map((value) => Math.min(Math.floor(value), cells - 1));
  const [u, v] = [x - i, y - j];
  const face = 2 * (i + cells * j) + (u >= v ? 0 : 1);
  return { face, bary: u >= v ? [1 - u, u - v, v] : [1 - v, u, v - u] };
}

function polygon(mesh, cells, corners) {
  const points = corners.map((corner) => at(cells, corner));
  return points.flatMap((point, i) => {
    const leg = mesh.shortestPath(point, points[(i + 1) % points.length]).points();
    return i < points.length - 1 ? leg.slice(0, -1) : leg;
  });
}

const rectangle = (left, low, right, high) => [
  [left, low],
  [right, low],
  [right, high],
  [left, high],
];

const cells = 10;
const mesh = karcher.meshFromObj(grid(cells));
const one = polygon(mesh, cells, rectangle(1.3, 1.2, 4.8, 4.1));
const other = polygon(mesh, cells, rectangle(3.1, 2.2, 7.3, 6.4));

test('the chosen inside of an outline stays, however large it is', async () => {
  const loops = [1.2, 4.7, 8.3].map((size) =>
    polygon(mesh, cells, rectangle(0.3, 0.4, 0.3 + size, 9.1)),
  );
  for (const [i, loop] of loops.entries()) {
    const area = 8.7 * [1.2, 4.7, 8.3][i];
    for (const on of [mesh, await remote.meshFromObj(grid(cells))]) {
      const [left] = await on.regions([{ outlines: [loop], inside: 'left' }]);
      const [right] = await on.regions([{ outlines: [loop], inside: 'right' }]);
      near(left.area, area);
      near(right.area, 100 - area);
      assert.deepEqual([left.data().isLeft, right.data().isLeft], [true, false]);
    }
  }
  assert.throws(() => mesh.regions([{ outlines: [one], inside: 'above' }]), {
    code: 'badArgument',
  });
});

test('squares on a plane, and their booleans', () => {
  const [a, b] = mesh.regions([one, other]);
  assert.ok(a instanceof Region);
  near(a.area, 3.5 * 2.9);
  near(a.perimeter, 2 * (3.5 + 2.9));
  near(b.area, 4.2 * 4.2);
  const both = 1.7 * 1.9;
  const areas = {
    union: a.area + b.area - both,
    intersection: both,
    difference: a.area - both,
    exclusion: a.area + b.area - 2 * both,
  };
  for (const [combine, area] of Object.entries(areas)) {
    const regions = mesh.regions([one, other], { combine });
    assert.equal(regions.length, 1);
    near(regions[0].area, area);
    const loops = regions[0].boundary();
    near(
      loops.reduce((sum, loop) => sum + loop.length, 0),
      regions[0].perimeter,
    );
    for (const loop of loops) {
      assert.ok(loop instanceof Path && loop.closed);
      // A boundary is a valid outline.
      assert.ok(mesh.regions([loop])[0].area > 0);
    }
  }
});

test('a region contains the points that lie in it', () => {
  console.log(`drawn with KARCHER_SEED=${seed}`);
  const random = randoms(seed);
  const [region] = mesh.regions([one, other], { combine: 'exclusion' });
  const within = ([x, y], [[left, low], , [right, high]]) =>
    x > left && x < right && y > low && y < high;
  for (let i = 0; i < 2000; i++) {
    const place = [cells * random.next().value, cells * random.next().value];
    const expected =
      within(place, rectangle(1.3, 1.2, 4.8, 4.1)) !== within(place, rectangle(3.1, 2.2, 7.3, 6.4));
    assert.equal(region.contains(at(cells, place)), expected, `${place}`);
  }
  assert.throws(() => region.contains({ face: 200, bary: [1, 0, 0] }), { code: 'badIndex' });
  assert.throws(() => region.contains({ vertex: 2 }), { code: 'badArgument', message: /a face/ });
});

test('rules, holes, and the side of a point', () => {
  const large = polygon(mesh, cells, rectangle(0.5, 0.5, 9.5, 9.5));
  const shape = { outlines: [large, one], inside: at(cells, [8, 8]) };
  near(mesh.regions([shape])[0].area, 81 - 3.5 * 2.9);
  near(mesh.regions([shape], { rule: 'nonZero' })[0].area, 81);
  near(mesh.regions([large])[0].area, 100 - 81);
  near(mesh.regions([{ outlines: [large], inside: at(cells, [5, 5]) }])[0].area, 81);
});

test('circles are valid outlines, since they are paths', () => {
  const circle = mesh.circle(at(cells, [4.3, 5.1]), { radius: 2.2 });
  const [region] = mesh.regions([circle.path]);
  near(region.area, Math.PI * 2.2 ** 2, 0.01);
});

test('on a face that was reversed or cut, points keep their place', () => {
  const lines = grid(cells).split('\n');
  const faces = lines.findIndex((line) => line.startsWith('f'));
  for (let k = faces; k < lines.length - 1; k += 7) {
    const [, a, b, c] = lines[k].split(' ');
    lines[k] = `f ${a} ${c} ${b}`;
  }
  const turned = karcher.meshFromObj(lines.join('\n'));
  // Every seventh triangle has its corners 1 and 2 swapped.
  const placed = (point) => {
    const { face, bary } = at(cells, point);
    return { face, bary: face % 7 === 0 ? [bary[0], bary[2], bary[1]] : bary };
  };
  const points = rectangle(1.3, 1.2, 4.8, 4.1).map(placed);
  const outline = points.flatMap((point, i) =>
    turned.shortestPath(point, points[(i + 1) % 4]).points(),
  );
  const [region] = turned.regions([outline]);
  near(region.area, 3.5 * 2.9);
  for (let x = 0.55; x < cells; x += 0.5) {
    for (let y = 0.57; y < cells; y += 0.5) {
      const expected = x > 1.3 && x < 4.8 && y > 1.2 && y < 4.1;
      assert.equal(region.contains(placed([x, y])), expected, `${x}, ${y}`);
    }
  }
});

test('paths without a region, and invalid outlines, are reported', () => {
  const bad = { name: 'KarcherError', code: 'badArgument' };
  const open = mesh.shortestPath(at(cells, [1.2, 1.3]), at(cells, [5.2, 3.1]));
  assert.throws(() => mesh.regions([open]), { ...bad, message: /does not bound/ });
  assert.throws(() => mesh.regions([]), { ...bad, message: /at least one shape/ });
  assert.throws(() => mesh.regions(one[0]), { ...bad, message: /must be an array/ });
  assert.throws(() => mesh.regions([[one[0]]]), { ...bad, message: /two points/ });
  assert.throws(() => mesh.regions([{ outlines: [] }]), { ...bad, message: /one outline/ });
  assert.throws(() => mesh.regions([{ outline: one }]), { ...bad, message: /no option/ });
  assert.throws(() => mesh.regions([one], { rule: 'odd' }), bad);
  assert.throws(() => mesh.regions([one], { combine: 'xor' }), bad);
  assert.throws(() => mesh.regions([[at(cells, [1, 1.2]), at(cells, [8, 8.1])]]), {
    ...bad,
    message: /no face in common/,
  });
  assert.throws(() => mesh.regions([[{ vertex: 4000 }, { vertex: 0 }]]), { code: 'badIndex' });
});

test('a cut mesh keeps all of its area in its parts', () => {
  const parts = mesh.cut([one, other]);
  const areas = parts.map((part) => {
    assert.equal(part.faces.length, part.triangles.length / 3);
    karcher.meshFromArrays(part.positions, part.triangles, { repair: 'none' }).dispose();
    return flatArea(part);
  });
  const [a, b, both] = [3.5 * 2.9, 4.2 * 4.2, 1.7 * 1.9];
  const expected = [100 - a - b + both, a - both, both, b - both];
  areas.sort((x, y) => y - x);
  expected.sort((x, y) => y - x);
  assert.equal(areas.length, expected.length);
  for (const [i, area] of areas.entries()) near(area, expected[i]);
});

function flatArea({ positions, triangles }) {
  let sum = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [...triangles.slice(t, t + 3)].map((v) => positions.slice(3 * v, 3 * v + 2));
    sum += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }
  return sum;
}

test('in a worker they are the same', async () => {
  const there = await remote.meshFromObj(grid(cells));
  const path = mesh.circle(at(cells, [4.3, 5.1]), { radius: 2.2 });
  const shapes = [{ outlines: [path.path] }, one];
  const [expected] = mesh.regions(shapes, { combine: 'union' });
  const [region] = await there.regions(shapes, { combine: 'union' });
  assert.ok(region.area > 0);
  assert.deepEqual(region.data(), expected.data());
  assert.deepEqual(await there.cut([one]), mesh.cut([one]));
  await assert.rejects(there.regions([[one[0], one[1]]]), { code: 'badArgument' });
});
