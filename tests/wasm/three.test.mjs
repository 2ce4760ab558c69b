// `karcher/three`: hits of raycasts as surface points, attributes of geometries.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { load } from 'karcher';
import {
  decalGeometry,
  geometryOf,
  logMapUvs,
  surfaceFromGeometry,
  surfaceFromMesh,
  tubeGeometry,
  vertexColors,
} from 'karcher/three';
import { loadInWorker } from 'karcher/worker';
import * as THREE from 'three';
import { acceleratedRaycast, CENTER, MeshBVH, SAH } from 'three-mesh-bvh';
import { long, randomFrom, seed } from '../web/part.mjs';
import { geometries } from './geometries.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const vector = (random) => new THREE.Vector3().set(...[0, 0, 0].map(() => 2 * random() - 1));

/** An object at a random place, turned and scaled unevenly. */
function somewhere(geometry, random) {
  const object = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
  object.position.copy(vector(random)).multiplyScalar(5);
  object.rotation.set(6 * random(), 6 * random(), 6 * random());
  object.scale.set(0.5 + random(), 0.5 + 2 * random(), -0.3 - random());
  object.updateMatrixWorld();
  object.raycast = acceleratedRaycast;
  return object;
}

/** Hits of rays between random places around an object, at least `least` of them. */
function* hitsOf(object, random, least) {
  object.geometry.computeBoundingSphere();
  const { center, radius } = object.geometry.boundingSphere;
  const place = (size) =>
    vector(random)
      .multiplyScalar(size * radius)
      .add(center)
      .applyMatrix4(object.matrixWorld);
  for (let i = 0, hits = 0; hits < least && i < 50 * least; i++) {
    const from = place(3);
    const ray = new THREE.Raycaster(from, place(1).sub(from).normalize());
    for (const hit of ray.intersectObject(object)) {
      hits++;
      yield hit;
    }
  }
}

/** Changes of a geometry before or after the creation of its mesh. */
const trees = {
  'no tree': () => {},
  'a tree': (geometry) => {
    geometry.boundsTree = new MeshBVH(geometry, { strategy: CENTER });
  },
  'a tree by areas': (geometry) => {
    geometry.boundsTree = new MeshBVH(geometry, { strategy: SAH, targetLeafSize: 1 });
  },
  'an indirect tree': (geometry) => {
    geometry.boundsTree = new MeshBVH(geometry, { indirect: true });
  },
};

