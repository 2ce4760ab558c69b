// The check-up of meshes whose lengths, angles and boundaries are known.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { load } from 'karcher';
import { checkUp } from 'karcher/checkup';
import { grid, tetrahedron, tube } from './meshes.mjs';
import { loadForTest } from './workers.mjs';

let karcher;
before(async () => {
  karcher = await load();
});

const near = (value, wanted) =>
  assert.ok(Math.abs(value - wanted) < 1e-9, `${value}, not ${wanted}`);

test('edges and angles of a tetrahedron with right angles', async () => {
  const found = await checkUp(karcher.meshFromObj(tetrahedron));
  near(found.shortestEdge, 1);
  near(found.longestEdge, Math.SQRT2);
  near(found.smallestAngle, 45);
  near(found.largestAngle, 90);
  const { needles, caps, boundary, nearBoundaries, expected } = found;
  assert.deepEqual([needles.length, caps.length, boundary.length, nearBoundaries], [0, 0, 0, null]);
  assert.deepEqual(expected, ['No defect disturbs curves.']);
  const sphere = await checkUp(karcher.shape('sphere', 2000));
  assert.deepEqual(sphere.expected, ['No defect disturbs curves.']);
});

test('needles and caps are found by their angles, and by their numbers', async () => {
  // A fan at vertex 0: angles of 1 degree (a needle) and 90 degrees, and a triangle with an angle
  // of 172 degrees.
  const at = (angle, radius) => [
    radius * Math.cos((angle * Math.PI) / 180),
    radius * Math.sin((angle * Math.PI) / 180),
    0,
  ];
  const positions = [0, 0, 0, ...at(0, 1), ...at(1, 1), ...at(91, 1), ...at(263, 1)];
  const triangles = [0, 1, 2, 0, 2, 3, 0, 3, 4];
  const found = await checkUp(karcher.meshFromArrays(positions, triangles));
  assert.deepEqual([Array.from(found.needles), Array.from(found.caps)], [[0], [2]]);
  near(found.smallestAngle, 1);
  near(found.largestAngle, 172);
  near(found.shortestEdge, 2 * Math.sin(Math.PI / 360));
  assert.ok(found.expected.some((sentence) => sentence.includes('thin triangles')));
});

test('the boundary edges are those of a single face', async () => {
  const sheet = await checkUp(karcher.meshFromObj(grid(5)));
  assert.equal(sheet.boundary.length / 6, 20);
  let length = 0;
  for (let at = 0; at < sheet.boundary.length; at += 6) {
    const [x, y, z, X, Y, Z] = sheet.boundary.subarray(at, at + 6);
    length += Math.hypot(X - x, Y - y, Z - z);
    assert.ok([x, y].some((value) => value === 0 || value === 5));
  }
  near(length, 20);
  const open = await checkUp(karcher.meshFromObj(tube(12, 3)));
  assert.equal(open.boundary.length / 6, 24);
  assert.match(open.expected.join(), /keep to the boundary/);
});

test('repeated and degenerate faces of a file are skipped', async () => {
  const twice = `${tetrahedron}f 1 1 2\n`;
  const mesh = karcher.meshFromObj(twice);
  const found = await checkUp(mesh);
  near(found.smallestAngle, 45);
  near(found.shortestEdge, 1);
});

test('the boundary is that of the remaining faces', async () => {
  // A square of two triangles.
  const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n';
  const edges = async (text) => {
    const { boundary } = await checkUp(karcher.meshFromObj(text));
    const places = Array.from({ length: boundary.length / 3 }, (_, i) =>
      boundary.slice(3 * i, 3 * i + 3).join(),
    );
    const ends = (i) => places.slice(2 * i, 2 * i + 2).sort();
    return Array.from({ length: places.length / 2 }, (_, i) => ends(i).join('-')).sort();
  };
  const sides = await edges(square);
  assert.equal(sides.length, 4);
  for (const twice of ['f 1 2 3', 'f 3 1 2\nf 2 3 1', 'f 1 3 2', 'f 1 3 2\nf 3 2 1\nf 1 3 4'])
    assert.deepEqual(await edges(`${square}${twice}\n`), sides, twice);
  // A fin has two boundary edges of its own, and one at its foot.
  const fin = await edges(`${square}v .5 .5 1\nf 1 3 5\n`);
  assert.deepEqual(
    fin.filter((edge) => !sides.includes(edge)),
    ['0,0,0-0.5,0.5,1', '0,0,0-1,1,0', '0.5,0.5,1-1,1,0'],
  );
  assert.equal(fin.length, 7);
  // Two triangles with the same corners form a closed surface if they are alone.
  const pillow = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n';
  assert.deepEqual(await edges(pillow), []);
  const beside = await edges(`${pillow}v 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\nf 4 5 6\n`);
  assert.equal(beside.length, 3);
  // A triangle without area beyond the boundary goes with its edges.
  const corner = 'v 0 0 0\nv 1 0 0\nv 0 -1 0\nf 1 2 3\n';
  assert.deepEqual(await edges(`${corner}v -1 0 0\nf 4 2 1\n`), await edges(corner));
});

