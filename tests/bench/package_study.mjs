// A table of the package's requirements beside the measured values: places of hits, log maps, many means, medians,
// derivatives. `npm run study -- package` runs it on the built module; times are the processor's.
import { load } from 'karcher';
import { energyAt, hessianAt, median, weightDerivatives } from 'karcher/statistics';
import { surfaceFromGeometry } from 'karcher/three';
import * as THREE from 'three';
import { acceleratedRaycast, CENTER, MeshBVH, SAH } from 'three-mesh-bvh';
import { geometries } from '../wasm/geometries.mjs';
import { grid } from '../wasm/meshes.mjs';
import { randomFrom } from '../web/part.mjs';

const random = randomFrom(20261126);
const karcher = await load();
const row = (...cells) => console.log(`| ${cells.join(' | ')} |`);
const length = (a) => Math.hypot(...a);
const minus = (a, b) => a.map((x, k) => x - b[k]);
const short = (value) => value.toPrecision(2);
const middle = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];

/** The median processor time of a call in milliseconds, after a first call without measurement. */
function milliseconds(call, times = 7) {
  call();
  return middle(
    Array.from({ length: times }, () => {
      const before = process.cpuUsage();
      call();
      const { user, system } = process.cpuUsage(before);
      return (user + system) / 1000;
    }),
  );
}

const pointOf = (mesh) => {
  const [u, v] = [random(), random()];
  const [b1, b2] = u + v < 1 ? [u, v] : [1 - u, 1 - v];
  return { face: Math.floor(random() * mesh.info.triangles), bary: [1 - b1 - b2, b1, b2] };
};

row('what', 'required', 'measured');
row('---', '---', '---');
hits(10_000);
logMapTime();
manyMeans();
await logDirections();
await medians(20);
await derivatives(20);

/** Hits of rays on every geometry, with each tree built before the surface and after it. */
function hits(count) {
  const trees = {
    none: () => {},
    center: (geometry) => new MeshBVH(geometry, { strategy: CENTER }),
    areas: (geometry) => new MeshBVH(geometry, { strategy: SAH, targetLeafSize: 1 }),
    indirect: (geometry) => new MeshBVH(geometry, { indirect: true }),
  };
  const orders = Object.keys(trees).flatMap((a) => Object.keys(trees).map((b) => [a, b]));
  const names = Object.keys(geometries);
  const most = Math.ceil(count / (orders.length * names.length));
  let [found, refused, farthest] = [0, 0, 0];
  for (const name of names) {
    for (const [first, second] of orders) {
      const geometry = geometries[name][0].clone();
      geometry.boundsTree = trees[first](geometry);
      const surface = surfaceFromGeometry(karcher, geometry);
      geometry.boundsTree = trees[second](geometry) ?? geometry.boundsTree;
      const object = new THREE.Mesh(
        geometry,
        new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }),
      );
      if (geometry.boundsTree) object.raycast = acceleratedRaycast;
      geometry.computeBoundingSphere();
      const { center, radius } = geometry.boundingSphere;
      const away = (r) =>
        new THREE.Vector3(...[0, 0, 0].map(() => 2 * random() - 1)).multiplyScalar(r);
      let left = most;
      for (let tries = 0; left > 0 && tries < 100 * most; tries++) {
        const from = center.clone().add(away(1).setLength(3 * radius));
        const aim = center.clone().add(away(radius)).sub(from).normalize();
        for (const hit of new THREE.Raycaster(from, aim).intersectObject(object).slice(0, left)) {
          left--;
          found++;
          try {
            const place = surface.position(surface.pointAt(hit));
            farthest = Math.max(farthest, place.distanceTo(hit.point) / surface.diagonal);
          } catch {
            refused++;
          }
        }
      }
    }
  }
  row(
    `${found} random hits on ${names.length} geometries, in ${orders.length} orders of tree and surface`,
    'within 1e-6 of the diagonal, or refused',
    `${short(farthest)}, ${refused} refused`,
  );
}

function logMapTime() {
  for (const name of ['torus', 'sphere']) {
    const mesh = karcher.shape(name, 70_000);
    const from = pointOf(mesh);
    const field = milliseconds(() => mesh.distance(from, { solver: 'fast' }));
    const map = milliseconds(() => mesh.logMap(from));
    row(
      `log map of a ${name} of ${mesh.info.triangles} triangles, beside one field (${field.toFixed(0)} ms)`,
      'at most 1.3 times',
      `${(map / field).toFixed(2)} times`,
    );
  }
}

