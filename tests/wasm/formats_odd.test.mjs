// Unusual but valid files, and files designed to consume time or memory.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { before, test } from 'node:test';
import { Worker } from 'node:worker_threads';
import { KarcherError, load } from 'karcher';
import { formatOf, meshFromFile } from 'karcher/formats';
import * as files from './mesh_files.mjs';

const { box, cutBox, encode } = files;
let karcher;
before(async () => {
  karcher = await load();
});

const open = (bytes, options) => meshFromFile(karcher, bytes, options);
const decode = (bytes) => new TextDecoder().decode(bytes);

test('a coordinate that is not a number marks one place, however often it appears', async () => {
  const { Places } = await import(new URL('./places.js', import.meta.resolve('karcher')).href);
  const places = new Places();
  const draw = (i) => [i % 50, i % 70, i % 3 === 0 ? Number.NaN : -0];
  const numbers = Array.from({ length: 20_000 }, (_, i) => places.number(...draw(i)));
  const named = new Map();
  for (const [i, number] of numbers.entries()) {
    const key = draw(i)
      .map((x) => x + 0)
      .join();
    if (!named.has(key)) named.set(key, number);
    assert.equal(number, named.get(key), key);
  }
  assert.equal(places.count, named.size);
  assert.deepEqual(
    [...named.values()],
    Array.from({ length: named.size }, (_, i) => i),
    'in their order',
  );
  assert.ok(Object.is(places.positions[5], 0), 'minus 0 is 0');
  const [none, ...others] = cutBox.positions.keys();
  const positions = [Number.NaN, ...others.map((i) => cutBox.positions[i])];
  assert.equal(none, 0);
  await assert.rejects(open(files.stlFile({ ...cutBox, positions })), { code: 'notFinite' });
});

test('a line ends by either sign or both, in every format of text', async () => {
  const wanted = (await open(files.objFile(box))).mesh;
  for (const eol of ['\r', '\r\n', '\n']) {
    const withEnds = (bytes) => encode(decode(bytes).replaceAll('\n', eol));
    const all = {
      obj: withEnds(files.objFile(box)),
      off: withEnds(encode(decode(files.offFile(box)).replace('OFF', 'OFF # a box'))),
      ply: files.plyFile(box, { eol }),
      // The first byte of the row is that of a line end.
      little: files.plyFile(
        { ...box, positions: [1e-323 * 5, ...box.positions.slice(1)] },
        { encoding: 'little', eol },
      ),
    };
    for (const [name, bytes] of Object.entries(all)) {
      const { mesh, file } = await open(bytes);
      const what = `${name}, ${JSON.stringify(eol)}`;
      assert.deepEqual(mesh.triangles(), wanted.triangles(), what);
      assert.equal(file.parts[0].triangles, 12, what);
    }
    const stl = await open(withEnds(files.stlFile(cutBox, { text: true, solids: 2 })));
    assert.deepEqual(
      stl.file.parts.map(({ name }) => name),
      ['part 0', 'part 1'],
    );
    const wrong = encode(['OFF', '3 1 0', '0 0 0', '1 0 0', '0 x 0', '3 0 1 2', ''].join(eol));
    await assert.rejects(open(wrong), { message: /^line 5: / });
  }
});

test('a byte order mark changes nothing', async () => {
  const wanted = (await open(files.objFile(box))).mesh;
  const all = {
    obj: files.objFile(box),
    off: files.offFile(box),
    ply: files.plyFile(box, {}),
    stl: encode(
      'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n',
    ),
  };
  for (const [name, bytes] of Object.entries(all)) {
    const marked = new Uint8Array([0xef, 0xbb, 0xbf, ...bytes]);
    const { mesh, file } = await open(marked);
    assert.equal(file.format, name);
    if (name === 'stl') assert.equal(mesh.info.triangles, 1);
    else assert.deepEqual(mesh.triangles(), wanted.triangles(), name);
    mesh.dispose();
  }
  wanted.dispose();
});

