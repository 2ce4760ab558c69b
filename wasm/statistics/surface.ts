import { KarcherError } from '../errors.js';
import type { PointLike, RepairKind, SurfacePoint } from '../types.js';
import type { AnyMesh } from './energy.js';

/**
 * The caller's triangles as faces of the surface. The surface has no face twice: a triangle that
 * repeats an earlier one has its first vertex at all three corners.
 */
export async function facesOf(mesh: AnyMesh, positions: Float64Array): Promise<Int32Array> {
  const triangles = await mesh.triangles();
  if (!isRepaired(mesh, 'duplicate')) return triangles;
  const places = placesOf(positions);
  const alike = new Map<string, SurfacePoint[]>();
  for (let face = 0; 3 * face < triangles.length; face++) {
    const corners = [0, 1, 2].map((k) => places[triangles[3 * face + k]!]!) as Three;
    if (!differ(corners)) continue;
    const sorted = [...corners].sort((a, b) => a - b);
    // The points of all triangles between the same places lie at one place, too.
    const [x, y, z] = corners.map((place) => [0.2, 0.35, 0.45][sorted.indexOf(place)]!) as Three;
    const point: SurfacePoint = { face, bary: [x, y, z] };
    const known = alike.get(sorted.join());
    if (known) known.push(point);
    else alike.set(sorted.join(), [point]);
  }
  const groups = [...alike.values()].filter((points) => points.length > 1);
  const ids = await idsOf(mesh, groups.flat());
  let next = 0;
  for (const group of groups) {
    const known = new Set<number>();
    for (const { face } of group) {
      const id = ids[next++]!;
      // The two sides of a double surface are different points at one place.
      if (known.has(id)) triangles.fill(triangles[3 * face]!, 3 * face, 3 * face + 3);
      known.add(id);
    }
  }
  return triangles;
}

type Three = [number, number, number];

const differ = ([a, b, c]: Three) => a !== b && b !== c && c !== a;

const isRepaired = (mesh: AnyMesh, wanted: RepairKind) =>
  mesh.info.repairs.some(({ kind }) => kind === wanted);

/** The first vertex at the place of each vertex. */
function placesOf(positions: Float64Array): Int32Array {
  const known = new Map<string, number>();
  return Int32Array.from({ length: positions.length / 3 }, (_, v) => {
    const name = positions.subarray(3 * v, 3 * v + 3).join();
    if (!known.has(name)) known.set(name, v);
    return known.get(name)!;
  });
}

/**
 * A number for each point of a face. Of several points at one place, those with the same number are
 * one point of the surface. The number is -1 for points that the surface does not have. It is that
 * of the finer mesh's face that has the point.
 */
async function idsOf(mesh: AnyMesh, points: readonly PointLike[]): Promise<number[]> {
  try {
    return (await mesh.carried(points, 1)).map(({ face }) => face);
  } catch (error) {
    if (!(error instanceof KarcherError) || error.code !== 'badIndex') throw error;
    // One of the points lies in a face that was left out.
    if (points.length === 1) return [-1];
    const middle = Math.floor(points.length / 2);
    const low = await idsOf(mesh, points.slice(0, middle));
    return low.concat(await idsOf(mesh, points.slice(middle)));
  }
}
