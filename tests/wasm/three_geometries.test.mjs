// Standard geometries of three.js, whose seams are open in the buffers and closed in the mesh.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { geometryOf, surfaceFromGeometry, surfaceFromMesh } from 'karcher/three';
import { loadInWorker } from 'karcher/worker';
import * as THREE from 'three';
import { geometries } from './geometries.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const arraysOf = ({ index, attributes: { position } }) => ({
  positions: position.array,
  triangles: index?.array ?? Uint32Array.from({ length: position.count }, (_, i) => i),
});

function meshOf(geometry) {
  const { positions, triangles } = arraysOf(geometry);
  return karcher.meshFromArrays(positions, triangles);
}

const key = (positions, v) =>
  Array.from(positions.slice(3 * v, 3 * v + 3), (x) => Math.round(x * 1e4)).join();

for (const [name, [geometry, boundaryLoops, genus]] of Object.entries(geometries)) {
  for (const [form, own] of [
    [name, geometry],
    [`${name}, without an index`, geometry.index ? geometry.toNonIndexed() : geometry],
  ]) {
    test(`${form}: is closed as expected`, () => {
      const { info } = meshOf(own);
      assert.deepEqual(
        [info.components, info.boundaryLoops, info.genus],
        [1, boundaryLoops, genus],
        JSON.stringify(info.repairs),
      );
    });

    test(`${form}: a raycast finds its point`, () => {
      const mesh = meshOf(own);
      const scene = new THREE.Mesh(own, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
      own.computeBoundingSphere();
      const { center, radius } = own.boundingSphere;
      let hits = 0;
      for (let i = 0; i < 60; i++) {
        const [a, b] = [2.4 * i, Math.acos(1 - (2 * i + 1) / 60)];
        const out = new THREE.Vector3(
          Math.sin(b) * Math.cos(a),
          Math.sin(b) * Math.sin(a),
          Math.cos(b),
        );
        const from = center.clone().addScaledVector(out, 2 * radius);
        const aim = center
          .clone()
          .add(new THREE.Vector3(out.y, out.z, out.x).multiplyScalar(0.5 * radius));
        const ray = new THREE.Raycaster(from, aim.sub(from).normalize());
        for (const { faceIndex, barycoord, point } of ray.intersectObject(scene)) {
          const place = mesh.position(mesh.surfacePoint(faceIndex, barycoord));
          assert.ok(point.distanceTo(new THREE.Vector3(...place)) < 1e-5 * radius);
          hits++;
        }
      }
      assert.ok(hits > 5, `${hits} hits`);
    });
  }

  test(`${name}: distances equal those of the form without an index`, () => {
    const [mesh, other] = [
      meshOf(geometry),
      meshOf(geometry.index ? geometry.toNonIndexed() : geometry),
    ];
    const places = mesh.positions();
    // Both forms have the same order of faces.
    const start = {
      face: Math.floor(arraysOf(geometry).triangles.length / 6),
      bary: [0.2, 0.3, 0.5],
    };
    const distances = mesh.distance(start);
    const byPlace = new Map();
    for (const [v, distance] of distances.entries()) {
      if (Number.isNaN(distance)) continue;
      const place = key(places, v);
      // The vertices of a seam are one vertex of the mesh.
      assert.ok(!byPlace.has(place) || Math.abs(byPlace.get(place) - distance) < 1e-9, place);
      byPlace.set(place, distance);
    }
    const otherPlaces = other.positions();
    for (const [v, distance] of other.distance(start).entries()) {
      // Only degenerate triangles have such vertices.
      if (Number.isNaN(distance)) continue;
      const expected = byPlace.get(key(otherPlaces, v));
      assert.ok(
        expected !== undefined && Math.abs(distance - expected) < 1e-4,
        `${v}: ${distance}`,
      );
    }
  });
}

for (const [name, [geometry]] of Object.entries(geometries)) {
  test(`${name}: log vectors at a vertex lie in the plane of its frame`, () => {
    const surface = surfaceFromGeometry(karcher, geometry);
    const { position } = geometry.attributes;
    const step = Math.ceil(position.count / 300);
    const used = new Set(arraysOf(geometry).triangles);
    for (let vertex = 0; vertex < position.count; vertex += step) {
      if (!used.has(vertex)) continue;
      const place = new THREE.Vector3().fromBufferAttribute(position, vertex);
      assert.ok(surface.position({ vertex }).equals(place), `vertex ${vertex}`);
      const normal = new THREE.Vector3().setFromMatrixColumn(surface.frame({ vertex }), 2);
      assert.ok(Math.abs(normal.length() - 1) < 1e-12, `vertex ${vertex}`);
      assert.ok(Math.abs(surface.normal({ vertex }).length() - 1) < 1e-12, `vertex ${vertex}`);
      const others = [0.3, 0.7].map((part) => ({
        face: Math.floor((part * arraysOf(geometry).triangles.length) / 3),
        bary: [0.2, 0.3, 0.5],
      }));
      const { vectors } = surface.mesh.logMap({ vertex }, others);
      for (let i = 0; i < vectors.length; i += 3) {
        const away = normal.dot(new THREE.Vector3().fromArray(vectors, i));
        assert.ok(Math.abs(away) < 1e-9 * surface.diagonal, `vertex ${vertex}: ${away}`);
      }
    }
  });
}

test('with the engine in a worker, the frame of a vertex is that of its log vectors, too', async () => {
  const remote = await loadInWorker();
  const open = new THREE.CylinderGeometry(1, 1.5, 2, 24, 3, true);
  for (const geometry of [open, ...Object.values(geometries).map(([given]) => given)]) {
    const [surface, own] = [
      await surfaceFromGeometry(remote, geometry),
      surfaceFromGeometry(karcher, geometry),
    ];
    for (const vertex of new Set(arraysOf(geometry).triangles)) {
      const [frame, expected] = [surface.frame({ vertex }), own.mesh.frame({ vertex })];
      const axes = [0, 1, 2].map((k) => new THREE.Vector3().setFromMatrixColumn(frame, k));
      axes.forEach((axis, k) => {
        const away = axis.distanceTo(new THREE.Vector3(...expected[k]));
        assert.ok(away < 1e-9, `vertex ${vertex}: ${away}`);
      });
    }
    const vertex = geometry.attributes.position.count >> 1;
    const { vectors } = await surface.mesh.logMap({ vertex }, [{ face: 1, bary: [0.2, 0.3, 0.5] }]);
    const normal = new THREE.Vector3().setFromMatrixColumn(surface.frame({ vertex }), 2);
    assert.ok(Math.abs(normal.dot(new THREE.Vector3().fromArray(vectors))) < 1e-9);
  }
  await remote.dispose();
});

test('geometryOf has separate normals for parts that are at one place but not welded', async () => {
  const triangle = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  const remote = await loadInWorker();
  for (const [places, triangles, options] of [
    // A triangle and its back.
    [[...triangle, ...triangle], [0, 1, 2, 3, 5, 4], { weld: 0 }],
    // Two triangles that touch at a corner.
    [
      [...triangle, 0, 0, 0, 0, -1, 0, 0, 0, 1],
      [0, 1, 2, 3, 4, 5],
    ],
    // Two triangles whose common edge is not welded.
    [[...triangle, 0, 0, 0, 0, 1, 0, 0, 0, 1], [0, 1, 2, 3, 4, 5], { weld: 0 }],
  ]) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
    geometry.setIndex(triangles);
    for (const engine of [karcher, remote]) {
      const mesh = await engine.meshFromArrays(places, triangles, options);
      const surfaces = [
        await surfaceFromGeometry(engine, geometry, options),
        await surfaceFromMesh(mesh),
      ];
      for (const surface of surfaces) {
        const { index, attributes } = geometryOf(surface);
        for (const [i, v] of index.array.entries()) {
          const normal = new THREE.Vector3().fromBufferAttribute(attributes.normal, v);
          const expected = surface.normal({ face: Math.floor(i / 3), bary: [1, 0, 0] });
          assert.ok(normal.distanceTo(expected) < 1e-6, `${places}: ${normal.toArray()}`);
        }
      }
    }
  }
  await remote.dispose();
});

