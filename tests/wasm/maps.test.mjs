// Log and exp maps, parallel transport, and mirroring in a geodesic.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { Vector3 } from 'three';
import { randomFrom, seed } from '../web/part.mjs';
import { grid } from './meshes.mjs';

const karcher = await load();

const add = (a, b) => a.map((value, i) => value + b[i]);
const minus = (a, b) => a.map((value, i) => value - b[i]);
const norm = (a) => Math.hypot(...a);
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const triples = (numbers) =>
  Array.from({ length: numbers.length / 3 }, (_, i) => [...numbers.slice(3 * i, 3 * i + 3)]);

const drawn = (name) => {
  console.log(`${name}: drawn with KARCHER_SEED=${seed}`);
  return randomFrom(seed);
};

const somewhere = (mesh, random) => {
  const [u, v] = [random(), random()];
  const [a, b] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
  return { face: Math.floor(random() * mesh.info.triangles), bary: [1 - a - b, a, b] };
};

/**
 * The largest turn, by rounding, of the direction in which a path of the plane grid leaves a point.
 * The ends of its first piece have a few roundings of coordinates up to 12. The piece may be as
 * short as the point's distance from an edge of its face, whose least height is the root of a half.
 */
const turnAt = ({ bary }) => (8 * Number.EPSILON * 12) / (Math.min(...bary) * Math.SQRT1_2);

test('on a plane the maps are differences and sums, and nothing turns', () => {
  const random = drawn('a plane');
  const mesh = karcher.meshFromObj(grid(12));
  const points = Array.from({ length: 40 }, () => somewhere(mesh, random));
  const directions = points.flatMap(() => [random() - 0.5, random() - 0.5, 0]);
  const from = somewhere(mesh, random);
  const to = somewhere(mesh, random);
  const log = mesh.logMap(from, points, directions);
  const here = mesh.position(from);
  // The rounding of the sum of a path's pieces, some 30 of them.
  const sums = 1e-13;
  const off = triples(log.vectors).map((vector) => sums + turnAt(from) * norm(vector));
  const turned = points.map((point) => sums + turnAt(from) + turnAt(point));
  const given = triples(directions);
  for (const [i, vector] of triples(log.vectors).entries()) {
    assert.ok(norm(minus(add(here, vector), mesh.position(points[i]))) < off[i]);
  }
  for (const [i, direction] of triples(log.directions).entries()) {
    assert.ok(norm(minus(direction, given[i])) < turned[i]);
  }
  const carried = mesh.transport(from, to, log.vectors);
  for (const [i, vector] of triples(log.vectors).entries()) {
    const bound = off[i] + turnAt(to) * norm(vector);
    assert.ok(norm(minus([...carried.slice(3 * i, 3 * i + 3)], vector)) < bound);
  }
  const back = mesh.expMap(from, log.vectors, log.directions);
  for (const [i, point] of back.points.entries()) {
    assert.ok(norm(minus(mesh.position(point), mesh.position(points[i]))) < 2 * off[i]);
  }
  for (const [i, direction] of triples(back.directions).entries()) {
    assert.ok(norm(minus(direction, given[i])) < 2 * turned[i]);
  }
  for (const [i, left] of back.remaining.entries()) assert.ok(left < 2 * off[i]);
});

