/** Changes of the shape of a circle or an ellipse by its handles and its number fields. */
import type { SurfacePoint } from 'karcher';
import type { CircleShape, RoundKind, Vector } from './figure';
import { cross, minus } from './vectors';

/** The radius of a new circle, relative to the surface's diagonal. */
const newRadius = 0.08;
/** The default of an ellipse's radius across, relative to its first radius. */
export const defaultAcross = 0.6;

const handles = ['center', 'rim', 'across'] as const;
/** The handles of a circle or an ellipse. An ellipse has one at the end of each radius: `rim` and `across`. */
export type CircleHandle = (typeof handles)[number];

export const isCircleHandle = (text: string): text is CircleHandle =>
  (handles as readonly string[]).includes(text);

/** The names beside the handles. */
export const handleNames = (kind: RoundKind): Record<CircleHandle, string> => ({
  center: 'Center',
  rim: kind === 'circle' ? 'Radius' : 'Along',
  across: 'Across',
});

/** The radii of a circle or an ellipse as drawn. */
export interface DrawnRadii {
  radius: number;
  /** The direction from the center to the rim. */
  direction: Vector;
  across: { radius: number } | null;
}

export function newCircle(center: SurfacePoint, diagonal: number, direction: Vector): CircleShape {
  return { center, rim: { radius: newRadius * diagonal, direction } };
}

/**
 * The shape with its radii as lengths, so that they stay when the center moves. A circle drops a
 * point that sets the radius across, since at another center the point would set another radius.
 */
export function byRadii({ across, ...shape }: CircleShape, drawn: DrawnRadii | null): CircleShape {
  if (!drawn) return { ...shape, ...(across && { across }) };
  const { radius, direction } = drawn;
  const length = drawn.across?.radius ?? (across && 'radius' in across && across.radius);
  return { ...shape, rim: { radius, direction }, ...(length && { across: { radius: length } }) };
}

/**
 * The shape with one of its handles at a point; `grabbed` is the shape with its radii as lengths.
 */
export function withHandle(
  shape: CircleShape,
  grabbed: CircleShape,
  handle: CircleHandle,
  point: SurfacePoint,
): CircleShape {
  if (handle === 'center') return { ...grabbed, center: point };
  // A turn of an ellipse does not change its radius across.
  return handle === 'rim' ? { ...grabbed, rim: point } : { ...shape, across: point };
}

/** The shape with another radius, in the direction in which its handle is drawn. */
export function withRadius(
  shape: CircleShape,
  drawn: DrawnRadii,
  handle: 'rim' | 'across',
  radius: number,
): CircleShape {
  if (handle === 'across') return { ...shape, across: { radius } };
  return byRadii(shape, { ...drawn, radius });
}

/**
 * The unit direction in the plane of a triangle that is perpendicular to another direction, to its
 * left.
 */
export function acrossDirection(direction: Vector, [a, b, c]: [Vector, Vector, Vector]): Vector {
  const across = cross(cross(minus(b, a), minus(c, a)), direction);
  const length = Math.hypot(...across);
  return length > 0 ? (across.map((value) => value / length) as Vector) : minus(b, a);
}

/**
 * The component of a geodesic's initial vector along another direction. The vector has the given
 * length and direction.
 */
export function reachAlong(length: number, direction: Vector, along: Vector): number {
  return length * direction.reduce((sum, value, axis) => sum + value * along[axis]!, 0);
}
