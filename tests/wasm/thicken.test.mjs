// Shells around parts of surfaces: closed, with the known volumes for a plane, a sphere and a
// torus, and no thicker than fits.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { load } from 'karcher';
import { solidOf, thickened } from 'karcher/checkup';
import { meshFile } from 'karcher/formats';
import { printed, temporaryFolder } from './run_cli.mjs';

const engine = await load();
const folder = temporaryFolder();
after(() => folder.remove());

const near = (value, wanted, part, what) =>
  assert.ok(
    Math.abs(value - wanted) <= part * Math.abs(wanted),
    `${what}: ${value}, not ${wanted}`,
  );

/** Triangles of a surface with two parameters from 0 to 1; a closed parameter ends at its start. */
function grid(across, along, place, [closedAcross, closedAlong] = [false, false]) {
  const [columns, rows] = [across + !closedAcross, along + !closedAlong];
  const positions = [];
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) positions.push(...place(i / across, j / along));
  }
  const at = (i, j) => (j % rows) * columns + (i % columns);
  const triangles = [];
  for (let j = 0; j < along; j++) {
    for (let i = 0; i < across; i++) {
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      triangles.push(a, b, c, a, c, d);
    }
  }
  return { positions, triangles };
}

/** The triangles, with those turned over whose first corner is at one of the places. */
function withTurned({ positions, triangles }, isTurned) {
  const result = Int32Array.from(triangles);
  for (let i = 0; i < result.length; i += 3) {
    const first = 3 * result[i];
    if (isTurned(positions.slice(first, first + 3))) result.subarray(i, i + 3).reverse();
  }
  return result;
}

/** A closed and oriented shell with positive volume. */
function shellOf(part, thickness) {
  const shell = thickened(part, thickness);
  const { closed, oriented, volume } = solidOf(shell);
  assert.ok(closed && oriented, 'closed and oriented');
  assert.ok(volume > 0, `${volume}`);
  return { ...shell, volume };
}

test('a rectangle becomes a plate, outwards and inwards', () => {
  const flat = grid(7, 5, (u, v) => [3 * u, 2 * v, 1]);
  for (const thickness of [0.25, -0.25]) {
    const { volume, most, positions } = shellOf(flat, thickness);
    near(volume, 1.5, 1e-12, 'its volume');
    assert.equal(most, null);
    assert.ok(positions.every((value, i) => i % 3 < 2 || value === 1 || value === 1 + thickness));
  }
});

test('a sphere becomes a hollow ball; inwards no thicker than its radius', () => {
  const sphere = engine.shape('sphere', 20_000);
  const part = { positions: sphere.positions(), triangles: sphere.triangles() };
  const wanted = (from, to) => (4 / 3) * Math.PI * (to ** 3 - from ** 3);
  near(shellOf(part, 0.2).volume, wanted(1, 1.2), 1e-3, 'outwards');
  near(shellOf(part, -0.2).volume, wanted(0.8, 1), 1e-3, 'inwards');
  assert.equal(thickened(part, 5).most, null);
  near(thickened(part, -1.5).most, 1, 0.02, 'what it allows');
});

test('a torus becomes a pipe with walls; inwards no thicker than the pipe, outwards than its hole', () => {
  const [large, small] = [2, 0.5];
  const torus = grid(
    160,
    60,
    (u, v) => {
      const [a, b] = [2 * Math.PI * u, 2 * Math.PI * v];
      const out = large + small * Math.cos(b);
      return [out * Math.cos(a), out * Math.sin(a), small * Math.sin(b)];
    },
    [true, true],
  );
  const wanted = (from, to) => 2 * Math.PI ** 2 * large * (to ** 2 - from ** 2);
  near(shellOf(torus, 0.3).volume, wanted(0.5, 0.8), 5e-3, 'outwards');
  near(shellOf(torus, -0.3).volume, wanted(0.2, 0.5), 5e-3, 'inwards');
  near(thickened(torus, -0.7).most, small, 0.02, 'inwards');
  near(thickened(torus, 2).most, large - small, 0.02, 'outwards, through the hole');
});

