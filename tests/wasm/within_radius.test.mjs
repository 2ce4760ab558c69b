// Distances and log maps up to a radius, and points carried to a finer mesh.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { KarcherError, load } from 'karcher';
import { randomFrom, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';

const karcher = await load();

const norm = (a) => Math.hypot(...a);
const minus = (a, b) => a.map((value, i) => value - b[i]);
const triple = (numbers, i) => [...numbers.slice(3 * i, 3 * i + 3)];

const drawn = (name) => {
  console.log(`${name}: drawn with KARCHER_SEED=${seed}`);
  return randomFrom(seed);
};

const somewhere = (mesh, random) => {
  const [u, v] = [random(), random()];
  const [a, b] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
  return { face: Math.floor(random() * mesh.info.triangles), bary: [1 - a - b, a, b] };
};

test('up to a radius distances and log vectors are those of the whole mesh, and NaN beyond', () => {
  const random = drawn('a radius');
  for (const shape of ['sphere', 'torus', 'openSheet']) {
    const mesh = karcher.shape(shape, 1500);
    const from = [somewhere(mesh, random), { vertex: 30 }];
    const radius = (0.05 + 0.2 * random()) * mesh.info.diagonal;
    for (const solver of ['exact', 'fast', 'graph']) {
      const all = mesh.distance(from, { solver });
      const near = mesh.distance(from, { solver, radius });
      assert.deepEqual(
        near,
        all.map((far) => (far <= radius ? far : Number.NaN)),
      );
      assert.ok(near.some(Number.isNaN) && !near.every(Number.isNaN));
      assert.deepEqual(mesh.distance(from, { solver, radius: Infinity }), all);
    }
    const { vectors: all } = mesh.logMap(from[0]);
    const { vectors: near } = mesh.logMap(from[0], { radius });
    const fast = mesh.distance(from[0], { solver: 'fast' });
    const wanted = all.map((value, i) => (fast[Math.floor(i / 3)] <= radius ? value : Number.NaN));
    assert.deepEqual(near, wanted);
    assert.deepEqual(mesh.logMap(from[0], {}).vectors, all);
  }
});

test('a radius is a positive number, and the only option of a log map', () => {
  const mesh = karcher.shape('torus', 500);
  for (const radius of [0, -1, Number.NaN, '1']) {
    assert.throws(() => mesh.distance({ vertex: 0 }, { radius }), KarcherError);
    assert.throws(() => mesh.logMap({ vertex: 0 }, { radius }), KarcherError);
  }
  assert.throws(() => mesh.logMap({ vertex: 0 }, { solver: 'exact' }), KarcherError);
  assert.throws(() => mesh.logMap({ vertex: 0 }, { radius: 1 }, [1, 0, 0]), KarcherError);
});

test('points are carried to the same place of a finer plane, level by level', () => {
  const random = drawn('carried points');
  const plane = karcher.meshFromObj(grid(12));
  const torus = karcher.shape('torus', 500);
  for (const levels of [1, 2, 3]) {
    const finer = plane.subdivide(levels);
    // Loop's rule keeps the places of a regular grid away from its boundary.
    const inside = Array.from({ length: 200 }, () => somewhere(plane, random)).filter((point) =>
      plane.position(point).every((value, k) => k === 2 || (value > 3 && value < 9)),
    );
    assert.ok(inside.length > 10);
    plane.carried(inside, levels).forEach((point, i) => {
      const off = minus(finer.position(point), plane.position(inside[i]));
      assert.ok(norm(off) < 1e-13, `${off}`);
    });
    finer.dispose();
    const fine = torus.subdivide(levels);
    if (levels > 1) {
      // The same as one level after the other.
      const half = torus.subdivide(levels - 1);
      const whole = half.subdivide(1);
      for (let i = 0; i < 50; i++) {
        const point = somewhere(torus, random);
        const steps = half.carried(torus.carried([point], levels - 1), 1);
        const [place] = torus.carried([point], levels).map((one) => fine.position(one));
        assert.ok(norm(minus(whole.position(steps[0]), place)) < 1e-13);
      }
    }
    // A point of an edge has the same place from both of its faces.
    const [triangles, part] = [torus.triangles(), random()];
    const edges = new Map();
    for (let corner = 0; corner < triangles.length; corner++) {
      const face = Math.floor(corner / 3);
      const next = 3 * face + ((corner + 1) % 3);
      const [from, to] = [triangles[corner], triangles[next]];
      const bary = [0, 0, 0];
      bary[corner % 3] = from < to ? part : 1 - part;
      bary[next % 3] = 1 - bary[corner % 3];
      const key = [from, to].sort((a, b) => a - b).join();
      const [point] = torus.carried([{ face, bary }], levels);
      const place = fine.position(point);
      if (edges.has(key)) assert.ok(norm(minus(place, edges.get(key))) < 1e-13);
      else edges.set(key, place);
    }
    fine.dispose();
  }
  assert.throws(() => torus.carried([{ vertex: 0 }], 7), KarcherError);
});

test('vertices are carried to where the rule of Loop moves them', () => {
  const torus = karcher.shape('torus', 500);
  const fine = torus.subdivide(1);
  const [positions, triangles] = [torus.positions(), torus.triangles()];
  const neighbours = Array.from({ length: torus.info.vertices }, () => new Set());
  triangles.forEach((v, corner) => {
    const face = 3 * Math.floor(corner / 3);
    for (const other of triangles.slice(face, face + 3)) if (other !== v) neighbours[v].add(other);
  });
  neighbours.forEach((around, vertex) => {
    const weight =
      (0.625 - (0.375 + 0.25 * Math.cos((2 * Math.PI) / around.size)) ** 2) / around.size;
    const place = triple(positions, vertex).map((x, k) => {
      const sum = [...around].reduce((all, other) => all + positions[3 * other + k], 0);
      return (1 - around.size * weight) * x + weight * sum;
    });
    const [point] = torus.carried([{ vertex }], 1);
    assert.ok(norm(minus(fine.position(point), place)) < 1e-14);
  });
});
