// Voronoi diagrams and centers of densities of `karcher/statistics`, against closed forms.
import assert from 'node:assert/strict';
import { after, describe, test } from 'node:test';
import { load } from 'karcher';
import { solidOf } from 'karcher/checkup';
import { centroid, voronoi } from 'karcher/statistics';
import { loadInWorker } from 'karcher/worker';
import { randomFrom, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';

const engine = await load();
const remote = await loadInWorker();
after(() => remote.dispose());

const apart = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));
const near = (a, b, tolerance) => assert.ok(apart(a, b) < tolerance, `${a} is not ${b}`);
const sum = (values) => values.reduce((all, value) => all + value, 0);

/** The grid as a file with separate vertices for each triangle, as in STL files. */
function unwelded(obj) {
  const lines = obj.split('\n');
  const places = lines.filter((line) => line.startsWith('v '));
  const corners = lines
    .filter((line) => line.startsWith('f '))
    .flatMap((line) => {
      const [a, b, c, d] = line.slice(2).split(' ').map(Number);
      return d === undefined ? [a, b, c] : [a, b, c, a, c, d];
    });
  const faces = corners.flatMap((_, i) => (i % 3 ? [] : [`f ${i + 1} ${i + 2} ${i + 3}`]));
  return [...corners.map((corner) => places[corner - 1]), ...faces].join('\n');
}

/** The file with every third face turned over. */
function partlyTurned(obj) {
  let faces = 0;
  return obj.replace(/^f (.*)$/gm, (line, corners) =>
    faces++ % 3 ? line : `f ${corners.split(' ').reverse().join(' ')}`,
  );
}

/**
 * The area of the part of a square that is nearest to one of several points: the square, clipped by
 * bisectors.
 */
function planarArea(size, sites, i) {
  let polygon = [
    [0, 0],
    [size, 0],
    [size, size],
    [0, size],
  ];
  sites.forEach((site, j) => {
    if (j === i) return;
    const beyond = (p) => apart(p, sites[i]) ** 2 - apart(p, site) ** 2;
    polygon = polygon.flatMap((p, k) => {
      const q = polygon[(k + 1) % polygon.length];
      const [a, b] = [beyond(p), beyond(q)];
      const kept = a <= 0 ? [p] : [];
      if (a <= 0 === b <= 0) return kept;
      return [...kept, p.map((x, axis) => x + (a / (a - b)) * (q[axis] - x))];
    });
  });
  return (
    sum(
      polygon.map((p, k) => {
        const q = polygon[(k + 1) % polygon.length];
        return p[0] * q[1] - p[1] * q[0];
      }),
    ) / 2
  );
}

