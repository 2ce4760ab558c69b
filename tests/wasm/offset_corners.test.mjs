// Mitred and bevelled offsets on a plane against the equivalent unions of rectangles and tips.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { long, randoms, seed } from '../web/part.mjs';
import { drawingOn, grid } from './meshes.mjs';

const karcher = await load();
const cells = 10;
const mesh = karcher.meshFromObj(grid(cells));
/** The tolerance of areas, relative to the plane's extent squared. */
const tolerance = 1e-9 * cells ** 2;
const outlineOf = drawingOn(mesh, cells);
const drawings = long ? 1000 : 24;

const ringArea = (ring) =>
  ring.reduce((sum, [x, y], i) => {
    const [u, v] = ring[(i + 1) % ring.length];
    return sum + (x * v - u * y) / 2;
  }, 0);

const plus = ([x, y], [u, v], s = 1) => [x + s * u, y + s * v];
const cross = ([x, y], [u, v]) => x * v - y * u;
const dot = ([x, y], [u, v]) => x * u + y * v;
const left = ([x, y]) => [-y, x];

const ways = (corners) =>
  corners.map((from, i) => {
    const [x, y] = plus(corners[(i + 1) % corners.length], from, -1);
    const length = Math.hypot(x, y);
    return [x / length, y / length];
  });

const turns = (corners) => {
  const all = ways(corners);
  return all.map((way, i) => {
    const before = all.at(i - 1);
    return Math.atan2(cross(before, way), dot(before, way));
  });
};

/**
 * Polygons whose union is the set within a distance of a closed polygon, with a kind of corners.
 */
function strips(corners, distance, kind, limit) {
  const count = corners.length;
  const way = ways(corners);
  const turn = turns(corners);
  return corners.flatMap((corner, i) => {
    const next = corners[(i + 1) % count];
    const aside = left(way[i]).map((x) => distance * x);
    const strip = [
      plus(corner, aside, -1),
      plus(next, aside, -1),
      plus(next, aside),
      plus(corner, aside),
    ];
    const before = way.at(i - 1);
    const side = turn[i] > 0 ? -distance : distance;
    const [from, to] = [before, way[i]].map((direction) => plus(corner, left(direction), side));
    const reach = Math.abs(distance * Math.tan(turn[i] / 2));
    const isMitred = kind === 'miter' && 1 / Math.cos(turn[i] / 2) <= limit;
    const tip = [corner, from, ...(isMitred ? [plus(from, before, reach)] : []), to];
    return [strip, tip];
  });
}

/**
 * The area of a union of convex polygons. Between neighboring ends and crossings of sides it is
 * linear in x. (A planar library fails for one in about a hundred of these.)
 */
function unionArea(polygons) {
  const sides = polygons.flatMap((ring) =>
    ring.map((from, i) => [from, ring[(i + 1) % ring.length]]),
  );
  const ends = sides.map(([[x]]) => x);
  for (const [i, [a, b]] of sides.entries()) {
    const d = plus(b, a, -1);
    for (const [c, e] of sides.slice(0, i)) {
      const f = plus(e, c, -1);
      const t = cross(plus(c, a, -1), f) / cross(d, f);
      if (t > 0 && t < 1) ends.push(a[0] + t * d[0]);
    }
  }
  ends.sort((x, y) => x - y);
  let area = 0;
  for (const [i, x] of ends.slice(1).entries()) {
    const width = x - ends[i];
    if (!(width > 0)) continue;
    const middle = x - width / 2;
    const intervals = polygons.flatMap((ring) => {
      const heights = ring.flatMap(([u, v], k) => {
        const [w, z] = ring[(k + 1) % ring.length];
        return u < middle === w < middle ? [] : [v + ((middle - u) / (w - u)) * (z - v)];
      });
      return heights.length === 2 ? [heights.sort((u, v) => u - v)] : [];
    });
    intervals.sort(([u], [v]) => u - v);
    let end = Number.NEGATIVE_INFINITY;
    for (const [low, high] of intervals) {
      area += width * Math.max(high - Math.max(low, end), 0);
      end = Math.max(end, high);
    }
  }
  return area;
}

test('mitred and bevelled offsets have the areas of their unions', () => {
  const random = randoms(seed);
  const next = () => random.next().value;
  let worst = 0;
  let compared = 0;
  for (let drawing = 0; drawing < drawings; drawing++) {
    const count = 3 + Math.floor(5 * next());
    const angles = Array.from({ length: count }, () => 2 * Math.PI * next());
    // Every third outline crosses itself.
    if (drawing % 3 > 0) angles.sort((a, b) => a - b);
    const corners = angles.map((angle) => {
      const radius = 0.4 + 1.6 * next();
      return [5 + radius * Math.cos(angle), 5 + radius * Math.sin(angle)];
    });
    // Smaller turns are rounded.
    if (turns(corners).some((turn) => Math.abs(turn) < 0.064)) continue;
    const distance = 0.05 + 0.6 * next();
    const limit = 1 + 3 * next();
    const outline = outlineOf(corners);
    for (const kind of ['miter', 'bevel']) {
      const told = () =>
        `KARCHER_SEED=${seed}, drawing ${drawing}: ${JSON.stringify({ kind, distance, limit, corners })}`;
      const wanted = unionArea(strips(corners, distance, kind, limit));
      const lines = mesh.offset([outline], { distance, corners: kind, miterLimit: limit });
      const area = lines.reduce((sum, line) => {
        assert.ok(line.closed, told());
        const places = line.polyline({ bits: 64 });
        const ring = Array.from({ length: line.count }, (_, i) => [
          places[3 * i],
          places[3 * i + 1],
        ]);
        return sum + ringArea(ring);
      }, 0);
      const off = Math.abs(area - wanted);
      worst = Math.max(worst, off);
      compared++;
      assert.ok(off < tolerance, `${area}, not ${wanted}: ${told()}`);
    }
  }
  assert.ok(compared > drawings);
  console.log(`${compared} areas, at most ${worst} apart; KARCHER_SEED=${seed}`);
});