test('vertices that welding replaced have the normals of those they are welded to', async () => {
  const remote = await loadInWorker();
  // Two strips touch at a vertex. There, two vertices of each strip are welded.
  const touching = new THREE.BufferGeometry();
  const strip = (x, y) => [0, 0, 0, x, 0, 0, 0, y, 1, 0, 0, 0, 0, y, 1, -x, 0, 0];
  const places = [...strip(1, 1), ...strip(2, -1)];
  touching.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
  for (const geometry of [...Object.values(geometries).map(([first]) => first), touching]) {
    const { positions, triangles } = arraysOf(geometry);
    const { normal: expected } = geometryOf(surfaceFromGeometry(karcher, geometry)).attributes;
    for (const engine of [karcher, remote]) {
      const mesh = await engine.meshFromArrays(positions, triangles);
      const { normal } = geometryOf(await surfaceFromMesh(mesh)).attributes;
      for (const v of triangles) {
        const away = new THREE.Vector3()
          .fromBufferAttribute(normal, v)
          .distanceTo(new THREE.Vector3().fromBufferAttribute(expected, v));
        assert.ok(away < 1e-6, `${geometry.type} ${v}: ${away}`);
      }
    }
  }
  await remote.dispose();
});

test('paths across seams have the right length', () => {
  // The ends are two edges of the polygon of `sides` sides apart. A path beside the vertex between
  // may be shorter than these edges, but not than the chord.
  const isOverTwoEdges = (length, radius, sides) => {
    const edges = 4 * radius * Math.sin(Math.PI / sides);
    const chord = 2 * radius * Math.sin((2 * Math.PI) / sides);
    assert.ok(length > chord && length < edges + 1e-6, `${chord} < ${length} < ${edges}`);
  };
  // The path is on the outer equator of a torus, from one step before the seam to one after it.
  // Vertex (j, i) is j (around the tube) * row + i (around the axis).
  const mesh = meshOf(new THREE.TorusGeometry(1, 0.4, 16, 48));
  const row = 48 + 1;
  isOverTwoEdges(mesh.shortestPath({ vertex: 47 }, { vertex: 1 }).length, 1.4, 48);
  // This path crosses the seam of the tube.
  isOverTwoEdges(mesh.shortestPath({ vertex: 15 * row }, { vertex: row }).length, 0.4, 16);
  // This path leads over the pole of a sphere, from one side of the ring around it to the other.
  const sphere = meshOf(new THREE.SphereGeometry(1, 32, 16));
  isOverTwoEdges(sphere.shortestPath({ vertex: 33 }, { vertex: 33 + 16 }).length, 1, 32);
  // This path leads from the center of a cylinder's cap down its side.
  const cylinder = meshOf(new THREE.CylinderGeometry(1, 1, 2, 24, 4));
  const places = cylinder.positions();
  const vertexAt = (...place) =>
    places.findIndex((_, i) => i % 3 === 0 && place.every((x, k) => places[i + k] === x)) / 3;
  const down = cylinder.shortestPath({ vertex: vertexAt(0, 1, 0) }, { vertex: vertexAt(0, 0, 1) });
  // Through the rim's vertex its length is 2; beside the vertex it is slightly less, as the rim is
  // a polygon.
  assert.ok(down.length < 2 + 1e-6 && down.length > 1 + Math.cos(Math.PI / 24), `${down.length}`);
});