test('1.#QNAN and similar spellings are no numbers, in any format', async () => {
  for (const word of ['1.#QNAN', '-1.#IND', '1.#INF']) {
    const all = {
      obj: `v ${word} 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n`,
      off: `OFF\n3 1 0\n${word} 0 0\n1 0 0\n0 1 0\n3 0 1 2\n`,
      ply: `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n${word} 0 0\n1 0 0\n0 1 0\n3 0 1 2\n`,
      stl: `solid s\nfacet normal 0 0 1\nouter loop\nvertex ${word} 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n`,
    };
    for (const [name, text] of Object.entries(all)) {
      await assert.rejects(
        open(encode(text), { name: `a.${name}` }),
        KarcherError,
        `${name}, ${word}`,
      );
    }
  }
});

test('a Git LFS pointer and UTF-16 text are recognized, whatever the ending', async () => {
  const pointer = encode('version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12345\n');
  const text = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
  const little = new Uint8Array([0xff, 0xfe, ...[...text].flatMap((c) => [c.charCodeAt(0), 0])]);
  const big = new Uint8Array([0xfe, 0xff, ...[...text].flatMap((c) => [0, c.charCodeAt(0)])]);
  for (const ending of ['obj', 'ply', 'stl', 'off', 'glb']) {
    const name = `scan.${ending}`;
    await assert.rejects(open(pointer, { name }), /Git LFS pointer, not the file itself/);
    await assert.rejects(open(little, { name }), /UTF-16 text: save it as UTF-8/);
    await assert.rejects(open(big, { name }), /UTF-16 text: save it as UTF-8/);
  }
});

test('parts of an OBJ file: comments, continued lines and line numbers are as in the engine', async () => {
  // The first face's comment ends in a backslash, which continues no line.
  const text = [
    'v 0 0 0',
    'v 1 0 0',
    'v 0 1 0',
    'o a',
    'f 1 2 3 # C:\\tmp\\',
    'v 9 9 9',
    'v 8 9 9',
    'o b#1 # named so',
    'f \\',
    ' 1 2 \\',
    ' 4 # four',
    'f 1\\',
    '2 5',
    'o a',
    'f 3 \\',
    '2 1',
    '',
  ].join('\n');
  const { file } = await open(encode(text));
  assert.deepEqual(file.parts, [
    { name: 'a', triangles: 2 },
    { name: 'b#1', triangles: 2 },
  ]);
  const { mesh } = await open(encode(text), { parts: [1] });
  assert.deepEqual(Array.from(mesh.triangles()), [0, 1, 3, 0, 1, 4]);
  assert.deepEqual(Array.from(mesh.positions().slice(9, 12)), [9, 9, 9]);
  // A wrong line after a removed one has its line number in the file.
  const bad = encode(`${text}o b#1\nf 1 2 x\n`);
  await assert.rejects(open(bad, { parts: [1] }), { message: /^line 18: / });
  // One file has a line without end, and one continues a line fifty thousand times.
  const long = `v 0 0 0\nv 1 0 0\nv 0 1 0\no a\nf 1 2 3\no b\nf 1 2 ${'\\\n'.repeat(50_000)}3`;
  assert.equal((await open(encode(long), { parts: [0] })).mesh.info.triangles, 1);
  assert.equal((await open(encode(long), { parts: [1] })).mesh.info.triangles, 1);
});

test('faces of fewer than three corners are left out, and reported', async () => {
  const some = { ...box, faces: [[0, 1], ...box.faces, [3], []] };
  for (const bytes of [
    files.plyFile(some),
    files.plyFile(some, { encoding: 'big' }),
    files.offFile(some),
  ]) {
    const { mesh, file } = await open(bytes);
    assert.equal(mesh.info.triangles, 12);
    assert.equal(file.notRead[0], '3 points and lines were left out.');
  }
  const { mesh } = await open(encode('OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n1 0\n1 1\n1 2\n3 0 1 2\n'));
  assert.equal(mesh.info.triangles, 1);
});

/** Property names that every object has. */
const inherited = ['constructor', '__proto__', 'toString', 'hasOwnProperty', 'valueOf'];

