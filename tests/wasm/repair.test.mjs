import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { badFiles, grid } from './meshes.mjs';
import { loadForTest } from './workers.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const countsOf = ({ info }) => Object.fromEntries(info.repairs.map((r) => [r.kind, r.count]));

/** The positions and triangles of a torus, as plain arrays. */
function torus() {
  const mesh = karcher.shape('torus', 2000);
  const arrays = {
    positions: Array.from(mesh.positions()),
    triangles: Array.from(mesh.triangles()),
  };
  mesh.dispose();
  return arrays;
}

/**
 * Each repair with its defect: the function damages the arrays and returns the number of defects.
 */
const defects = {
  repeatedCorner({ triangles }) {
    triangles.push(3, 4, 3, 5, 5, 5);
    return 2;
  },
  duplicate({ triangles }) {
    triangles.push(...triangles.slice(30, 33), ...triangles.slice(60, 63).reverse());
    return 2;
  },
  turnedOver({ triangles }) {
    for (const face of [7, 100, 500]) {
      const [a, b] = triangles.slice(3 * face, 3 * face + 2);
      triangles.splice(3 * face, 2, b, a);
    }
    return 3;
  },
  noArea({ positions, triangles }) {
    // Face 40's first edge gets a vertex on its other side, and a degenerate triangle fills the
    // gap.
    const [a, b] = triangles.slice(120, 122);
    const middle = positions.length / 3;
    for (let k = 0; k < 3; k++) positions.push((positions[3 * a + k] + positions[3 * b + k]) / 2);
    const other = triangles.findIndex(
      (v, i) => v === b && triangles[i - (i % 3) + ((i + 1) % 3)] === a,
    );
    const face = other - (other % 3);
    const apex = triangles[face + ((other + 2) % 3)];
    triangles.splice(face, 3, b, middle, apex);
    triangles.push(middle, a, apex, b, a, middle);
    return 1;
  },
  branching({ positions, triangles }) {
    positions.push(9, 9, 9);
    triangles.push(triangles[0], triangles[1], positions.length / 3 - 1);
    return 1;
  },
  bowTie({ positions, triangles }) {
    const v = positions.length / 3;
    positions.push(7, 7, 7, 8, 7, 7);
    triangles.push(triangles[0], v, v + 1);
    return 1;
  },
  dropped({ positions }) {
    positions.push(Number.NaN, 0, Number.POSITIVE_INFINITY);
    return 1;
  },
};

for (const [kind, damage] of Object.entries(defects)) {
  test(`${kind}: repaired and counted, refused on request, and points keep their place`, () => {
    const arrays = torus();
    const count = damage(arrays);
    const { positions, triangles } = arrays;
    const mesh = karcher.meshFromArrays(positions, triangles);
    assert.deepEqual(countsOf(mesh), { [kind]: count });
    if (kind !== 'dropped' && kind !== 'duplicate') {
      assert.throws(() => karcher.meshFromArrays(positions, triangles, { repair: 'none' }), {
        name: 'KarcherError',
      });
    }
    // The caller's faces and vertices keep their own indices.
    assert.deepEqual(Array.from(mesh.triangles()), triangles);
    assert.deepEqual(Array.from(mesh.positions()), positions);
    for (let face = 0; face < triangles.length / 3; face++) {
      const bary = [0.2, 0.5, 0.3];
      const place = [0, 1, 2].map((k) =>
        bary.reduce((sum, b, i) => sum + b * positions[3 * triangles[3 * face + i] + k], 0),
      );
      const near = (found) => found.every((x, k) => Math.abs(x - place[k]) < 1e-13);
      assert.ok(near(mesh.position({ face, bary })), `face ${face}`);
      assert.ok(near(mesh.position(mesh.surfacePoint(face, bary))), `face ${face}`);
    }
    // Results use the caller's indices, too.
    const { face } = mesh.surfacePoint(0, [1, 0, 0]);
    const path = mesh.shortestPath({ face, bary: [0.2, 0.2, 0.6] }, { vertex: 900 });
    for (const [i, point] of path.points().entries()) {
      const place = mesh.position(point);
      const drawn = Array.from(path.polyline({ bits: 64 }).slice(3 * i, 3 * i + 3));
      assert.ok(place.every((x, k) => Math.abs(x - drawn[k]) < 1e-12));
    }
    mesh.dispose();
  });
}

