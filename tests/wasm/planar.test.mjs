// Cells and booleans on a plane against a planar library, which does not know triangles.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from 'karcher';
import clipping from 'polygon-clipping';
import { long, randoms, seed } from '../web/part.mjs';
import { drawingOn, grid } from './meshes.mjs';

const karcher = await load();
const cells = 10;
const mesh = karcher.meshFromObj(grid(cells));
/** The tolerance of areas, relative to the plane's extent squared. */
const tolerance = 1e-9 * cells ** 2;
const outlineOf = drawingOn(mesh, cells);
const drawings = long ? 10_000 : 200;

const areaOf = (polygons) =>
  polygons.flat().reduce((sum, ring) => {
    // Holes have the opposite orientation.
    const pieces = ring.slice(1).map(([x, y], i) => ring[i][0] * y - x * ring[i][1]);
    return sum + pieces.reduce((total, piece) => total + piece, 0) / 2;
  }, 0);

/**
 * Corners within a window of less than half of the plane. Some are vertices of the grid or lie on
 * its lines, so that outlines share points and stretches, and follow edges. Every third outline
 * crosses itself.
 */
function corners(next, kind) {
  const [left, low] = [4 * next(), 4 * next()];
  const count = 3 + Math.floor(6 * next());
  const angles = Array.from({ length: count }, () => 2 * Math.PI * next());
  if (kind % 3 > 0) angles.sort((a, b) => a - b);
  const all = angles.map((angle) => {
    const radius = 0.5 + 2.4 * next();
    const place = [left + 3 + radius * Math.cos(angle), low + 3 + radius * Math.sin(angle)];
    return place.map((value) => (next() < 0.3 ? Math.round(value) : value));
  });
  return all.filter((corner, i) => `${corner}` !== `${all[(i + 1) % count]}`);
}

test(`${drawings} drawings have the areas of a planar library`, () => {
  const random = randoms(seed);
  const next = () => random.next().value;
  const of = {
    union: 'union',
    intersection: 'intersection',
    difference: 'difference',
    exclusion: 'xor',
  };
  let worst = 0;
  let compared = 0;
  for (let drawing = 0; drawing < drawings; drawing++) {
    const rings = [0, 1, 2].slice(0, 2 + (drawing % 2)).map((k) => corners(next, drawing + k));
    if (rings.some((ring) => ring.length < 3)) continue;
    const outlines = rings.map(outlineOf);
    for (const [combine, name] of Object.entries(of)) {
      const [region] = mesh.regions(outlines, { combine, rule: 'nonZero' });
      const wanted = areaOf(clipping[name](...rings.map((ring) => [[ring]][0])));
      const off = Math.abs(region.area - wanted);
      worst = Math.max(worst, off);
      const told = () => `seed ${seed}, drawing ${drawing}: ${combine} of ${JSON.stringify(rings)}`;
      assert.ok(off < tolerance, `${region.area}, not ${wanted}: ${told()}`);
      compared++;
    }
  }
  assert.ok(compared > 3 * drawings);
  console.log(`${compared} areas, at most ${worst} apart; KARCHER_SEED=${seed}`);
});
