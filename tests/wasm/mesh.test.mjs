import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { KarcherError, load } from 'karcher';
import { badFiles, grid, square, tetrahedron } from './meshes.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

test('a tetrahedron: a closed surface of genus 0', () => {
  const { info } = karcher.meshFromObj(tetrahedron);
  assert.deepEqual(
    { ...info, meanEdge: 0, diagonal: 0 },
    {
      vertices: 4,
      triangles: 4,
      components: 1,
      boundaryLoops: 0,
      genus: 0,
      meanEdge: 0,
      diagonal: 0,
      repairs: [],
    },
  );
  assert.ok(Math.abs(info.meanEdge - (1 + Math.SQRT2) / 2) < 1e-15);
  assert.ok(Math.abs(info.diagonal - Math.sqrt(3)) < 1e-15);
});

test('text, bytes and arrays make the same mesh', () => {
  const text = grid(3);
  const meshes = [
    karcher.meshFromObj(text),
    karcher.meshFromObj(new TextEncoder().encode(text)),
    karcher.meshFromObj(Buffer.from(text)),
  ];
  const [first] = meshes;
  meshes.push(karcher.meshFromArrays(first.positions(), first.triangles()));
  meshes.push(
    karcher.meshFromArrays(Array.from(first.positions()), Uint16Array.from(first.triangles())),
  );
  for (const mesh of meshes) {
    assert.deepEqual(mesh.info, first.info);
    assert.deepEqual(mesh.positions(), first.positions());
    assert.deepEqual(mesh.triangles(), first.triangles());
  }
});

test('vertices and faces keep the order of the file', () => {
  const mesh = karcher.meshFromObj(grid(4));
  const positions = mesh.positions();
  const triangles = mesh.triangles();
  assert.equal(positions.length, 3 * 25);
  for (let vertex = 0; vertex < 25; vertex++) {
    const place = [vertex % 5, Math.floor(vertex / 5), 0];
    assert.deepEqual(Array.from(positions.slice(3 * vertex, 3 * vertex + 3)), place);
    assert.deepEqual(mesh.position({ vertex }), place);
  }
  // Square 6 has its lower left corner at (2, 1).
  assert.deepEqual(Array.from(triangles.slice(36, 42)), [7, 8, 13, 7, 13, 12]);
  assert.deepEqual(mesh.position({ face: 12, bary: [0.5, 0.25, 0.25] }), [2.5, 1.25, 0]);
});

test('polygons are cut, welded vertices repeat, dropped vertices keep their place', () => {
  // Two squares; the right one has its own vertices along the common edge, and vertex 4 is unused.
  const mesh = karcher.meshFromObj(
    `${square}v 7 8 9\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 6 7 8 9\n`,
  );
  const { info } = mesh;
  assert.equal(info.vertices, 6);
  assert.equal(info.triangles, 4);
  assert.equal(info.components, 1);
  assert.deepEqual(
    info.repairs.map(({ kind, count }) => [kind, count]),
    [
      ['triangulated', 2],
      ['welded', 2],
      ['dropped', 1],
    ],
  );
  for (const { message } of info.repairs) assert.match(message, /\d/);
  const positions = Array.from(mesh.positions());
  assert.equal(positions.length, 27);
  assert.deepEqual(positions.slice(12, 18), [7, 8, 9, 1, 0, 0]);
  assert.deepEqual(mesh.position({ vertex: 5 }), [1, 0, 0]);
  assert.deepEqual(mesh.position({ vertex: 8 }), [1, 1, 0]);
  assert.throws(() => mesh.position({ vertex: 4 }), { code: 'badIndex', message: /vertex 4/ });
  const used = new Set(mesh.triangles());
  assert.ok(!used.has(4));
  assert.equal(used.size, 6);
});

