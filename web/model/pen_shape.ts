/** Changes of a pen curve's shape between its anchors: bending a segment, and fitting fewer segments. */
import { type Cubic, cubicAt, nearestCubic, type Planar } from './cubic_fit';
import type { Figure, Side, Tangent, Vector } from './figure';
import { type OnSegment, withHandleAt, withTangents } from './pen';
import type { DrawnTangents } from './pen_legs';

/**
 * The shifts of a segment's two handles that move its point at a parameter by 1, with the smallest
 * sum of squares.
 */
export function bendingParts(t: number): [number, number] {
  const [first, second] = [3 * t * (1 - t) ** 2, 3 * t ** 2 * (1 - t)];
  const whole = first ** 2 + second ** 2;
  return [first / whole, second / whole];
}

/** A tangent vector as a handle; null if it has no length. */
function handleOf(vector: Vector): Tangent | null {
  const length = Math.hypot(...vector);
  if (!(length > 0)) return null;
  return { direction: vector.map((value) => value / length) as Vector, length };
}

/**
 * The figure after the two handles of a segment have moved. Each handle moves by a vector at its
 * anchor. Smooth joints stay smooth.
 */
export function withBentSegment(
  figure: Figure,
  drawn: readonly DrawnTangents[],
  { from, to }: OnSegment,
  [first, second]: readonly [Vector, Vector],
): Figure {
  const bent = (index: number, side: Side, by: Vector) => {
    const anchor = figure.points[index]!;
    const found = drawn[index]?.[side];
    const vector = by.map((value, axis) =>
      found ? value + found.length * found.direction[axis]! : value,
    ) as Vector;
    const handle = handleOf(vector);
    if (!handle) return anchor;
    const options = { broken: false };
    const handles = withHandleAt(anchor.tangents, drawn[index] ?? {}, side, handle, options);
    return withTangents(anchor, handles);
  };
  const points = figure.points.with(from, bent(from, 'after', first));
  return { ...figure, points: points.with(to, bent(to, 'before', second)) };
}

/** The number of places on each of two segments to which the merged curve is fitted. */
const placesHeld = 24;

/**
 * One curve that replaces two consecutive curves. At its ends it has the given directions, which
 * point into the curve. If the two curves are parts of a single cubic curve, this curve is the
 * result.
 */
export function mergedCubic(
  first: Cubic,
  second: Cubic,
  directions: { start: Planar | null; end: Planar | null },
): Cubic {
  const far = (p: Planar, q: Planar) => Math.hypot(p[0] - q[0], p[1] - q[1]);
  const [before, after] = [far(first[2], first[3]), far(second[0], second[1])];
  const [chord, next] = [far(first[0], first[3]), far(second[0], second[3])];
  // If the two curves are parts of one curve, the lengths of their handles at the removed anchor
  // have the same ratio as their parameter ranges (De Casteljau's algorithm).
  const split = before > 0 && after > 0 ? before / (before + after) : chord / (chord + next || 1);
  const places = Array.from({ length: placesHeld + 1 }, (_, i) => i / placesHeld);
  const parameters = [
    ...places.map((t) => t * split),
    ...places.slice(1).map((t) => split + t * (1 - split)),
  ];
  const points = [
    ...places.map((t) => cubicAt(first, t)),
    ...places.slice(1).map((t) => cubicAt(second, t)),
  ];
  const unit = Math.max(chord, next, before, after, Number.MIN_VALUE);
  const tolerances = points.map(() => unit);
  return nearestCubic(points, directions, tolerances, parameters).cubic;
}
