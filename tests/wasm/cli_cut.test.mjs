// Cuts of meshes along curves, and the files of the parts.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { load } from 'karcher';
import { solidOf } from 'karcher/checkup';
import { meshFile, meshFromFile, writtenFormats } from 'karcher/formats';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { randoms, seed } from '../web/part.mjs';
import { failure, karcher, printed, temporaryFolder } from './run_cli.mjs';

const engine = await load();
const folder = temporaryFolder();
after(() => folder.remove());

const near = (actual, expected, tolerance = 1e-9) =>
  assert.ok(Math.abs(actual - expected) < tolerance, `${actual} is not ${expected}`);

const sphere = engine.shape('sphere', 2000);
const meshName = folder.write(
  'sphere.ply',
  meshFile({ positions: sphere.positions(), triangles: sphere.triangles() }, 'ply'),
);

const [first, second] = [
  [1, 0, 0.3],
  [0.8, 0.7, 0.1],
];

/**
 * A closed curve about a place of the sphere, at increasing angles: it winds around the place
 * `turns` times.
 */
function loop(center, next, turns = 1) {
  const points = Array.from({ length: 8 }, (_, i) => {
    const angle = (turns * i * Math.PI) / 4;
    const [y, z] = [Math.cos(angle), Math.sin(angle)].map((side) => (0.5 + 0.2 * next()) * side);
    return sphere.nearestPoint([center[0], center[1] + y, center[2] + z]).point;
  });
  return { kind: 'catmullrom', closed: true, points };
}

console.log(`drawn with KARCHER_SEED=${seed}`);
const random = randoms(seed);
const next = () => random.next().value;
const curves = folder.write(
  'curves.json',
  JSON.stringify({ curves: [loop(first, next), loop(second, next)] }),
);
const args = ['cut', meshName, '--curve', curves, '--samples', '12'];

/** The boundary edges, as the places of their ends. */
function rim({ positions, triangles }) {
  const place = (v) => positions.slice(3 * v, 3 * v + 3).join(' ');
  const edges = new Set();
  for (let i = 0; i < triangles.length; i++) {
    edges.add(`${triangles[i]} ${triangles[i - (i % 3) + ((i + 1) % 3)]}`);
  }
  return [...edges]
    .map((edge) => edge.split(' '))
    .filter(([tail, head]) => !edges.has(`${head} ${tail}`))
    .map(([tail, head]) => [place(tail), place(head)]);
}

async function fileRead(name, repair = 'none') {
  const bytes = new Uint8Array(readFileSync(name));
  const { mesh } = await meshFromFile(engine, bytes, { name, repair });
  return mesh;
}

for (const format of writtenFormats) {
  test(`parts as ${format} files fit together and are read without a repair`, async () => {
    const isSingle = format === 'stl' || format === 'glb';
    const out = join(folder.path, `part.${format}`);
    const { parts } = await printed(...args, '--out', out);
    assert.ok(parts.length >= 4, `${parts.length} parts`);
    const sides = new Map();
    let sum = 0;
    for (const [i, { file, triangles, area, oriented, closed, volume }] of parts.entries()) {
      assert.equal(file, join(folder.path, `part_${i}.${format}`));
      assert.deepEqual([oriented, closed, volume], [true, false, null]);
      const mesh = await fileRead(file);
      assert.deepEqual(mesh.info.repairs, []);
      if (!isSingle) assert.equal(mesh.info.triangles, triangles);
      const content = { positions: mesh.positions(), triangles: mesh.triangles() };
      near(solidOf(content).area, area, isSingle ? 1e-5 : 1e-12);
      sum += area;
      for (const [tail, head] of rim(content)) {
        sides.set(`${tail}/${head}`, (sides.get(`${tail}/${head}`) ?? 0) + 1);
      }
    }
    near(sum, solidOf({ positions: sphere.positions(), triangles: sphere.triangles() }).area);
    // The sphere has no boundary: every rim is the rim of another part, to the last bit.
    for (const [side, count] of sides) {
      assert.equal(sides.get(side.split('/').reverse().join('/')), count, side);
    }
  });
}

