// Curves in written files: rows of CSV, lines and tubes beside the mesh, as other programs read them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, describe, test } from 'node:test';
import { load } from 'karcher';
import { solidOf } from 'karcher/checkup';
import { curvesCsv, meshFile, meshFromFile, pathParameters } from 'karcher/formats';
import { loadInWorker } from 'karcher/worker';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { randomFrom, seed } from '../web/part.mjs';
import { failure, karcher, printed, temporaryFolder } from './run_cli.mjs';

const engine = await load();
const folder = temporaryFolder();
after(() => folder.remove());

/** A sphere of radius 2, and its arrays. */
const ball = (() => {
  const geometry = new THREE.SphereGeometry(2, 32, 16);
  const mesh = engine.meshFromArrays(
    Float64Array.from(geometry.attributes.position.array),
    Int32Array.from(geometry.index.array),
  );
  return { mesh, surface: { positions: mesh.positions(), triangles: mesh.triangles() } };
})();
const faces = ball.mesh.info.triangles;
const { mesh, surface } = ball;
const pointsOf = (random, count) =>
  Array.from({ length: count }, () => ({
    face: Math.floor(random() * faces),
    bary: [0.2, 0.3, 0.5],
  }));

/** A path along places that need not lie on a surface. */
function pathAlong(places, closed) {
  const lengths = new Float64Array(places.length);
  for (let i = 1; i < places.length; i++) {
    lengths[i] = lengths[i - 1] + Math.hypot(...places[i].map((x, k) => x - places[i - 1][k]));
  }
  return {
    closed,
    count: places.length,
    length: lengths.at(-1),
    points: () => places.map(() => ({ face: 0, bary: [1, 0, 0] })),
    polyline: () => Float64Array.from(places.flat()),
    lengths: () => lengths,
  };
}

/** The triangles of a geometry of three.js as a mesh of doubles, of which equal places are one. */
function weldedOf({ attributes, index }) {
  const numbers = new Map();
  const positions = [];
  const { array } = attributes.position;
  const vertexOf = (i) => {
    const place = array.slice(3 * i, 3 * i + 3);
    const key = place.join(' ');
    if (!numbers.has(key)) {
      numbers.set(key, positions.length / 3);
      positions.push(...place);
    }
    return numbers.get(key);
  };
  const corners = index ? [...index.array] : [...Array(array.length / 3).keys()];
  return { positions, triangles: corners.map(vertexOf) };
}

const rowsOf = (text) =>
  text
    .trimEnd()
    .split('\n')
    .map((line) => line.split(','));