test('on a tube the log map of all vertices has the directions of its unrolled strips', () => {
  const [sides, rings, height] = [40, 60, 12];
  const side = 2 * Math.sin(Math.PI / sides);
  const [positions, triangles] = [[], []];
  for (let row = 0; row <= rings; row++) {
    for (let i = 0; i < sides; i++) {
      const angle = (2 * Math.PI * i) / sides;
      positions.push(Math.cos(angle), Math.sin(angle), (height * row) / rings);
      const [a, b] = [row * sides + i, row * sides + ((i + 1) % sides)];
      if (row < rings) triangles.push(a, b, b + sides, a, b + sides, a + sides);
    }
  }
  const tube = karcher.meshFromArrays(positions, triangles);
  const row = 20;
  const vectors = triples(tube.logMap({ vertex: row * sides }).vectors);
  // No more than 12 of 40 strips away, the path round the other side is longer.
  for (let there = 2; there < rings - 2; there++) {
    for (let i = -12; i <= 12; i++) {
      const up = (height * (there - row)) / rings;
      const [x, y, z] = vectors[there * sides + ((i + sides) % sides)];
      // Across the edge at the source, the plane of the vectors is that of one strip or of the
      // other, unfolded.
      const across = Math.sign(i) * Math.hypot(x, y);
      assert.ok(Math.hypot(z - up, across - side * i) < 1e-12, `${i}, ${there}`);
    }
  }
  tube.dispose();
});

test('vectors are a flat array, triples, or objects with x, y and z', () => {
  const mesh = karcher.shape('torus', 500);
  const [from, to, third] = [3, 40, 77].map((vertex) => ({ vertex }));
  const flat = [0.1, 0.2, 0.3, -0.2, 0.1, 0];
  const inTriples = triples(flat);
  const named = inTriples.map(([x, y, z]) => ({ x, y, z }));
  const typed = inTriples.map((triple) => Float64Array.from(triple));
  for (const given of [Float64Array.from(flat), inTriples, named, typed]) {
    assert.deepEqual(mesh.expMap(from, given, given), mesh.expMap(from, flat, flat));
    assert.deepEqual(mesh.transport(from, to, given), mesh.transport(from, to, flat));
    assert.deepEqual(mesh.logMap(from, [to, third], given), mesh.logMap(from, [to, third], flat));
    const line = mesh.shortestPath(from, to).points();
    assert.deepEqual(
      mesh.mirror(line, line.slice(1, 3), given),
      mesh.mirror(line, line.slice(1, 3), flat),
    );
  }
  // A vector of three.js has a method `length`.
  for (const one of [named[0], new Vector3(...inTriples[0])]) {
    assert.deepEqual(mesh.expMap(from, one), mesh.expMap(from, inTriples[0]));
  }
  const bad = { code: 'badArgument' };
  for (const [wrong, message] of [
    [
      [
        [1, 2, 3],
        [1, 2],
      ],
      /entry 1 of the vectors must be 3 numbers, not 2/,
    ],
    [[{ x: 1, y: 2 }], /must be a number, not undefined/],
    [[{ x: 1, y: 2, z: 3 }, 4], /entry 1 of the vectors must be an array of numbers, not 4/],
    [[1, 2, { x: 1, y: 2, z: 3 }], /entry 2 of the vectors must be a number/],
    [{}, /the vectors must be an array/],
    [null, /the vectors must be an array/],
    ['abc', /the vectors must be an array/],
  ]) {
    assert.throws(() => mesh.expMap(from, wrong), { ...bad, message });
  }
  const infinite = [[0, 0, 0], { x: 0, y: Infinity, z: 0 }];
  assert.throws(() => mesh.expMap(from, infinite), { code: 'notFinite', message: /entry 1/ });
});

test('a geodesic that meets the boundary reports its remaining length', () => {
  const mesh = karcher.meshFromObj(grid(4));
  const from = { face: 0, bary: [0.5, 0.25, 0.25] };
  const { points, remaining } = mesh.expMap(from, [-2, 0, 0, 0, 1, 0]);
  assert.ok(Math.abs(remaining[0] - 1.5) < 1e-12 && remaining[1] < 1e-12);
  assert.ok(Math.abs(mesh.position(points[0])[0]) < 1e-12);
});

/** Moves points along from p to q: log map, transport, exp map. */
function moved(mesh, points, directions, p, q) {
  const log = mesh.logMap(p, points, directions);
  return mesh.expMap(q, mesh.transport(p, q, log.vectors), mesh.transport(p, q, log.directions));
}