test('a part that touches itself at a point is read unchanged', async () => {
  // A figure eight: its outside reaches the crossing from two sides.
  const points = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => {
    const angle = ((i + 0.4) * Math.PI) / 4;
    return sphere.nearestPoint([1, 0.6 * Math.sin(angle), 0.4 * Math.sin(2 * angle)]).point;
  });
  const eight = JSON.stringify({ kind: 'polyline', closed: true, points });
  const file = folder.write('eight.json', eight);
  for (const format of writtenFormats) {
    const out = join(folder.path, `eight.${format}`);
    const { parts } = await printed('cut', meshName, '--curve', file, '--out', out);
    assert.equal(parts.length, 3);
    const mesh = await fileRead(parts[0].file, 'safe');
    // Corners of an STL file have no indices that would keep them apart.
    const expected = [format === 'stl' ? 'bowTie' : 'keptApart'];
    assert.deepEqual(
      mesh.info.repairs.map(({ kind }) => kind),
      expected,
      format,
    );
    const content = { positions: mesh.positions(), triangles: mesh.triangles() };
    near(solidOf(content).area, parts[0].area, 1e-5);
  }
});

test('parts of a cut keep the colors and parts of the file, and shells keep colors', async () => {
  const [positions, triangles] = [sphere.positions(), sphere.triangles()];
  // Colors change linearly, so that those between corners are known.
  const colorAt = (place) => Array.from(place, (x) => Math.round(127.5 + 100 * x));
  const colors = Uint8Array.from(positions, (x) => Math.round(127.5 + 100 * x));
  const names = [{ name: 'upper' }, { name: 'lower' }];
  const partOf = Int32Array.from({ length: triangles.length / 3 }, (_, f) =>
    [0, 1, 2].every((k) => positions[3 * triangles[3 * f + k] + 1] >= 0) ? 0 : 1,
  );
  const content = { positions, triangles, colors, parts: names, partOf };
  const colored = folder.write('colored.obj', meshFile(content, 'obj'));
  const cut = ['cut', colored, ...args.slice(2)];
  const read = async (file) => {
    const bytes = new Uint8Array(readFileSync(file));
    return meshFromFile(engine, bytes, { name: file, repair: 'none' });
  };
  const farthest = (mesh, given, scale = 1) =>
    Math.max(
      ...given.map((value, i) => Math.abs(value - colorAt([mesh.positions()[i] * scale])[0])),
    );
  const { parts } = await printed(...cut, '--out', join(folder.path, 'colored_part.obj'));
  assert.ok(parts.length >= 4);
  const seen = new Set();
  for (const { file } of parts) {
    const { mesh, file: said } = await read(file);
    // Colors are rounded twice: in the original file and here.
    assert.ok(farthest(mesh, said.colors) <= 1, `${farthest(mesh, said.colors)}`);
    said.parts.forEach(({ name, triangles: count }) => {
      if (count > 0) seen.add(name);
    });
  }
  assert.deepEqual([...seen].sort(), ['lower', 'upper']);
  const shells = [...cut, '--thickness', '0.1', '--out', join(folder.path, 'colored_shell.ply')];
  for (const { file } of (await printed(...shells)).parts) {
    const { mesh, file: said } = await read(file);
    const places = mesh.positions();
    const inner = [...said.colors].filter((_, i) => i < places.length / 2);
    assert.equal(said.colors.length, places.length);
    assert.ok(farthest(mesh, Uint8Array.from(inner)) <= 1);
  }
});

test('parts are ordered by area; without --out no file is written', async () => {
  const { parts } = await printed(...args);
  for (const [i, part] of parts.entries()) {
    assert.equal('file' in part, false);
    if (i > 0) assert.ok(part.area <= parts[i - 1].area);
  }
});