describe('a Voronoi diagram', () => {
  test('of random points of a plane has straight bisectors as borders', async () => {
    const random = randomFrom(seed);
    const cells = 8;
    const sites = Array.from({ length: 12 }, () => [cells * random(), cells * random()]);
    const texts = [grid(cells), unwelded(grid(cells)), partlyTurned(unwelded(grid(cells)))];
    for (const text of texts) {
      for (const mesh of [engine.meshFromObj(text), await remote.meshFromObj(text)]) {
        const points = [];
        for (const site of sites) points.push((await mesh.nearestPoint([...site, 0])).point);
        const { areas, borders, cell, nearest } = await voronoi(mesh, points);
        sites.forEach((_, i) => {
          const area = planarArea(cells, sites, i);
          near([areas[i]], [area], 1e-9);
          const region = cell(i);
          near([region.area], [area], 1e-9);
          assert.ok(region.contains(points[i]));
          assert.equal(region.boundary().length, 1);
          assert.ok(region.boundary()[0].closed);
        });
        for (const { between, path } of borders) {
          const flat = path.polyline({ bits: 64 });
          for (let k = 0; k < flat.length; k += 3) {
            const [one, other] = between.map((i) => apart(flat.subarray(k, k + 2), sites[i]));
            near([one], [other], 1e-9);
          }
          // The bisector of two points is one straight line.
          near([apart(flat.subarray(0, 3), flat.subarray(-3))], [path.length], 1e-9);
          const [x, y] = [0, 1].map((axis) => flat[flat.length - 3 + axis] - flat[axis]);
          const [from] = between.map((i) => sites[i]);
          const isLeft = x * (from[1] - flat[1]) - y * (from[0] - flat[0]) > 0;
          assert.ok(isLeft, `the cell of ${between} lies to the left`);
        }
        const positions = await mesh.positions();
        nearest.forEach((site, v) => {
          const distances = sites.map((at) => apart(positions.subarray(3 * v, 3 * v + 2), at));
          near([distances[site]], [Math.min(...distances)], 1e-9);
        });
      }
    }
  });

  test('of points at vertices, with borders along edges, divides a plane evenly', async () => {
    const mesh = engine.meshFromObj(grid(8));
    const points = [
      [2, 2, 0],
      [6, 2, 0],
      [2, 6, 0],
      [6, 6, 0],
    ].map((place) => mesh.nearestPoint(place).point);
    const { areas, cell } = await voronoi(mesh, points);
    for (const area of areas) near([area], [16], 1e-12);
    near([cell(3).perimeter], [16], 1e-12);
    near((await centroid(mesh, cell(3))).position, [6, 6, 0], 1e-9);
  });

  test('of the vertices of an octahedron divides a sphere into six equal cells', async () => {
    const mesh = engine.shape('sphere', 5000);
    const points = [0, 1, 2].flatMap((axis) =>
      [1, -1].map((sign) => mesh.nearestPoint([0, 1, 2].map((k) => (k === axis ? sign : 0))).point),
    );
    const { areas, borders } = await voronoi(mesh, points);
    const area = solidOf({ positions: mesh.positions(), triangles: mesh.triangles() }).area;
    near([sum(areas)], [area], 1e-9 * area);
    // The triangles are not symmetric: distances and areas equal those of the sphere up to the
    // square of the edges.
    for (const own of areas) near([own], [area / 6], 2e-3 * area);
    // The borders are edges of a cube: twelve arcs of length acos(1/3).
    assert.equal(borders.length, 12);
    for (const { path } of borders) near([path.length], [Math.acos(1 / 3)], 2e-2);
  });

  test('of a torus is that of the C++ library (tests/engine/voronoi_test.cpp)', async () => {
    const mesh = engine.shape('torus', 800);
    const sites = [
      [1.4, 0, 0],
      [0, 1.3, 0.2],
      [-0.9, -0.4, -0.3],
      [0.2, -1, 0.4],
    ].map((place) => mesh.nearestPoint(place).point);
    const { areas } = await voronoi(mesh, sites, { solver: 'exact' });
    near(areas, [3.385178194343, 4.176408647218, 4.36023141479, 3.558260310662], 1e-9);
  });

  test('of sites of several points, of equal ones and of separate parts', async () => {
    const far = grid(4).replace(/^v (\S+)/gm, (_, x) => `v ${Number(x) + 100}`);
    const shifted = far.replace(/^f .*$/gm, (line) => line.replace(/\d+/g, (n) => Number(n) + 25));
    const mesh = engine.meshFromObj(grid(4) + shifted);
    const at = (x, y) => mesh.nearestPoint([x, y, 0]).point;
    const { areas, cell, nearest } = await voronoi(mesh, [
      [at(0, 0), at(4, 4)],
      at(2, 2),
      at(2, 2),
    ]);
    near(areas, [4, 12, 0], 1e-9);
    assert.equal(cell(2).boundary().length, 0);
    assert.deepEqual(new Set(nearest.subarray(25)), new Set([-1]));
    assert.throws(() => cell(3), { code: 'badIndex' });
    await assert.rejects(voronoi(mesh, []), { code: 'tooFewPoints' });
    await assert.rejects(voronoi(mesh, [at(0, 0), []]), { code: 'tooFewPoints' });
    await assert.rejects(voronoi(mesh, [at(0, 0)], { sover: 'fast' }), { code: 'badArgument' });
  });
});

describe('the centroid of a density', () => {
  test('on a plane is its center of mass, of the whole and of a cell', async () => {
    const size = 6;
    const text = grid(size);
    for (const mesh of [engine.meshFromObj(text), await remote.meshFromObj(text)]) {
      const positions = await mesh.positions();
      const density = Array.from({ length: positions.length / 3 }, (_, v) => positions[3 * v]);
      // The density is x: its integral is 6³/2, that of x² is 6⁴/3.
      const all = await centroid(mesh, 'all', { density });
      near(all.position, [(2 / 3) * size, size / 2, 0], 1e-6);
      const sites = [];
      for (const place of [
        [2, 3, 0],
        [3, 3, 0],
      ]) {
        sites.push((await mesh.nearestPoint(place)).point);
      }
      const { cell } = await voronoi(mesh, sites);
      // To the left of x = 2.5 the centroid is at 2/3 of that.
      const left = await centroid(mesh, cell(0), { density });
      near(left.position, [(2 / 3) * 2.5, size / 2, 0], 1e-6);
      near((await centroid(mesh, cell(0))).position, [1.25, size / 2, 0], 1e-6);
    }
  });

  test('needs one finite value for each vertex, not all 0', async () => {
    const mesh = engine.meshFromObj(grid(3));
    const rejects = (density) =>
      assert.rejects(centroid(mesh, 'all', { density }), { code: 'badArgument' });
    await rejects([1, 2]);
    await rejects(new Array(16).fill(0));
    await rejects([...new Array(15).fill(1), -1]);
    await rejects([...new Array(15).fill(1), Number.NaN]);
  });
});