describe('a hit', () => {
  const names = Object.keys(geometries);
  const orders = Object.keys(trees).flatMap((first) =>
    Object.keys(trees).map((second) => [first, second]),
  );
  const most = Math.ceil((long ? 10_000 : 320) / (2 * orders.length));

  for (const name of names) {
    test(`is the surface point at its place: ${name}, whenever trees were made`, (t) => {
      t.diagnostic(`seed ${seed}`);
      const random = randomFrom(seed);
      let hits = 0;
      for (const [first, second] of orders) {
        for (const hasIndex of [true, false]) {
          const [given] = geometries[name];
          const geometry = hasIndex || !given.index ? given.clone() : given.toNonIndexed();
          trees[first](geometry);
          const surface = surfaceFromGeometry(karcher, geometry);
          trees[second](geometry);
          const object = somewhere(geometry, random);
          const toOwn = object.matrixWorld.clone().invert();
          for (const hit of hitsOf(object, random, most)) {
            const place = surface.mesh.position(surface.pointAt(hit));
            const away = hit.point
              .clone()
              .applyMatrix4(toOwn)
              .distanceTo({
                ...{ x: place[0], y: place[1], z: place[2] },
              });
            const message = `${first}, ${second}, ${hasIndex}: ${away}`;
            assert.ok(away <= 1e-6 * surface.diagonal, message);
            hits++;
          }
        }
      }
      assert.ok(hits >= orders.length * most, `${hits} hits`);
    });
  }

  test('is found beside vertices that have no place, which no face uses', () => {
    const positions = new Float32Array(3 * 5).fill(Number.NaN);
    positions.set([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3)).setIndex([0, 1, 2]);
    geometry.boundingSphere = new THREE.Sphere(new THREE.Vector3(), 2);
    const surface = surfaceFromGeometry(karcher, geometry);
    const ray = new THREE.Raycaster(new THREE.Vector3(0.25, 0.5, 1), new THREE.Vector3(0, 0, -1));
    const [hit] = ray.intersectObject(new THREE.Mesh(geometry));
    assert.deepEqual(surface.pointAt(hit), { face: 0, bary: [0.25, 0.25, 0.5] });
  });

  test('is refused if the object is another one, or has changed', () => {
    const random = randomFrom(seed);
    const geometry = new THREE.TorusGeometry(1, 0.4, 16, 48);
    const surface = surfaceFromGeometry(karcher, geometry);
    const changed = {
      'another one': new THREE.TorusKnotGeometry(1, 0.3, 64, 12),
      scaled: geometry.clone().scale(1, 1, 1.001),
      'other triangles of the same vertices': geometry.clone(),
    };
    const { index } = changed['other triangles of the same vertices'];
    // The other diagonal of a quadrilateral: a, b, d and b, c, d.
    for (let i = 0; i < index.count; i += 6) {
      const [a, b, d, , c] = index.array.slice(i, i + 5);
      index.array.set([a, b, c, a, c, d], i);
    }
    for (const [name, other] of Object.entries(changed)) {
      for (const hit of hitsOf(somewhere(other, random), random, 20)) {
        assert.throws(() => surface.pointAt(hit), { name: 'KarcherError', code: 'badPoint' }, name);
      }
    }
    const morphed = geometry.clone();
    const { position } = morphed.attributes;
    const target = position.clone();
    for (let v = 0; v < target.count; v++) target.setZ(v, 1.2 * target.getZ(v));
    morphed.morphAttributes.position = [target];
    const object = new THREE.Mesh(morphed, new THREE.MeshBasicMaterial());
    object.morphTargetInfluences = [1];
    const [hit] = new THREE.Raycaster(
      new THREE.Vector3(1.02, 0.13, 5),
      new THREE.Vector3(0, 0, -1),
    ).intersectObject(object);
    assert.throws(() => surface.pointAt(hit), { code: 'badPoint' });
    object.morphTargetInfluences = [0];
    surface.pointAt({
      ...hit,
      point: surface.position({ face: 3, bary: [0.2, 0.3, 0.5] }),
      face: null,
      faceIndex: 3,
    });
    object.scale.setScalar(0);
    object.updateMatrixWorld();
    assert.throws(() => surface.pointAt(hit), { code: 'badPoint', message: /nothing/ });
  });

  test('of an instance is in the coordinates of the geometry', () => {
    const geometry = new THREE.SphereGeometry(1, 24, 12);
    const surface = surfaceFromGeometry(karcher, geometry);
    const object = new THREE.InstancedMesh(geometry, new THREE.MeshBasicMaterial(), 2);
    object.setMatrixAt(1, new THREE.Matrix4().makeTranslation(3, 0, 0));
    const ray = new THREE.Raycaster(new THREE.Vector3(3.1, 0.2, 5), new THREE.Vector3(0, 0, -1));
    const [hit] = ray.intersectObject(object);
    assert.equal(hit.instanceId, 1);
    const place = surface.position(surface.pointAt(hit));
    assert.ok(place.distanceTo(hit.point.clone().sub({ x: 3, y: 0, z: 0 })) < 1e-6);
  });

  test('of a tree alone is in the coordinates of the geometry', () => {
    const geometry = new THREE.TorusGeometry(1, 0.4, 16, 48);
    const surface = surfaceFromGeometry(karcher, geometry);
    const tree = new MeshBVH(geometry);
    const ray = new THREE.Ray(new THREE.Vector3(1.02, 0.13, 5), new THREE.Vector3(0, 0, -1));
    const hit = tree.raycastFirst(ray, THREE.DoubleSide);
    assert.ok(surface.position(surface.pointAt(hit)).distanceTo(hit.point) < 1e-6);
  });

  test('of a double surface lies on the side that was hit', () => {
    // Two triangles, back to back.
    const geometry = new THREE.BufferGeometry();
    const places = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    geometry.setAttribute('position', new THREE.BufferAttribute(places, 3));
    geometry.setIndex([0, 2, 1, 0, 1, 2]);
    const surface = surfaceFromGeometry(karcher, geometry, { repair: 'none' });
    const object = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial());
    for (const side of [-1, 1]) {
      const from = new THREE.Vector3(0.2, 0.2, side);
      const [hit] = new THREE.Raycaster(from, new THREE.Vector3(0, 0, -side)).intersectObject(
        object,
      );
      assert.equal(surface.normal(surface.pointAt(hit)).z, side);
    }
  });
});

