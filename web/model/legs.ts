/**
 * The legs of a control polygon: each is the shortest path to the next point, unless its point says
 * otherwise.
 */
import type { CurveOptions, SurfacePoint } from 'karcher';
import type { ControlPoint, Spline } from './figure';

type Polygon = Pick<Spline, 'settings' | 'points'>;

const samePlace = (a: SurfacePoint | undefined, b: SurfacePoint | undefined) =>
  a?.face === b?.face && (a?.bary.every((weight, i) => weight === b?.bary[i]) ?? true);

function endsOf({ settings, points }: Polygon, i: number): (ControlPoint | undefined)[] {
  const next = i + 1 < points.length || !settings.closed ? i + 1 : 0;
  return [points[i], points[next]];
}

/** Another way to the next point; the shortest where none is given. */
export function withLeg(
  point: ControlPoint,
  leg: readonly SurfacePoint[] | null | undefined,
): ControlPoint {
  if ((leg ?? undefined) === point.leg) return point;
  const { leg: _, ...rest } = point;
  return leg ? { ...rest, leg } : rest;
}

/** Without those legs of `before` that do not join the same two places any more. */
export function withFittingLegs<Of extends Polygon>(polygon: Of, before: Polygon): Of {
  if (polygon.points === before.points && polygon.settings.closed === before.settings.closed) {
    return polygon;
  }
  const fits = ({ leg }: ControlPoint, i: number) => {
    const old = leg ? before.points.findIndex((point) => point.leg === leg) : -1;
    if (old < 0) return true;
    const ends = endsOf(before, old);
    return endsOf(polygon, i).every((end, side) => samePlace(end, ends[side]));
  };
  if (polygon.points.every(fits)) return polygon;
  const points = polygon.points.map((point, i) => (fits(point, i) ? point : withLeg(point, null)));
  return { ...polygon, points };
}

/** The legs as the engine takes them. */
export function legsOf({ settings, points }: Polygon): Pick<CurveOptions, 'legs'> {
  const legs = points.slice(0, settings.closed ? undefined : -1).map(({ leg }) => leg ?? null);
  return legs.some((leg) => leg !== null) ? { legs } : {};
}
