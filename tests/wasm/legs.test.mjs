// The legs of a control polygon stay as they look, whatever edits the curve.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import bunny from 'bunny';
import { load } from 'karcher';

const karcher = await load();
const torus = karcher.shape('torus', 2000);
const start = torus.surfacePoint(5, [0.2, 0.3, 0.5]);
const along = (length) => torus.straightest(start, [0, 0, 1], length).end;
const far = [1, 2].map((i) => torus.surfacePoint(5 + 40 * i, [0.2, 0.3, 0.5]));

function isNear(actual, expected, part, what = '') {
  assert.ok(Math.abs(actual - expected) < part * expected, `${what} ${actual}, not ${expected}`);
}

/** A curve whose last point was dragged far round the tube: the leg to it is long. */
function drawnOut(options) {
  const curve = torus.curve({ points: [...far, start, start], samples: 17, ...options });
  for (let step = 1; step <= 50; step++) curve.dragPoint(3, along(step * 0.05));
  return curve;
}

/** A polyline of two points after a drag by a length of more than one turn round the tube. */
function around(length) {
  const line = torus.curve({ kind: 'polyline', points: [start, start], samples: 9 });
  for (let step = 1; step <= 50; step++) line.dragPoint(1, along((step * length) / 50));
  return line;
}

const lengthOf = (curves) => curves.reduce((sum, curve) => sum + curve.length, 0);
const sameAnew = (curve) =>
  isNear(torus.curve(curve.value()).length, curve.length, 2e-4, 'traced anew');

test('a value with drawn legs closes and opens a curve as its methods do', () => {
  for (const kind of ['polyline', 'bspline']) {
    const byValue = drawnOut({ kind, levels: 3 });
    const byMethod = drawnOut({ kind, levels: 3 });
    for (const closed of [true, false]) {
      byMethod.setClosed(closed);
      byValue.set({ ...byValue.value(), closed });
      assert.deepEqual(byValue.polyline(), byMethod.polyline(), `${kind}, closed: ${closed}`);
    }
  }
});

test('a point inserted in a curve leaves its legs in place', () => {
  // The tolerance is that of curves with levels, whose points become averages of other averages.
  for (const [options, part] of [
    [{ kind: 'polyline' }, 1e-4],
    [{ kind: 'bezier', levels: 3 }, 3e-3],
    [{ kind: 'rational', levels: 3, weights: [1, 2, 0.5, 1] }, 3e-3],
    [{ kind: 'bspline', levels: 3 }, 3e-3],
    [{ kind: 'bspline', levels: 3, degree: 2, knots: 'clamped' }, 3e-3],
    [{ kind: 'bspline', levels: 3, closed: true, weights: [1, 2, 0.5, 1] }, 3e-3],
    [{ kind: 'catmullrom', levels: 3 }, 3e-3],
    [{ kind: 'catmullrom', levels: 3, closed: true }, 3e-3],
  ]) {
    const curve = drawnOut(options);
    const { length, segmentCount } = curve;
    for (const t of [0.3, 0.9]) {
      const more = drawnOut(options);
      more.insertOnCurve(t * segmentCount);
      isNear(more.length, length, part, `${JSON.stringify(options)} at ${t}:`);
      sameAnew(more);
      const parts = curve.split(t * segmentCount);
      isNear(lengthOf(parts), length, part, `${JSON.stringify(options)} cut at ${t}:`);
      for (const cut of parts) sameAnew(cut);
      if (parts.length === 2) {
        const [first, second] = parts;
        isNear(first.join(second).length, length, part, `${JSON.stringify(options)} joined:`);
      }
    }
  }
});