test('a thin triangle that repeats another one counts once', async () => {
  const positions = [0, 0, 0, 10, 0, 0, 10, 0.1, 0, 5, -5, 0];
  const triangles = [0, 1, 2, 1, 0, 3, 0, 1, 2, 2, 0, 1];
  const mesh = karcher.meshFromArrays(positions, triangles);
  assert.deepEqual(Array.from((await checkUp(mesh)).needles), [0]);
});

test('coinciding boundaries: the number of their vertices, and the weld that joins them', async () => {
  const gap = 3.3e-4;
  const right = grid(4)
    .split('\n')
    .map((line) => {
      const [word, ...numbers] = line.split(' ').map((part, i) => (i === 0 ? part : Number(part)));
      if (word === 'v') return `v ${numbers[0] + 4 + gap} ${numbers[1]} 0`;
      return word === 'f' ? `f ${numbers.map((number) => number + 25).join(' ')}` : line;
    })
    .join('\n');
  const text = grid(4) + right;
  const apart = karcher.meshFromObj(text);
  assert.equal(apart.info.components, 2);
  const { nearBoundaries, expected } = await checkUp(apart);
  assert.equal(nearBoundaries.places.length / 3, 10);
  assert.ok(
    nearBoundaries.weld >= gap && nearBoundaries.weld < 1.2 * gap,
    `${nearBoundaries.weld}`,
  );
  assert.match(expected.join(' '), /not joined.*weld of 0\.00034/);
  const joined = karcher.meshFromObj(text, { weld: nearBoundaries.weld });
  assert.equal(joined.info.components, 1);
  assert.equal((await checkUp(joined)).nearBoundaries, null);
  // Farther apart the rows are two parts, each with its boundary.
  const far = karcher.meshFromObj(text.replaceAll(`.${'00033'}`, '.01'));
  assert.equal((await checkUp(far)).nearBoundaries, null);
});

/** Two rows of quads along x with a slit of `gap` between them; `inner` is the length of an edge across. */
function slit(gap, inner, count = 8) {
  const positions = [];
  const triangles = [];
  for (const [y, Y] of [
    [-inner, 0],
    [gap, gap + inner],
  ]) {
    const start = positions.length / 3;
    for (let i = 0; i <= count; i++) positions.push(i, y, 0, i, Y, 0);
    for (let i = start; i < start + 2 * count; i += 2)
      triangles.push(i, i + 2, i + 3, i, i + 3, i + 1);
  }
  return [positions, triangles];
}

test('a weld is offered only if the engine makes it', async () => {
  for (const [gap, inner] of [
    [3e-4, 6e-4],
    [3e-4, 8e-4],
    [3e-4, 1e-3],
    [3e-4, 0.5],
    [2e-4, 7e-4],
  ]) {
    const [positions, triangles] = slit(gap, inner);
    const { nearBoundaries: near } = await checkUp(karcher.meshFromArrays(positions, triangles));
    assert.equal(near !== null, inner > 3 * gap, `${gap} ${inner}`);
    if (!near) continue;
    const joined = karcher.meshFromArrays(positions, triangles, { weld: near.weld });
    assert.equal(joined.info.components, 1, `a weld of ${near.weld}`);
  }
});

test('seams that were not welded are coinciding boundaries', async () => {
  const [positions, triangles] = slit(0, 1);
  const apart = karcher.meshFromArrays(positions, triangles, { weld: 0 });
  assert.equal(apart.info.components, 2);
  const { nearBoundaries: near, boundary } = await checkUp(apart);
  assert.equal(near.places.length / 3, 18);
  assert.equal(boundary.length / 6, 2 * (2 * 8 + 2));
  assert.equal(
    karcher.meshFromArrays(positions, triangles, { weld: near.weld }).info.components,
    1,
  );
  // Welding leaves none.
  const whole = await checkUp(karcher.meshFromArrays(positions, triangles));
  assert.deepEqual([whole.nearBoundaries, whole.boundary.length / 6], [null, 2 * 8 + 4]);
  // Corners that only touch stay apart, and the check-up offers no weld.
  const touching = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, -1, 0];
  const mesh = karcher.meshFromArrays(touching, [0, 1, 2, 3, 4, 5]);
  assert.equal((await checkUp(mesh)).nearBoundaries, null);
});

