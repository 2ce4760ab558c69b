// Files of meshes: a reader of each format returns the mesh that was written.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { load } from 'karcher';
import { fileEndings, formatOf, guessUp, meshFromFile, namesBeside } from 'karcher/formats';
import { loadInWorker } from 'karcher/worker';
import { SphereGeometry, Mesh as ThreeMesh, TorusGeometry } from 'three';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import * as files from './mesh_files.mjs';

const { box, cutBox, encode } = files;
let karcher;
before(async () => {
  karcher = await load();
});

const open = (bytes, options) => meshFromFile(karcher, bytes, options);

/** Places of a mesh's corners, triangle by triangle. */
function placesOf(mesh) {
  const positions = mesh.positions();
  return Array.from(mesh.triangles(), (vertex) =>
    Array.from(positions.subarray(3 * vertex, 3 * vertex + 3)),
  );
}

const written = ({ positions, faces }) =>
  faces.flat().map((vertex) => positions.slice(3 * vertex, 3 * vertex + 3));

test('every format restores the written mesh, corner by corner', async () => {
  for (const [name, bytes] of Object.entries(files.everyFile(cutBox))) {
    const { mesh, file } = await open(bytes, { name });
    assert.deepEqual(placesOf(mesh), written(cutBox), name);
    assert.equal(mesh.info.vertices, 8, name);
    assert.equal(mesh.info.boundaryLoops, 0, name);
    assert.deepEqual(mesh.info.repairs, [], name);
    assert.equal(file.parts.length, 1, name);
    assert.equal(file.parts[0].triangles, 12, name);
    mesh.dispose();
  }
});

test('the content identifies the format, and the name if the content does not', () => {
  for (const [name, bytes] of Object.entries(files.everyFile(cutBox))) {
    const format = name.split('.')[1].replace('glb', 'gltf');
    assert.equal(formatOf(bytes), format, name);
    assert.equal(formatOf(bytes, 'mesh.obj'), format, name);
  }
  assert.equal(formatOf(encode('anything'), 'x.STL'), 'stl');
  assert.deepEqual(fileEndings, ['.obj', '.ply', '.stl', '.off', '.glb', '.gltf']);
});

test('polygons are cut as those of an OBJ file', async () => {
  const wanted = await open(files.objFile(box));
  for (const bytes of [
    files.plyFile(box),
    files.plyFile(box, { encoding: 'big' }),
    files.offFile(box),
  ]) {
    const { mesh, file } = await open(bytes);
    assert.deepEqual(mesh.triangles(), wanted.mesh.triangles());
    assert.deepEqual(mesh.positions(), wanted.mesh.positions());
    assert.deepEqual(mesh.info.repairs, wanted.mesh.info.repairs);
    assert.equal(file.parts[0].triangles, 12);
  }
  // A star with crossing sides, and a triangle.
  const crossed = {
    positions: [0, 3, 0, 2, -3, 0, -3, 1, 0, 3, 1, 0, -2, -3, 0],
    faces: [[0, 1, 2, 3, 4]],
  };
  await assert.rejects(open(files.offFile(crossed)), {
    code: 'degenerateFace',
    message: /^face 0: the face with 5 corners cannot be cut/,
  });
  const more = { ...crossed, faces: [[0, 1, 2], ...crossed.faces] };
  for (const bytes of [files.offFile(more), files.plyFile(more, { encoding: 'big' })]) {
    const { mesh } = await open(bytes);
    assert.equal(mesh.info.triangles, 1);
    assert.match(mesh.info.repairs[0].message, /^1 face was left out: .* \(the first: face 1\)$/);
  }
});