test('names of every object’s properties are ordinary words', async () => {
  const gltf = (changes) => encode(JSON.stringify({ ...files.gltfParts(cutBox).json, ...changes }));
  const ply = decode(files.plyFile(box));
  for (const word of inherited) {
    assert.equal(formatOf(encode('v 0 0 0'), `x.${word}`), 'obj', word);
    const refused = {
      type: ply.replace('double x', `${word} x`),
      length: ply.replace('list uchar int', `list ${word} int`),
      encoding: ply.replace('format ascii', `format ${word}`),
      number: ply.replace('2 200 3 4', `2 200 ${word} 4`),
      uri: decode(gltf({ buffers: [{ byteLength: 9, uri: word }] })),
      extension: decode(gltf({ extensionsRequired: [word] })),
      accessor: decode(
        gltf({ accessors: [{ bufferView: 0, componentType: word, count: 8, type: 'VEC3' }] }),
      ),
    };
    for (const [what, text] of Object.entries(refused)) {
      await assert.rejects(
        open(encode(text)),
        (error) => {
          assert.equal(error.code, 'badFile', `${what} ${word}: ${error.message}`);
          assert.match(error.message, new RegExp(`${word}|numbers of no type`), what);
          return true;
        },
        what,
      );
    }
  }
});

test('glTF: vertices are numbered by whole numbers from 0', async () => {
  const withIndex = (changes) => {
    const parts = files.gltfParts(cutBox);
    Object.assign(parts.json.accessors[1], changes);
    return files.glbOf(parts);
  };
  for (const componentType of [5120, 5122, 5126]) {
    await assert.rejects(open(withIndex({ componentType, count: 3 })), {
      code: 'badFile',
      message: /accessor 1 has numbers that are no indices/,
    });
  }
  await assert.rejects(open(withIndex({ normalized: true })), { message: /is normalized/ });
  const sparse = (componentType, count = 1) => ({
    sparse: {
      count,
      indices: { bufferView: 1, componentType },
      values: { bufferView: 1, byteOffset: 4 },
    },
  });
  await assert.rejects(open(withIndex(sparse(5126))), { message: /sparse part .* are no indices/ });
  // The indices are 0 1 2 0 …: the fourth is not greater than the third.
  await assert.rejects(open(withIndex(sparse(5125, 4))), { message: /row \d+ after row \d+/ });
});

test('glTF: a mesh that many nodes place is read once, and one that is too large is refused before it is made', async () => {
  const many = { positions: box.positions, faces: Array.from({ length: 20_000 }, () => [0, 1, 2]) };
  const nodes = Array.from({ length: 2501 }, () => ({ mesh: 0 }));
  const scenes = [{ nodes: [...nodes.keys()] }];
  const glb = files.glbFile(many, { nodes, scenes });
  await assert.rejects(open(glb), {
    code: 'outOfMemory',
    message: /makes 50,020,000 triangles .* 17\.7 GB .* has 4\.00 GB/,
  });
  const { mesh, file } = await open(glb, { parts: [3] });
  assert.equal(file.parts.length, nodes.length);
  const [{ kind, count }] = mesh.info.repairs;
  assert.deepEqual([kind, count], ['duplicate', 19_999]);
  // Vertices count as well as triangles.
  const positions = Array.from({ length: 120_000 }, (_, i) => i % 17);
  const vertices = files.glbFile({ positions, faces: [[0, 1, 3]] }, { nodes, scenes });
  await assert.rejects(open(vertices), { code: 'outOfMemory', message: /of 100,040,000 vertices/ });
  // The vertices would fit twice into the engine's memory, but not with all their derived data.
  const fewer = { nodes: nodes.slice(0, 2000), scenes: [{ nodes: [...Array(2000).keys()] }] };
  await assert.rejects(open(files.glbFile({ positions, faces: [[0, 1, 3]] }, fewer)), {
    code: 'outOfMemory',
    message: /of 80,000,000 vertices, which take at least 5\.3\d GB/,
  });
  // A thousand nodes of a mesh of a thousand primitives, in a few kilobytes.
  const { json, buffer } = files.gltfParts(cutBox);
  const primitives = Array.from({ length: 1000 }, () => json.meshes[0].primitives[0]);
  const places = files.glbOf({
    json: {
      ...json,
      meshes: [{ primitives }],
      nodes: nodes.slice(0, 1000),
      scenes: [{ nodes: [...Array(1000).keys()] }],
    },
    buffer,
  });
  await assert.rejects(open(places), { code: 'badFile', message: /place 1,000,000 parts/ });
});

