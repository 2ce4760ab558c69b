// Files of random bytes, and good files with changed bytes: each leads to a mesh with finite
// places, or to a KarcherError, soon and with little memory.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import fc from 'fast-check';
import { load } from 'karcher';
import { meshFromFile, namesBeside } from 'karcher/formats';
import { dracoParts, meshoptParts } from './compressed_files.mjs';
import { checkMeant, draws } from './draws.mjs';
import {
  box,
  cutBox,
  everyFile,
  glbOf,
  gltfParts,
  objFile,
  offFile,
  plyFile,
  stlFile,
} from './mesh_files.mjs';
import { watchdog } from './watchdog.mjs';

const watch = watchdog({ after });
let karcher;
before(async () => {
  karcher = await load();
});

const encode = (text) => new TextEncoder().encode(text);
/** The largest memory of this process, for small files only. */
const mostMemory = 1.5e9;

/** Opens a file, or expects a refusal. Returns whether it opened. */
async function opens(bytes, options) {
  watch(bytes);
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
    watch(null);
    const peak = 1024 * process.resourceUsage().maxRSS;
    assert.ok(peak <= mostMemory, `${peak} bytes were taken for small files`);
  }
}

const name = fc.constantFrom('x', 'x.obj', 'x.ply', 'x.stl', 'x.off', 'x.glb', 'x.gltf');

test('random bytes, alone and after the beginning of a format', async () => {
  // After the beginning of an OBJ file random bytes may be faces of its three vertices, so some
  // files open.
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

/** A change of bytes, which sets, inserts, removes, or repeats some, at a fraction of the file. */
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

test('good files with some changed bytes', async () => {
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

/** Every place in a JSON value, as the list of keys that leads to it. */
function placesIn(value, path = []) {
  const below =
    typeof value === 'object' && value !== null
      ? Object.keys(value).flatMap((key) => placesIn(value[key], [...path, key]))
      : [];
  return path.length > 0 ? [path, ...below] : below;
}

const jsonValue = fc.oneof(
  fc.jsonValue(),
  fc.constantFrom('constructor', '__proto__', 'toString'),
  fc.constantFrom(
    -1,
    1e15,
    2 ** 53,
    0.5,
    '0',
    [],
    {},
    { toString: 1 },
    null,
    [[]],
    [0, 0],
    2 ** 31,
  ),
);

function withOthers(json, changes) {
  const copy = structuredClone(json);
  for (const [path, instead] of changes) {
    const owner = path
      .slice(0, -1)
      .reduce((at, key) => (typeof at === 'object' && at !== null ? at[key] : undefined), copy);
    if (typeof owner === 'object' && owner !== null) owner[path.at(-1)] = structuredClone(instead);
  }
  return copy;
}

for (const [name, count, parts] of [
  ['glTF', 600, () => gltfParts(cutBox)],
  ['glTF that Draco compressed', 60, () => dracoParts(cutBox)],
  ['glTF that meshoptimizer compressed', 600, () => meshoptParts(cutBox)],
]) {
  test(`${name} whose JSON has another value anywhere`, async () => {
    const { json, buffer } = await parts();
    let opened = 0;
    const path = fc.constantFrom(...placesIn(json));
    await fc.assert(
      fc.asyncProperty(
        fc.array(fc.tuple(path, jsonValue), { minLength: 1, maxLength: 2 }),
        async (changes) => {
          if (await opens(glbOf({ json: withOthers(json, changes), buffer }), {})) opened++;
        },
      ),
      draws(count),
    );
    assert.ok(opened > count / 30, 'some places matter little');
  });
}

/** Extreme numbers in bytes, as in files. */
const extremes = [
  ...[0, 1, 0x7f, 0x80, 0xff].map((byte) => [byte]),
  ...[0x7fff, 0x8000, 0xffff].map((number) => [...new Uint8Array(Uint16Array.of(number).buffer)]),
  ...[0, 1, 2 ** 24, 2 ** 28, 2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1].map((number) => [
    ...new Uint8Array(Uint32Array.of(number).buffer),
  ]),
  ...[Number.NaN, Number.POSITIVE_INFINITY, -3e38, 1e-45].map((number) => [
    ...new Uint8Array(Float32Array.of(number).buffer),
  ]),
  ...[Number.NaN, 1e308].map((number) => [...new Uint8Array(Float64Array.of(number).buffer)]),
  // Draco writes counts in groups of seven bits.
  ...[
    [0xff, 0xff, 0xff, 0xff, 0x0f],
    [0x80, 0x80, 0x80, 0x01],
  ],
];

/** A flipped bit, an extreme number, a part of another file, or an early end. */
const damage = fc.record({
  at: fc.double({ min: 0, max: 1, maxExcluded: true, noNaN: true }),
  from: fc.double({ min: 0, max: 1, noNaN: true }),
  kind: fc.constantFrom('bit', 'bit', 'number', 'number', 'turned', 'splice', 'end'),
  which: fc.nat(),
  length: fc.integer({ min: 1, max: 64 }),
});

function damaged(bytes, other, damages) {
  return damages.reduce((file, { at, from, kind, which, length }) => {
    const place = Math.floor(at * file.length);
    const start = Math.floor(from * other.length);
    const number = extremes[which % extremes.length];
    const flipped = [(file[place] ?? 0) ^ (1 << (which % 8))];
    const instead = {
      ...{ bit: flipped, number, turned: number.toReversed(), end: [] },
      splice: other.subarray(start, start + length),
    }[kind];
    const end = kind === 'end' ? file.length : place + instead.length;
    return Uint8Array.of(...file.subarray(0, place), ...instead, ...file.subarray(end));
  }, bytes);
}

test('files with flipped bits, extreme numbers, parts of others, and early ends', async () => {
  let opened = 0;
  const good = fc.constantFrom(...goodFiles);
  await fc.assert(
    fc.asyncProperty(
      ...[good, good, fc.array(damage, { minLength: 1, maxLength: 4 })],
      async (file, other, damages) => {
        if (await opens(damaged(file, other, damages), { repair: 'none' })) opened++;
      },
    ),
    draws(2000),
  );
  assert.ok(opened > 20, 'some damages matter little');
});

for (const [name, count, parts] of [
  ['Draco', 60, () => [dracoParts(cutBox), dracoParts(cutBox, { bits: 11 })]],
  ['meshoptimizer', 1000, () => [meshoptParts(cutBox)]],
]) {
  test(`data compressed by ${name}, with the same damages`, async () => {
    let opened = 0;
    const good = fc.constantFrom(...(await Promise.all(parts())));
    await fc.assert(
      fc.asyncProperty(
        ...[good, good, fc.array(damage, { minLength: 1, maxLength: 2 })],
        async ({ json, buffer }, other, damages) => {
          const file = { json, buffer: damaged(buffer, other.buffer, damages) };
          if (await opens(glbOf(file), {})) opened++;
        },
      ),
      draws(count),
    );
    assert.ok(opened > count / 30, 'some damages matter little');
  });
}
