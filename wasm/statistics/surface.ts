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

/**
 * For each vertex of a face, the first of the vertices that are welded to it. Faces name this
 * vertex already, except those that a repair has cut. `faces` are those of `facesOf`.
 */
export async function firstOfWelded(
  mesh: AnyMesh,
  positions: Float64Array,
  faces: Int32Array,
): Promise<Int32Array> {
  const places = placesOf(positions);
  // Faces with two corners at one place are none of the surface.
  const used = new Uint8Array(places.length);
  for (let i = 0; i < faces.length; i += 3) {
    const [u, v, w] = [faces[i]!, faces[i + 1]!, faces[i + 2]!];
    if (differ([places[u]!, places[v]!, places[w]!])) used[u] = used[v] = used[w] = 1;
  }
  const count = new Int32Array(places.length);
  places.forEach((place, v) => {
    count[place]! += used[v]!;
  });
  const first = places.map((_, v) => v);
  const sharing = Array.from(first.filter((v) => used[v] === 1 && count[places[v]!]! > 1));
  const names = isRepaired(mesh, 'keptApart')
    ? await idsOf(
        mesh,
        sharing.map((vertex) => ({ vertex })),
      )
    : sharing.map((v) => places[v]!);
  const known = new Map<number, number>();
  sharing.forEach((v, i) => {
    const name = names[i]!;
    if (name < 0) return;
    if (!known.has(name)) known.set(name, v);
    first[v] = known.get(name)!;
  });
  return first;
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
 * A number for each point. Of several points at one place, those with the same number are one point
 * of the surface. The number is -1 for points that the surface does not have.
 *
 * The number is that of the finer mesh's face that has the point. A vertex has one such face of its
 * own, whichever faces of the caller meet there.
 */
async function idsOf(mesh: AnyMesh, points: readonly PointLike[]): Promise<number[]> {
  try {
    return (await mesh.carried(points, 1)).map(({ face }) => face);
  } catch (error) {
    if (!(error instanceof KarcherError) || error.code !== 'badIndex') throw error;
    // One of the points is a vertex that was dropped.
    if (points.length === 1) return [-1];
    const middle = Math.floor(points.length / 2);
    const low = await idsOf(mesh, points.slice(0, middle));
    return low.concat(await idsOf(mesh, points.slice(middle)));
  }
}
