// `karcher/three`: curves as objects that are drawn, edited and dragged.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { load } from 'karcher';
import { CurveDrag, SurfaceCurve, surfaceFromGeometry } from 'karcher/three';
import { loadInWorker } from 'karcher/worker';
import * as THREE from 'three';

let karcher;
before(async () => {
  karcher = await load();
});

const engines = { 'in the page': load, 'in a worker': loadInWorker };
for (const [where, loadEngine] of Object.entries(engines)) {
  describe(`a curve with the engine ${where}`, () => {
    let engine;
    let surface;
    const points = [10, 200, 420, 630].map((vertex) => ({ vertex }));
    before(async () => {
      engine = await loadEngine();
      surface = await surfaceFromGeometry(engine, new THREE.TorusGeometry(1, 0.4, 16, 48));
    });

    after(() => engine.dispose?.());

    const drawn = (curve) => {
      const { attributes, instanceCount } = curve.line.geometry;
      const { array } = attributes.instanceStart.data;
      const ends = Array.from({ length: instanceCount }, (_, i) => [
        ...array.slice(6 * i + 3, 6 * i + 6),
      ]);
      return [...array.slice(0, 3), ...ends.flat()];
    };
    /** The facade's curve of a value, with `moved` after a step of a drag to these points. */
    const expected = (value, moved) => {
      const { mesh } = surfaceFromGeometry(karcher, new THREE.TorusGeometry(1, 0.4, 16, 48));
      const curve = mesh.curve(value);
      const view = curve.view();
      if (!moved) return [...view.polyline];
      return [...curve.set({ ...value, points: moved, legs: view.drawnLegs }).polyline];
    };

    test('is drawn, and drawn again after a move', async () => {
      const curve = new SurfaceCurve(surface, { kind: 'bspline', points });
      await curve.ready;
      assert.deepEqual(drawn(curve), expected({ kind: 'bspline', points }));
      assert.equal(await curve.movePoint(1, { vertex: 230 }), true);
      const moved = points.map((point, i) => (i === 1 ? { vertex: 230 } : point));
      assert.deepEqual(curve.value.points, moved);
      assert.deepEqual(drawn(curve), expected({ kind: 'bspline', points }, moved));
      curve.dispose();
    });

    test('makes the newest of many edits, and reports the dropped ones', async () => {
      const curve = new SurfaceCurve(surface, { kind: 'bspline', points });
      const edits = [];
      for (let vertex = 200; vertex < 240; vertex++) edits.push(curve.movePoint(1, { vertex }));
      const told = await Promise.all(edits);
      assert.equal(told.at(-1), true);
      assert.ok(told.filter(Boolean).length < 5, `${told.filter(Boolean).length} were made`);
      assert.deepEqual(curve.value.points[1], { vertex: 239 });
      curve.dispose();
      await assert.rejects(curve.movePoint(0, { vertex: 1 }), { code: 'disposed' });
    });

    test('does not change for an invalid edit', async () => {
      const curve = new SurfaceCurve(surface, { kind: 'bspline', points });
      await curve.ready;
      const before = drawn(curve);
      await assert.rejects(curve.movePoint(0, { vertex: 1e6 }), { code: 'badIndex' });
      await assert.rejects(curve.movePoint(9, { vertex: 0 }), { code: 'badIndex' });
      assert.deepEqual(drawn(curve), before);
      assert.deepEqual(curve.value.points, points);
      curve.dispose();
      const none = new SurfaceCurve(surface, { kind: 'bspline', points: [] });
      await assert.rejects(none.ready, { code: 'tooFewPoints' });
      assert.equal(none.visible, false);
    });

    test('is dragged by the pointer', async () => {
      const curve = new SurfaceCurve(surface, { kind: 'bspline', points });
      const object = new THREE.Mesh(new THREE.TorusGeometry(1, 0.4, 16, 48));
      object.add(curve);
      const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 10);
      camera.position.z = 4;
      camera.updateMatrixWorld();
      object.updateMatrixWorld(true);
      const element = Object.assign(new EventTarget(), {
        getBoundingClientRect: () => ({ left: 0, top: 0, width: 400, height: 400 }),
        style: { touchAction: '' },
        setPointerCapture: () => {},
      });
      const seen = surface.position(points[1]).project(camera);
      const pointer = (type, x, y) =>
        element.dispatchEvent(
          Object.assign(new Event(type), { clientX: x, clientY: y, button: 0, pointerId: 1 }),
        );
      const drag = new CurveDrag(curve, object, camera, element);
      await curve.ready;
      const [x, y] = [200 * (1 + seen.x), 200 * (1 - seen.y)];
      pointer('pointermove', x + 3, y);
      assert.deepEqual(curve.value.points[1], points[1]);
      pointer('pointerdown', x + 2, y);
      assert.equal(drag.dragged, 1);
      pointer('pointermove', x - 8, y + 5);
      pointer('pointerup', x - 8, y + 5);
      assert.equal(drag.dragged, -1);
      const now = surface.position(curve.value.points[1]).project(camera);
      assert.ok(Math.hypot(200 * (1 + now.x) - (x - 8), 200 * (1 - now.y) - (y + 5)) < 1e-3);
      await curve.set(curve.value);
      assert.equal(element.style.touchAction, 'none');
      drag.dispose();
      assert.equal(element.style.touchAction, '');
      pointer('pointerdown', x, y);
      assert.equal(drag.dragged, -1);
      curve.dispose();
    });

    test('is dragged by visible points, not by those behind the surface', async () => {
      const object = new THREE.Mesh(new THREE.TorusGeometry(1, 0.4, 16, 48));
      const own = surfaceFromGeometry(karcher, object.geometry);
      const at = (x, z) => own.mesh.nearestPoint([x, 0, z]).point;
      const curve = new SurfaceCurve(own, { kind: 'polyline', points: [at(1, 0.4), at(-1, -0.4)] });
      object.add(curve);
      const cameras = [
        new THREE.PerspectiveCamera(50, 1, 0.1, 10),
        new THREE.OrthographicCamera(-2, 2, 2, -2, 0.1, 10),
      ];
      for (const camera of cameras) {
        for (const side of [1, -1]) {
          camera.position.z = 4 * side;
          camera.lookAt(0, 0, 0);
          camera.updateMatrixWorld();
          const element = Object.assign(new EventTarget(), {
            getBoundingClientRect: () => ({ left: 0, top: 0, width: 400, height: 400 }),
            style: { touchAction: '' },
            setPointerCapture: () => {},
          });
          const drag = new CurveDrag(curve, object, camera, element);
          const held = curve.value.points.map((point) => {
            const seen = own.position(point).project(camera);
            const [clientX, clientY] = [200 * (1 + seen.x), 200 * (1 - seen.y)];
            const press = new Event('pointerdown');
            element.dispatchEvent(Object.assign(press, { clientX, clientY, button: 0 }));
            return drag.dragged;
          });
          assert.deepEqual(held, side > 0 ? [0, -1] : [-1, 1]);
          drag.dispose();
        }
      }
      curve.dispose();
    });
  });
}