test('two opposite plates allow half of their gap', () => {
  const [lower, upper] = [grid(4, 4, (u, v) => [u, v, 0]), grid(4, 4, (u, v) => [v, u, 0.3])];
  const count = lower.positions.length / 3;
  const both = {
    positions: [...lower.positions, ...upper.positions],
    triangles: [...lower.triangles, ...upper.triangles.map((vertex) => vertex + count)],
  };
  near(thickened(both, 0.2).most, 0.15, 1e-12, 'what they allow');
  assert.equal(thickened(both, 0.14).most, null);
  assert.throws(() => thickened(both, 0), /must not be 0/);
});

/** Two wavy sheets that face each other, with a different gap everywhere. */
function sheets(cells) {
  const height = (u, v) => 0.3 * Math.sin(5 * u) * Math.cos(7 * v);
  const lower = grid(cells, cells, (u, v) => [3 * u, 3 * v, height(u, v)]);
  const upper = grid(cells, cells, (u, v) => [3 * v, 3 * u, 2 + height(v, u + 0.3)]);
  const first = lower.positions.length / 3;
  return {
    positions: [...lower.positions, ...upper.positions],
    triangles: [...lower.triangles, ...upper.triangles.map((vertex) => first + vertex)],
  };
}

const ball = (cells) =>
  grid(
    2 * cells,
    cells,
    (u, v) => {
      const [round, down] = [2 * Math.PI * u, Math.PI * (0.05 + 0.9 * v)];
      return [Math.sin(down) * Math.cos(round), -Math.sin(down) * Math.sin(round), Math.cos(down)];
    },
    [true, false],
  );

test('the largest thickness is that of all pairs of vertices', () => {
  let bounded = 0;
  for (const part of [sheets(16), ball(12)]) {
    for (const thickness of [0.1, 0.9, 40, 1e9, -0.1, -0.9, -40, -1e9]) {
      const { positions, most } = thickened(part, thickness);
      const count = part.positions.length;
      const unit = thickened(part, Math.sign(thickness)).positions;
      const placeOf = (i) => [0, 1, 2].map((k) => positions[i + k]);
      let least = Math.abs(thickness);
      for (let i = 0; i < count; i += 3) {
        const here = placeOf(i);
        const normal = here.map((value, k) => unit[count + i + k] - value);
        for (let j = 0; j < count; j += 3) {
          const to = placeOf(j).map((value, k) => value - here[k]);
          const ahead = to.reduce((sum, value, k) => sum + value * normal[k], 0);
          // Rounding of the unit normals must not make neighbors in a plane lie ahead.
          if (ahead > 1e-12) {
            least = Math.min(
              least,
              to.reduce((sum, value) => sum + value * value, 0) / (2 * ahead),
            );
          }
        }
      }
      const found = most ?? Math.abs(thickness);
      assert.ok(found <= least * (1 + 1e-9), `${thickness}: ${found}, not ${least}`);
      if (most !== null && Math.abs(found - least) <= 1e-9 * least) bounded++;
    }
  }
  assert.ok(bounded >= 4, `${bounded}`);
});

test('a thickness that is large beside the part does not compare all pairs of vertices', () => {
  for (const shape of [sheets, ball]) {
    for (const thickness of [1000, -1000]) {
      const [few, many] = [20, 80].map((cells) => {
        const { positions, triangles } = shape(cells);
        let reads = 0;
        const get = (target, name) => {
          reads++;
          return target[name];
        };
        thickened({ positions: new Proxy(positions, { get }), triangles }, thickness);
        return reads / positions.length;
      });
      assert.ok(many < 3 * few, `${shape.name}, ${thickness}: ${few} and ${many} reads a number`);
    }
  }
});