test('numbers in a text are the nearest doubles, in every notation', async () => {
  const numbers = [
    ...['0.1', '1e22', '-1.7976931348623157e10', '123456789012345678', '+.5', '5.', '1E-5'],
    ...['0.30000000000000004', '-0', '9007199254740993', '2.2250738585072014e-10', '1e-7'],
  ];
  const vertices = numbers.map((number, i) => `${number} ${i} ${i * i}`);
  const text = `OFF\n${numbers.length} 1 0\n${vertices.join('\n')}\n3 0 8 5\n`;
  // Vertices without a face are no part of the surface, but keep their place.
  const { mesh } = await open(encode(text));
  const xs = Array.from(mesh.positions()).filter((_, i) => i % 3 === 0);
  assert.deepEqual(xs, numbers.map(Number));
});

test('files by three.js are read, and three.js reads the same', async () => {
  const torus = new TorusGeometry(1, 0.4, 12, 30);
  const place = (i) =>
    [0, 1, 2].map((axis) => Math.fround(torus.attributes.position.array[3 * i + axis]));
  const wanted = Array.from(torus.index.array, place);
  const near = (mesh) => {
    const places = placesOf(mesh);
    assert.equal(places.length, wanted.length);
    for (const [i, found] of places.entries()) {
      assert.ok(found.every((x, axis) => Math.abs(x - wanted[i][axis]) < 1e-6));
    }
    assert.deepEqual([mesh.info.boundaryLoops, mesh.info.genus], [0, 1]);
  };
  const object = new ThreeMesh(torus);
  const bytesOf = (result) =>
    typeof result === 'string' ? encode(result) : new Uint8Array(result.buffer ?? result);
  const ply = (options) => bytesOf(new PLYExporter().parse(object, null, options));
  near((await open(ply({}))).mesh);
  near((await open(ply({ binary: true }))).mesh);
  near((await open(ply({ binary: true, littleEndian: true }))).mesh);
  near((await open(bytesOf(new STLExporter().parse(object)))).mesh);
  near((await open(bytesOf(new STLExporter().parse(object, { binary: true })))).mesh);

  const nodes = [
    { children: [1, 2], translation: [1, 2, 3], rotation: [0.5, 0.5, 0.5, 0.5] },
    { mesh: 0, scale: [2, -1, 1] },
    { mesh: 0, matrix: [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 9, 0, 0, 1] },
  ];
  const glb = files.glbFile(cutBox, { nodes });
  const { scene } = await new GLTFLoader().parseAsync(glb.slice().buffer, '');
  scene.updateMatrixWorld(true);
  const shown = [];
  scene.traverse((node) => {
    if (!node.isMesh) return;
    const { position } = node.geometry.attributes;
    const turned = node.matrixWorld.determinant() < 0;
    const index = Array.from(node.geometry.index.array);
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = index.slice(i, i + 3);
      for (const vertex of turned ? [a, c, b] : [a, b, c]) {
        shown.push(
          node.localToWorld(scene.position.clone().fromBufferAttribute(position, vertex)).toArray(),
        );
      }
    }
  });
  const { mesh } = await open(glb);
  for (const [i, found] of placesOf(mesh).entries()) {
    assert.ok(found.every((x, axis) => Math.abs(x - shown[i][axis]) < 1e-12));
  }
  assert.equal(mesh.info.components, 2);
});

