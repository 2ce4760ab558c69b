// Files of random bytes, and files that were good before bytes of them changed: each makes a mesh with
// finite places, or is refused with a KarcherError.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import fc from 'fast-check';
import { load } from 'karcher';
import { meshFromFile, namesBeside } from 'karcher/formats';
import { checkMeant, draws } from './draws.mjs';
import {
  box,
  cutBox,
  everyFile,
  gltfParts,
  objFile,
  offFile,
  plyFile,
  stlFile,
} from './mesh_files.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const encode = (text) => new TextEncoder().encode(text);
/** Long for so few bytes, on a busy machine. */
const longest = 20_000;

/** Opens a file, or sees it refused; true where it was opened. */
async function opens(bytes, options) {
  const started = performance.now();
  try {
    namesBeside(bytes, options.name);
    const { mesh, file } = await meshFromFile(karcher, bytes, options);
    const positions = mesh.positions();
    for (const vertex of mesh.triangles()) {
      for (let axis = 0; axis < 3; axis++) assert.ok(Number.isFinite(positions[3 * vertex + axis]));
    }
    assert.ok(file.parts.length > 0);
    mesh.dispose();
    return true;
  } catch (error) {
    if (error?.code === 'ERR_ASSERTION') throw error;
    checkMeant(error, /undefined|\[object|Aborted|internal/);
    return false;
  } finally {
    assert.ok(performance.now() - started < longest);
  }
}

const name = fc.constantFrom('x', 'x.obj', 'x.ply', 'x.stl', 'x.off', 'x.glb', 'x.gltf');

test('random bytes, also after the beginning of a format', async () => {
  // Faces of three vertices that are there may follow what is a beginning of an OBJ file.
  let refused = 0;
  const start = fc.constantFrom(
    ...['', 'ply\nformat ascii 1.0\n', 'ply\nformat binary_big_endian 1.0\nelement vertex 3\n'],
    ...[
      'solid x\nfacet normal',
      'OFF\n',
      'OFF 3 1 0\n',
      'glTF\x02\0\0\0',
      '{"asset":{"version":"2.0"}',
    ],
    ...['v 0 0 0\nf ', '\0'.repeat(80)],
  );
  await fc.assert(
    fc.asyncProperty(start, fc.uint8Array({ maxLength: 300 }), name, async (text, bytes, file) => {
      if (!(await opens(Uint8Array.of(...encode(text), ...bytes), { name: file }))) refused++;
    }),
    draws(300),
  );
  assert.ok(refused > 20, 'they are refused with a sentence');
});

const [text, gltf] = [
  (bytes) => new TextDecoder().decode(bytes),
  (changes) => {
    const { json, buffer } = gltfParts(cutBox, changes);
    json.buffers[0].uri = `data:;base64,${Buffer.from(buffer).toString('base64')}`;
    return encode(JSON.stringify(json));
  },
];

const goodFiles = [
  ...Object.values(everyFile(cutBox)),
  ...[
    objFile(box),
    offFile(box),
    plyFile(box),
    plyFile(box, { encoding: 'little', length: 'int' }),
  ],
  ...[stlFile(cutBox, { text: true, solids: 2 }), gltf({})],
];

/** Bytes set, put in, taken out, or repeated, at a place that is a part of the whole. */
const change = fc.record({
  at: fc.double({ min: 0, max: 1, noNaN: true }),
  kind: fc.constantFrom('set', 'set', 'set', 'set', 'put', 'take', 'repeat', 'end'),
  bytes: fc.uint8Array({ minLength: 1, maxLength: 3 }),
});

function changed(bytes, changes) {
  return changes.reduce((file, { at, kind, bytes: given }) => {
    const place = Math.floor(at * file.length);
    const [head, tail] = [file.subarray(0, place), file.subarray(place)];
    const parts = {
      set: [head, given, tail.subarray(given.length)],
      put: [head, given, tail],
      take: [head, tail.subarray(given.length)],
      repeat: [head, tail.subarray(0, 40), tail],
      end: [head],
    };
    return new Uint8Array(Buffer.concat(parts[kind]));
  }, bytes);
}

test('files that were good before some bytes changed', async () => {
  let opened = 0;
  await fc.assert(
    fc.asyncProperty(
      fc.constantFrom(...goodFiles),
      fc.array(change, { minLength: 1, maxLength: 2 }),
      fc.boolean(),
      async (file, changes, mend) => {
        if (await opens(changed(file, changes), { repair: mend ? 'safe' : 'none' })) opened++;
      },
    ),
    draws(600),
  );
  assert.ok(opened > 20, 'some changes matter little');
});

test('text files with other numbers, words and counts', async () => {
  const word = fc.oneof(
    fc.constantFrom(
      'nan',
      '-inf',
      '1e999',
      '-1',
      '0',
      '2147483648',
      '99999999999999999999',
      '#',
      '\\',
    ),
    fc.constantFrom(
      'list',
      'element',
      'property',
      'vertex',
      'endsolid',
      'OFF',
      'f',
      'o',
      'constructor',
      '__proto__',
      'toString',
      '{',
      '[]',
      'null',
    ),
    fc.double().map(String),
    fc.integer().map(String),
  );
  let opened = 0;
  const texts = goodFiles.map(text).filter((one) => !one.includes('\ufffd') && !one.includes('\0'));
  await fc.assert(
    fc.asyncProperty(
      fc.constantFrom(...texts),
      fc.array(fc.tuple(fc.nat(), word), { minLength: 1, maxLength: 3 }),
      async (file, changes) => {
        const words = file.split(/([\s,:]+)/);
        for (const [at, instead] of changes) words[(2 * at) % words.length] = instead;
        if (await opens(encode(words.join('')), {})) opened++;
      },
    ),
    draws(600),
  );
  assert.ok(opened > 20, 'some words matter little');
});

test('glTF whose JSON has something else in any place', async () => {
  const { json } = gltfParts(cutBox);
  const paths = [];
  (function walk(value, path) {
    if (path.length > 0) paths.push(path);
    if (typeof value !== 'object' || value === null) return;
    for (const key of Object.keys(value)) walk(value[key], [...path, key]);
  })(json, []);
  let opened = 0;
  const value = fc.oneof(
    fc.jsonValue(),
    fc.constantFrom('constructor', '__proto__', 'toString'),
    fc.constantFrom(-1, 1e15, 2 ** 53, 0.5, '0', [], {}, null, [[]], [0, 0], 2 ** 31),
  );
  await fc.assert(
    fc.asyncProperty(
      fc.array(fc.tuple(fc.constantFrom(...paths), value), { minLength: 1, maxLength: 3 }),
      async (changes) => {
        const copy = JSON.parse(text(gltf({})));
        for (const [path, instead] of changes) {
          const owner = path
            .slice(0, -1)
            .reduce(
              (at, key) => (typeof at === 'object' && at !== null ? at[key] : undefined),
              copy,
            );
          if (typeof owner === 'object' && owner !== null)
            owner[path.at(-1)] = structuredClone(instead);
        }
        if (await opens(encode(JSON.stringify(copy)), {})) opened++;
      },
    ),
    draws(600),
  );
  assert.ok(opened > 20, 'some places matter little');
});
