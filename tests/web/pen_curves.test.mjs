// Curves of the pen against cubic Bézier curves of the plane, and their smoothness on other
// surfaces.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { arraysOfShape, openPage } from './engine_in_node.mjs';
import { load } from './figures.mjs';
import { randoms, seed } from './part.mjs';
import {
  bernstein,
  drawPen,
  far,
  placeOn,
  pointAt,
  roughPlane,
  segmentsOf,
  vector,
} from './pen_plane.mjs';

const angleBetween = (a, b) => {
  const cosine = a.reduce((sum, value, axis) => sum + value * b[axis], 0);
  return (Math.acos(Math.min(1, cosine / (Math.hypot(...a) * Math.hypot(...b)))) * 180) / Math.PI;
};

describe('curves of the pen', () => {
  const numbers = randoms(seed);
  const random = () => numbers.next().value;
  let plane;
  const arrays = roughPlane(12, random);
  const placeOf = placeOn(arrays);
  before(async () => {
    plane = await openPage(arrays);
  });

  function worstOffPlane({ curve }, segments) {
    const { count, segment, t, position } = curve.samples;
    let worst = 0;
    for (let i = 0; i < count; i++) {
      const control = segments[segment[i]];
      const weights = bernstein(t[i]);
      const expected = [0, 1, 2].map((axis) =>
        weights.reduce((sum, weight, k) => sum + weight * control[k][axis], 0),
      );
      worst = Math.max(worst, far(Array.from(position.subarray(3 * i, 3 * i + 3)), expected));
    }
    return worst;
  }

  const spots = [
    [0.2, 0.3],
    [0.4, 0.7],
    [0.6, 0.35],
    [0.8, 0.6],
  ];

  async function anchors(page) {
    const places = await Promise.all(spots.map(([x, y]) => pointAt(page, arrays, x, y)));
    const size = () => 0.02 + 0.1 * random();
    const handle = await pointAt(page, arrays, 0.7, 0.5);
    return [
      { ...places[0], tangents: { after: vector(size(), size()) } },
      { ...places[1], tangents: { after: vector(size(), -size()), before: { length: size() } } },
      { ...places[2], tangents: { after: handle, before: { length: null } } },
      { ...places[3], tangents: { before: vector(-size(), size()), after: vector(size(), 0.01) } },
    ];
  }

  for (const closed of [false, true]) {
    test(`are cubic Bézier curves on a plane, ${closed ? 'closed' : 'open'}`, async (t) => {
      const points = await anchors(plane);
      const view = await drawPen(plane, points, { closed });
      assert.equal(view.problem, null);
      const segments = segmentsOf(arrays, points, closed);
      assert.equal(new Set(view.curve.samples.segment).size, segments.length);
      const off = worstOffPlane(view, segments);
      t.diagnostic(`farthest from the planar cubic: ${off.toExponential(1)} of the side`);
      assert.ok(off <= 1e-9, `${off}`);
    });
  }

  test('of corners alone are straight, and a single anchor has none', async () => {
    const places = await Promise.all(spots.map(([x, y]) => pointAt(plane, arrays, x, y)));
    const { curve } = await drawPen(plane, places);
    const length = spots.slice(1).reduce((sum, spot, i) => sum + far(spot, spots[i]), 0);
    assert.ok(Math.abs(curve.length - length) <= 1e-9, `${curve.length} ${length}`);
    assert.equal((await drawPen(plane, places.slice(0, 1))).curve, null);
  });

  test('keep their shape on a plane when an anchor is inserted', async () => {
    const points = await anchors(plane);
    const before = await drawPen(plane, points);
    const { position, segment } = before.curve.samples;
    const half = segment.indexOf(1) + Math.floor(segment.filter((one) => one === 1).length / 3);
    const near = Array.from(position.subarray(3 * half, 3 * half + 3));
    await plane.edits.atCurve('insert', near);
    const after = await plane.settled();
    const { points: more } = plane.editor.state.figure;
    assert.equal(more.length, 5);
    assert.equal(plane.editor.state.selection, 2);
    assert.ok(far(placeOf(more[2]), near) < 1e-9);
    const old = segmentsOf(arrays, points, false)[1];
    const places = Array.from({ length: 200 }, (_, i) =>
      [0, 1, 2].map((axis) =>
        bernstein(i / 199).reduce((sum, weight, k) => sum + weight * old[k][axis], 0),
      ),
    );
    // The two halves run where the whole curve ran.
    const line = after.curve.samples.position;
    for (const place of places) {
      let least = Infinity;
      for (let i = 0; i < line.length; i += 3) {
        least = Math.min(least, far(place, Array.from(line.subarray(i, i + 3))));
      }
      assert.ok(least < 3e-3, `${least}: samples are as far apart`);
    }
    // The halves have other chords than the whole.
    assert.ok(Math.abs(after.curve.length / before.curve.length - 1) < 1e-4);
    plane.editor.undo();
    assert.deepEqual(plane.editor.state.figure.points, points);
  });

  test('have their last segment at their end', async () => {
    const points = await anchors(plane);
    const { tangents, curve } = await drawPen(plane, points);
    const { figure } = plane.editor.state;
    const { segmentAt, withAnchorAt } = await load('model/pen.ts');
    assert.deepEqual(segmentAt(figure, 3), { from: 2, to: 3, t: 1 });
    const closed = { ...figure, settings: { ...figure.settings, closed: true } };
    assert.deepEqual(segmentAt(closed, 3), { from: 3, to: 0, t: 0 });
    assert.deepEqual(segmentAt(closed, 4), { from: 3, to: 0, t: 1 });
    const [end] = points.slice(-1);
    const made = withAnchorAt(figure, tangents, 3, end, [1, 0, 0], curve.samples);
    assert.equal(made.index, 3, 'the new anchor comes before the last one');
    assert.deepEqual(made.points[0], points[0], 'the first anchor stays as it is');
  });

  test('have handles that stay opposite at smooth anchors, and keep their lengths', async () => {
    const { withHandleAt, asJoint, jointOf } = plane;
    const points = await anchors(plane);
    const { tangents: drawn } = await drawPen(plane, points);
    const to = vector(0.03, 0.02);
    const [, smooth, symmetric, corner] = points.map(({ tangents }) => tangents);
    assert.deepEqual([smooth, symmetric, corner].map(jointOf), ['smooth', 'symmetric', 'corner']);
    const dragged = (tangents, i, broken = false) =>
      withHandleAt(tangents, drawn[i], 'before', to, { broken });
    for (const [tangents, i] of [
      [smooth, 1],
      [symmetric, 2],
    ]) {
      const changed = points.with(i, { ...points[i], tangents: dragged(tangents, i) });
      const now = (await drawPen(plane, changed)).tangents[i];
      assert.ok(far(now.before.direction, to.direction) < 1e-12);
      assert.ok(angleBetween(now.before.direction, now.after.direction) > 180 - 1e-5);
      const length = i === 1 ? drawn[1].after.length : to.length;
      assert.ok(Math.abs(now.after.length - length) < 1e-12);
      assert.ok(Math.abs(far(placeOf(now.after.point), placeOf(changed[i])) - length) < 1e-9);
    }
    const broken = dragged(smooth, 1, true);
    assert.equal(jointOf(broken), 'corner');
    assert.deepEqual(broken.after, smooth.after);
    for (const joint of ['corner', 'smooth', 'symmetric']) {
      assert.equal(jointOf(asJoint(corner, drawn[3], joint)), joint);
    }
  });

  for (const shape of ['sphere', 'torus']) {
    test(`are smooth at smooth anchors of a ${shape}`, (t) => smoothOn(shape, t));
  }

  async function smoothOn(shape, t) {
    const page = await openPage(await arraysOfShape(shape, 5000));
    const { triangles } = page.session.client.info;
    const places = [0.12, 0.2, 0.31].map((part) => ({
      face: Math.floor(part * triangles),
      bary: [0.3, 0.3, 0.4],
    }));
    const points = places.map((place, i) => ({
      ...place,
      tangents: {
        after: { direction: [0.6, 0.48, 0.64], length: 0.15 + 0.05 * i },
        before: { length: 0.1 },
      },
    }));
    const { editor, session } = page;
    const view = await drawPen(page, points);
    assert.equal(view.problem, null);
    const options = page.methodOptions(editor.state.method);
    const value = await page.curveValueOf(session.client, editor.state.figure, options);
    const curve = await session.client.mesh.curve(value);
    const step = 1e-6;
    const [from, to] = await Promise.all([curve.tangentAt(1 - step), curve.tangentAt(1 + step)]);
    const angle = angleBetween(from.inSpace, to.inSpace);
    t.diagnostic(
      `angle between the tangents before and after an anchor: ${angle.toFixed(3)} degrees`,
    );
    assert.ok(angle < 0.5, `${angle}`);
    const { vectors } = await session.client.mesh.logMap(places[1], [view.tangents[1].after.point]);
    const along = angleBetween(to.inSpace, vectors);
    // Facets of these surfaces meet at a few degrees.
    assert.ok(along < 6, `${along}: the curve leaves along its handle`);
  }
});