test('faces that do not belong to a part have no say in its shell', () => {
  const moved = (part, whole) => {
    const faces = Array.from({ length: part.triangles.length / 3 }, (_, face) => face);
    return thickened({ ...part, faces }, 0.1, whole).positions.slice(part.positions.length);
  };
  const joined = (one, other) => ({
    positions: [...one.positions, ...other.positions],
    triangles: [
      ...one.triangles,
      ...other.triangles.map((vertex) => vertex + one.positions.length / 3),
    ],
  });
  const same = (values, wanted, what) =>
    values.forEach((value, i) => {
      assert.ok(Math.abs(value - wanted[i]) < 1e-12, `${what}: ${values}, not ${wanted}`);
    });
  const solid = {
    positions: [0, 0, 0, 1, 0.1, 0.2, 0.3, 1, 0.1, 0.2, 0.3, 1.1],
    triangles: [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3],
  };
  const cube = (x, y) => ({
    positions: [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [x + (i & 1), y + ((i >> 1) & 1), i >> 2]),
    triangles: [
      ...[0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4],
      ...[2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5],
    ],
  });
  // Each face of the tetrahedron once more, turned over, with any of its corners first.
  const tip = moved(solid, solid).slice(0, 3);
  assert.ok(Math.max(...tip) < -0.05, `${tip}`);
  for (let k = 0; k < 3; k++) {
    const copies = solid.triangles.map((_, i, all) => all[i - (i % 3) + ((k + 2 * i) % 3)]);
    const whole = { ...solid, triangles: [...solid.triangles, ...copies] };
    same(moved(solid, whole), moved(solid, solid), `copies from corner ${k}`);
  }
  // Two cubes that touch along an edge, or at a corner.
  const own = moved(cube(0, 0), cube(0, 0));
  same(
    own.slice(9, 12),
    [1, 1, 0].map((x, k) => x + (k < 2 ? 1 : -1) * 0.1 * Math.sqrt(1 / 3)),
    '',
  );
  same(moved(cube(0, 0), joined(cube(0, 0), cube(1, 1))), own, 'along an edge');
  const above = cube(1, 1);
  above.positions = above.positions.map((x, i) => x + (i % 3 === 2 ? 1 : 0));
  same(moved(cube(0, 0), joined(cube(0, 0), above)), own, 'at a corner');
});

test('the command line cuts and thickens, and says what is allowed', async () => {
  const sphere = engine.shape('sphere', 2000);
  const surface = { positions: sphere.positions(), triangles: sphere.triangles() };
  // Half of the faces turned over, as in files of several programs: the import turns them back.
  const turned = { ...surface, triangles: withTurned(surface, ([, , z]) => z < 0) };
  const points = [0, 1, 2, 3].map((i) => {
    const angle = (i * Math.PI) / 2;
    return sphere.nearestPoint([1, Math.cos(angle), Math.sin(angle)]).position;
  });
  const run = async (mesh, thickness) => {
    const file = folder.write('ball.ply', meshFile(mesh, 'ply'));
    const own = engine.meshFromArrays(mesh.positions, mesh.triangles);
    const places = points.map((place) => own.nearestPoint(place).point);
    const record = { kind: 'catmullrom', closed: true, points: places };
    const curve = folder.write('ring.json', JSON.stringify(record));
    const args = ['cut', file, '--curve', curve, '--thickness', `${thickness}`];
    return (await printed(...args)).parts;
  };
  for (const mesh of [surface, turned]) {
    const thin = await run(mesh, 0.1);
    assert.equal(thin.length, 2);
    for (const { closed, volume, allowed } of thin) {
      assert.ok(closed && volume > 0);
      assert.equal(allowed, undefined);
    }
    near(thin[0].volume + thin[1].volume, (4 / 3) * Math.PI * (1.1 ** 3 - 1), 0.02, 'both shells');
    const [large] = await run(mesh, -3);
    near(large.allowed, 1, 0.05, 'what the larger one allows');
  }
});
