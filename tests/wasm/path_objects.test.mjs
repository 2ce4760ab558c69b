// Tubes and ribbons of `karcher/three` along paths and curves, as objects that follow them.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { load } from 'karcher';
import {
  geometryOf,
  RibbonOnSurface,
  ribbonGeometry,
  SurfaceCurve,
  surfaceFromGeometry,
  surfaceFromMesh,
  TubeOnSurface,
  tubeGeometry,
} from 'karcher/three';
import { loadInWorker } from 'karcher/worker';
import * as THREE from 'three';

const karcher = await load();

const placesOf = (geometry) => {
  const { position } = geometry.attributes;
  return Array.from({ length: position.count }, (_, v) =>
    new THREE.Vector3().fromBufferAttribute(position, v),
  );
};
/** The coordinates, without -0. */
const listOf = (place) => Array.from(place, (x) => x + 0);
const arraysOf = ({ attributes, index }) => [attributes.position.array, index.array];

test('ribbons, tubes, normals and frames keep their side across faces that the import turned over', async () => {
  const geometry = new THREE.PlaneGeometry(2, 2, 8, 8);
  const turned = [40, 41, 55, 70, 71, 72, 73];
  for (const face of turned) geometry.index.array.subarray(3 * face + 1, 3 * face + 3).reverse();
  const remote = await loadInWorker();
  for (const engine of [karcher, remote]) {
    const surface = await surfaceFromGeometry(engine, geometry);
    for (let face = 0; face < geometry.index.count / 3; face++) {
      const point = { face, bary: [0.2, 0.3, 0.5] };
      assert.deepEqual(listOf(surface.normal(point)), [0, 0, 1], `face ${face}`);
      assert.deepEqual(listOf(await surface.mesh.normal(point)), [0, 0, 1]);
      const axes = [0, 1, 2].map((k) =>
        listOf(new THREE.Vector3().setFromMatrixColumn(surface.frame(point), k)),
      );
      assert.deepEqual(axes, (await surface.mesh.frame(point)).map(listOf));
    }
    const at = async (x, y) => (await surface.mesh.nearestPoint([x, y, 0])).point;
    const path = await surface.mesh.shortestPath(await at(-0.9, 0.13), await at(0.9, -0.21));
    const ribbon = ribbonGeometry(surface, path, { width: 0.1 });
    const up = ribbon.attributes.normal;
    for (let v = 0; v < up.count; v++) assert.ok(up.getZ(v) > 0.99, `vertex ${v}: ${up.getZ(v)}`);
    const tube = tubeGeometry(surface, path, { radius: 0.1, sides: 4 }).attributes.normal;
    for (let v = 0; v < tube.count; v += 4) {
      const first = new THREE.Vector3().fromBufferAttribute(tube, 0);
      assert.ok(first.dot(new THREE.Vector3().fromBufferAttribute(tube, v)) > 0.99);
    }
    const drawn = geometryOf(surface);
    drawn.attributes.normal.array.forEach((x, i) => {
      assert.equal(x, i % 3 === 2 ? 1 : 0);
    });
    assert.deepEqual([...drawn.index.array], [...new THREE.PlaneGeometry(2, 2, 8, 8).index.array]);
  }
  await remote.dispose();
});

test('a face that was turned over and cut has its normal on the upper side', () => {
  // Vertex 3 lies on the edge from 0 to 1. The flat triangle there cuts the first face, whose
  // corners are clockwise.
  const positions = [0, 0, 0, 2, 0, 0, 1, 2, 0, 1, 0, 0, 1, -2, 0, 0, -2, 0, 2, -2, 0];
  const corners = [0, 2, 1, 1, 0, 3, 0, 4, 3, 4, 1, 3, 0, 5, 4, 4, 6, 1];
  for (const first of [0, 5]) {
    // The same triangle once more, with vertices of its own or not.
    const more = first === 0 ? [0, 1, 2] : [];
    const mesh = karcher.meshFromArrays(positions, [...corners, ...more]);
    const kinds = mesh.info.repairs.map(({ kind }) => kind);
    assert.ok(kinds.includes('noArea') && kinds.includes('turnedOver'), `${kinds}`);
    const surface = surfaceFromMesh(mesh);
    for (const face of [0, 2, 3, 4, 5]) {
      const point = { face, bary: [0.2, 0.3, 0.5] };
      assert.deepEqual(listOf(mesh.normal(point)), [0, 0, 1]);
      assert.deepEqual(listOf(surface.normal(point)), [0, 0, 1], `face ${face}`);
    }
    for (let vertex = 0; vertex < 7; vertex++) {
      const axes = [0, 1, 2].map((k) =>
        listOf(new THREE.Vector3().setFromMatrixColumn(surface.frame({ vertex }), k)),
      );
      assert.deepEqual(axes, mesh.frame({ vertex }).map(listOf), `vertex ${vertex}`);
    }
  }
});

