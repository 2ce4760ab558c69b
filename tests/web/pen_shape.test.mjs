// Bending of pen curves, and insertion and removal of anchors: exact on a plane, approximate
// elsewhere.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { openPage } from './engine_in_node.mjs';
import { randoms, seed } from './part.mjs';
import {
  add,
  bernstein,
  drawPen,
  far,
  pointAt,
  roughPlane,
  segmentsOf,
  vector,
} from './pen_plane.mjs';

const within = (line, place) => {
  let least = Infinity;
  for (let i = 3; i < line.length; i += 3) {
    const from = Array.from(line.subarray(i - 3, i));
    const to = Array.from(line.subarray(i, i + 3));
    const step = add(to, from, -1);
    const whole = step.reduce((sum, value) => sum + value * value, 0) || 1;
    const along = add(place, from, -1).reduce((sum, value, axis) => sum + value * step[axis], 0);
    const part = Math.min(1, Math.max(0, along / whole));
    least = Math.min(least, far(place, add(from, step, part)));
  }
  return least;
};

const placeOf = (weights, control) =>
  [0, 1, 2].map((axis) => weights.reduce((sum, weight, k) => sum + weight * control[k][axis], 0));

const places = (control, count = 60) =>
  Array.from({ length: count + 1 }, (_, i) => placeOf(bernstein(i / count), control));