describe('CSV', () => {
  const curves = ['bspline', 'bezier', 'catmullrom', 'polyline'].flatMap((kind) =>
    [false, true].map((closed) => ({ kind, closed })),
  );

  for (const { kind, closed } of curves) {
    test(`of a ${closed ? 'closed' : 'open'} ${kind} has its points to the last bit`, (t) => {
      t.diagnostic(`seed ${seed}`);
      const curve = mesh.curve({ kind, closed, points: pointsOf(randomFrom(seed), 5) });
      const path = curve.path();
      const parameters = pathParameters(path, curve.samples());
      const [header, ...rows] = rowsOf(curvesCsv([{ name: 'c', path, parameters }], surface));
      assert.equal(
        header.join(),
        'x,y,z,normal_x,normal_y,normal_z,face,bary_1,bary_2,bary_3,length,parameter',
      );
      const numbers = rows.map((row) => row.map(Number));
      assert.deepEqual(
        numbers.flatMap((row) => row.slice(0, 3)),
        [...path.polyline({ bits: 64 })],
      );
      const points = numbers.map(([, , , , , , face, ...rest]) => ({
        face,
        bary: rest.slice(0, 3),
      }));
      assert.deepEqual(points, path.points());
      assert.deepEqual(
        numbers.map((row) => row[10]),
        [...path.lengths()],
      );
      for (const [i, row] of numbers.entries()) {
        // Normals are of length 1, and of a sphere's chord faces nearly its own.
        const normal = row.slice(3, 6);
        assert.ok(Math.abs(Math.hypot(...normal) - 1) < 1e-15);
        const outwards = row.slice(0, 3).reduce((sum, x, k) => sum + (x * normal[k]) / 2, 0);
        assert.ok(outwards > Math.cos(0.2), `the normal of row ${i} is off: ${outwards}`);
        // The engine itself has the length at a parameter.
        const last = closed && i === numbers.length - 1;
        const length = last ? curve.length : curve.lengthAt(row[11]);
        assert.ok(Math.abs(length - row[10]) < 1e-12 * curve.length, `${length} at ${row[11]}`);
      }
      assert.deepEqual([numbers[0][11], numbers.at(-1)[11]], [0, curve.segmentCount]);
      curve.dispose();
    });
  }

  test('of a curve that ends with a bridge has all parameters', () => {
    const torus = engine.shape('torus', 2000);
    const points = [1148, 364, 986, 768].map((face) => ({ face, bary: [0.2, 0.3, 0.5] }));
    const curve = torus.curve({ kind: 'bspline', points, levels: 0, samples: 33 });
    assert.equal(curve.bridged().at(-1).t1, 1);
    const parameters = pathParameters(curve.path(), curve.samples());
    assert.equal(parameters.at(-1), curve.segmentCount);
    assert.deepEqual(parameters, parameters.toSorted());
    torus.dispose();
  });

  test('of a curve in a worker is the same', async () => {
    const remote = await loadInWorker();
    try {
      const [positions, triangles] = [surface.positions.slice(), surface.triangles.slice()];
      const there = await remote.meshFromArrays(positions, triangles);
      const value = { kind: 'bspline', points: pointsOf(randomFrom(seed), 5) };
      const [far, own] = [await there.curve(value), mesh.curve(value)];
      const textOf = (path, samples) =>
        curvesCsv([{ path, parameters: pathParameters(path, samples) }], surface);
      const text = textOf(await far.path(), await far.samples());
      assert.equal(text, textOf(own.path(), own.samples()));
    } finally {
      await remote.dispose();
    }
  });

  test('of a sphere has normals outwards, also where the import turned faces over', (t) => {
    t.diagnostic(`seed ${seed}`);
    const random = randomFrom(seed);
    const shape = engine.shape('sphere', 1000);
    const triangles = shape.triangles();
    for (let first = 0; first < triangles.length; first += 3) {
      if (random() < 0.3) triangles.subarray(first + 1, first + 3).reverse();
    }
    const turned = engine.meshFromArrays(shape.positions(), triangles);
    assert.ok(turned.info.repairs.some(({ kind }) => kind === 'turnedOver'));
    const path = turned.shortestPath({ vertex: 3 }, { vertex: 400 });
    // The engine may turn all faces of the sphere over, but none alone.
    const sides = rowsOf(curvesCsv([{ path }], turned))
      .slice(1)
      .map((row) => {
        const [x, y, z, a, b, c] = row.map(Number);
        return x * a + y * b + z * c;
      });
    assert.ok(
      sides.every((side) => side * sides[0] > 0.9),
      `${sides}`,
    );
  });

  test('of several curves names them, also by odd names', () => {
    const path = mesh.shortestPath({ vertex: 40 }, { vertex: 200 });
    const named = [{ name: 'a "b", c', path, parameters: [...path.lengths()] }, { path }];
    const lines = curvesCsv(named, surface).split('\n');
    assert.match(lines[0], /^curve,x,y,z,.*,length,parameter$/);
    assert.match(lines[1], /^"a ""b"", c",/);
    assert.match(lines.at(-2), /^curve 2,.*,$/);
    assert.throws(() => curvesCsv([{ path, parameters: [0] }], surface), { code: 'badArgument' });
    const other = { positions: [0, 0, 0], triangles: [0, 0, 0] };
    assert.throws(() => curvesCsv([{ path }], other), { code: 'badIndex' });
    for (const face of [-1, 0.5, Number.NaN]) {
      const points = path.points().map((point) => ({ ...point, face }));
      const astray = { closed: false, count: points.length, points: () => points };
      const arrays = { polyline: (bits) => path.polyline(bits), lengths: () => path.lengths() };
      assert.throws(() => curvesCsv([{ path: { ...astray, ...arrays } }], surface), {
        code: 'badIndex',
      });
    }
  });
});