test('a curve that ends inside leaves a slit, and closed parts have a volume', async () => {
  const points = folder.write('points.txt', '3 0.2 0.2\n90 0.3 0.3\n');
  const { parts } = await printed('cut', meshName, '--points', points, '--kind', 'polyline');
  assert.equal(parts.length, 1);
  const [part] = parts;
  // Each side of the slit has its own vertices.
  assert.deepEqual([part.closed, part.volume], [false, null]);
  const { area, volume, closed } = solidOf({
    positions: sphere.positions(),
    triangles: sphere.triangles(),
  });
  assert.ok(closed && volume > 0);
  near(part.area, area);
  // Of all bodies with this area the ball has the largest volume.
  assert.ok(36 * Math.PI * volume ** 2 < area ** 3);
  assert.ok(36 * Math.PI * volume ** 2 > 0.98 * area ** 3);
});

test('a box of 2 by 3 by 4, far from the origin', () => {
  const positions = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [
    1e6 + 2 * (i & 1),
    3 * ((i >> 1) & 1),
    4 * ((i >> 2) & 1),
  ]);
  const triangles = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ].flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);
  const box = solidOf({ positions, triangles });
  assert.deepEqual(box, { area: 52, oriented: true, closed: true, volume: 24 });
  assert.equal(solidOf({ positions, triangles: triangles.toReversed() }).volume, -24);
  const open = solidOf({ positions, triangles: triangles.slice(3) });
  assert.deepEqual([open.oriented, open.closed, open.volume], [true, false, null]);
  const turned = triangles.with(0, triangles[1]).with(1, triangles[0]);
  const { oriented, closed } = solidOf({ positions, triangles: turned });
  assert.deepEqual([oriented, closed], [false, false]);
});

test('the loaders of three.js read the written files', async () => {
  const triangles = sphere.triangles();
  const content = { positions: sphere.positions(), triangles };
  const bytes = (format) => meshFile(content, format).buffer;
  const corners = triangles.length;
  assert.equal(new STLLoader().parse(bytes('stl')).getAttribute('position').count, corners);
  assert.equal(new PLYLoader().parse(bytes('ply')).index.count, corners);
  const obj = new OBJLoader().parse(new TextDecoder().decode(bytes('obj')));
  assert.equal(obj.children[0].geometry.getAttribute('position').count, corners);
  const { scene } = await new GLTFLoader().parseAsync(bytes('glb'), '');
  const { geometry } = scene.children[0];
  assert.equal(geometry.index.count, corners);
  geometry.computeBoundingSphere();
  near(geometry.boundingSphere.center.length(), 0, 1e-3);
});

test('triangles that degenerate in single precision are left out of STL and GLB', async () => {
  // Two triangles, and a needle between them whose short side vanishes.
  const positions = [1, 0, 0, 2, 0, 0, 1, 1, 0, 1 + 1e-12, 0, 0, 0, 0, 0];
  const triangles = [3, 1, 2, 0, 3, 2, 4, 0, 2];
  for (const format of ['stl', 'glb']) {
    const bytes = meshFile({ positions, triangles }, format);
    const { mesh } = await meshFromFile(engine, bytes, { repair: 'none' });
    assert.deepEqual([mesh.info.triangles, mesh.info.components], [2, 1]);
  }
});

test('impossible formats and parts are reported', async () => {
  assert.match(await failure(...args, '--out', 'part.off'), /^--out of cut must end in \.stl, /);
  assert.match(await failure(...args, '--out', 'stl'), /as leg\.stl, not 'stl'$/);
  const nowhere = join(folder.path, 'none', 'part.stl');
  assert.match(await failure(...args, '--out', nowhere), /^cannot write to .*part_0\.stl: /);
  const bad = { name: 'KarcherError' };
  assert.throws(() => meshFile({ positions: [0, 0], triangles: [] }, 'stl'), bad);
  assert.throws(() => meshFile({ positions: [0, 0, 0], triangles: [0, 0, 1] }, 'stl'), {
    ...bad,
    code: 'badIndex',
  });
  assert.throws(() => meshFile({ positions: [], triangles: [] }, 'off'), bad);
});

test('the help of cut names its own --out', async () => {
  const { stdout } = await karcher('help', 'cut');
  assert.equal(stdout.match(/--out FILE/g).length, 1);
});