test('glTF: strips, fans, no indices, normalized and sparse numbers', async () => {
  const { json, buffer } = files.gltfParts(cutBox);
  const withMode = (mode, corners, changes = {}) => {
    const view = new DataView(buffer.buffer.slice(0));
    for (const [i, vertex] of corners.entries()) view.setUint32(4 * (24 + i), vertex, true);
    const [position, index] = json.accessors;
    return files.glbOf({
      json: {
        ...json,
        meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, mode }] }],
        accessors: [position, { ...index, count: corners.length }],
        ...changes,
      },
      buffer: new Uint8Array(view.buffer),
    });
  };
  const trianglesOf = async (bytes) => Array.from((await open(bytes)).mesh.triangles());
  assert.deepEqual(await trianglesOf(withMode(5, [0, 1, 2, 3, 7])), [0, 1, 2, 1, 3, 2, 2, 3, 7]);
  assert.deepEqual(await trianglesOf(withMode(6, [0, 1, 2, 3])), [0, 1, 2, 0, 2, 3]);

  const soup = { positions: written(cutBox).flat(), faces: [] };
  const plain = files.gltfParts(soup);
  plain.json.meshes = [{ primitives: [{ attributes: { POSITION: 0 } }] }];
  const { mesh } = await open(files.glbOf(plain));
  assert.deepEqual(placesOf(mesh), written(cutBox));
  assert.deepEqual([mesh.info.vertices, mesh.info.boundaryLoops], [8, 0], 'welded');

  // Rows of bytes: 0 0 0, 255 0 0, and 0 0 0, which sparse values replace by 0 255 51.
  const bytes = [0, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0, 2, 0, 255, 51];
  const quantized = {
    asset: { version: '2.0' },
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [
      {
        ...{ bufferView: 0, componentType: 5121, normalized: true, count: 3, type: 'VEC3' },
        sparse: {
          count: 1,
          indices: { bufferView: 1, componentType: 5121 },
          values: { bufferView: 1, byteOffset: 1 },
        },
      },
    ],
    bufferViews: [
      { buffer: 0, byteLength: 12, byteStride: 4 },
      { buffer: 0, byteOffset: 12, byteLength: 4 },
    ],
    buffers: [
      { uri: `data:application/gltf-buffer;base64,${btoa(String.fromCharCode(...bytes))}` },
    ],
    extensionsRequired: ['KHR_mesh_quantization'],
  };
  const read = await open(encode(JSON.stringify(quantized)));
  assert.deepEqual(placesOf(read.mesh), [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0.2],
  ]);
});

test('glTF with a separate buffer', async () => {
  const { json, buffer } = files.gltfParts(cutBox);
  json.buffers[0].uri = 'a%20body.bin';
  const text = encode(JSON.stringify(json));
  assert.deepEqual(namesBeside(text), ['a body.bin']);
  assert.deepEqual(namesBeside(files.offFile(box)), []);
  await assert.rejects(open(text), { code: 'badFile', message: /needs 'a body\.bin'/ });
  const { mesh } = await open(text, { beside: { 'a body.bin': buffer } });
  assert.deepEqual(placesOf(mesh), written(cutBox));
  for (const uri of ['../up.bin', '/etc/hosts', 'https://elsewhere.invalid/x.bin', 'a/../../b']) {
    json.buffers[0].uri = uri;
    assert.throws(() => namesBeside(encode(JSON.stringify(json))), { message: /not lie beside/ });
  }
});

test('parts are listed, and the requested ones are read', async () => {
  const obj = encode(
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 6 1 0\no left\nf 1 2 3\no right\ng top\nf -4 -3 \\\n-2\nf 5 7 6\no left\nf 3 2 1\n',
  );
  const all = await open(obj);
  assert.deepEqual(all.file.parts, [
    { name: 'left', triangles: 2 },
    { name: 'right, top', triangles: 2 },
  ]);
  assert.deepEqual(Array.from(all.file.partOf), [0, 1, 1, 0]);
  assert.deepEqual(all.mesh.fileMarks().parts, all.file.parts);
  await assert.rejects(open(obj, { parts: [2] }), { code: 'badArgument', message: /no part 2/ });
  const right = await open(obj, { parts: [1] });
  assert.deepEqual(Array.from(right.mesh.triangles()), [3, 4, 5, 4, 6, 5]);

  const stl = files.stlFile(cutBox, { text: true, solids: 3 });
  const { file } = await open(stl);
  assert.deepEqual(
    file.parts.map(({ name, triangles }) => [name, triangles]),
    [
      ['part 0', 4],
      ['part 1', 4],
      ['part 2', 4],
    ],
  );
  const some = await open(stl, { parts: [2, 0] });
  assert.deepEqual(placesOf(some.mesh), [
    ...written(cutBox).slice(0, 12),
    ...written(cutBox).slice(24),
  ]);
  const nodes = [
    { mesh: 0, name: 'one' },
    { mesh: 0, name: 'two', translation: [9, 0, 0] },
  ];
  const glb = files.glbFile(cutBox, { nodes, scenes: [{ nodes: [0, 1] }] });
  assert.deepEqual(
    (await open(glb)).file.parts.map(({ name }) => name),
    ['one', 'two'],
  );
  assert.equal((await open(glb, { parts: [1] })).mesh.positions()[0], 9);
  await assert.rejects(open(glb, { parts: [2] }), { code: 'badArgument', message: /no part 2/ });
  await assert.rejects(open(glb, { parts: [-1] }), { code: 'badArgument' });
  await assert.rejects(open(glb, { parts: [] }), { code: 'badArgument' });
});