describe('a tube', () => {
  /** A regular polygon in a plane, closed. */
  const polygon = (count, size) =>
    Array.from({ length: count + 1 }, (_, i) => {
      const angle = (2 * Math.PI * (i % count)) / count;
      return [size * Math.cos(angle), size * Math.sin(angle), 1];
    });
  const tubeOf = async (path, how) => {
    const curves = [{ path, ...how }];
    // PLY keeps positions in doubles.
    const { mesh: tube } = await meshFromFile(
      engine,
      meshFile({ positions: [], triangles: [], curves }, 'ply'),
      { repair: 'none' },
    );
    return solidOf({ positions: tube.positions(), triangles: tube.triangles() });
  };

  for (const [count, sides] of [
    [64, 8],
    [12, 5],
    [3, 64],
  ]) {
    test(`of ${sides} sides along a polygon of ${count} has its area and volume`, async () => {
      const [size, radius] = [3, 0.25];
      const solid = await tubeOf(pathAlong(polygon(count, size), true), { radius, sides });
      // Places at a distance from the axis move along chords: Pappus' theorem with these.
      const turn = (2 * Math.PI) / count;
      const section = (sides / 2) * radius ** 2 * Math.sin((2 * Math.PI) / sides);
      const volume = count * Math.sin(turn) * size * section;
      assert.ok(solid.closed && solid.oriented);
      assert.ok(Math.abs(solid.volume - volume) < 1e-12 * volume, `${solid.volume}, not ${volume}`);
      // The area of the tube is at most that of the torus, and nearly that with many sides.
      const torus = 4 * Math.PI ** 2 * size * radius;
      assert.ok(solid.area < torus);
      if (count === 64) assert.ok(solid.area > 0.97 * torus);
    });
  }

  test('along an open line is a prism, closed by its ends', async () => {
    const [length, radius, sides] = [7, 0.5, 6];
    const path = pathAlong(
      [
        [0, 0, 0],
        [2, 0, 0],
        [length, 0, 0],
      ],
      false,
    );
    const solid = await tubeOf(path, { radius, sides });
    const section = (sides / 2) * radius ** 2 * Math.sin((2 * Math.PI) / sides);
    const area = 2 * section + length * 2 * sides * radius * Math.sin(Math.PI / sides);
    assert.ok(solid.closed && solid.oriented);
    assert.ok(Math.abs(solid.volume - length * section) < 1e-12);
    assert.ok(Math.abs(solid.area - area) < 1e-12);
  });

  test('of a circle on the sphere has nearly the volume of a torus', async () => {
    const { path } = mesh.circle({ face: 200, bary: [0.3, 0.3, 0.4] }, { radius: 1.2 });
    const radius = 0.05;
    const solid = await tubeOf(path, { radius, sides: 32 });
    const section = 16 * radius ** 2 * Math.sin(Math.PI / 16);
    assert.ok(solid.closed && solid.oriented);
    // The length of the polyline, less the second order of its turns.
    assert.ok(Math.abs(solid.volume / (path.length * section) - 1) < 5e-3);
  });

  test('does not twist, and closes, along knots in space', async (t) => {
    t.diagnostic(`seed ${seed}`);
    const random = randomFrom(seed);
    for (let i = 0; i < 20; i++) {
      const [a, b, c] = [random(), random(), random()];
      const places = Array.from({ length: 201 }, (_, k) => {
        const s = (2 * Math.PI * (k % 200)) / 200;
        const across = 3 + (0.5 + a) * Math.cos(3 * s);
        return [
          across * Math.cos(2 * s),
          across * Math.sin(2 * s) + b * Math.sin(s),
          (1 + c) * Math.sin(3 * s),
        ];
      });
      const [radius, sides] = [0.05, 16];
      const path = pathAlong(places, true);
      const solid = await tubeOf(path, { radius, sides });
      const section = (sides / 2) * radius ** 2 * Math.sin((2 * Math.PI) / sides);
      assert.ok(solid.closed && solid.oriented);
      // A twisted tube would be thinner between its rings.
      const part = solid.volume / (path.length * section);
      assert.ok(Math.abs(part - 1) < 0.02, `${part} of the volume`);
    }
  });
});

const path = mesh.circle({ face: 200, bary: [0.3, 0.3, 0.4] }, { radius: 1.2 }).path;
const open = mesh.shortestPath({ vertex: 40 }, { vertex: 200 });
const curves = [
  { name: 'ring', path, color: [200, 30, 40] },
  { name: 'seam', path: open, color: [20, 130, 240] },
];
const single = (one) => [...one.polyline()];
const near = (a, b, by) => {
  assert.equal(a.length, b.length);
  assert.ok(a.every((x, i) => Math.abs(x - b[i]) <= by));
};
const bytesOf = (color) =>
  color
    .toArray()
    .map((light) =>
      Math.round(255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055)),
    );

