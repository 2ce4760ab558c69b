// Edits of curves of `karcher/three` that change the number of control points.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { CurveDrag, SurfaceCurve, surfaceFromGeometry } from 'karcher/three';
import * as THREE from 'three';

let surface;
before(async () => {
  surface = surfaceFromGeometry(await load(), new THREE.TorusGeometry(1, 0.4, 16, 48));
});

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
