/** Lines and bands at equal distances, which paint a pattern. */
import type { FillStyle } from '../model/drawing';

/** Bars: the painted part of each period of distance, between two fractions of the period. */
export interface Bars {
  period: number;
  from: number;
  to: number;
}

/**
 * The bars of a fill; null for a solid one. Lines are a quarter of their spacing wide; the first
 * band lies along the border.
 */
export function barsOf({ pattern, spacing }: Pick<FillStyle, 'pattern' | 'spacing'>): Bars | null {
  if (pattern === 'solid' || spacing === null) return null;
  return pattern === 'hatched'
    ? { period: spacing, from: 0.375, to: 0.625 }
    : { period: 2 * spacing, from: 0, to: 0.5 };
}

export const partPainted = ({ from, to }: Bars) => to - from;

/** x and y of a place on paper, and the distance at this place. */
export type Valued = readonly [number, number, number];

/**
 * The largest number of bars in a triangle. A triangle with more bars is painted whole: the bars
 * would be too fine to see.
 */
const mostBars = 64;

/**
 * The painted parts of a triangle whose corners have distances. The parts are triangles, given by x
 * and y of each corner.
 */
export function paintedParts(triangle: readonly Valued[], { period, from, to }: Bars): number[] {
  const values = triangle.map(([, , value]) => value / period);
  const first = Math.floor(Math.min(...values));
  const last = Math.floor(Math.max(...values));
  if (!(last - first < mostBars)) return triangle.flatMap((corner) => corner.slice(0, 2));
  const triangles: number[] = [];
  for (let bar = first; bar <= last; bar++) {
    const above = clipped(triangle, ([, , value]) => value - (bar + from) * period);
    const part = clipped(above, ([, , value]) => (bar + to) * period - value);
    for (let i = 2; i < part.length; i++) {
      for (const [x, y] of [part[0]!, part[i - 1]!, part[i]!]) triangles.push(x, y);
    }
  }
  return triangles;
}

/**
 * The part of a polygon where a height is not negative. The height is linear in the numbers of a
 * corner.
 */
export function clipped<Corner extends readonly number[]>(
  polygon: readonly Corner[],
  heightOf: (corner: Corner) => number,
): Corner[] {
  const heights = polygon.map(heightOf);
  const left: Corner[] = [];
  for (const [i, corner] of polygon.entries()) {
    const next = (i + 1) % polygon.length;
    const [here, there] = [heights[i]!, heights[next]!];
    if (here >= 0) left.push(corner);
    if (here >= 0 === there >= 0) continue;
    const part = here / (here - there);
    const between = corner.map((of, k) => of + part * (polygon[next]![k]! - of));
    left.push(between as readonly number[] as Corner);
  }
  return left;
}