test('a curve over a reversed or cut face equals the one on the sound mesh', () => {
  const arrays = torus();
  const sound = karcher.meshFromArrays(arrays.positions, arrays.triangles);
  const turned = { ...arrays, triangles: [...arrays.triangles] };
  defects.turnedOver(turned);
  const mended = karcher.meshFromArrays(turned.positions, turned.triangles);
  const [[before], [after]] = [sound, mended].map((mesh) => {
    const points = [20, 35, 60, 80].map((vertex) => ({ vertex }));
    return [mesh.curve({ kind: 'bspline', points, samples: 64 })];
  });
  const polyline = before.polyline({ bits: 64 });
  for (const [i, x] of after.polyline({ bits: 64 }).entries()) {
    assert.ok(Math.abs(x - polyline[i]) < 1e-9);
  }
  // Samples have the indices and corners of their mesh.
  const { face, bary, position, count } = after.samples();
  for (let i = 0; i < count; i++) {
    const place = mended.position({
      face: face[i],
      bary: Array.from(bary.slice(3 * i, 3 * i + 3)),
    });
    assert.ok(place.every((x, k) => Math.abs(x - position[3 * i + k]) < 1e-12));
  }
});

test('files with comments, repeated corners and unused indices are opened', () => {
  const mesh = karcher.meshFromObj(
    'v 0 0 0\nv 1 0 0 # right\nv nan nan nan\nv 1 1 0\nv 0 1 0\nf 1 2 4 # half\nf 1 4 4 5\nf 1 1 2\n',
  );
  assert.deepEqual(countsOf(mesh), { repeatedCorner: 2, dropped: 1 });
  assert.equal(mesh.info.triangles, 2);
  assert.deepEqual(mesh.position({ face: 1, bary: [0, 0, 1] }), [0, 1, 0]);
});

test('each file without a mesh is opened with a report, or refused as before', () => {
  for (const { what, text, code } of badFiles) {
    if (code.startsWith('nonManifold')) {
      assert.ok(karcher.meshFromObj(text).info.repairs.length > 0, what);
    } else {
      assert.throws(() => karcher.meshFromObj(text), { code }, what);
    }
  }
});

test('boundaries that lie near each other are welded within a given tolerance', () => {
  const apart = (gap) =>
    `v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 0 ${1 + gap} 0\nv ${1 + gap} 0 0\nv 1 1 0\nf 4 5 6\n`;
  const partsOf = (gap, options) => karcher.meshFromObj(apart(gap), options).info.components;
  assert.equal(partsOf(1e-7), 1);
  assert.equal(partsOf(1e-3), 2);
  assert.equal(partsOf(1e-3, { weld: 2e-3 }), 1);
  assert.equal(partsOf(1e-7, { weld: 0 }), 2);
  assert.equal(partsOf(1e-7, { repair: 'none' }), 2);
  assert.equal(partsOf(0, { repair: 'none' }), 1);
});

test('wrong options are refused', () => {
  const wrong = [
    [{ repair: 'all' }, /repair must be one of safe, none/],
    [{ weld: -1 }, /at least 0/],
    [{ weld: '1' }, /must be a number/],
    [{ weld: 1, repair: 'none' }, /no use/],
    [{ welds: 1 }, /no option 'welds'/],
  ];
  for (const [options, message] of wrong) {
    assert.throws(() => karcher.meshFromObj(grid(2), options), { code: 'badArgument', message });
  }
});

test('a one-sided surface is refused with the reason', () => {
  const strip = [0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 0, 4, 0, 1];
  assert.throws(
    () => karcher.meshFromArrays([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1], strip),
    {
      code: 'notOrientable',
      message: /one side only/,
    },
  );
});

test('the properties of a mesh are read-only, in a worker too', async (t) => {
  const { positions, triangles } = torus();
  defects.duplicate({ positions, triangles });
  const remote = await loadForTest(t);
  for (const mesh of [
    karcher.meshFromArrays(positions, triangles),
    await remote.meshFromArrays(positions, triangles),
  ]) {
    const before = structuredClone(mesh.info);
    const { info } = mesh;
    assert.throws(() => info.repairs.push({}), TypeError);
    assert.throws(() => Object.assign(info.repairs[0], { count: 7 }), TypeError);
    assert.throws(() => Object.assign(info, { genus: 7 }), TypeError);
    assert.deepEqual(mesh.info, before);
  }
});
