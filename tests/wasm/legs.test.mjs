// The legs of a control polygon stay as they are seen, whatever is done to the curve.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import bunny from 'bunny';
import { load } from 'karcher';

const karcher = await load();
const torus = karcher.shape('torus', 2000);
const start = torus.surfacePoint(5, [0.2, 0.3, 0.5]);
const along = (length) => torus.straightest(start, [0, 0, 1], length).end;

function isNear(actual, expected, part, what = '') {
  assert.ok(Math.abs(actual - expected) < part * expected, `${what} ${actual}, not ${expected}`);
}

test('a leg stays that of its two points', () => {
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
  // Closed: the leg to the first point comes and goes with it.
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

test('what was drawn is what is saved, where few points do not find it again', () => {
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
  // As a link tells points: by two of their weights.
  const inShort = ({ face, bary: [, b, c] }) => ({ face, bary: [1 - b - c, b, c] });
  const value = line.value();
  const linked = mesh.curve({ ...value, legs: value.legs.map((leg) => leg.map(inShort)) });
  isNear(linked.length, line.length, 2e-4);
  const twice = mesh.curve(again.value());
  isNear(twice.length, again.length, 2e-4);
  mesh.dispose();
});