test('joined curves have the legs of both', () => {
  const line = around(2.5);
  isNear(line.length, 2.5, 1e-6);
  const [a, b] = far;
  const other = torus.curve({ kind: 'polyline', points: [a, b] });
  const gap = torus.shortestPath(line.points()[1], a).length;
  isNear(line.join(other).length, 2.5 + gap + other.length, 1e-4);
  const back = torus.shortestPath(b, start).length;
  isNear(other.join(line).length, other.length + back + 2.5, 1e-4);
  const on = torus.curve({ kind: 'polyline', points: [line.points()[1], a] });
  isNear(line.join(on).length, 2.5 + gap, 1e-4);
});

test('unchanged points keep their legs', () => {
  const line = around(2.5);
  line.setPoints(line.points());
  isNear(line.length, 2.5, 1e-6);
  const [a, b] = line.points();
  line.setPoints([a, b, far[0]]);
  isNear(line.length, 2.5 + torus.shortestPath(b, far[0]).length, 1e-6);
  line.setPoints([far[1], a, b, far[0]]);
  line.setPoints([far[0], a, b]);
  line.setPoints([a, b]);
  const shortest = torus.shortestPath(a, b).length;
  isNear(line.length, shortest, 1e-6, 'points that are elsewhere in between:');
});

test('a leg belongs to its two points', () => {
  const [a, b] = [start, along(1)];
  const through = [0.25, 0.5, 0.75].map((part) => along(part * 2.4995));
  const end = along(2.4995);
  const line = () =>
    torus.curve({ kind: 'polyline', points: [start, end, start], legs: [through, null] });
  const there = line()
    .legs()
    .map(({ path }) => path.length);
  assert.ok(there[1] < 0.5 * there[0]);
  const isAs = (curve, expected) => {
    const lengths = curve.legs().map(({ path }) => path.length);
    assert.deepEqual(
      lengths.map((length) => length.toFixed(6)),
      expected.map((length) => length.toFixed(6)),
    );
  };
  const longer = line();
  longer.addPoint(b);
  isAs(longer, [...there, torus.shortestPath(a, b).length]);
  const turned = line();
  turned.reverse();
  isAs(turned, there.toReversed());
  turned.reverse();
  isAs(turned, there);
  // In a closed curve the leg to the first point comes and goes with it.
  const ring = torus.curve({
    kind: 'polyline',
    closed: true,
    points: [end, b, start],
    legs: [null, null, through],
  });
  const [first, second, last] = ring.legs().map(({ path }) => path.length);
  assert.equal(last.toFixed(6), there[0].toFixed(6));
  ring.reverse();
  isAs(ring, [last, second, first]);
  ring.movePointInOrder(0, 2);
  assert.ok(ring.legs().some(({ path }) => path.length.toFixed(6) === last.toFixed(6)));
  ring.setClosed(false);
  ring.setClosed(true);
  assert.ok(ring.length > last);
});

test('a drawn leg is saved as it is, if few points do not suffice to find it', () => {
  const mesh = karcher.meshFromArrays(bunny.positions.flat(), bunny.cells.flat());
  const a = { face: 2339, bary: [0.5204387754201899, 0.06321221590042114, 0.41634900867938995] };
  const b = { face: 557, bary: [0.4276285022497177, 0.07726478576660156, 0.4951067119836807] };
  const direction = [0.23968079686164856, 0.27058303356170654, -0.4263044595718384];
  const line = mesh.curve({ kind: 'polyline', points: [a, b] });
  for (let i = 1; i <= 30; i++) {
    line.dragPoint(1, mesh.straightest(b, direction, i * 0.5 * mesh.info.meanEdge).end);
  }
  const again = mesh.curve(JSON.parse(JSON.stringify(line.value())));
  isNear(again.length, line.length, 2e-4);
  // A link stores two of a point's weights.
  const inShort = ({ face, bary: [, b, c] }) => ({ face, bary: [1 - b - c, b, c] });
  const value = line.value();
  const linked = mesh.curve({ ...value, legs: value.legs.map((leg) => leg.map(inShort)) });
  isNear(linked.length, line.length, 2e-4);
  const twice = mesh.curve(again.value());
  isNear(twice.length, again.length, 2e-4);
  mesh.dispose();
});
