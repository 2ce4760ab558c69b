// Standard geometries of three.js.
import * as THREE from 'three';

const profile = (...points) => points.map(([x, y]) => new THREE.Vector2(x, y));
const circle = new (class extends THREE.Curve {
  getPoint(t, target = new THREE.Vector3()) {
    return target.set(Math.cos(2 * Math.PI * t), Math.sin(2 * Math.PI * t), 0);
  }
})();
const arc = new THREE.CatmullRomCurve3([
  new THREE.Vector3(0, 0, 0),
  new THREE.Vector3(1, 1, 0),
  new THREE.Vector3(2, 0, 1),
]);
const outline = new THREE.Shape(profile([0, 0], [2, 0], [2, 1], [1, 1.5], [0, 1]));
const pierced = outline.clone();
pierced.holes.push(new THREE.Path(profile([0.5, 0.3], [0.5, 0.7], [1.5, 0.7], [1.5, 0.3])));

/** Each geometry with the number of boundary loops and the genus of its surface. */
export const geometries = {
  box: [new THREE.BoxGeometry(1, 2, 3, 2, 3, 4), 0, 0],
  capsule: [new THREE.CapsuleGeometry(1, 2, 8, 24, 3), 0, 0],
  circle: [new THREE.CircleGeometry(1, 24), 1, 0],
  cone: [new THREE.ConeGeometry(1, 2, 24, 5), 0, 0],
  'cone without a base': [new THREE.ConeGeometry(1, 2, 24, 5, true), 1, 0],
  cylinder: [new THREE.CylinderGeometry(1, 1, 2, 24, 4), 0, 0],
  'cylinder without caps': [new THREE.CylinderGeometry(1, 1.5, 2, 24, 4, true), 2, 0],
  dodecahedron: [new THREE.DodecahedronGeometry(1, 2), 0, 0],
  extruded: [new THREE.ExtrudeGeometry(outline, { depth: 1, steps: 3 }), 0, 0],
  'extruded with a hole': [
    new THREE.ExtrudeGeometry(pierced, { depth: 1, bevelEnabled: false, steps: 2 }),
    0,
    1,
  ],
  icosahedron: [new THREE.IcosahedronGeometry(1, 6), 0, 0],
  'lathe, closed': [
    new THREE.LatheGeometry(profile([0, -1], [1, -0.5], [1, 0.5], [0, 1]), 24),
    0,
    0,
  ],
  'lathe from nearly the axis': [
    new THREE.LatheGeometry(profile([6e-17, -1], [1, -0.5], [1, 0.5], [1.2e-16, 1]), 24),
    0,
    0,
  ],
  'lathe, open': [new THREE.LatheGeometry(profile([0.5, -1], [1, 0], [0.5, 1]), 24), 2, 0],
  octahedron: [new THREE.OctahedronGeometry(1, 5), 0, 0],
  plane: [new THREE.PlaneGeometry(2, 1, 6, 4), 1, 0],
  ring: [new THREE.RingGeometry(0.5, 1, 24, 3), 2, 0],
  shape: [new THREE.ShapeGeometry(outline), 1, 0],
  'shape with a hole': [new THREE.ShapeGeometry(pierced), 2, 0],
  sphere: [new THREE.SphereGeometry(1, 32, 16), 0, 0],
  'half of a sphere': [new THREE.SphereGeometry(1, 32, 16, 0, 2 * Math.PI, 0, Math.PI / 2), 1, 0],
  tetrahedron: [new THREE.TetrahedronGeometry(1, 4), 0, 0],
  torus: [new THREE.TorusGeometry(1, 0.4, 16, 48), 0, 1],
  'torus knot': [new THREE.TorusKnotGeometry(1, 0.3, 128, 16), 0, 1],
  'tube, closed': [new THREE.TubeGeometry(circle, 64, 0.3, 12, true), 0, 1],
  'tube, open': [new THREE.TubeGeometry(arc, 32, 0.2, 12, false), 2, 0],
};
