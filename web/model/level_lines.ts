/** Lines of equal value in the form that the page draws. */
import { levelLines as crossingsOf, type LevelCrossing } from 'karcher/statistics';

/** A step that is 1, 2 or 5 times a power of ten. About `count` such steps reach `most`. */
export function roundStep(most: number, count: number): number {
  const power = 10 ** Math.floor(Math.log10(most / count));
  const factor = [1, 2, 5, 10].find((one) => one * power >= (most / count) * 0.999) ?? 10;
  // A division by a whole number rounds only once: 0.2 is 2 / 10.
  return power < 1 ? factor / Math.round(1 / power) : factor * power;
}

/**
 * The lines of each level, as x, y, z of their points (see `levelLines` of `karcher/statistics`).
 */
export function levelLines(
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
  valueAt: (corner: number) => number,
  levels: readonly number[],
): Float32Array[][] {
  const placeOf = ({ face, bary }: LevelCrossing) =>
    [0, 1, 2].map((axis) => {
      const at = (k: number) => positions[3 * triangles[3 * face + k]! + axis]!;
      return bary[0] * at(0) + bary[1] * at(1) + bary[2] * at(2);
    });
  return crossingsOf(triangles, valueAt, levels).map((lines) =>
    lines.map((line) => Float32Array.from(line.flatMap(placeOf))),
  );
}
