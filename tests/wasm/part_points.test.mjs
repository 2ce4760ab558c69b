// Points and curves of a surface on the parts that are cut out of it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { load } from 'karcher';
import { solidOf } from 'karcher/checkup';
import { curvesOnPart, meshFile, pointsOnPart } from 'karcher/formats';
import { randoms, seed } from '../web/part.mjs';
import { printed, temporaryFolder } from './run_cli.mjs';

const engine = await load();
console.log(`drawn with KARCHER_SEED=${seed}`);
const random = randoms(seed);
const next = () => random.next().value;
const folder = temporaryFolder();
after(() => folder.remove());

const whole = (mesh) => ({ positions: mesh.positions(), triangles: mesh.triangles() });
const far = (p, q) => Math.hypot(...p.map((x, k) => x - q[k]));
const placeOn = ({ positions, triangles }, { face, bary }) =>
  [0, 1, 2].map((axis) =>
    bary.reduce((sum, w, k) => sum + w * positions[3 * triangles[3 * face + k] + axis], 0),
  );
const anyPoint = (mesh) => {
  const [a, b] = [next(), next()].toSorted();
  return { face: Math.floor(next() * mesh.info.triangles), bary: [a, b - a, 1 - b] };
};
/** A closed curve around a point of the surface. */
function loop(mesh, at) {
  const ways = Array.from({ length: 7 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 7;
    const radius = (0.08 + 0.08 * next()) * mesh.info.diagonal;
    return [radius * Math.cos(angle), radius * Math.sin(angle), radius * Math.sin(angle + 1)];
  });
  const { points } = mesh.expMap(at, ways);
  const curve = mesh.curve({ kind: 'catmullrom', closed: true, points });
  const path = curve.path();
  curve.dispose();
  return path;
}

test('each point of a surface lies in one part of its cuts, at the same place', () => {
  for (const name of ['sphere', 'torus', 'openSheet']) {
    const mesh = engine.shape(name, 2000);
    const surface = whole(mesh);
    const paths = [0, 1, 2].map(() => loop(mesh, anyPoint(mesh)));
    const parts = mesh.cut(paths);
    assert.ok(parts.length > 1);
    const points = Array.from({ length: 500 }, () => anyPoint(mesh));
    const found = parts.map((part) => pointsOnPart(part, surface, points));
    points.forEach((point, i) => {
      const on = found.flatMap((all, part) => (all[i] ? [{ part, point: all[i] }] : []));
      assert.equal(on.length, 1, `point ${i} of ${name} is in ${on.length} parts`);
      const place = placeOn(parts[on[0].part], on[0].point);
      const apart = far(place, placeOn(surface, point));
      assert.ok(apart < 1e-12 * mesh.info.diagonal, `${apart}`);
      const sum = on[0].point.bary.reduce((total, weight) => total + weight, 0);
      assert.ok(Math.abs(sum - 1) < 1e-12 && Math.min(...on[0].point.bary) >= 0);
    });
    mesh.dispose();
  }
});

test('points of a cut lie on the parts on both of its sides, also where it runs along edges', () => {
  const mesh = engine.shape('sphere', 500);
  const surface = whole(mesh);
  const onBoth = (path, points) => {
    const parts = mesh.cut([path]);
    assert.equal(parts.length, 2);
    for (const part of parts) {
      pointsOnPart(part, surface, points).forEach((point, i) => {
        assert.ok(point, `point ${i}`);
        const apart = far(placeOn(part, point), placeOn(surface, points[i]));
        assert.ok(apart < 1e-9 * mesh.info.diagonal, `${apart}`);
      });
    }
  };
  const path = loop(mesh, anyPoint(mesh));
  onBoth(path, path.points());
  // The edges around a vertex; each side of the cut has only the faces on it.
  const ring = [];
  for (let i = 0; i < surface.triangles.length; i += 3) {
    const corners = [...surface.triangles.subarray(i, i + 3)];
    const k = corners.indexOf(17);
    if (k >= 0) ring.push([corners[(k + 1) % 3], corners[(k + 2) % 3]]);
  }
  const around = [ring[0][0]];
  while (around.length <= ring.length)
    around.push(ring.find(([from]) => from === around.at(-1))[1]);
  const vertices = around.map((vertex) => ({ vertex }));
  const surfaced = around.slice(1).map((vertex) => {
    const place = [...surface.positions.subarray(3 * vertex, 3 * vertex + 3)];
    return mesh.nearestPoint(place).point;
  });
  onBoth(vertices, surfaced);
  mesh.dispose();
});

test('the pieces of a curve on the parts add up to the curve', () => {
  const mesh = engine.shape('torus', 1500);
  const surface = whole(mesh);
  const at = anyPoint(mesh);
  const opposite = mesh.nearestPoint(placeOn(surface, at).map((x) => -x)).point;
  const [cut, across] = [loop(mesh, at), mesh.shortestPath(at, opposite)];
  // The curve gets a point wherever it crosses the cut, so that its pieces end there.
  const parts = mesh.cut([cut]);
  const names = parts.map((part) => {
    const pieces = curvesOnPart(part, surface, [{ name: 'cut', path: cut }]);
    assert.equal(pieces.length, 1);
    assert.equal(pieces[0].path.closed, true);
    assert.deepEqual(pieces[0].path.polyline({ bits: 64 }), cut.polyline({ bits: 64 }));
    assert.equal(pieces[0].path.lengths().at(-1), cut.length);
    const text = new TextDecoder().decode(meshFile({ ...part, curves: pieces }, 'obj'));
    assert.match(text, /^l 1?\d+/m);
    return pieces[0].name;
  });
  assert.deepEqual(names, ['cut', 'cut']);
  const pieces = parts.flatMap((part) => curvesOnPart(part, surface, [{ path: across }]));
  assert.ok(pieces.length >= 2);
  const counted = pieces.reduce((sum, { path }) => sum + path.count, 0);
  assert.equal(counted, across.count);
  for (const { path } of pieces) {
    assert.equal(path.lengths()[0], 0);
    assert.equal(path.polyline({ bits: 64 }).length, 3 * path.count);
    assert.equal(path.closed, false);
  }
  mesh.dispose();
});