describe('curves beside the mesh', () => {
  test('as GLB are lines of their own names and colors', async () => {
    const bytes = meshFile({ ...surface, curves }, 'glb');
    const { scene } = await new GLTFLoader().parseAsync(bytes.buffer, '');
    const [ball, ...lines] = scene.children;
    assert.ok(ball.isMesh);
    assert.deepEqual(
      lines.map(({ name, type }) => [name, type]),
      [
        ['ring', 'Line'],
        ['seam', 'Line'],
      ],
    );
    lines.forEach((line, i) => {
      assert.deepEqual([...line.geometry.attributes.position.array], single(curves[i].path));
      assert.deepEqual(bytesOf(line.material.color), curves[i].color);
    });
    // Our own reader has the mesh alone, with a note.
    const { mesh: read, file } = await meshFromFile(engine, bytes);
    assert.equal(read.info.triangles, ball.geometry.index.count / 3);
    assert.match(file.notRead.join(), /line/);
  });

  test('as GLB are tubes, smooth and closed', async () => {
    const tubes = curves.map((curve) => ({ ...curve, radius: 0.03, sides: 12 }));
    const bytes = meshFile(
      { ...surface, partOf: Array(faces).fill(0), parts: [{ name: 'ball' }], curves: tubes },
      'glb',
    );
    const { scene } = await new GLTFLoader().parseAsync(bytes.buffer, '');
    assert.deepEqual(
      scene.children.map(({ name }) => name),
      ['ball', 'ring', 'seam'],
    );
    scene.children.slice(1).forEach(({ geometry, material }, i) => {
      const solid = solidOf(weldedOf(geometry));
      assert.ok(solid.closed && solid.oriented && solid.volume > 0);
      assert.equal(geometry.attributes.normal.count, geometry.attributes.position.count);
      assert.deepEqual(bytesOf(material.color), curves[i].color);
    });
    const { mesh: read, file } = await meshFromFile(engine, bytes);
    assert.equal(read.info.components, 3);
    assert.deepEqual(
      file.parts.map(({ name }) => name),
      ['ball', 'ring', 'seam'],
    );
  });

  test('as OBJ are lines after the mesh', async () => {
    const bytes = meshFile({ ...surface, curves }, 'obj');
    const group = new OBJLoader().parse(new TextDecoder().decode(bytes));
    const [ball, ...lines] = group.children;
    assert.ok(ball.isMesh && ball.name === 'surface');
    assert.equal(ball.geometry.attributes.position.count, 3 * faces);
    assert.ok(lines.every(({ isLineSegments }) => isLineSegments));
    assert.deepEqual(
      lines.map(({ name }) => name),
      ['ring', 'seam'],
    );
    const { mesh: read } = await meshFromFile(engine, bytes, { name: 'a.obj' });
    assert.equal(read.info.triangles, faces);
    // Positions are right to the last bit.
    const own = new TextDecoder()
      .decode(bytes)
      .split('\n')
      .filter((line) => line.startsWith('v '));
    const last = own.slice(-open.count).flatMap((line) => line.split(' ').slice(1, 4).map(Number));
    assert.deepEqual(last, [...open.polyline({ bits: 64 })]);
    const { array } = lines[1].geometry.attributes.position;
    near([...array.slice(0, 3), ...array.slice(3, 6)], single(open).slice(0, 6), 0);
  });

  test('as PLY are edges after the mesh', async () => {
    const bytes = meshFile({ ...surface, curves }, 'ply');
    const geometry = new PLYLoader().parse(bytes.buffer);
    const count = surface.positions.length / 3 + path.count + open.count;
    assert.deepEqual(
      [geometry.attributes.position.count, geometry.index.count],
      [count, 3 * faces],
    );
    const last = geometry.attributes.color;
    // The loader has bytes of linear light.
    const color = [last.getX(count - 1), last.getY(count - 1), last.getZ(count - 1)];
    near(color, new THREE.Color().setStyle('rgb(20, 130, 240)').toArray(), 1 / 255);
    const { mesh: read, file } = await meshFromFile(engine, bytes);
    assert.equal(read.info.triangles, faces);
    assert.match(file.notRead.join(), /edge/);
    // The last edge ends at the last vertex.
    const view = new DataView(bytes.buffer);
    assert.deepEqual(
      [8, 4].map((back) => view.getInt32(bytes.length - back, true)),
      [count - 2, count - 1],
    );
  });

  test('as STL are tubes only', () => {
    assert.throws(() => meshFile({ ...surface, curves }, 'stl'), {
      code: 'badArgument',
      message: /lines/,
    });
    const alone = curves.map((curve) => ({ ...curve, radius: 0.03 }));
    const bytes = meshFile({ positions: [], triangles: [], curves: alone }, 'stl');
    const solid = solidOf(weldedOf(new STLLoader().parse(bytes.buffer)));
    assert.ok(solid.closed && solid.oriented && solid.volume > 0);
  });

  test('alone are files, too', async () => {
    const alone = { positions: [], triangles: [], curves };
    const { scene } = await new GLTFLoader().parseAsync(meshFile(alone, 'glb').buffer, '');
    assert.deepEqual(
      scene.children.map(({ type }) => type),
      ['Line', 'Line'],
    );
    assert.match(
      new TextDecoder().decode(meshFile(alone, 'ply')),
      /element face 0\n.*\nelement edge/,
    );
  });

  test('wrong ones are refused', () => {
    for (const wrong of [
      { color: [1, 2] },
      { color: [1, 2, 256] },
      { radius: 0 },
      { radius: -1 },
      { radius: 1, sides: 2 },
      { radius: 1, sides: 65 },
    ]) {
      for (const format of ['obj', 'ply', 'glb', 'stl']) {
        const curve = { path: open, radius: 0.1, ...wrong };
        assert.throws(() => meshFile({ ...surface, curves: [curve] }, format), {
          code: 'badArgument',
        });
      }
    }
  });
});

