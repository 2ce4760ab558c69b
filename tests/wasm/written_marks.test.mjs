// Colors and parts of a mesh in written files.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { load } from 'karcher';
import { meshFile, meshFromFile } from 'karcher/formats';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { printed, temporaryFolder } from './run_cli.mjs';

const engine = await load();
const folder = temporaryFolder();
after(() => folder.remove());

const cells = 12;
const side = cells + 1;
const positions = Array.from({ length: side * side }, (_, i) => [
  i % side,
  Math.floor(i / side),
  0,
]);
/** All values of a byte, some of them repeated. */
const colors = Uint8Array.from({ length: 3 * side * side }, (_, i) => (7 * i) % 256);
const rows = (row) => Array.from({ length: cells }, (_, x) => row * side + x);
const quads = Array.from({ length: cells }, (_, row) => rows(row)).flat();
const triangles = quads.flatMap((a) => [a, a + 1, a + side + 1, a, a + side + 1, a + side]);
const parts = [{ name: 'left half' }, { name: 'ö {2}' }];
const partOf = quads.flatMap((_, i) => Array(2).fill(i < quads.length / 2 ? 0 : 1));
const marked = { positions: positions.flat(), triangles, colors, parts, partOf };

/** Colors by place, since readers may order vertices differently. */
const byPlace = (places, bytes) =>
  Object.fromEntries(
    Array.from({ length: places.length / 3 }, (_, i) => [
      [...places.slice(3 * i, 3 * i + 3)].join(' '),
      [...bytes.slice(3 * i, 3 * i + 3)],
    ]),
  );

for (const [format, keepsParts] of [
  ['ply', false],
  ['obj', true],
  ['glb', true],
]) {
  test(`${format} keeps them`, async () => {
    const { mesh, file } = await meshFromFile(engine, meshFile(marked, format));
    assert.deepEqual(
      byPlace(mesh.positions(), file.colors),
      byPlace(marked.positions, marked.colors),
    );
    if (!keepsParts) return;
    assert.deepEqual(
      file.parts.map(({ name }) => name),
      parts.map(({ name }) => name),
    );
    assert.deepEqual([...file.partOf], partOf);
  });
}

test('other programs read the same colors', async () => {
  const { buffer } = meshFile(marked, 'ply');
  const ply = new PLYLoader().parse(buffer).getAttribute('color');
  const { scene } = await new GLTFLoader().parseAsync(meshFile(marked, 'glb').buffer, '');
  assert.equal(scene.children.length, 2);
  const glb = scene.children[0].geometry.getAttribute('color');
  // Both programs return linear light, one of them in bytes.
  for (let i = 0; i < glb.count; i++) {
    for (const axis of ['getX', 'getY', 'getZ']) {
      assert.ok(Math.abs(ply[axis](i) - glb[axis](i)) < 1 / 255, `${axis} of vertex ${i}`);
    }
  }
});

test('karcher convert keeps them, even of a repaired mesh', async () => {
  // Each triangle has its own vertices, which the reader welds, and one face occurs twice.
  const corners = [...triangles, ...triangles.slice(0, 3)];
  const loose = {
    positions: corners.flatMap((v) => positions[v]),
    triangles: corners.map((_, i) => i),
    colors: corners.flatMap((v) => [...colors.slice(3 * v, 3 * v + 3)]),
    parts,
    partOf: [...partOf, 0],
  };
  const from = folder.write('loose.obj', meshFile(loose, 'obj'));
  for (const format of ['ply', 'obj', 'glb']) {
    const to = join(folder.path, `kept.${format}`);
    await printed('convert', from, '--out', to);
    const { mesh, file } = await meshFromFile(engine, readFileSync(to));
    assert.equal(mesh.info.vertices, side * side);
    assert.deepEqual(byPlace(mesh.positions(), file.colors), byPlace(marked.positions, colors));
    if (format !== 'ply') assert.equal(file.parts.length, 2);
  }
});

test('karcher convert keeps the colors of parts that only touch', async () => {
  // A red and a blue tetrahedron, each with a vertex of its own at the origin.
  const solid = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];
  const corner = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];
  const both = {
    positions: [...corner, ...corner.map((value) => -value)],
    triangles: [...solid, ...solid.map((vertex) => vertex + 4)],
    colors: Uint8Array.from({ length: 24 }, (_, i) => (i % 3 === (i < 12 ? 0 : 2) ? 255 : 0)),
  };
  const from = folder.write('touching.ply', meshFile(both, 'ply'));
  const to = join(folder.path, 'converted.ply');
  for (const command of ['convert', 'repair']) {
    await printed(command, from, '--out', to);
    const { mesh, file } = await meshFromFile(engine, readFileSync(to));
    const colors = (face) =>
      [...mesh.triangles().slice(3 * face, 3 * face + 3)].map((v) =>
        [...file.colors.slice(3 * v, 3 * v + 3)].join(),
      );
    for (let face = 0; face < 8; face++) {
      const own = face < 4 ? '255,0,0' : '0,0,255';
      assert.deepEqual(colors(face), [own, own, own], `${command}, face ${face}`);
    }
  }
});

test('invalid colors and parts are refused', () => {
  for (const [wrong, code] of [
    [{ colors: colors.slice(1) }, 'badArgument'],
    [{ colors: Float64Array.from(colors, () => 0.5) }, 'badArgument'],
    [{ colors: Array(colors.length).fill(256) }, 'badArgument'],
    [{ partOf: partOf.slice(1) }, 'badArgument'],
    [{ partOf: partOf.map(() => 2) }, 'badIndex'],
    [{ parts: undefined }, 'badIndex'],
  ]) {
    assert.throws(() => meshFile({ ...marked, ...wrong }, 'obj'), { code });
  }
});

test('a name stays on its line', async () => {
  const named = { ...marked, parts: [{ name: 'a\nv 1 2 3' }, { name: '' }] };
  const { file } = await meshFromFile(engine, meshFile(named, 'obj'));
  assert.deepEqual(
    file.parts.map(({ name }) => name),
    ['a v 1 2 3', 'unnamed'],
  );
});

test('a text that is longer than a string may be is written in blocks', async () => {
  const rows = 200;
  const place = (i) => [i % rows, Math.floor(i / rows), 0];
  const grid = Array.from({ length: rows * rows }, (_, i) => i);
  const corners = grid.filter((i) => i % rows < rows - 1 && i < rows * (rows - 1));
  const large = {
    positions: grid.flatMap(place),
    triangles: corners.flatMap((a) => [a, a + 1, a + rows]),
  };
  const { encode } = TextEncoder.prototype;
  const texts = [];
  TextEncoder.prototype.encode = function (text) {
    texts.push(text);
    return encode.call(this, text);
  };
  let bytes;
  try {
    bytes = meshFile(large, 'obj');
  } finally {
    TextEncoder.prototype.encode = encode;
  }
  assert.ok(Math.max(...texts.map(({ length }) => length)) < bytes.length / 2);
  const wanted = [
    ...grid.map((i) => `v ${place(i).join(' ')}\n`),
    ...corners.map((a) => `f ${a + 1} ${a + 2} ${a + rows + 1}\n`),
  ].join('');
  assert.ok(new TextDecoder().decode(bytes) === wanted, 'the blocks follow each other');
});