test('a file and arrays of the same numbers make the same positions, to 10 units in the last place', () => {
  // Numbers in all notations of JavaScript and other languages.
  const notations = [
    (x) => `${x}`,
    (x) => x.toPrecision(17),
    (x) => x.toExponential(),
    (x) => x.toExponential(20),
    (x) => `+${x.toPrecision(17)}`.replace('+-', '-'),
  ];
  let state = 12;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state / 2 ** 32 - 0.5) * 10 ** ((state % 7) - 3);
  };
  const count = 500;
  const positions = Float64Array.from({ length: 9 * count }, () => random() + random() * 2 ** -32);
  const triangles = Int32Array.from({ length: 3 * count }, (_, i) => i);
  const faces = Array.from({ length: count }, (_, i) => `f ${3 * i + 1} ${3 * i + 2} ${3 * i + 3}`);
  const expected = karcher.meshFromArrays(positions, triangles).positions();
  for (const notation of notations) {
    const vertices = Array.from({ length: 3 * count }, (_, v) => {
      return `v ${Array.from(positions.slice(3 * v, 3 * v + 3), notation).join(' ')}`;
    });
    const mesh = karcher.meshFromObj([...vertices, ...faces].join('\n'));
    for (const [i, x] of mesh.positions().entries()) {
      // A unit in the last place is at most 2^-52 of a number.
      assert.ok(Math.abs(x - expected[i]) <= 10 * 2 ** -52 * Math.abs(expected[i]));
    }
  }
});

test('one place in two notations is one vertex', () => {
  const mesh = karcher.meshFromObj(
    'v 0.348799 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 3.48799e-1 0 0\nv 0 -1 0\nv 1 0 0\nf 4 5 6\n',
  );
  assert.ok(Math.abs(mesh.position({ vertex: 0 })[0] - 0.348799) < 1e-15);
  assert.equal(mesh.info.components, 1);
  assert.deepEqual(
    mesh.info.repairs.map(({ kind, count }) => [kind, count]),
    [['welded', 2]],
  );
});

test('parts that touch at a vertex stay separate, and the repair is reported', () => {
  const mesh = karcher.meshFromObj(
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 0 0 0\nv -1 0 0\nv 0 -1 0\nf 4 5 6\n',
  );
  assert.equal(mesh.info.components, 2);
  assert.deepEqual(
    mesh.info.repairs.map(({ kind, count }) => [kind, count]),
    [['keptApart', 1]],
  );
});

test('coordinates beyond the limits of size are refused', () => {
  const at = (size) => [
    () => karcher.meshFromArrays([0, 0, 0, size, 0, 0, 0, size, 0], [0, 1, 2]),
    () => karcher.meshFromObj(`v 0 0 0\nv ${size} 0 0\nv ${size} 1 0\nv 0 ${size} 0\nf 1 2 3 4`),
  ];
  const says = /vertex 1 .* 1e\+150; at most 1e\+30 .* scale the mesh first/;
  for (const make of at(1e150)) assert.throws(make, { code: 'badArgument', message: says });
  const tiny = () => karcher.meshFromArrays([0, 0, 0, 1e-150, 0, 0, 0, 1e-150, 0], [0, 1, 2]);
  assert.throws(tiny, { code: 'badArgument', message: /at least 1e-30: scale/ });
  const infinite = () => karcher.meshFromObj('v 0 0 0\nv 1e999 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4');
  assert.throws(infinite, { code: 'notFinite', message: /vertex 1/ });
});

test('a point is checked, and its rounding errors are removed', () => {
  const mesh = karcher.meshFromObj(square);
  assert.deepEqual(mesh.surfacePoint(1, [0.25, 0.25, 0.5]), { face: 1, bary: [0.25, 0.25, 0.5] });
  const barycoord = { x: 0.25, y: 0.25, z: 0.5 };
  assert.deepEqual(mesh.surfacePoint(1, barycoord), mesh.surfacePoint(1, [0.25, 0.25, 0.5]));
  assert.deepEqual(mesh.surfacePoint(0, Float32Array.of(-1e-8, 0.5, 0.5)), {
    face: 0,
    bary: [0, 0.5, 0.5],
  });
  const wrong = [
    [2, [1, 0, 0], 'badIndex', /face 2/],
    [-1, [1, 0, 0], 'badIndex', /face -1/],
    [1, [0.5, 0.6, -0.1], 'badPoint', /face 1/],
    [1, [0.5, 0.5, 0.5], 'badPoint', /sum to 1/],
    [1, [Number.NaN, 0.5, 0.5], 'notFinite', /face 1/],
    [0.5, [1, 0, 0], 'badArgument', /whole number/],
    ['0', [1, 0, 0], 'badArgument', /whole number/],
    [0, [1, 0], 'badArgument', /3 numbers/],
    [0, ['1', 0, 0], 'badArgument', /must be a number/],
    [0, undefined, 'badArgument', /array/],
  ];
  for (const [face, bary, code, message] of wrong) {
    assert.throws(() => mesh.surfacePoint(face, bary), { name: 'KarcherError', code, message });
  }
  for (const point of [undefined, null, 3, {}, { vertex: 1.5 }, { vertex: '1' }]) {
    assert.throws(() => mesh.position(point), { code: 'badArgument' });
  }
  for (const vertex of [-1, 4, 2 ** 31]) {
    assert.throws(() => mesh.position({ vertex }), KarcherError);
  }
});