for (const [shape, triangles] of [
  ['sphere', 20000],
  ['torus', 20000],
]) {
  test(`two opposite moves on a ${shape} restore points where the maps are one-to-one`, () => {
    const random = drawn(shape);
    const mesh = karcher.shape(shape, triangles);
    const { diagonal } = mesh.info;
    let restored = 0;
    let oneToOne = 0;
    let all = 0;
    let worst = 0;
    for (let i = 0; i < 30; i++) {
      const p = somewhere(mesh, random);
      const around = (radius) => {
        const angle = 2 * Math.PI * random();
        // Any two directions suffice if they are not both parallel to the normal of the face.
        return [Math.cos(angle), Math.sin(angle), 0.3].map((value) => value * radius);
      };
      const spots = Array.from({ length: 12 }, () => around(0.12 * diagonal * random()));
      const points = mesh.expMap(p, spots.flat()).points;
      const ways = mesh.expMap(p, spots.flat(), spots.flat()).directions;
      const q = mesh.expMap(p, around(0.15 * diagonal)).points[0];
      const there = moved(mesh, points, ways, p, q);
      const back = moved(mesh, there.points, there.directions, q, p);
      // The map is one-to-one there if the path to the new place is the geodesic that led there.
      const wanted = triples(mesh.transport(p, q, mesh.logMap(p, points).vectors));
      const found = triples(mesh.logMap(q, there.points).vectors);
      for (const [j, point] of points.entries()) {
        all++;
        const away = norm(minus(mesh.position(back.points[j]), mesh.position(point))) / diagonal;
        const turned = norm(
          minus([...back.directions.slice(3 * j, 3 * j + 3)], [...ways.slice(3 * j, 3 * j + 3)]),
        );
        const isRestored = away < 1e-9 && turned < 1e-7;
        if (isRestored) restored++;
        if (norm(minus(wanted[j], found[j])) > 1e-9 * diagonal) continue;
        // The return is the same: the first path found is the one on which the return ends.
        const again = mesh.expMap(p, mesh.logMap(p, [point]).vectors).points[0];
        if (norm(minus(mesh.position(again), mesh.position(point))) > 1e-10 * diagonal) continue;
        oneToOne++;
        worst = Math.max(worst, away);
        assert.ok(isRestored, `point ${j} of drawing ${i} is ${away} off, its direction ${turned}`);
      }
    }
    console.log(
      `${shape}: one-to-one at ${oneToOne} of ${all} points, restored ${restored}; the worst of these ${worst.toExponential(1)} of the diagonal off`,
    );
    assert.ok(oneToOne > 0.7 * all);
  });
}

test('a vector carried round an octant of a sphere turns by a right angle', () => {
  const mesh = karcher.shape('sphere', 20000);
  // Three points a quarter of a great circle apart.
  const positions = mesh.positions();
  const nearest = (target) => {
    let best = 0;
    for (let v = 0; v < positions.length / 3; v++) {
      const at = (w) => norm(minus([...positions.slice(3 * w, 3 * w + 3)], target));
      if (at(v) < at(best)) best = v;
    }
    return best;
  };
  const corners = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ].map((corner) => {
    const vertex = nearest(corner);
    const face = mesh.triangles().indexOf(vertex);
    const bary = [0.2, 0.2, 0.2];
    bary[face % 3] = 0.6;
    return { face: Math.floor(face / 3), bary };
  });
  const start = mesh.logMap(corners[0], [corners[1]]).vectors;
  let vector = start;
  for (const i of [0, 1, 2]) vector = mesh.transport(corners[i], corners[(i + 1) % 3], vector);
  assert.ok(Math.abs(norm([...vector]) - norm([...start])) < 1e-12);
  const cosine = dot([...vector], [...start]) / dot([...start], [...start]);
  // The corners differ from the octant's by up to an edge, and the curvature is concentrated in the
  // vertices.
  assert.ok(Math.abs(cosine) < 0.03, `${cosine}`);
});