test('reading reports its progress, and stops on request', async () => {
  const sphere = new SphereGeometry(1, 300, 300);
  const mesh = {
    positions: Array.from(sphere.attributes.position.array),
    faces: Array.from({ length: sphere.index.count / 3 }, (_, i) =>
      Array.from(sphere.index.array.slice(3 * i, 3 * i + 3)),
    ),
  };
  const stl = files.stlFile(mesh, { text: true });
  const told = [];
  const controller = new AbortController();
  const reason = new Error('enough');
  await assert.rejects(
    open(stl, {
      progress(done, stage) {
        told.push([done, stage]);
        if (done > 0.2) controller.abort(reason);
      },
      signal: controller.signal,
    }),
    reason,
  );
  assert.ok(told.length > 1);
  assert.ok(
    told.every(([done, stage], i) => stage === 'reading' && (i === 0 || done >= told[i - 1][0])),
  );
  assert.ok(told.at(-1)[0] < 0.5, 'it did not go on');
});

test('in a worker: a file with its progress, its parts, and cancellation', async () => {
  const remote = await loadInWorker();
  after(() => remote.dispose());
  const stages = new Set();
  const { mesh, file } = await remote.meshFromFile(
    files.stlFile(cutBox, { text: true, solids: 2 }),
    {
      parts: [1],
      progress: (_, stage) => stages.add(stage),
    },
  );
  assert.equal(mesh.info.triangles, 6);
  assert.equal(file.parts.length, 2);
  assert.ok(stages.has('making'));
  await assert.rejects(remote.meshFromFile(encode('OFF BINARY')), { code: 'badFile' });
  await assert.rejects(
    remote.meshFromFile(files.stlFile(cutBox), { signal: AbortSignal.abort() }),
    {
      name: 'AbortError',
    },
  );
  assert.equal((await mesh.positions()).length % 3, 0);
});

test('wrong arguments are refused', async () => {
  const wrong = [
    [['text'], /must be a Uint8Array/],
    [[files.offFile(box), { part: 1 }], /no option 'part'/],
    [[files.offFile(box), { parts: 1 }], /the parts must be an array/],
    [[files.offFile(box), { signal: 1 }], /AbortSignal/],
    [[files.offFile(box), { progress: 1 }], /progress must be a function/],
    [[files.offFile(box), { repair: 'all' }], /repair/],
  ];
  for (const [args, message] of wrong) {
    await assert.rejects(open(...args), { code: 'badArgument', message });
  }
});

