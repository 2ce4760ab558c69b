// Edits of curves of `karcher/three` that change the number of control points.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { load } from 'karcher';
import { CurveDrag, SurfaceCurve, surfaceFromGeometry } from 'karcher/three';
import { loadInWorker } from 'karcher/worker';
import * as THREE from 'three';

const torus = new THREE.TorusGeometry(1, 0.4, 16, 48);
let surface;
let remote;
let surfaceInWorker;
before(async () => {
  surface = surfaceFromGeometry(await load(), torus);
  remote = await loadInWorker();
  surfaceInWorker = await surfaceFromGeometry(remote, torus);
});
after(() => remote.dispose());

const pointsAt = (...vertices) => vertices.map((vertex) => ({ vertex }));

test('there is a handle at each control point, however many there were before', async () => {
  const curve = new SurfaceCurve(surface, { kind: 'polyline', points: pointsAt(10, 200, 420) });
  await curve.ready;
  const element = Object.assign(new EventTarget(), { style: { touchAction: '' } });
  const drag = new CurveDrag(curve, new THREE.Mesh(), new THREE.PerspectiveCamera(), element);
  const { geometry } = curve.children.find((child) => child.isPoints);
  for (const vertices of [
    [10, 200, 420],
    [30, 220, 440, 660],
    [30, 500],
  ]) {
    const points = pointsAt(...vertices);
    assert.equal(await curve.set({ kind: 'polyline', points }), true);
    const { position } = geometry.attributes;
    assert.equal(position.count, points.length);
    points.forEach((point, i) => {
      const handle = new THREE.Vector3().fromBufferAttribute(position, i);
      assert.ok(handle.distanceTo(surface.position(point)) < 1e-6, `${vertices}: handle ${i}`);
      // The renderer and raycasts skip handles outside the sphere.
      const { center, radius } = geometry.boundingSphere;
      assert.ok(handle.distanceTo(center) < radius + 1e-6, `${vertices}: handle ${i}`);
    });
  }
  drag.dispose();
  curve.dispose();
});

test('a drag that replaces a waiting change starts from its points, without the old legs', async () => {
  const [a, b, d, e] = pointsAt(10, 200, 420, 430);
  const curve = new SurfaceCurve(surface, { kind: 'polyline', points: [a, b] });
  const changed = curve.set({ ...curve.value, points: [a, b, d] });
  const moves = [curve.movePoint(2, d), curve.movePoint(2, e)];
  assert.deepEqual(await Promise.all([changed, ...moves]), [false, false, true]);
  const expected = surface.mesh.curve({ kind: 'polyline', points: [a, b, e] });
  assert.deepEqual(curve.view.polyline, expected.view().polyline);
  curve.dispose();
});

test('the value after a drag has the drawn legs, so that other changes keep them', async () => {
  const line = new SurfaceCurve(surface, { kind: 'polyline', points: pointsAt(10, 10) });
  await line.ready;
  // Round the tube, back to the first point: the shortest leg has no length.
  const whole = surface.mesh.curve({ kind: 'polyline', points: pointsAt(10, 10) });
  const start = whole.value().points[0];
  const turn = 2 * Math.PI * 0.4;
  for (let step = 1; step <= 50; step++) {
    await line.movePoint(1, surface.mesh.straightest(start, [0, 0, 1], (step * turn) / 50).end);
  }
  const { length } = line.view;
  assert.ok(length > turn / 2, `${length}`);
  await line.set({ ...line.value });
  assert.ok(Math.abs(line.view.length - length) < 1e-6, `${line.view.length}, not ${length}`);
  line.dispose();
});

test('an edit under way when a curve is disposed of resolves to false', async () => {
  const worker = await loadInWorker();
  const there = await surfaceFromGeometry(worker, torus);
  const line = new SurfaceCurve(there, { kind: 'polyline', points: pointsAt(10, 200) });
  await line.ready;
  const edit = line.set({ kind: 'polyline', points: pointsAt(10, 300) });
  line.dispose();
  worker.dispose();
  assert.equal(await edit, false);
});

/** Vertices of the shortest loop around the hole of the torus. */
const onLoop = (i) => ({ vertex: 8 * 49 + i });

/** A polyline whose end was dragged most of the way around the hole. */
async function woundPolyline(on) {
  const curve = new SurfaceCurve(on, { kind: 'polyline', points: [onLoop(0), onLoop(4)] });
  await curve.ready;
  for (let i = 8; i <= 40; i += 4) await curve.movePoint(1, onLoop(i));
  return curve;
}

