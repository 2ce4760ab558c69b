// Files of glTF compressed by Draco or meshoptimizer: readers restore written meshes, in this
// thread and in a worker, and report damage.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { load } from 'karcher';
import { meshFromFile, namesBeside } from 'karcher/formats';
import { loadInWorker } from 'karcher/worker';
import { dracoFile, dracoParts, meshoptFile, meshoptParts } from './compressed_files.mjs';
import { glbFile, glbOf } from './mesh_files.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

/** A torus of n by n quads, each of two triangles. */
function torus(n) {
  const positions = [];
  const faces = [];
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      const [u, v] = [(2 * Math.PI * i) / n, (2 * Math.PI * j) / n];
      const r = 2 + 0.7 * Math.cos(v);
      positions.push(r * Math.cos(u), r * Math.sin(u), 0.7 * Math.sin(v));
      const at = (a, b) => n * (a % n) + (b % n);
      faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
      faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
    }
  }
  return { positions, faces };
}

/** Triangles by the places of their corners, each starting with its least corner, sorted. */
function trianglesOf(positions, corners) {
  const told = (vertex) => Array.from(positions.slice(3 * vertex, 3 * vertex + 3)).join(' ');
  return Array.from({ length: corners.length / 3 }, (_, i) => {
    const three = [0, 1, 2].map((k) => told(corners[3 * i + k]));
    const first = three.indexOf([...three].sort()[0]);
    return [...three.slice(first), ...three.slice(0, first)].join(', ');
  }).sort();
}

const meshTriangles = (mesh) => trianglesOf(mesh.positions(), mesh.triangles());
const shape = torus(40);
const written = trianglesOf(Float32Array.from(shape.positions), shape.faces.flat());

test('each compression restores the written mesh', async () => {
  const plain = glbFile(shape).length;
  for (const [name, bytes] of Object.entries({
    draco: await dracoFile(shape),
    'EXT meshopt': await meshoptFile(shape),
    'KHR meshopt': await meshoptFile(shape, { name: 'KHR_meshopt_compression' }),
  })) {
    assert.ok(bytes.length < plain, name);
    const { mesh, file } = await meshFromFile(karcher, bytes);
    assert.deepEqual(meshTriangles(mesh), written, name);
    assert.deepEqual(file.notRead, [], name);
    mesh.dispose();
  }
});

test('places rounded by Draco are as near as it promises', async () => {
  const bits = 12;
  const { mesh } = await meshFromFile(karcher, await dracoFile(shape, { bits }));
  assert.equal(mesh.info.vertices, shape.positions.length / 3);
  assert.equal(mesh.info.triangles, shape.faces.length);
  // Half a step of the finest grid over the longest side, in each coordinate, and the rounding to
  // floats.
  const most = (0.51 * 5.4) / (2 ** bits - 1);
  const positions = mesh.positions();
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = positions.subarray(i, i + 3);
    const off = Math.abs(Math.hypot(Math.hypot(x, y) - 2, z) - 0.7);
    assert.ok(off <= Math.sqrt(3) * most, `vertex ${i / 3} is ${off} off`);
  }
  mesh.dispose();
});

test('in a worker', async () => {
  const remote = await loadInWorker();
  after(() => remote.dispose());
  for (const bytes of [await dracoFile(shape), await meshoptFile(shape)]) {
    const { mesh } = await remote.meshFromFile(bytes);
    assert.equal(mesh.info.triangles, shape.faces.length);
  }
});

test('a buffer that only replaces compressed data is not requested', async () => {
  const { json } = await meshoptParts(shape);
  json.buffers[0].uri = 'compressed.bin';
  json.buffers[1].uri = 'fallback.bin';
  const text = new TextEncoder().encode(JSON.stringify(json));
  assert.deepEqual(namesBeside(text, 'mesh.gltf'), ['compressed.bin']);
});

test('damaged data is refused with its name', async () => {
  const changed = async (parts, change) => {
    const { json, buffer } = await parts;
    const copy = { json: structuredClone(json), buffer: buffer.slice() };
    change(copy.json, copy.buffer);
    return glbOf(copy);
  };
  const meshopt = (json, i) => json.bufferViews[i].extensions.EXT_meshopt_compression;
  const cases = [
    [
      await changed(dracoParts(shape), (json) => {
        json.accessors[1].count = 3;
      }),
      /buffer view 0, which Draco compressed, has 3,200 triangles of 1,600 vertices, but/,
    ],
    [
      await changed(dracoParts(shape), (_, buffer) => buffer.fill(0, 0, 5)),
      /buffer view 0, which Draco compressed, cannot be read/,
    ],
    [
      await changed(dracoParts(shape), (json) => {
        json.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.attributes.POSITION = 7;
      }),
      /it has no attribute 7/,
    ],
    [
      await changed(meshoptParts(shape), (_, buffer) => buffer.fill(0, 0, 1)),
      /buffer view 0, which meshoptimizer compressed, is damaged/,
    ],
    [
      await changed(meshoptParts(shape), (json) => {
        meshopt(json, 0).count = 4e9;
      }),
      /buffer view 0, .* declares 48,000,000,000 bytes, more than/,
    ],
    [
      await changed(meshoptParts(shape), (json) => {
        meshopt(json, 0).filter = 'constructor';
      }),
      /of a kind that is not known/,
    ],
  ];
  for (const [bytes, message] of cases) {
    await assert.rejects(meshFromFile(karcher, bytes), { code: 'badFile', message });
  }
});

test('triangles compressed by Draco are read without an accessor', async () => {
  const { json, buffer } = await dracoParts(shape);
  const [primitive] = json.meshes[0].primitives;
  const numbers = json.accessors.splice(primitive.indices, 1);
  assert.equal(numbers.length, 1);
  delete primitive.indices;
  const { mesh, file } = await meshFromFile(karcher, glbOf({ json, buffer }));
  assert.deepEqual(meshTriangles(mesh), written);
  assert.deepEqual(file.parts, [{ name: 'body', triangles: shape.faces.length }]);
  json.accessors[0].count++;
  await assert.rejects(meshFromFile(karcher, glbOf({ json, buffer })), {
    code: 'badFile',
    message: /3,200 triangles of 1,600 vertices, but its accessors declare 1,601$/,
  });
});

test('colors compressed by Draco are read; wrong ones do not make a surface fail', async () => {
  const vertices = shape.positions.length / 3;
  // Light of 0 and 1 is the same in sRGB.
  const colors = Array.from({ length: 4 * vertices }, (_, i) =>
    i % 7 < 3 || i % 4 === 3 ? 255 : 0,
  );
  const given = colors.filter((_, i) => i % 4 !== 3);
  const read = async (change = () => {}) => {
    const parts = await dracoParts(shape, { colors });
    change(parts.json);
    return (await meshFromFile(karcher, glbOf(parts))).file.colors;
  };
  assert.deepEqual(Array.from(await read()), given);
  const white = given.map(() => 255);
  const extension = (json) =>
    json.meshes[0].primitives[0].extensions.KHR_draco_mesh_compression.attributes;
  for (const [change, wanted] of [
    [(json) => (extension(json).COLOR_0 = 9), white],
    [(json) => (json.accessors.at(-1).type = 'VEC3'), white],
    [(json) => delete extension(json).COLOR_0, null],
  ]) {
    const found = await read(change);
    assert.deepEqual(found && Array.from(found), wanted);
  }
});