test('the upward axis: from a base, from a rim that is open below, or by default', () => {
  const turned = ({ positions, faces }, order) => ({
    positions: positions.map((_, i) => positions[3 * Math.floor(i / 3) + order[i % 3]]),
    faces,
  });
  const guess = ({ positions, faces }, format = 'obj') => guessUp(positions, faces.flat(), format);
  // A cone on z = 0, with and without its base.
  const ring = Array.from({ length: 40 }, (_, i) => (Math.PI * i) / 20);
  const side = ring.map((_, i) => [i, (i + 1) % 40, 40]);
  const positions = [...ring.flatMap((t) => [Math.cos(t), Math.sin(t), 0]), 0, 0, 3, 0, 0, 0];
  const cone = { positions, faces: [...side, ...ring.map((_, i) => [(i + 1) % 40, i, 41])] };
  const open = { positions, faces: side };
  for (const shape of [cone, open]) {
    assert.equal(guess(shape), 'z');
    assert.equal(guess(turned(shape, [1, 2, 0])), 'y');
    assert.equal(guess(shape, 'gltf'), 'y');
  }
  // The guess does not depend on the place of the shape, nor on how far its base reaches around a
  // hole, since chains of edges enclose nothing.
  const raised = (shape, by) => ({
    ...shape,
    positions: shape.positions.map((x, i) => x + (i % 3 === 0 ? by : 0)),
  });
  for (const by of [100, -1e4]) {
    assert.equal(guess(raised(turned(open, [2, 0, 1]), by)), 'y', 'lying on its side');
    assert.equal(guess(raised(open, by)), 'z');
  }
  const sheet = (height) => ({
    positions: [5, 5, height, 9, 5, height, 9, 9, height + 4, 5, 9, height + 4],
    faces: [
      [0, 1, 2],
      [0, 2, 3],
    ],
  });
  for (const height of [0, 100, -100]) {
    assert.equal(guess(sheet(height)), 'y', 'usual: one edge is no sole');
    assert.equal(guess(sheet(height), 'stl'), 'z');
  }
  const sphere = new SphereGeometry(1, 40, 40);
  const round = {
    positions: Array.from(sphere.attributes.position.array),
    faces: [Array.from(sphere.index.array)],
  };
  assert.deepEqual(
    ['obj', 'ply', 'stl'].map((format) => guess(round, format)),
    ['y', 'y', 'z'],
  );
});

/**
 * Two triangles with a red, a green, a blue and a half gray vertex; the third is at the place of
 * the fourth.
 */
const colored = {
  positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 1, 0],
  colors: [
    [255, 0, 0],
    [0, 255, 0],
    [0, 0, 255],
    [128, 128, 128],
    [255, 255, 255],
  ],
  faces: [
    [0, 1, 2],
    [3, 1, 4],
  ],
};

/** A file with four floats for each color; in glTF these are linear light. */
function coloredGlb(light, accessor = {}) {
  const { json, buffer } = files.gltfParts(colored);
  const bytes = new Uint8Array(buffer.length + 4 * light.length);
  bytes.set(buffer);
  bytes.set(new Uint8Array(Float32Array.from(light).buffer), buffer.length);
  json.bufferViews.push({ buffer: 0, byteOffset: buffer.length, byteLength: 4 * light.length });
  json.accessors.push({
    ...{ bufferView: json.bufferViews.length - 1, componentType: 5126, type: 'VEC4' },
    ...{ count: light.length / 4, ...accessor },
  });
  json.buffers[0].byteLength = bytes.length;
  json.materials = [{ name: 'paint' }];
  const primitive = json.meshes[0].primitives[0];
  primitive.attributes.COLOR_0 = json.accessors.length - 1;
  primitive.material = 0;
  return files.glbOf({ json, buffer: bytes });
}

function coloredPly(type, toNumber, names) {
  const places = colored.colors.map((color, i) =>
    [...colored.positions.slice(3 * i, 3 * i + 3), ...color.map(toNumber)].join(' '),
  );
  const properties = ['x', 'y', 'z'].map((axis) => `property float ${axis}`);
  const channels = names.map((name) => `property ${type} ${name}`);
  const faces = colored.faces.map((face) => `3 ${face.join(' ')}`);
  return encode(
    [
      ...['ply', 'format ascii 1.0', 'element vertex 5', ...properties, ...channels],
      ...['element face 2', 'property list uchar int vertex_indices', 'end_header'],
      ...[...places, ...faces, ''],
    ].join('\n'),
  );
}