test('only vertices that the import welded count as one', async () => {
  const edges = async (positions, triangles, options) => {
    const mesh = karcher.meshFromArrays(positions, triangles, options);
    const kinds = mesh.info.repairs.map(({ kind, count }) => `${count} ${kind}`);
    return [(await checkUp(mesh)).boundary.length / 6, kinds.join()];
  };
  // A square of two triangles apart, and the first of them again.
  const square = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0];
  const again = [...square, ...square.slice(0, 9)];
  const apart = [0, 1, 2, 3, 4, 5];
  for (const more of [
    [6, 7, 8],
    [7, 8, 6],
    [6, 7, 2],
    [0, 1, 2],
  ]) {
    const unused = 9 - new Set([...apart, ...more]).size;
    const found = await edges(again, [...apart, ...more], { weld: 0 });
    const dropped = unused > 0 ? `,${unused} dropped` : '';
    assert.deepEqual(found, [6, `2 keptApart,1 duplicate${dropped}`], `${more}`);
    const welded = await edges(again, [...apart, ...more]);
    assert.deepEqual(welded, [4, `2 welded,1 duplicate${dropped}`], `${more}`);
  }
  // The copy holds a further triangle, which thus joins the first one. The seam of the square stays.
  const held = [
    [...again, 2, 0, 0],
    [...apart, 6, 7, 8, 7, 9, 8],
  ];
  assert.deepEqual(await edges(...held, { weld: 0 }), [7, '2 keptApart,1 duplicate']);
  const { nearBoundaries: near } = await checkUp(karcher.meshFromArrays(...held, { weld: 0 }));
  assert.equal(near.places.length / 3, 4);
  assert.deepEqual(await edges(...held, { weld: near.weld }), [5, '2 welded,1 duplicate']);
  // Three triangles at one edge stay apart, beside a seam that is welded.
  const fan = [1, 2, 3].flatMap((k) => [5, 0, 0, 6, 0, 0, 5, Math.cos(2 * k), Math.sin(2 * k)]);
  assert.deepEqual(
    await edges(
      [...square, ...fan],
      Array.from({ length: 15 }, (_, i) => i),
    ),
    [4 + 9, '2 welded,4 keptApart'],
  );
});

test('corners that nearly touch are offered no weld, since it would join nothing', async () => {
  for (const gap of [1e-5, 1e-4]) {
    const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, -gap, -gap, 0, -1, 0, 0, 0, -1, 0];
    const triangles = [0, 1, 2, 3, 4, 5];
    const mesh = karcher.meshFromArrays(positions, triangles);
    assert.equal((await checkUp(mesh)).nearBoundaries, null, `a gap of ${gap}`);
    const welded = karcher.meshFromArrays(positions, triangles, { weld: 2 * gap });
    assert.equal(welded.info.components, 2);
  }
});