test('a change brings the value of the drawn curve, with the legs of a drag', async () => {
  for (const on of [surface, surfaceInWorker]) {
    const curve = await woundPolyline(on);
    let drawn;
    curve.addEventListener('change', ({ value, view }) => {
      drawn = { value, view };
    });
    const moves = [curve.movePoint(1, onLoop(42)), curve.movePoint(1, { vertex: 1e6 })];
    const [{ value: isDrawn }, { reason }] = await Promise.allSettled(moves);
    assert.deepEqual([isDrawn, reason.code], [true, 'badIndex']);
    assert.equal(drawn.view, curve.view);
    assert.deepEqual(drawn.value.points, [onLoop(0), onLoop(42)]);
    // The loop has 48 edges.
    const side = surface.position(onLoop(0)).distanceTo(surface.position(onLoop(1)));
    for (const { length } of [drawn.view, surface.mesh.curve(drawn.value).view()]) {
      assert.ok(Math.abs(length - 42 * side) < 1e-6, `${length}`);
    }
    // A curve of this value is dragged as the drawn one.
    const same = new SurfaceCurve(on, drawn.value);
    await same.ready;
    for (let i = 44; i <= 72; i += 4) {
      await same.movePoint(1, onLoop(i % 48));
      assert.ok(Math.abs(same.view.length - i * side) < 1e-6, `${i}: ${same.view.length}`);
    }
    // The value of the dragged curve has its legs, too.
    await same.set(curve.value);
    assert.ok(Math.abs(same.view.length - 42 * side) < 1e-6, `${same.view.length}`);
    for (const each of [curve, same]) each.dispose();
  }
});

test('options that make no curve can be followed by others that do', async () => {
  const value = { kind: 'bspline', points: pointsAt(10, 200, 420, 630) };
  for (const on of [surface, surfaceInWorker]) {
    const curve = new SurfaceCurve(on, { ...value, points: [] });
    await assert.rejects(curve.ready, { code: 'tooFewPoints' });
    await assert.rejects(curve.set({ ...value, points: [{ vertex: 1 }] }), {
      code: 'tooFewPoints',
    });
    await assert.rejects(curve.path(), { code: 'tooFewPoints' });
    assert.equal(await curve.set(value), true);
    assert.equal(curve.visible, true);
    assert.deepEqual(curve.view.polyline, surface.mesh.curve(value).view().polyline);
    assert.equal((await curve.path()).length, curve.view.length);
    assert.equal(await curve.movePoint(0, { vertex: 11 }), true);
    curve.dispose();
  }
});

test('a drag of a curve that could not be set has no legs of the drawn one', async () => {
  const curve = await woundPolyline(surfaceInWorker);
  const ends = { kind: 'polyline', points: [onLoop(1), { vertex: 1e6 }] };
  const edits = [curve.set(ends), curve.movePoint(1, onLoop(39))];
  const [{ reason }, { value }] = await Promise.allSettled(edits);
  assert.deepEqual([reason.code, value], ['badIndex', true]);
  const expected = surface.mesh.curve({ kind: 'polyline', points: [onLoop(1), onLoop(39)] });
  assert.deepEqual(curve.view.polyline, expected.view().polyline);
  curve.dispose();
});

test('a second finger neither moves nor releases the point of the first', async () => {
  const curve = new SurfaceCurve(surface, { kind: 'polyline', points: pointsAt(10, 200) });
  await curve.ready;
  const object = new THREE.Mesh(torus);
  object.add(curve);
  const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 10);
  camera.position.z = 4;
  for (const each of [camera, object]) each.updateMatrixWorld(true);
  const element = Object.assign(new EventTarget(), {
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 400, height: 400 }),
    style: { touchAction: '' },
    setPointerCapture: () => {},
  });
  const drag = new CurveDrag(curve, object, camera, element);
  const seen = surface.position({ vertex: 200 }).project(camera);
  const [x, y] = [200 * (1 + seen.x), 200 * (1 - seen.y)];
  const pointer = (pointerId, type, clientX, clientY) =>
    element.dispatchEvent(
      Object.assign(new Event(type), { clientX, clientY, button: 0, pointerId }),
    );
  pointer(1, 'pointerdown', x, y);
  for (const type of ['pointerdown', 'pointermove', 'pointerup', 'pointercancel']) {
    pointer(2, type, 200, 100);
    assert.equal(drag.dragged, 1, type);
  }
  assert.deepEqual(curve.value.points, pointsAt(10, 200));
  pointer(1, 'pointermove', x - 8, y + 5);
  assert.ok('face' in curve.value.points[1]);
  pointer(1, 'pointerup', x - 8, y + 5);
  assert.equal(drag.dragged, -1);
  drag.dispose();
  curve.dispose();
});

test('a finger scrolls again only when the last drag on an element has ended', () => {
  const curve = new SurfaceCurve(surface, { kind: 'polyline', points: pointsAt(10, 200) });
  for (const before of ['', 'pan-y']) {
    for (const order of [
      [0, 1],
      [1, 0],
    ]) {
      const element = Object.assign(new EventTarget(), { style: { touchAction: before } });
      const of = [new THREE.Mesh(), new THREE.PerspectiveCamera(), element];
      const drags = [new CurveDrag(curve, ...of), new CurveDrag(curve, ...of)];
      const [first, last] = order.map((i) => drags[i]);
      // A second call changes nothing.
      for (let i = 0; i < 2; i++) {
        first.dispose();
        assert.equal(element.style.touchAction, 'none', `${order}`);
      }
      last.dispose();
      assert.equal(element.style.touchAction, before, `${order}`);
      const again = new CurveDrag(curve, ...of);
      assert.equal(element.style.touchAction, 'none');
      again.dispose();
      assert.equal(element.style.touchAction, before);
    }
  }
  curve.dispose();
});
