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
  const start = [positions[0]!, positions[1]!, positions[2]!];
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
    const [a, b, c] = corners.map((v) => start.map((from, k) => positions[3 * v + k]! - from));
    const across = cross(
      b!.map((value, k) => value - a![k]!),
      c!.map((value, k) => value - a![k]!),
    );
    area += Math.hypot(...across) / 2;
    volume += across.reduce((sum, value, k) => sum + value * a![k]!, 0) / 6;
  }
  along.sort();
  against.sort();
  const oriented = along.every((edge, i) => i === 0 || edge !== along[i - 1]);
  const closed = along.every((edge, i) => edge === against[i]);
  return { area, oriented, closed, volume: closed && oriented ? volume : null };
}

const cross = (u: readonly number[], v: readonly number[]) =>
  [0, 1, 2].map((k) => {
    const [l, m] = [(k + 1) % 3, (k + 2) % 3];
    return u[l]! * v[m]! - u[m]! * v[l]!;
  });