test('glTF: primitives of the same places have their own colors', async () => {
  const one = cutBox.positions.length / 3;
  const { json, buffer } = files.gltfParts({
    positions: [...cutBox.positions, ...cutBox.positions.map((x) => x + 9)],
    faces: [...cutBox.faces, ...cutBox.faces.map((face) => face.map((vertex) => vertex + one))],
  });
  const rows = 2 * one;
  const colors = Uint8Array.from({ length: 4 * rows }, (_, i) => (i % 4 === 0 ? 0 : 255));
  const bytes = new Uint8Array([...buffer, ...colors]);
  json.buffers[0].byteLength = bytes.length;
  json.bufferViews.push({ buffer: 0, byteOffset: buffer.length, byteLength: colors.length });
  const [, indices] = json.accessors;
  const half = indices.count / 2;
  json.accessors.push(
    { ...{ bufferView: 2, componentType: 5121, normalized: true }, count: rows, type: 'VEC4' },
    { ...indices, count: half },
    { ...indices, byteOffset: 4 * half, count: half },
  );
  const plain = { attributes: { POSITION: 0 }, indices: 3 };
  const colored = { attributes: { POSITION: 0, COLOR_0: 2 }, indices: 4 };
  for (const primitives of [
    [plain, colored],
    [colored, plain],
  ]) {
    json.meshes[0].primitives = primitives;
    const { mesh, file } = await open(files.glbOf({ json, buffer: bytes }));
    mesh.triangles().forEach((vertex, i) => {
      const isColored = primitives[file.partOf[Math.floor(i / 3)]] === colored;
      const wanted = isColored ? [0, 255, 255] : [255, 255, 255];
      assert.deepEqual([...file.colors.subarray(3 * vertex, 3 * vertex + 3)], wanted);
    });
  }
});

test('glTF: a node of very many children', async () => {
  const children = Array.from({ length: 300_000 }, (_, i) => i + 1);
  const nodes = [{ children }, ...children.map((i) => (i === 7 ? { mesh: 0 } : {}))];
  const { mesh } = await open(files.glbFile(cutBox, { nodes }));
  assert.equal(mesh.info.triangles, 12);
});

/** A glTF file of a triangle, with more nodes, accessors or skins. */
function triangleWith(change, rows = []) {
  const { json, buffer } = files.gltfParts({
    positions: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    faces: [[0, 1, 2]],
  });
  const bytes = rows.map((numbers) => new Uint8Array(Float32Array.from(numbers).buffer));
  const whole = new Uint8Array(bytes.reduce((sum, { length }) => sum + length, buffer.length));
  whole.set(buffer);
  let at = buffer.length;
  const views = bytes.map((one) => {
    whole.set(one, at);
    const view = { buffer: 0, byteOffset: at, byteLength: one.length };
    at += one.length;
    return view;
  });
  const all = { ...json, bufferViews: [...json.bufferViews, ...views] };
  return files.glbOf({ json: { ...all, ...change(all, json.bufferViews.length) }, buffer: whole });
}

const rounded = (mesh) => [...mesh.positions()].map((x) => Math.round(1e6 * x) / 1e6 + 0);

test('glTF: the place of a skinned mesh is not that of its node', async () => {
  const nodes = [
    { mesh: 0, skin: 0, scale: [100, 100, 100], translation: [5, 5, 5], children: [1] },
    { mesh: 0 },
  ];
  const skins = [{ joints: [1] }];
  const { mesh } = await open(triangleWith(() => ({ nodes, skins, scenes: [{ nodes: [0] }] })));
  const same = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  assert.deepEqual(rounded(mesh).slice(0, 9), same);
  assert.deepEqual(
    rounded(mesh).slice(9),
    same.map((x) => 100 * x + 5),
    'its child is',
  );
});