test('a point does not depend on the order of faces in memory', () => {
  // Errors and results use the caller's faces although the engine sorts them.
  const mesh = karcher.meshFromObj(grid(8));
  for (let face = 0; face < 128; face++) {
    assert.equal(mesh.surfacePoint(face, [0.2, 0.3, 0.5]).face, face);
    assert.throws(() => mesh.surfacePoint(face, [2, 0, 0]), {
      message: new RegExp(`face ${face} `),
    });
  }
});

test('files without a mesh: an error each, and the program continues', () => {
  const mesh = karcher.meshFromObj(square);
  for (const { what, text, code, says } of badFiles) {
    assert.throws(
      () => karcher.meshFromObj(text, { repair: 'none' }),
      (error) => {
        assert.ok(error instanceof KarcherError, what);
        assert.ok(error instanceof Error);
        assert.equal(error.code, code, what);
        assert.match(error.message, says, what);
        return true;
      },
    );
    assert.deepEqual(mesh.position({ vertex: 2 }), [1, 1, 0]);
    assert.equal(karcher.meshFromObj(square).info.triangles, 2);
  }
});

test('arrays without a mesh are refused', () => {
  const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  const wrong = [
    [positions, [0, 1], 'badArgument', /multiple/],
    [positions.slice(1), [0, 1, 2], 'badArgument', /multiple/],
    [positions, [0, 1, 3], 'badIndex', /vertex 3/],
    [positions, [0, 1, -1], 'badIndex', /vertex -1/],
    [positions, [0, 1, 1], 'degenerateFace', /face 0/],
    [positions, [0, 1, Number.NaN], 'badArgument', /entry 2 of the triangles/],
    [positions, [0, 1, 0.5], 'badArgument', /whole number/],
    [positions, [0, 1, 2 ** 32], 'badArgument', /whole number/],
    [positions, [], 'badFile', /no faces/],
    [positions.with(4, Number.NaN), [0, 1, 2], 'notFinite', /vertex 1/],
    [positions.with(8, Number.POSITIVE_INFINITY), [0, 1, 2], 'notFinite', /vertex 2/],
    [positions.with(4, '1'), [0, 1, 2], 'badArgument', /entry 4 of the positions/],
    [positions.with(4, undefined), [0, 1, 2], 'badArgument', /entry 4 of the positions/],
    [positions, undefined, 'badArgument', /array/],
    ['000100010', [0, 1, 2], 'badArgument', /array/],
    [null, [0, 1, 2], 'badArgument', /array/],
  ];
  for (const [coordinates, triangles, code, message] of wrong) {
    assert.throws(() => karcher.meshFromArrays(coordinates, triangles, { repair: 'none' }), {
      name: 'KarcherError',
      code,
      message,
    });
  }
  assert.throws(() => karcher.meshFromObj(3), { code: 'badArgument' });
  assert.throws(() => karcher.meshFromObj(), { code: 'badArgument' });
  assert.equal(karcher.meshFromArrays(positions, [0, 1, 2]).info.triangles, 1);
});

