// Random cuts of surfaces with and without rims, similar to those of files by `npm run study --
// cuts`.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import { long, seed } from '../web/part.mjs';
import { checkedFiles, checkedParts, surfaceOf } from './cut_checks.mjs';
import { grid, tube } from './meshes.mjs';
import { randomCut, rimVertices } from './random_cuts.mjs';

const karcher = await load();
const count = long ? 100 : 4;
const meshes = {
  sphere: karcher.shape('sphere', 1000),
  torus: karcher.shape('torus', 1000),
  knot: karcher.shape('knot', 1000),
  plane: karcher.meshFromObj(grid(8)),
  // A tube with needles and two rims.
  tube: karcher.meshFromObj(tube(60, 2)),
};

for (const [name, mesh] of Object.entries(meshes)) {
  test(`${count} random cuts of a ${name} fit, and so do the files of their parts`, async () => {
    const surface = surfaceOf(mesh);
    const rim = rimVertices(mesh);
    let parts = 0;
    for (let i = 0; i < count; i++) {
      const cut = mesh.cut(randomCut(mesh, rim, seed + i));
      parts += cut.length;
      const { faults } = checkedParts(cut, surface);
      faults.push(...(await checkedFiles(karcher, cut, surface)).faults);
      assert.deepEqual(faults, [], `KARCHER_SEED=${seed + i}`);
    }
    assert.ok(parts > 1.5 * count, `${parts} parts`);
  });
}

test('parts that do not fit are detected', async () => {
  const [mesh, surface] = [meshes.sphere, surfaceOf(meshes.sphere)];
  const parts = mesh.cut(randomCut(mesh, [], 3));
  const told = (spoil) => {
    const spoilt = parts.map((part) => ({ ...part, positions: part.positions.slice() }));
    spoil(spoilt);
    return checkedParts(spoilt, surface).faults.join('; ');
  };
  assert.equal(
    told(() => {}),
    '',
  );
  const moved = told(([part]) => {
    const [[tail]] = openRim(part);
    part.positions[3 * tail] += 1e-15 + 1e-15 * Math.abs(part.positions[3 * tail]);
  });
  assert.match(moved, /^borders that do not fit/);
  const turned = told((spoilt) => {
    const [a, b, ...others] = spoilt[0].triangles;
    spoilt[0] = { ...spoilt[0], triangles: Int32Array.from([b, a, ...others]) };
  });
  assert.match(turned, /is not oriented/);
  const missing = told((spoilt) => {
    spoilt[0] = { ...spoilt[0], triangles: spoilt[0].triangles.slice(3) };
  });
  assert.match(missing, /areas are off/);
});

/** The boundary edges, as vertices. */
function openRim({ triangles }) {
  const next = (i) => triangles[i - (i % 3) + ((i + 1) % 3)];
  const edges = new Set(Array.from(triangles, (tail, i) => `${tail} ${next(i)}`));
  return [...edges]
    .map((edge) => edge.split(' ').map(Number))
    .filter(([tail, head]) => !edges.has(`${head} ${tail}`));
}
