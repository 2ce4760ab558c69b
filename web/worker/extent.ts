/** The extents of many places around a point, in the tangent plane there. */
import type { Mesh, SurfacePoint } from 'karcher';
import type { Vector } from '../model/figure';
import { dot } from '../model/vectors';

/** A place, with a radius around it. */
export interface Extent {
  place: SurfacePoint;
  radius: number;
}

/** The sides of a rectangle, in coordinates along two axes. */
export interface Box {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

type Coordinates = readonly [number, number];

/**
 * The rectangle along two perpendicular axes around the log vectors of places. A path to each place
 * would take long on a large mesh. Instead, one log map of the vertices shows which places reach
 * farthest, and only these places get a path.
 */
export function boxAround(
  mesh: Mesh,
  at: SurfacePoint,
  around: readonly Extent[],
  axes: readonly [Vector, Vector],
): Box {
  const places = around.map(({ place }) => place);
  const toBox = (vectors: Float64Array) => (_: unknown, i: number) => {
    const vector = [...vectors.subarray(3 * i, 3 * i + 3)] as Vector;
    return [dot(vector, axes[0]), dot(vector, axes[1])] as const;
  };
  const sidesOf = (coordinates: readonly Coordinates[], extents: readonly Extent[]) =>
    (
      [
        [0, -1],
        [0, 1],
        [1, -1],
        [1, 1],
      ] as const
    ).map(([axis, way]) => {
      const reach = coordinates.map((own, i) => way * own[axis] + extents[i]!.radius);
      const which = reach.reduce((best, one, i) => (one > reach[best]! ? i : best), 0);
      return { which, value: way * reach[which]! };
    });
  const nearly = nearlyLogs(mesh, at, places);
  const outermost = nearly
    ? [...new Set(sidesOf(places.map(toBox(nearly)), around).map(({ which }) => which))]
    : [...around.keys()];
  const extents = outermost.map((i) => around[i]!);
  const { vectors } = mesh.logMap(
    at,
    extents.map(({ place }) => place),
  );
  const [left, right, bottom, top] = sidesOf(extents.map(toBox(vectors)), extents).map(
    ({ value }) => value,
  ) as [number, number, number, number];
  return { left, right, bottom, top };
}

/**
 * Approximate log vectors of places: weighted means of the log vectors at the corners of their
 * faces. Null if there are at most four places, if all lie at `at`, if the vertices near them are
 * not more than the places, or if a log vector is missing.
 */
function nearlyLogs(
  mesh: Mesh,
  at: SurfacePoint,
  places: readonly SurfacePoint[],
): Float64Array | null {
  const positions = mesh.positionsOf([at, ...places]);
  let far = 0;
  for (let i = 3; i < positions.length; i += 3) {
    far = Math.max(far, Math.hypot(...[0, 1, 2].map((k) => positions[i + k]! - positions[k]!)));
  }
  // Each of the four sides needs a path to one place anyway.
  if (far === 0 || places.length <= 4) return null;
  const triangles = mesh.triangles();
  // On a sphere, no shortest path to a place is longer than this; on other surfaces a path may be.
  const first = (Math.PI / 2) * far;
  for (const radius of [first, 2 * first, Infinity]) {
    const { vectors } = mesh.logMap(at, { radius });
    const logs = Float64Array.from({ length: 3 * places.length }, (_, i) => {
      const { face, bary } = places[Math.floor(i / 3)]!;
      return bary.reduce((sum, weight, k) => {
        const corner = triangles[3 * face + k]!;
        return sum + weight * vectors[3 * corner + (i % 3)]!;
      }, 0);
    });
    if (logs.some(Number.isNaN)) continue;
    let reached = 0;
    for (let i = 0; i < vectors.length; i += 3) if (!Number.isNaN(vectors[i]!)) reached++;
    return reached > places.length ? logs : null;
  }
  return null;
}