function manyMeans() {
  const mesh = karcher.shape('torus', 70_000);
  for (const part of [0.05, 0.15]) {
    const reach = part * mesh.info.diagonal;
    const away = () => [0, 0, 0].map(() => reach * (2 * random() - 1));
    const { points } = mesh.expMap(pointOf(mesh), Array.from({ length: 8 }, away));
    const rows = Array.from({ length: 10_000 }, () => points.map(() => random()));
    const all = milliseconds(() => mesh.centersOfMass(points, rows, { normalize: true }), 3);
    row(
      `10,000 means of 8 points within ${part} of the diagonal on a torus of ${mesh.info.triangles} triangles`,
      'under 1,000 ms',
      `${all.toFixed(0)} ms`,
    );
  }
}

/**
 * The log map of all vertices against the directions in which exact shortest paths leave the
 * source.
 */
async function logDirections() {
  for (const name of ['sphere', 'torus', 'knot']) {
    const mesh = karcher.shape(name, 5000);
    const off = [];
    for (let source = 0; source < 4; source++) {
      const from = pointOf(mesh);
      const { vectors } = mesh.logMap(from);
      for (let i = 0; i < 100; i++) {
        const vertex = Math.floor(random() * mesh.info.vertices);
        const path = mesh.shortestPath(from, { vertex });
        const line = path.polyline({ bits: 64 });
        const step = minus([...line.slice(3, 6)], [...line.slice(0, 3)]);
        const vector = [...vectors.slice(3 * vertex, 3 * vertex + 3)];
        const exact = step.map((x) => (x * path.length) / length(step));
        off.push(length(minus(vector, exact)) / path.length);
      }
    }
    const sorted = off.toSorted((a, b) => a - b);
    const at = (part) => `${short(100 * sorted[Math.floor(part * (sorted.length - 1))])} %`;
    row(
      `log vectors of a ${name}'s vertices beside exact shortest paths, ${off.length} pairs`,
      'the same directions',
      `median ${at(0.5)} of the length off, 9 of 10 below ${at(0.9)}`,
    );
  }
}

/** Medians of three points of a plane: they see the points at equal angles. */
async function medians(count) {
  const mesh = karcher.meshFromObj(grid(10));
  let most = 0;
  for (let i = 0; i < count; i++) {
    const places = Array.from({ length: 3 }, (_, k) => {
      const angle = (2 * Math.PI * (k + 0.5 * random())) / 3;
      return [5 + 4 * Math.cos(angle), 5 + 4 * Math.sin(angle), 0];
    });
    const points = places.map((place) => mesh.nearestPoint(place).point);
    const { position } = await median(mesh, points);
    const units = places.map((place) => {
      const way = minus(place, [...position]);
      return way.map((x) => x / length(way));
    });
    most = Math.max(most, length([0, 1].map((k) => units.reduce((sum, u) => sum + u[k], 0))));
  }
  row(`the pull of unit vectors at ${count} Fermat points`, '0', `at most ${short(most)}`);
}

async function derivatives(count) {
  const mesh = karcher.meshFromObj(grid(10));
  let [byEnergy, byHessian, byWeights] = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    const points = Array.from({ length: 5 }, () => pointOf(mesh));
    const places = points.map((point) => mesh.position(point));
    const weights = points.map(() => 0.1 + random());
    const total = weights.reduce((a, b) => a + b);
    const at = pointOf(mesh);
    const here = mesh.position(at);
    const expected = [0, 1, 2].map((k) =>
      places.reduce((sum, place, n) => sum - 2 * weights[n] * (place[k] - here[k]), 0),
    );
    const { gradient } = await energyAt(mesh, points, weights, at);
    byEnergy = Math.max(byEnergy, length(minus(gradient, expected)));
    const [xx, xy, yy] = (await hessianAt(mesh, points, weights, at)).matrix;
    byHessian = Math.max(byHessian, length([xx - 2 * total, xy, yy - 2 * total]));
    const center = mesh.centerOfMass(points, weights, { normalize: true });
    const moves = await weightDerivatives(mesh, points, weights, center.point).catch(() => null);
    // A center on an edge has no derivative.
    if (!moves) continue;
    const own = [...center.position];
    for (const [n, move] of moves.entries()) {
      const exact = minus(places[n], own).map((x) => x / total);
      byWeights = Math.max(byWeights, length(minus([...move], exact)));
    }
  }
  row(
    `${count} gradients, Hessians and derivatives by weights on a plane`,
    'the closed forms',
    `at most ${[byEnergy, byHessian, byWeights].map(short).join(', ')} off`,
  );
}