test('glTF: instances of a mesh have their places, and are counted before they are made', async () => {
  const instanced =
    (count = 3) =>
    (all, view) => ({
      nodes: [
        {
          mesh: 0,
          translation: [0, 0, 1],
          extensions: {
            EXT_mesh_gpu_instancing: {
              attributes: {
                TRANSLATION: all.accessors.length,
                ROTATION: all.accessors.length + 1,
                SCALE: all.accessors.length + 2,
              },
            },
          },
        },
      ],
      extensionsUsed: ['EXT_mesh_gpu_instancing'],
      extensionsRequired: ['EXT_mesh_gpu_instancing'],
      scenes: [{ nodes: [0] }],
      accessors: [
        ...all.accessors,
        { bufferView: view, componentType: 5126, count, type: 'VEC3' },
        { bufferView: view + 1, componentType: 5126, count: 3, type: 'VEC4' },
        { bufferView: view + 2, componentType: 5126, count: 3, type: 'VEC3' },
      ],
    });
  const half = Math.SQRT1_2;
  const rows = [
    [0, 0, 0, 5, 0, 0, 0, 7, 0],
    [0, 0, 0, 1, 0, 0, half, half, 0, 0, 0, 1],
    [1, 1, 1, 1, 1, 1, 2, 2, 2],
  ];
  const { mesh, file } = await open(triangleWith(instanced(), rows));
  assert.deepEqual(
    rounded(mesh),
    [
      [0, 0, 1, 1, 0, 1, 0, 1, 1],
      [5, 0, 1, 5, 1, 1, 4, 0, 1],
      [0, 7, 1, 2, 7, 1, 0, 9, 1],
    ].flat(),
  );
  assert.equal(file.parts.length, 3);
  assert.match(file.parts[2].name, /, instance 3$/);
  await assert.rejects(open(triangleWith(instanced(2), rows)), {
    code: 'badFile',
    message: /lists of 2 and 3 and 3 rows/,
  });
  // A sparse list of zeros takes no bytes: it could have any number of instances.
  const many = triangleWith((all, view) => {
    const change = instanced()(all, view);
    for (const accessor of change.accessors.slice(-3)) {
      delete accessor.bufferView;
      accessor.count = 2 ** 31;
      accessor.sparse = {
        count: 0,
        indices: { bufferView: view, componentType: 5125 },
        values: { bufferView: view },
      };
    }
    return change;
  }, rows);
  await assert.rejects(open(many), { code: 'badFile', message: /more than 250,000 parts/ });
});

test('glTF: sparse places without a view are zeros, except the given ones', async () => {
  const bytes = triangleWith(
    (all, view) => ({
      bufferViews: [...all.bufferViews, { buffer: 0, byteOffset: 0, byteLength: 0 }],
      accessors: all.accessors.map((accessor) =>
        accessor.type === 'VEC3'
          ? {
              componentType: 5126,
              type: 'VEC3',
              count: 3,
              sparse: {
                count: 2,
                indices: { bufferView: view, componentType: 5125 },
                values: { bufferView: view + 1 },
              },
            }
          : accessor,
      ),
    }),
    [new Float32Array(Uint32Array.of(1, 2).buffer), [3, 0, 0, 0, 4, 0]],
  );
  const { mesh } = await open(bytes);
  assert.deepEqual(rounded(mesh), [0, 0, 0, 3, 0, 0, 0, 4, 0]);
});

test('an embedded buffer of glTF is decoded within a few times its size', async () => {
  const { json, buffer } = files.gltfParts(cutBox);
  const padded = Buffer.concat([Buffer.from(buffer), Buffer.alloc(2 ** 25)]);
  json.buffers[0] = {
    byteLength: padded.length,
    uri: `data:;base64,${padded.toString('base64')}`,
  };
  const code = `
    const { parentPort, workerData } = require('node:worker_threads');
    (async () => {
      const [{ load }, { meshFromFile }] = await Promise.all(workerData.modules.map((at) => import(at)));
      const { mesh } = await meshFromFile(await load(), workerData.bytes);
      parentPort.postMessage(mesh.info.vertexCount);
    })();`;
  const modules = ['karcher', 'karcher/formats'].map((name) => import.meta.resolve(name));
  const worker = new Worker(code, {
    eval: true,
    workerData: { modules, bytes: encode(JSON.stringify(json)) },
    resourceLimits: { maxOldGenerationSizeMb: 8 * (padded.length / 2 ** 20) },
  });
  const [count] = await once(worker, 'message');
  await worker.terminate();
  assert.equal(count, (await open(files.glbFile(cutBox))).mesh.info.vertexCount);
});