describe('the command line', () => {
  const file = folder.write('ball.ply', meshFile(surface, 'ply'));
  const points = folder.write('points.txt', 'v:40\nv:200\nv:330\nv:120\n');

  test('writes a curve as CSV, by the ending or to standard output', async () => {
    const to = join(folder.path, 'curve.csv');
    const trace = ['trace', file, '--points', points];
    assert.equal((await karcher(...trace, '--out', to)).status, 0);
    const { stdout } = await karcher(...trace, '--format', 'csv');
    assert.equal(stdout, readFileSync(to, 'utf8'));
    const [header, ...rows] = rowsOf(stdout);
    assert.deepEqual(header.slice(-2), ['length', 'parameter']);
    const { polyline, length } = await printed(...trace);
    assert.deepEqual(
      rows.map((row) => row.slice(0, 3).map(Number)),
      polyline,
    );
    assert.ok(Math.abs(Number(rows.at(-1)[10]) - length) < 1e-12 * length);
    assert.match(await failure(...trace, '--format', 'csv', '--tube', '1'), /^--tube has no use/);
  });

  test('writes lines and tubes, with the mesh on request', async () => {
    const lines = ['isolines', file, '--center', 'v:40', '--radius', '0.5,1'];
    const glb = join(folder.path, 'lines.glb');
    for (const [extra, types] of [
      [[], ['Line', 'Line']],
      [['--surface'], ['Mesh', 'Line', 'Line']],
      [
        ['--surface', '--tube', '0.02'],
        ['Mesh', 'Mesh', 'Mesh'],
      ],
    ]) {
      assert.equal((await karcher(...lines, ...extra, '--out', glb)).status, 0);
      const { buffer } = Uint8Array.from(readFileSync(glb));
      const { scene } = await new GLTFLoader().parseAsync(buffer, '');
      assert.deepEqual(
        scene.children.map(({ type }) => type),
        types,
      );
      assert.equal(scene.children.at(-1).name, 'isolines_2');
    }
    assert.match(
      await failure(...lines, '--format', 'stl'),
      /needs --tube RADIUS: STL has no lines/,
    );
    assert.match(await failure(...lines, '--surface'), /^--surface has no use with --format json$/);
    const several = ['isolines', file, file, '--center', 'v:40', '--radius', '0.5', '--tube', '1'];
    assert.match(await failure(...several), /^--tube has no use with --format json$/);
    const none = ['isolines', file, '--center', 'v:40', '--radius', '1000', '--out', glb];
    assert.match(await failure(...none), /GLB needs a triangle or a line/);
  });
});
