/**
 * The median and the largest of the distances by which a curve's samples move, in a unit of length.
 */
export interface Shift {
  median: number;
  largest: number;
}

/** The largest median shift, in mean edges, that users do not see as a jump. */
export const unseenShift = 0.2;

/**
 * The distances between the samples of two curves at the same parameters, in a unit of length. The
 * arrays have x, y, z of each sample. Null if the numbers of samples differ or are 0.
 */
export function shiftBetween(from: Float64Array, to: Float64Array, unit: number): Shift | null {
  if (from.length !== to.length || from.length === 0) return null;
  const distances = new Float64Array(from.length / 3).map((_, i) =>
    Math.hypot(...[0, 1, 2].map((axis) => to[3 * i + axis]! - from[3 * i + axis]!)),
  );
  distances.sort();
  const middle = (distances.length - 1) / 2;
  const median = (distances[Math.floor(middle)]! + distances[Math.ceil(middle)]!) / 2;
  return { median: median / unit, largest: distances.at(-1)! / unit };
}