test('a straightest geodesic on a plane is a straight line', () => {
  const mesh = karcher.meshFromObj(grid(4));
  const from = { face: 0, bary: [0.5, 0.25, 0.25] };
  const walked = mesh.straightest(from, [0, 3, 4], 2);
  const end = mesh.position(walked.end);
  assert.ok(Math.abs(end[0] - 0.5) < 1e-14 && Math.abs(end[1] - 2.25) < 1e-14);
  assert.equal(walked.remaining, 0);
  assert.equal(walked.stop, 'complete');
  assert.equal(walked.path.length, 2);
  const polyline = walked.path.polyline({ bits: 64 });
  assert.deepEqual(Array.from(polyline.slice(0, 3)), [0.5, 0.25, 0]);
  assert.deepEqual(Array.from(polyline.slice(-3)), end);
  const named = mesh.straightest(from, { x: 0, y: 3, z: 4 }, 2);
  assert.deepEqual(named.path.polyline({ bits: 64 }), polyline);
  // From (0.5, 0.25) the left side is half a unit away.
  const stopped = mesh.straightest(from, [-2, 0, 0], 3);
  assert.ok(Math.abs(stopped.remaining - 2.5) < 1e-14);
  assert.equal(stopped.stop, 'boundary');
  assert.ok(Math.abs(stopped.path.length - 0.5) < 1e-14);
  assert.deepEqual(mesh.position(stopped.end), [0, 0.25, 0]);
  assert.throws(() => mesh.straightest(from, [0, 0, 1], 1), { code: 'badArgument' });
  for (const wrong of [[0, 1], { x: 0, y: 1 }, { x: 0, y: 1, z: '1' }]) {
    assert.throws(() => mesh.straightest(from, wrong, 1), { code: 'badArgument' });
  }
  assert.throws(() => mesh.straightest(from, [0, Number.NaN, 1], 1), { code: 'notFinite' });
  assert.throws(() => mesh.straightest(from, [0, 1, 0], -1), { code: 'badArgument' });
  assert.throws(() => mesh.straightest(from, [0, 1, 0], Number.NaN), { code: 'notFinite' });
});

test('a straightest geodesic that exceeds its bound says so', () => {
  const { stop, remaining } = karcher
    .shape('sphere', 2000)
    .straightest({ vertex: 12 }, [1, 0, 0], 1e7);
  assert.equal(stop, 'limit');
  assert.ok(remaining > 9e6 && remaining < 1e7);
});

test('an unknown option is refused', () => {
  const mesh = karcher.meshFromObj(grid(4));
  const points = [6, 8, 16, 18].map((vertex) => ({ vertex }));
  const wrong = [
    [
      () => mesh.centerOfMass(points, [1, 0, 0, 0], { solvr: 'exact' }),
      /no option 'solvr'.*solver/,
    ],
    [() => mesh.curve({ kind: 'bspline', points, sample: 3 }), /no option 'sample'/],
    [() => mesh.circle(points[0], { radius: 1, arc: 3 }), /no option 'arc'/],
    [() => mesh.ellipse(points[0], { radius: 1 }), /no option 'radius'.*radii/],
    [() => mesh.isolines(points[0], { radius: 1, kind: 'exact' }), /no option 'kind'/],
    [() => mesh.isolines(points[0], { radius: 1, solver: 'graph', rings: 2 }), /take no solver/],
    [() => mesh.isolines(points[0], { radius: 1, type: 'exact', rings: 2 }), /take no rings/],
    [() => mesh.distance(points[0], { solver: 'graph', ring: 3 }), /no option 'ring'/],
  ];
  for (const [use, message] of wrong) assert.throws(use, { code: 'badArgument', message });
  for (const normalize of ['no', 1]) {
    assert.throws(() => mesh.centerOfMass(points, [1, 0, 0, 0], { normalize }), {
      code: 'badArgument',
      message: /normalize must be true or false/,
    });
  }
  return assert.rejects(mesh.prepare({ solvr: 'graph' }), { code: 'badArgument' });
});

test('a number out of range is refused with the range', () => {
  assert.throws(() => karcher.shape('sphere', 1e12), {
    code: 'badArgument',
    message: /from -2147483647 to 2147483647, not 1000000000000/,
  });
});

test('a disposed mesh cannot be used', () => {
  const mesh = karcher.meshFromObj(square);
  mesh.dispose();
  mesh.dispose();
  assert.equal(mesh.info.triangles, 2);
  const uses = [
    () => mesh.positions(),
    () => mesh.triangles(),
    () => mesh.surfacePoint(0, [1, 0, 0]),
    () => mesh.position({ vertex: 0 }),
    () => mesh.straightest({ vertex: 0 }, [1, 0, 0], 1),
  ];
  for (const use of uses) assert.throws(use, { code: 'disposed', message: /the mesh/ });
});

test('each load has a memory of its own', async () => {
  const other = await load();
  const before = karcher.allocatedBytes();
  const mesh = other.meshFromObj(grid(10));
  assert.equal(karcher.allocatedBytes(), before);
  mesh.dispose();
});