/** An OFF file with `rest` after the place of each vertex. */
function coloredOff(keyword, rest) {
  const places = colored.colors.map((color, i) =>
    [...colored.positions.slice(3 * i, 3 * i + 3), ...rest(color)].join(' '),
  );
  const faces = colored.faces.map((face) => `3 ${face.join(' ')} 0.5 0.5 0.5`);
  return encode([keyword, '5 2 0', ...places, ...faces, ''].join('\n'));
}

test('colors are those of the file’s vertices, in every type of number, welded or not', async () => {
  const obj = encode(
    `${colored.colors
      .map((color, i) =>
        ['v', ...colored.positions.slice(3 * i, 3 * i + 3), ...color.map((c) => c / 255)].join(' '),
      )
      .join('\n')}\nf 1 2 3\nf 4 2 5\n`,
  );
  const toLight = (c) => (c > 10 ? ((c / 255 + 0.055) / 1.055) ** 2.4 : c / 255 / 12.92);
  const light = colored.colors.flatMap((color) => [...color.map(toLight), 1]);
  const glb = await open(coloredGlb(light));
  const rgb = ['red', 'green', 'blue'];
  const opened = [
    await open(obj),
    await open(coloredPly('uchar', (c) => c, rgb)),
    await open(
      coloredPly('float', (c) => c / 255, ['diffuse_red', 'diffuse_green', 'diffuse_blue']),
    ),
    await open(coloredPly('ushort', (c) => 257 * c, ['r', 'g', 'b'])),
    await open(coloredOff('COFF', (color) => color)),
    await open(coloredOff('COFF', (color) => [...color, 9])),
    await open(coloredOff('COFF', (color) => [...color.map((c) => c / 255), 0.5])),
    await open(coloredOff('STCNOFF', (color) => [0, 0, 1, ...color, 0.2, 0.3])),
    await open(coloredOff('STCNOFF', (color) => [0, 0, 1, ...color, 255, 0.2, 0.3])),
    glb,
  ];
  for (const { mesh, file } of opened) {
    assert.equal(mesh.info.components, 1, file.format);
    assert.deepEqual(Array.from(file.colors), colored.colors.flat(), file.format);
    assert.equal(mesh.positions().length, file.colors.length);
  }
  assert.deepEqual(glb.file.materials, ['paint']);
  assert.deepEqual(Array.from(glb.file.materialOf), [0, 0]);
  assert.equal((await open(files.objFile(box))).file.colors, null);
  assert.equal((await open(files.glbFile(cutBox))).file.colors, null);
  // A surface opens despite invalid colors.
  const { file } = await open(coloredGlb(light, { type: 'VEC2' }));
  assert.equal(file.colors, null);
});

test('triangles know their part and material', async () => {
  const stl = await open(files.stlFile(cutBox, { text: true, solids: 3 }), { parts: [0, 2] });
  assert.deepEqual(Array.from(stl.file.partOf), [0, 0, 0, 0, 2, 2, 2, 2]);
  const nodes = [
    { mesh: 0, name: 'one' },
    { mesh: 0, name: 'two', translation: [9, 0, 0] },
  ];
  const glb = files.glbFile(cutBox, { nodes, scenes: [{ nodes: [0, 1] }] });
  assert.deepEqual(Array.from((await open(glb, { parts: [1] })).file.partOf), Array(12).fill(1));
  const { file } = await open(glb);
  assert.deepEqual([file.materials, file.materialOf], [[], null]);
  const obj = encode(
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl a\nf 1 2 4 3\nusemtl b\nf 4 2 1\n',
  );
  const marks = (await open(obj)).file;
  assert.deepEqual(
    [marks.materials, Array.from(marks.materialOf)],
    [
      ['a', 'b'],
      [0, 0, 1],
    ],
  );
});