describe('the shape of curves of the pen', () => {
  console.log(`KARCHER_SEED=${seed}`);
  const numbers = randoms(seed);
  const random = () => numbers.next().value;
  const arrays = roughPlane(12, random);
  const flat = { carry: () => (direction) => direction };
  const spots = [
    [0.2, 0.3],
    [0.4, 0.7],
    [0.6, 0.35],
    [0.8, 0.6],
  ];
  let page;
  before(async () => {
    page = await openPage(arrays);
  });

  async function anchors() {
    const size = () => 0.04 + 0.08 * random();
    const [p, q, r, s] = await Promise.all(spots.map((spot) => pointAt(page, arrays, ...spot)));
    return [
      { ...p, tangents: { after: vector(size(), size()) } },
      { ...q, tangents: { after: vector(size(), -size()), before: { length: size() } } },
      { ...r, tangents: { after: vector(size(), 0.01), before: { length: null } } },
      s,
    ];
  }

  test('a bent segment passes through the pointer at its parameter, and smooth anchors stay smooth', async (t) => {
    const points = await anchors();
    const { tangents } = await drawPen(page, points);
    const { figure, method } = page.editor.state;
    const { client } = page.session;
    let worst = 0;
    for (const at of [
      { from: 0, to: 1, t: 0.2 },
      { from: 1, to: 2, t: 0.5 },
      { from: 2, to: 3, t: 0.85 },
    ]) {
      const options = page.methodOptions(method);
      const bend = await page.Bend.of(client, flat, figure, tangents, options, at);
      // The bend is small, so that no handle meets the boundary.
      const weights = bernstein(at.t);
      const at0 = placeOf(weights, segmentsOf(arrays, points, false)[at.from]);
      const [x, y] = at0.map((value) => value + 0.08 * (random() - 0.5));
      const point = await pointAt(page, arrays, x, y);
      const { to: bent } = await bend.through(point, 1);
      assert.deepEqual(bend.anchors, [at.from, at.to]);
      bend.end();
      const control = segmentsOf(arrays, bent.points, false)[at.from];
      const place = placeOf(weights, control);
      worst = Math.max(worst, far(place, [x, y, 0]));
      assert.deepEqual(
        bent.points.map(({ tangents }) => page.jointOf(tangents)),
        points.map(({ tangents }) => page.jointOf(tangents)),
      );
      const { face, bary } = bent.points[at.from];
      assert.deepEqual({ face, bary }, { face: points[at.from].face, bary: points[at.from].bary });
    }
    t.diagnostic(`a bent segment misses the pointer by ${worst.toExponential(1)} of the side`);
    assert.ok(worst < 1e-9, `${worst}`);
  });

  test('a bend back to its start changes nothing', async () => {
    const points = await anchors();
    const { tangents, curve } = await drawPen(page, points);
    const { figure, method } = page.editor.state;
    const { client } = page.session;
    const at = { from: 1, to: 2, t: 0.4 };
    const bend = await page.Bend.of(client, flat, figure, tangents, page.methodOptions(method), at);
    await bend.through(await pointAt(page, arrays, 0.5, 0.9), 1);
    const old = segmentsOf(arrays, points, false)[1];
    const [start] = places(old, 1);
    assert.ok(far(start, segmentsOf(arrays, figure.points, false)[1][0]) < 1e-12);
    const [x, y] = placeOf(bernstein(at.t), old);
    const { to } = await bend.through(await pointAt(page, arrays, x, y), 4);
    const now = segmentsOf(arrays, to.points, false)[1];
    for (const [k, place] of now.entries()) assert.ok(far(place, old[k]) < 1e-9);
    assert.ok(curve.length > 0);
  });

  test('an anchor that is inserted and removed again leaves the curve unchanged', async (t) => {
    const points = await anchors();
    await drawPen(page, points);
    const old = segmentsOf(arrays, points, false);
    let worst = 0;
    for (const [segment, part] of [
      [0, 0.3],
      [1, 0.62],
      [2, 0.5],
    ]) {
      await drawPen(page, points);
      const near = places(old[segment], 100)[Math.round(100 * part)];
      await page.edits.atCurve('insert', near);
      await page.settled();
      const put = page.editor.state.figure.points;
      assert.equal(put.length, 5);
      const halves = segmentsOf(arrays, put, false);
      const whole = places(old[segment], 400).flat();
      for (const half of halves.slice(segment, segment + 2)) {
        for (const place of places(half, 20)) {
          // The distance is that from the chords of the whole curve.
          assert.ok(within(Float64Array.from(whole), place) < 1e-5);
        }
      }
      await page.edits.removeAnchor(segment + 1);
      await page.settled();
      const left = segmentsOf(arrays, page.editor.state.figure.points, false);
      assert.equal(left.length, 3);
      for (const [k, place] of left[segment].entries()) {
        worst = Math.max(worst, far(place, old[segment][k]));
      }
    }
    t.diagnostic(`control points are ${worst.toExponential(1)} of the side off`);
    assert.ok(worst < 1e-6, `${worst}`);
    page.editor.undo();
    page.editor.undo();
    assert.deepEqual(page.editor.state.figure.points, points);
  });

  test('without an anchor is the nearest cubic, keeps its directions, and straight sides stay straight', async () => {
    const points = await anchors();
    const { tangents: drawn, curve } = await drawPen(page, points);
    await page.edits.removeAnchor(1);
    const view = await page.settled();
    const left = page.editor.state.figure.points;
    assert.equal(left.length, 3);
    const after = view.tangents[0].after;
    assert.ok(far(after.direction, drawn[0].after.direction) < 1e-9);
    assert.ok(far(view.tangents[1].before.direction, drawn[2].before.direction) < 1e-9);
    assert.ok(Math.abs(view.tangents[1].after.length - drawn[2].after.length) < 1e-12);
    const off = (line, from) => Math.max(...from.map((place) => within(line, place)));
    const old = segmentsOf(arrays, points, false);
    const through = [...places(old[0]), ...places(old[1])];
    const found = off(view.curve.polyline, through);
    // The directions are the same, with handles of every tenth of the side.
    const [from, to] = [old[0][0], old[1][3]];
    const [onward, back] = [drawn[0].after.direction, drawn[2].before.direction];
    const lengths = Array.from({ length: 8 }, (_, i) => (i + 1) / 10);
    const tried = lengths.flatMap((first) =>
      lengths.map((second) => [from, add(from, onward, first), add(to, back, second), to]),
    );
    const lines = tried.map((control) => Float32Array.from(places(control).flat()));
    const least = Math.min(...lines.map((line) => off(line, through)));
    assert.ok(found < 1.5 * least, `${found} off, where one cubic is ${least}`);
    const plain = [points[0], ...points.slice(2)];
    const without = off((await drawPen(page, plain)).curve.polyline, through);
    assert.ok(found < without, 'nearer than with the handles that are left');
    assert.ok(curve.length > 0);
    const corners = await Promise.all(spots.map((spot) => pointAt(page, arrays, ...spot)));
    await drawPen(page, corners);
    await page.edits.removeAnchor(1);
    await page.settled();
    assert.deepEqual(page.editor.state.figure.points, corners.toSpliced(1, 1));
  });

  test('loses an anchor also after a stop cancelled the look at the anchor’s face', async () => {
    const points = await anchors();
    await drawPen(page, points);
    const { client } = page.session;
    await client.corners(points[0].face);
    const asked = client.corners(points[1].face);
    client.stop();
    await assert.rejects(asked, /it was stopped/);
    await page.edits.removeAnchor(1);
    assert.equal(page.editor.state.figure.points.length, 3);
  });

  test('on a sphere a bend comes as near to the pointer as required, and is C1', async (t) => {
    const sphere = await openPage(5000);
    const { triangles, diagonal } = sphere.session.client.info;
    const places = [0.12, 0.2, 0.31].map((part) => ({
      face: Math.floor(part * triangles),
      bary: [0.3, 0.3, 0.4],
    }));
    const points = places.map((place) => ({
      ...place,
      tangents: {
        after: { direction: [0.6, 0.48, 0.64], length: 0.2 },
        before: { length: 0.1 },
      },
    }));
    const { tangents } = await drawPen(sphere, points);
    const { figure, method } = sphere.editor.state;
    const options = sphere.methodOptions(method);
    const at = { from: 0, to: 1, t: 0.4 };
    const { client } = sphere.session;
    const bend = await sphere.Bend.of(client, flat, figure, tangents, options, at);
    const point = { face: Math.floor(0.17 * triangles), bary: [0.2, 0.5, 0.3] };
    const { to } = await bend.through(point, 8);
    bend.end();
    const view = await drawPen(sphere, to.points);
    assert.equal(view.problem, null);
    const value = await sphere.curveValueOf(client, sphere.editor.state.figure, options);
    const curve = await client.mesh.curve(value);
    const there = await curve.pointAt(at.t);
    const path = await client.mesh.shortestPath(there.point, point);
    t.diagnostic(`${(path.length / diagonal).toExponential(1)} of the diagonal from the pointer`);
    assert.ok(path.length < 2e-3 * diagonal, `${path.length / diagonal}`);
    const step = 1e-6;
    const [from, on] = await Promise.all([curve.tangentAt(1 - step), curve.tangentAt(1 + step)]);
    const cosine =
      from.inSpace.reduce((sum, x, axis) => sum + x * on.inSpace[axis], 0) /
      (Math.hypot(...from.inSpace) * Math.hypot(...on.inSpace));
    const degrees = (Math.acos(Math.min(1, cosine)) * 180) / Math.PI;
    t.diagnostic(`tangents at the smooth anchor are ${degrees.toFixed(3)} degrees apart`);
    assert.ok(degrees < 0.5, `${degrees}`);
  });

  test('is described before a click', () => {
    const { penActionAt, penWords } = page;
    const state = { anchors: 3, closed: false, selected: 2, chosen: false, alt: false };
    const told = (under, part = {}) => penActionAt(under, { ...state, ...part });
    const [surface, curve] = [{ type: 'surface' }, { type: 'curve' }];
    const anchor = (index) => ({ type: 'anchor', index });
    const handle = { type: 'handle', side: 'after' };
    const cases = [
      [surface, {}, 'add'],
      [surface, { selected: null }, 'begin'],
      [surface, { closed: true }, 'begin'],
      [surface, { anchors: 0, selected: null }, 'begin'],
      [curve, {}, 'bend'],
      [curve, { chosen: true, selected: null }, 'move'],
      [curve, { chosen: true }, 'bend'],
      [anchor(0), {}, 'close'],
      [anchor(0), { selected: 1 }, 'anchor'],
      [anchor(0), { closed: true }, 'anchor'],
      [anchor(0), { alt: true }, 'convert'],
      [anchor(1), {}, 'anchor'],
      [handle, {}, 'handle'],
      [handle, { alt: true }, 'break'],
    ];
    for (const [under, part, action] of cases) {
      assert.equal(told(under, part), action, JSON.stringify([under, part]));
      assert.ok(penWords[action].length > 10);
    }
  });
});