describe('a surface', () => {
  test('has the place, the normal and the frame of a point', () => {
    const surface = surfaceFromGeometry(karcher, new THREE.BoxGeometry(1, 2, 3, 2, 3, 4));
    const point = { face: 5, bary: [0.2, 0.3, 0.5] };
    const place = surface.position(point);
    assert.deepEqual(
      place.toArray().map(Math.fround),
      surface.mesh.position(point).map(Math.fround),
    );
    const normal = surface.normal(point);
    // The normal points out of the box, whose sides are orthogonal to the axes.
    assert.ok(normal.dot(place) > 0);
    assert.equal(Math.max(...normal.toArray().map(Math.abs)), 1);
    const frame = surface.frame(point);
    assert.ok(Math.abs(frame.determinant() - 1) < 1e-12);
    assert.ok(
      new THREE.Vector3(0, 0, 2).applyMatrix4(frame).distanceTo(place.addScaledVector(normal, 2)) <
        1e-12,
    );
    assert.ok(
      surface
        .position({ vertex: 7 })
        .distanceTo(new THREE.Vector3(...surface.mesh.position({ vertex: 7 }))) < 1e-12,
    );
    assert.throws(() => surface.position({ face: 1e6, bary: [1, 0, 0] }), { code: 'badIndex' });
    assert.throws(() => surface.normal({ vertex: -1 }), { code: 'badIndex' });
    const none = new THREE.BufferGeometry();
    assert.throws(() => surfaceFromGeometry(karcher, none), { code: 'badArgument' });
  });

  test('reads interleaved positions and integers', () => {
    const plain = new THREE.IcosahedronGeometry(1, 2);
    const { position } = plain.attributes;
    const numbers = Int16Array.from(position.array, (x) => Math.round(32767 * x));
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(numbers, 3, true));
    const surface = surfaceFromGeometry(karcher, geometry);
    assert.equal(surface.mesh.info.boundaryLoops, 0);
    assert.ok(Math.abs(surface.diagonal - 2 * Math.sqrt(3)) < 0.5);
  });

  test('becomes a welded geometry with the groups, whose hits are its points', () => {
    const random = randomFrom(seed);
    const box = new THREE.BoxGeometry(1, 2, 3, 2, 3, 4);
    const surface = surfaceFromGeometry(karcher, box);
    const geometry = geometryOf(surface, box);
    assert.deepEqual(geometry.groups, box.groups);
    assert.ok(geometry.index.array instanceof Uint32Array);
    assert.ok(geometry.attributes.position.array instanceof Float32Array);
    const used = new Set(geometry.index.array);
    assert.equal(used.size, surface.mesh.info.vertices);
    const shape = surfaceFromMesh(karcher.shape('torus', 2000));
    const drawn = geometryOf(shape);
    trees['a tree'](drawn);
    for (const hit of hitsOf(somewhere(drawn, random), random, 50)) {
      const toOwn = hit.object.matrixWorld.clone().invert();
      const place = new THREE.Vector3(...shape.mesh.position(shape.pointAt(hit)));
      assert.ok(place.distanceTo(hit.point.applyMatrix4(toOwn)) < 1e-6 * shape.diagonal);
    }
  });

  test('has one normal across seams whose vertices differ by rounding', async () => {
    const worker = await loadInWorker();
    // At the seam of three.js's sphere the sine of 2 pi is not 0.
    const sphere = new THREE.SphereGeometry(1, 24, 16);
    const inPage = surfaceFromGeometry(karcher, sphere);
    for (const surface of [inPage, await surfaceFromGeometry(worker, sphere)]) {
      const geometry = geometryOf(surface);
      const { position, normal } = geometry.attributes;
      const [place, upright] = [new THREE.Vector3(), new THREE.Vector3()];
      // The mesh is symmetric about its axis, so that normals of one row have one slope.
      const slopes = new Map();
      for (let v = 0; v < position.count; v++) {
        if (!geometry.index.array.includes(v)) continue;
        place.fromBufferAttribute(position, v);
        const radial = upright.fromBufferAttribute(normal, v).dot(place);
        const row = Math.floor(v / 25);
        const slope = slopes.get(row) ?? radial;
        slopes.set(row, slope);
        assert.ok(Math.abs(radial - slope) < 1e-6, `vertex ${v}: ${radial}, not ${slope}`);
      }
      const object = somewhere(geometry, randomFrom(seed));
      for (const hit of hitsOf(object, randomFrom(seed), 200)) surface.pointAt(hit);
    }
    worker.dispose();
  });

  test('has distances as colors and a log map as texture coordinates', () => {
    const plane = new THREE.PlaneGeometry(2, 2, 8, 8);
    const surface = surfaceFromGeometry(karcher, plane);
    const center = { vertex: 40 };
    const colors = vertexColors([0, 1, Number.NaN, 2], {
      ramp: (part, color) => color.setRGB(part, 0, 0),
    });
    assert.deepEqual([...colors.array], [0, 0, 0, 0.5, 0, 0, 0.5, 0.5, 0.5, 1, 0, 0]);
    assert.equal(vertexColors(surface.mesh.distance(center)).count, 81);
    const vertices = Array.from({ length: 81 }, (_, vertex) => ({ vertex }));
    const { vectors } = surface.mesh.logMap(center, vertices);
    // On a plane the texture coordinates equal the plane's up to a motion: lengths stay.
    const uvs = logMapUvs(vectors, surface.frame(center), 1);
    assert.deepEqual([uvs.getX(40), uvs.getY(40)], [0.5, 0.5]);
    for (let v = 0; v < 81; v++) {
      const away = 2 * Math.hypot(uvs.getX(v) - 0.5, uvs.getY(v) - 0.5);
      const place = surface.position({ vertex: v });
      assert.ok(Math.abs(away - place.length()) < 1e-6, `${v}`);
    }
    assert.ok(logMapUvs([Number.NaN, 0, 0], surface.frame(center), 1).getX(0) < -1);
  });

  test('makes decals, without triangles across the cut locus', () => {
    // The surface is a cylinder with an odd number of sides: no vertex is opposite to another.
    const [sides, rings] = [33, 9];
    const positions = [];
    const triangles = [];
    for (let j = 0; j < rings; j++) {
      for (let i = 0; i < sides; i++) {
        const angle = (2 * Math.PI * i) / sides;
        positions.push(Math.cos(angle), Math.sin(angle), 0.2 * j);
        if (j === 0) continue;
        const [a, b] = [(j - 1) * sides + i, (j - 1) * sides + ((i + 1) % sides)];
        triangles.push(a, b, b + sides, a, b + sides, a + sides);
      }
    }
    const surface = surfaceFromMesh(karcher.meshFromArrays(positions, triangles));
    const center = { vertex: 4 * sides };
    const { vectors } = surface.mesh.logMap(center);
    const facesOf = (radius, options) => {
      const { array } = decalGeometry(
        surface,
        vectors,
        surface.frame(center),
        radius,
        options,
      ).index;
      return Array.from({ length: array.length / 3 }, (_, f) => [...array.slice(3 * f, 3 * f + 3)]);
    };
    const isOpposite = (face) =>
      face.some((v) => v % sides === 16) && face.some((v) => v % sides === 17);
    const all = facesOf(10);
    assert.equal(all.length, (sides - 1) * 2 * (rings - 1));
    assert.equal(all.filter(isOpposite).length, 0);
    assert.equal(facesOf(10, { stretch: 1e3 }).length, 2 * sides * (rings - 1));
    // A small picture covers only the triangles that it reaches.
    const near = facesOf(0.3);
    assert.ok(near.length > 0 && near.length < all.length / 4, `${near.length}`);
    for (const face of near) {
      const away = face.map((v) => Math.min(v % sides, sides - (v % sides)));
      assert.ok(Math.min(...away) <= 2, `${face}`);
    }
    assert.throws(() => facesOf(1, { stretch: 0 }), { code: 'badArgument' });
  });

  test('makes decals that are smooth where several vertices lie at one place', () => {
    const surface = surfaceFromGeometry(karcher, new THREE.IcosahedronGeometry(1, 6));
    const center = { vertex: 0 };
    const { vectors } = surface.mesh.logMap(center);
    const { index, attributes } = decalGeometry(surface, vectors, surface.frame(center), 0.5);
    const at = (attribute, v) => new THREE.Vector3().fromBufferAttribute(attribute, v);
    assert.ok(index.count > 100);
    for (const v of index.array) {
      // The normals of the unit sphere are its places.
      const away = at(attributes.normal, v).distanceTo(at(attributes.position, v));
      assert.ok(away < 0.05, `vertex ${v}: ${away}`);
    }
  });

  test('has tubes along paths', () => {
    const surface = surfaceFromGeometry(karcher, new THREE.TorusGeometry(1, 0.4, 24, 64));
    const { path } = surface.mesh.circle({ face: 100, bary: [0.2, 0.3, 0.5] }, { radius: 0.3 });
    const radius = 0.02;
    const tube = tubeGeometry(surface, path, { radius, sides: 6 });
    // The tube is closed, has the genus of a torus, and faces outwards.
    const { info } = surfaceFromGeometry(karcher, tube).mesh;
    assert.deepEqual([info.boundaryLoops, info.genus, info.repairs.length], [0, 1, 0]);
    const places = tube.attributes.position;
    const [a, b, c] = [0, 1, 2].map((k) =>
      new THREE.Vector3().fromBufferAttribute(places, tube.index.getX(k)),
    );
    const out = new THREE.Vector3().fromBufferAttribute(tube.attributes.normal, tube.index.getX(0));
    assert.ok(b.sub(a).cross(c.sub(a)).dot(out) > 0);
    const open = tubeGeometry(surface, surface.mesh.shortestPath({ vertex: 3 }, { vertex: 400 }));
    assert.equal(surfaceFromGeometry(karcher, open).mesh.info.boundaryLoops, 2);
    assert.throws(() => tubeGeometry(surface, path, { sides: 2 }), { code: 'badArgument' });
  });
});
