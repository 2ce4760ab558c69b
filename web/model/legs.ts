/**
 * The legs of a control polygon: each is the shortest path to the next point, unless its point says
 * otherwise.
 */
import type { CurveOptions, DrawnLeg } from 'karcher';
import { type ControlPoint, type Spline, withLeg } from './figure';
import { isOpposite, otherSide, type Side } from './pen';

type Polygon = Pick<Spline, 'settings' | 'points'>;

/** What tells the handle on one side of an anchor of the pen; nothing where the anchor itself is the end. */
function handleOf({ tangents }: ControlPoint, side: Side) {
  const told = tangents?.[side];
  return isOpposite(told) ? [told, tangents?.[otherSide(side)]] : told;
}

/** What tells where the leg from a point to the next one starts and ends. */
export function endsOf({ settings, points }: Polygon, i: number): string {
  const next = i + 1 < points.length || !settings.closed ? i + 1 : 0;
  const ends = [points[i], points[next]].map(
    (point, end) =>
      point && [point.face, point.bary, handleOf(point, end === 0 ? 'after' : 'before')],
  );
  return JSON.stringify(ends);
}

/** Without those legs of `before` that do not join the same two places any more, points or handles. */
export function withFittingLegs<Of extends Polygon>(polygon: Of, before: Polygon): Of {
  if (polygon.points === before.points && polygon.settings.closed === before.settings.closed) {
    return polygon;
  }
  const fits = ({ leg }: ControlPoint, i: number) => {
    const old = leg ? before.points.findIndex((point) => point.leg === leg) : -1;
    return old < 0 || endsOf(polygon, i) === endsOf(before, old);
  };
  if (polygon.points.every(fits)) return polygon;
  const points = polygon.points.map((point, i) => (fits(point, i) ? point : withLeg(point, null)));
  return { ...polygon, points };
}

/** A value whose legs go on from where they were drawn, where it tells none; none were drawn of another number. */
export function withDrawnLegs(value: CurveOptions, drawn: readonly DrawnLeg[]): CurveOptions {
  const { points, closed = false, legs = [] } = value;
  if (drawn.length !== points.length - (closed ? 0 : 1)) return value;
  return { ...value, legs: drawn.map((leg, i) => legs[i] ?? leg) };
}

/** The legs as the engine takes them. */
export function legsOf({ settings, points }: Polygon): Pick<CurveOptions, 'legs'> {
  const legs = points.slice(0, settings.closed ? undefined : -1).map(({ leg }) => leg ?? null);
  return legs.some((leg) => leg !== null) ? { legs } : {};
}