test('on a plane the mirror image is the reflection, and mirroring twice restores a point', () => {
  const random = drawn('mirrors');
  const mesh = karcher.meshFromObj(grid(12));
  const path = mesh.shortestPath({ vertex: 0 }, { vertex: 168 });
  const [a, b] = [mesh.position({ vertex: 0 }), mesh.position({ vertex: 168 })];
  const along = minus(b, a).map((value) => value / norm(minus(b, a)));
  const points = Array.from({ length: 30 }, () => somewhere(mesh, random));
  const directions = points.flatMap(() => [random() - 0.5, random() - 0.5, 0]);
  const reflected = (v) => along.map((value, i) => 2 * dot(v, along) * value - v[i]);
  const image = mesh.mirror(path.points(), points, directions);
  for (const [i, point] of points.entries()) {
    const wanted = add(a, reflected(minus(mesh.position(point), a)));
    assert.ok(norm(minus(mesh.position(image.points[i]), wanted)) < 1e-9, `${i}`);
    const way = reflected(directions.slice(3 * i, 3 * i + 3));
    assert.ok(norm(minus([...image.directions.slice(3 * i, 3 * i + 3)], way)) < 1e-9);
  }
  const twice = mesh.mirror(path.points(), image.points, image.directions);
  for (const [i, point] of points.entries()) {
    assert.ok(norm(minus(mesh.position(twice.points[i]), mesh.position(point))) < 1e-9);
  }
});

test('on a sphere the mirror image lies equally far from the line, on the other side', () => {
  const random = drawn('mirrors on a sphere');
  const mesh = karcher.shape('sphere', 20000);
  const p = somewhere(mesh, random);
  const line = [0.9, -0.9].map(
    (length) => mesh.straightest(p, [length, 0.3 * length, 0.2 * length], 1).path,
  );
  const points = [...line[0].points().toReversed(), ...line[1].points().slice(1)];
  const spots = mesh.expMap(p, [0.1, 0.2, 0.1, -0.2, 0.3, -0.1, 0.3, -0.2, 0.2]).points;
  const { points: images } = mesh.mirror(points, spots);
  // The line is nearly a great circle, in a plane through the middle.
  const [a, b] = [mesh.position(p), mesh.position(line[0].points().at(-1))];
  const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const length = norm(normal);
  for (const [i, spot] of spots.entries()) {
    const height = dot(mesh.position(spot), normal) / length;
    const wanted = mesh.position(spot).map((value, k) => value - (2 * height * normal[k]) / length);
    const off = norm(minus(mesh.position(images[i]), wanted));
    assert.ok(off < 0.02, `image ${i} is ${off} off`);
  }
});

test('invalid lines, directions and vectors are reported', () => {
  const mesh = karcher.meshFromObj(grid(12));
  const [p, q] = [{ vertex: 0 }, { vertex: 50 }];
  const bad = { code: 'badArgument' };
  assert.throws(() => mesh.logMap(p, [q], [1, 0]), bad);
  assert.throws(() => mesh.logMap(p, [q, q], [1, 0, 0]), {
    ...bad,
    message: /a direction a point/,
  });
  assert.throws(() => mesh.expMap(p, [1, Number.NaN, 0]), { code: 'notFinite' });
  assert.throws(() => mesh.mirror([p], [q]), bad);
  assert.throws(() => mesh.mirror([p, { vertex: 168 }], [q]), {
    ...bad,
    message: /no face in common/,
  });
  assert.throws(() => mesh.mirror([p, p], [q]), { ...bad, message: /must have a length/ });
  assert.throws(() => mesh.mirror([p, { vertex: 1 }], [{ vertex: 160 }]), {
    ...bad,
    message: /no perpendicular/,
  });
  const two = karcher.meshFromObj(
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n',
  );
  assert.throws(() => two.logMap({ vertex: 0 }, [{ vertex: 4 }]), { code: 'unreachable' });
  assert.throws(() => two.transport({ vertex: 0 }, { vertex: 4 }, []), { code: 'unreachable' });
});