test('vertices at the ends of a contracted edge are one', async () => {
  // A hemisphere in rows, whose first row is a pole of 8 vertices at one place.
  const [columns, rows] = [8, 4];
  const dome = (shift) => {
    const [positions, triangles] = [[], []];
    for (let j = 0; j <= rows; j++) {
      for (let i = 0; i < columns; i++) {
        const [a, b] = [(2 * Math.PI * i) / columns, (Math.PI * j) / (2 * rows)];
        const out = j === 0 ? 0 : Math.sin(b);
        positions.push(shift + out * Math.cos(a), out * Math.sin(a), Math.cos(b));
      }
    }
    const at = (i, j) => j * columns + (i % columns);
    for (let j = 0; j < rows; j++) {
      for (let i = 0; i < columns; i++) {
        const [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        triangles.push(a, b, c, a, c, d);
      }
    }
    return [positions, triangles];
  };
  for (const shift of [0, 5]) {
    const mesh = karcher.meshFromArrays(...dome(shift));
    assert.deepEqual(
      mesh.info.repairs.map(({ kind }) => kind).filter((kind) => /contr|weld/.test(kind)),
      ['contracted'],
    );
    const { boundary, nearBoundaries } = await checkUp(mesh);
    assert.deepEqual([boundary.length / 6, nearBoundaries], [columns, null], `shift ${shift}`);
  }
  // A seam that was not welded stays a boundary beside a contracted edge.
  const [positions, triangles] = slit(0, 1);
  const [tips, faces] = dome(20);
  const count = positions.length / 3;
  const both = [...triangles, ...faces.map((vertex) => vertex + count)];
  const mesh = karcher.meshFromArrays([...positions, ...tips], both, { weld: 0 });
  const { boundary } = await checkUp(mesh);
  assert.equal(boundary.length / 6, 2 * (2 * 8 + 2) + columns);
});

test('a check of boundaries far from the origin ends', async () => {
  const check = async (positions, triangles) =>
    (await checkUp(karcher.meshFromArrays(positions, triangles))).nearBoundaries;
  for (const x of [2e12, 2 ** 50]) {
    const square = [x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0];
    assert.equal(await check(square, [0, 1, 2, 0, 2, 3]), null, `${x}`);
  }
  // The boundary of this sheet has an edge as long as the spacing of doubles there.
  const y = 5e6;
  const sheet = [0, y, 0, 10, y, 0, 10, y + 10, 0, 0, y + 10, 0, 10, y + 2 ** -30, 0];
  assert.equal(await check(sheet, [0, 1, 4, 0, 4, 2, 0, 2, 3]), null);
  // A slit there is found as well as at the origin.
  const [positions, triangles] = slit(2 ** -12, 1);
  const far = positions.map((value, i) => value + (i % 3 === 0 ? 1e9 : 0));
  assert.equal((await check(far, triangles)).places.length / 3, 18);
});

test('degenerate triangles are no caps: the engine flips them away', async () => {
  // Vertex 3 lies on the edge from 0 to 1, up to rounding.
  const positions = [0, 0, 0, 3, 1, 0, 1, 2, 0, 0.9, 0.3, 0, 2, -2, 0];
  const triangles = [0, 3, 1, 0, 1, 2, 0, 4, 3, 3, 4, 1];
  const mesh = karcher.meshFromArrays(positions, triangles);
  assert.ok(mesh.info.repairs.some(({ kind }) => kind === 'noArea'));
  const { caps, largestAngle } = await checkUp(mesh);
  assert.deepEqual([caps.length, largestAngle < 170], [0, true]);
});

test('many boundary vertices near each other are examined in slices', async () => {
  // Parallel strips are near each other compared with the diagonal, but too far apart for welding.
  const [positions, triangles] = [[], []];
  for (let k = 0; k < 4000; k++) {
    const [x, y] = [1e-6 * (k % 60), 1e-6 * Math.floor(k / 60)];
    const at = positions.length / 3;
    positions.push(x, y, 0, x + 5e-7, y, 0, x, y + 5e-7, 0);
    triangles.push(at, at + 1, at + 2);
  }
  const at = positions.length / 3;
  positions.push(0, 0, 9, 9, 0, 9, 0, 9, 9);
  triangles.push(at, at + 1, at + 2);
  const told = [];
  const mesh = karcher.meshFromArrays(positions, triangles);
  const found = await checkUp(mesh, { progress: (done) => told.push(done) });
  assert.ok(told.every((done, i) => i === 0 || done >= told[i - 1]));
  assert.equal(found.nearBoundaries, null);
  assert.equal(found.boundary.length / 6, 3 * 4001);
});

test('works in slices, with progress and cancellation, even in a worker', async (t) => {
  const mesh = karcher.shape('openSheet', 200_000);
  const told = [];
  await checkUp(mesh, { progress: (done, stage) => told.push([done, stage]) });
  assert.ok(told.length > 2);
  assert.ok(
    told.every(([done, stage], i) => stage === 'checking' && (i === 0 || done >= told[i - 1][0])),
  );
  const reason = new Error('enough');
  await assert.rejects(checkUp(mesh, { signal: AbortSignal.abort(reason) }), reason);
  mesh.dispose();
  await assert.rejects(checkUp(mesh), { code: 'disposed' });
  await assert.rejects(checkUp(mesh, { signal: 1 }), { code: 'badArgument' });

  const remote = await loadForTest(t);
  const found = await checkUp(await remote.meshFromObj(tetrahedron));
  near(found.largestAngle, 90);
});
