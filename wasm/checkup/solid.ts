import { at, cross, dot, subtract } from '../vectors.js';

/** The suitability of triangles for printing. */
export interface Solid {
  /** The sum of the triangles' areas. */
  area: number;
  /** Whether no edge has the same direction in two triangles. */
  oriented: boolean;
  /** Whether each edge occurs equally often in both directions, so that no part is open. */
  closed: boolean;
  /**
   * The enclosed volume, which is negative if the triangles face inwards; null unless the triangles
   * are closed and oriented.
   */
  volume: number | null;
}

/**
 * Measures triangles as `mesh.cut` returns them: x, y, z for each vertex, and three vertices for
 * each triangle.
 */
export function solidOf({
  positions,
  triangles,
}: {
  positions: ArrayLike<number>;
  triangles: ArrayLike<number>;
}): Solid {
  const count = positions.length / 3;
  const along = new Float64Array(triangles.length);
  const against = new Float64Array(triangles.length);
  const start = at(positions, 0);
  let area = 0;
  let volume = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const corners = [triangles[i]!, triangles[i + 1]!, triangles[i + 2]!];
    corners.forEach((tail, k) => {
      const head = corners[(k + 1) % 3]!;
      along[i + k] = tail * count + head;
      against[i + k] = head * count + tail;
    });
    // Places are relative to the first vertex, so that a place far from the origin costs no digits.
    const [a, b, c] = corners.map((v) => subtract(at(positions, v), start));
    const across = cross(subtract(b!, a!), subtract(c!, a!));
    area += Math.hypot(...across) / 2;
    volume += dot(across, a!) / 6;
  }
  along.sort();
  against.sort();
  const oriented = along.every((edge, i) => i === 0 || edge !== along[i - 1]);
  const closed = along.every((edge, i) => edge === against[i]);
  return { area, oriented, closed, volume: closed && oriented ? volume : null };
}
