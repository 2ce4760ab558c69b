/**
 * The legs of a control polygon. Each leads from a point to the next one, along the shortest path
 * unless the point stores another path.
 */
import type { CurveOptions, DrawnLeg, LegPoints, SurfacePoint } from 'karcher';
import type { Side } from './figure';
import { type ControlPoint, type Spline, surfacePoint, withLeg } from './figure';
import { isOpposite, otherSide } from './pen';

type Polygon = Pick<Spline, 'settings' | 'points'>;

/** The data of the handle on one side of a pen anchor; undefined if the anchor has none there. */
function handleOf({ tangents }: ControlPoint, side: Side) {
  const told = tangents?.[side];
  return isOpposite(told) ? [told, tangents?.[otherSide(side)]] : told;
}

/** A text that identifies where the leg from a point to the next one starts and ends. */
export function endsKey({ settings, points }: Polygon, i: number): string {
  const next = i + 1 < points.length || !settings.closed ? i + 1 : 0;
  const ends = [points[i], points[next]].map(
    (point, end) =>
      point && [point.face, point.bary, handleOf(point, end === 0 ? 'after' : 'before')],
  );
  return JSON.stringify(ends);
}

/** The figure without the legs of `before` that no longer join the same two points or handles. */
export function withFittingLegs<Of extends Polygon>(polygon: Of, before: Polygon): Of {
  if (polygon.points === before.points && polygon.settings.closed === before.settings.closed) {
    return polygon;
  }
  const fits = ({ leg }: ControlPoint, i: number) => {
    const old = leg ? before.points.findIndex((point) => point.leg === leg) : -1;
    return old < 0 || endsKey(polygon, i) === endsKey(before, old);
  };
  if (polygon.points.every(fits)) return polygon;
  const points = polygon.points.map((point, i) => (fits(point, i) ? point : withLeg(point, null)));
  return { ...polygon, points };
}

/** The legs of a curve as it was last drawn, and the indices of the dragged control points. */
export interface DrawnBefore {
  legs: readonly DrawnLeg[];
  points: readonly number[];
}

/**
 * A curve's value with the drawn legs at the dragged points, so that the engine continues these
 * legs. The value's own legs stay.
 */
export function withDrawnLegs(value: CurveOptions, before: DrawnBefore): CurveOptions {
  const { points, closed = false, legs = [] } = value;
  // The drawn legs do not correspond to a value with another number of points.
  if (before.legs.length !== points.length - (closed ? 0 : 1)) return value;
  const at = legsAt(points.length, before.points);
  return {
    ...value,
    legs: before.legs.map((leg, i) => legs[i] ?? (at.includes(i) ? leg : null)),
  };
}

/** The indices of the legs that meet the given points. */
const legsAt = (count: number, at: readonly number[]): number[] => [
  ...new Set(at.flatMap((i) => [i, (i + count - 1) % count])),
];

/** For each leg, the few points that determine it; null for the shortest path. */
export type ToldLegs = readonly (readonly SurfacePoint[] | null)[];

/**
 * The figure after a drag. It stores the drawn legs that meet its dragged points, unless it has
 * legs there itself.
 */
export function withTold<Of extends Polygon>(
  figure: Of,
  dragged: readonly number[],
  told: ToldLegs,
): Of {
  const at = legsAt(figure.points.length, dragged).filter((i) => told[i] && !figure.points[i]?.leg);
  if (at.length === 0) return figure;
  const points = figure.points.map((point, i) =>
    at.includes(i) ? withLeg(point, told[i] ?? null) : point,
  );
  return { ...figure, points };
}

/** The legs in the engine's form. */
export function legsOf({ settings, points }: Polygon): Pick<CurveOptions, 'legs'> {
  const legs = points.slice(0, settings.closed ? undefined : -1).map(({ leg }) => leg ?? null);
  return legs.some((leg) => leg !== null) ? { legs } : {};
}

/** The engine's points of a leg, with weights that a link stores to the last bit. */
export const waypointsOf = (leg: LegPoints | undefined): SurfacePoint[] | null =>
  leg?.map((point) => {
    if ('vertex' in point) throw new Error('the engine gives points of faces');
    const { face, bary } = point;
    return surfacePoint(face, bary[1], Math.min(bary[2], 1 - bary[1]));
  }) ?? null;