test('a ribbon on a plane is a strip of its width, facing up', () => {
  const surface = surfaceFromGeometry(karcher, new THREE.PlaneGeometry(2, 2, 8, 8));
  const at = (x, y) => surface.mesh.nearestPoint([x, y, 0]).point;
  const [from, to] = [new THREE.Vector3(-0.7, -0.4, 0), new THREE.Vector3(0.6, 0.5, 0)];
  const path = surface.mesh.shortestPath(at(from.x, from.y), at(to.x, to.y));
  const width = 0.1;
  const ribbon = ribbonGeometry(surface, path, { width });
  const along = to.clone().sub(from).normalize();
  const left = new THREE.Vector3(-along.y, along.x, 0);
  const { uv, normal } = ribbon.attributes;
  placesOf(ribbon).forEach((place, v) => {
    const away = place.clone().sub(from);
    const side = v % 2;
    // Single precision of coordinates up to 1.
    assert.ok(Math.abs(away.dot(left) - (0.5 - side) * width) < 1e-6);
    assert.ok(Math.abs(uv.getX(v) * width - away.dot(along)) < 1e-6);
    assert.equal(uv.getY(v), side);
    assert.ok(Math.abs(normal.getZ(v) - 1) < 1e-6);
  });
  const area = (geometry) => {
    const [places, corners] = [placesOf(geometry), [...geometry.index.array]];
    let sum = 0;
    for (let i = 0; i < corners.length; i += 3) {
      const [a, b, c] = corners.slice(i, i + 3).map((v) => places[v]);
      sum += b.clone().sub(a).cross(c.clone().sub(a)).z / 2;
    }
    return sum;
  };
  assert.ok(Math.abs(area(ribbon) - width * path.length) < 1e-6);
  const double = ribbonGeometry(surface, path.toJSON(), { width: 2 * width });
  assert.ok(Math.abs(area(double) - 2 * width * path.length) < 1e-6);
  assert.throws(() => ribbonGeometry(surface, path, { width: 0 }), { code: 'badArgument' });
});

test('a closed ribbon ends where it starts, with the widths of its length between', () => {
  const surface = surfaceFromMesh(karcher.shape('torus', 2000));
  const { path } = surface.mesh.circle({ vertex: 12 }, { radius: 0.2 });
  const width = 0.02;
  const ribbon = ribbonGeometry(surface, path, { width });
  const places = placesOf(ribbon);
  assert.deepEqual(places.slice(-2), places.slice(0, 2));
  const { uv } = ribbon.attributes;
  const last = uv.getX(uv.count - 1);
  assert.ok(Math.abs(last * width - path.length) < 1e-3 * path.length);
  places.forEach((place, v) => {
    if (v % 2) assert.ok(Math.abs(place.distanceTo(places[v - 1]) - width) < 1e-6);
  });
});

const kinds = {
  tube: { Kind: TubeOnSurface, geometry: tubeGeometry, options: { radius: 0.02, sides: 5 } },
  ribbon: { Kind: RibbonOnSurface, geometry: ribbonGeometry, options: { width: 0.03 } },
};
const engines = { 'in the page': load, 'in a worker': loadInWorker };
for (const [where, loadEngine] of Object.entries(engines)) {
  describe(`with the engine ${where}`, () => {
    let engine;
    let surface;
    const points = [10, 200, 420, 630].map((vertex) => ({ vertex }));
    before(async () => {
      engine = await loadEngine();
      surface = await surfaceFromGeometry(engine, new THREE.TorusGeometry(1, 0.4, 16, 48));
    });
    after(() => engine.dispose?.());

    for (const [name, { Kind, geometry, options }] of Object.entries(kinds)) {
      test(`a ${name} along a path is drawn at once, and along another one`, async () => {
        const [path, other] = await Promise.all(
          [points[1], points[2]].map((to) => surface.mesh.shortestPath(points[0], to)),
        );
        const object = new Kind(surface, path, options);
        assert.deepEqual(arraysOf(object.geometry), arraysOf(geometry(surface, path, options)));
        await object.ready;
        let freed = 0;
        object.geometry.addEventListener('dispose', () => freed++);
        await object.follow(other.toJSON());
        assert.equal(freed, 1);
        assert.deepEqual(arraysOf(object.geometry), arraysOf(geometry(surface, other, options)));
        assert.throws(() => new Kind(surface, { face: 3 }, options), { code: 'badArgument' });
        object.dispose();
      });

      test(`a ${name} along a curve follows its edits until it is disposed of`, async () => {
        const curve = new SurfaceCurve(surface, { kind: 'catmullrom', points });
        const material = new THREE.MeshBasicMaterial();
        const object = new Kind(surface, curve, { ...options, material });
        const parent = new THREE.Object3D().add(object);
        assert.equal(object.material, material);
        await object.ready;
        const drawn = async () =>
          assert.deepEqual(
            arraysOf(object.geometry),
            arraysOf(geometry(surface, await curve.path(), options)),
          );
        await drawn();
        const first = object.geometry;
        await Promise.all([300, 301, 302].map((vertex) => curve.movePoint(1, { vertex })));
        // The object follows the drawing of the curve; the promise is that of the last edit.
        await object.follow(curve);
        assert.notEqual(object.geometry, first);
        await drawn();
        const last = object.geometry;
        object.dispose();
        assert.equal(parent.children.length, 0);
        await curve.movePoint(1, points[1]);
        await curve.path();
        assert.equal(object.geometry, last);
        curve.dispose();
      });

      test(`a ${name} along a curve that cannot be made says so`, async () => {
        const curve = new SurfaceCurve(surface, { kind: 'catmullrom', points: [points[0]] });
        const object = new Kind(surface, curve, options);
        await assert.rejects(object.ready, { name: 'KarcherError' });
        object.dispose();
        curve.dispose();
      });

      test(`a ${name} follows another curve while the first one fails`, async () => {
        const failing = new SurfaceCurve(surface, { kind: 'catmullrom', points: [points[0]] });
        const curve = new SurfaceCurve(surface, { kind: 'catmullrom', points });
        const object = new Kind(surface, failing, options);
        await object.follow(curve);
        await object.ready;
        assert.deepEqual(
          arraysOf(object.geometry),
          arraysOf(geometry(surface, await curve.path(), options)),
        );
        for (const each of [object, failing, curve]) each.dispose();
      });
    }
  });
}