test('a line between two points of a border lies on the part through which it runs', () => {
  const surface = { positions: [0, 0, 0, 10, 0, 0, 0, 10, 0], triangles: [0, 1, 2] };
  const mesh = engine.meshFromArrays(surface.positions, surface.triangles);
  const at = (x, y) => ({ face: 0, bary: [1 - (x + y) / 10, x / 10, y / 10] });
  // A rectangle with a notch.
  const outline = [
    ...[at(1, 1), at(4, 1), at(4, 2), at(2, 2), at(2, 3), at(4, 3)],
    ...[at(4, 4), at(1, 4), at(1, 1)],
  ];
  const [inner, outer] = mesh.cut([outline]).sort((a, b) => solidOf(a).area - solidOf(b).area);
  assert.ok(Math.abs(solidOf(inner).area - 7) < 1e-9);
  const counts = (path) =>
    [inner, outer].map((part) =>
      curvesOnPart(part, surface, [{ path }]).map((piece) => piece.path.count),
    );
  const line = (from, to) => mesh.shortestPath(from, to);
  assert.deepEqual(counts(line(at(4, 2), at(4, 3))), [[], [2]], 'across the notch');
  assert.deepEqual(counts(line(at(4, 1), at(4, 2))), [[2], [2]], 'along the border');
  assert.deepEqual(counts(line(at(2, 2), at(1, 4))), [[2], []], 'inside');
  assert.deepEqual(counts(line(at(3, 1.5), at(3, 2.5))), [[], []], 'it crosses the border');
  mesh.dispose();
});

test('a line that leaves a part and comes back within a face belongs to no part', () => {
  const surface = { positions: [0, 0, 0, 10, 0, 0, 0, 10, 0], triangles: [0, 1, 2] };
  const mesh = engine.meshFromArrays(surface.positions, surface.triangles);
  const at = ([x, y]) => ({ face: 0, bary: [1 - (x + y) / 10, x / 10, y / 10] });
  const corners = [
    [1, 1],
    [2, 1],
    [1, 2],
  ];
  const outline = [...corners, corners[0]].map(at);
  const [inner, outer] = mesh.cut([outline]).sort((a, b) => solidOf(a).area - solidOf(b).area);
  const counts = (from, to) => {
    const path = mesh.shortestPath(at(from), at(to));
    return [inner, outer].map((part) => curvesOnPart(part, surface, [{ path }]).length);
  };
  assert.deepEqual(counts([0, 1.3], [8.7, 1.3]), [0, 0], 'through the triangle');
  assert.deepEqual(counts([0, 0.5], [9, 0.5]), [0, 1], 'beside it');
  assert.deepEqual(counts([0, 1], [9, 1]), [0, 1], 'along its side');
  assert.deepEqual(counts([0, 3], [3, 0]), [0, 1], 'along its long side');
  assert.deepEqual(counts([1, 1], [1.5, 1.5]), [1, 0], 'inside');
  // The open triangle has a place of the segment if the line cuts it between other lines.
  const enters = (p, q) => {
    let [low, high] = [0, 1];
    for (const inside of [([x]) => x - 1, ([, y]) => y - 1, ([x, y]) => 3 - x - y]) {
      const [start, end] = [inside(p), inside(q)];
      if (start <= 0 && end <= 0) return false;
      if (start < 0) low = Math.max(low, start / (start - end));
      if (end < 0) high = Math.min(high, start / (start - end));
    }
    return low < high;
  };
  const border = () => {
    const t = 10 * next();
    return [
      [0, t],
      [t, 0],
      [t, 10 - t],
    ][Math.floor(3 * next())];
  };
  for (let i = 0; i < 200; i++) {
    const [p, q] = [border(), border()];
    assert.deepEqual(counts(p, q), [0, enters(p, q) ? 0 : 1], `from ${p} to ${q}`);
  }
  mesh.dispose();
});

test('karcher cut writes the curves along with the parts that they border', async () => {
  const mesh = engine.shape('sphere', 500);
  const name = folder.write('sphere.ply', meshFile(whole(mesh), 'ply'));
  const points = loop(mesh, anyPoint(mesh)).points();
  const curve = folder.write(
    'curve.json',
    JSON.stringify({
      kind: 'polyline',
      closed: true,
      points: points.filter((_, i) => i % 9 === 0),
    }),
  );
  const out = join(folder.path, 'part.obj');
  const more = ['--samples', '8', '--with-curves'];
  const { parts } = await printed('cut', name, '--curve', curve, '--out', out, ...more);
  assert.equal(parts.length, 2);
  const [one, other] = parts.map(({ file }) => readFileSync(file, 'utf8').split('\n'));
  for (const lines of [one, other]) {
    assert.equal(lines.filter((line) => line.startsWith('l ')).length, 1);
    assert.ok(lines.includes('o curve 1'));
  }
});
