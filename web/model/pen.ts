/**
 * Curves of the pen: cubic Bézier segments between anchors, each with up to two tangent handles,
 * one on either side. A handle lies at the end of a straightest geodesic from its anchor. If one
 * handle is the opposite of the other, the curve stays smooth there when either moves.
 */
import type { CurveOptions, CurveSamples, FieldOptions, SurfacePoint } from 'karcher';
import {
  askedLevels,
  type ControlPoint,
  type Figure,
  plain,
  type Side,
  type Tangent,
  type Tangents,
  type Vector,
  withLeg,
} from './figure';
import { withOrigin } from './origins';
import { type DrawnTangent, type DrawnTangents, penLegs, waysAlong } from './pen_legs';

/** The relation between the handles of an anchor. */
export type Joint = 'corner' | 'smooth' | 'symmetric';

export const otherSide = (side: Side): Side => (side === 'before' ? 'after' : 'before');

export const isOpposite = (tangent: Tangent | undefined): tangent is { length: number | null } =>
  tangent !== undefined && !('face' in tangent) && !('direction' in tangent);

export function jointOf(tangents: Tangents | undefined): Joint {
  const opposite = [tangents?.before, tangents?.after].find(isOpposite);
  if (!opposite) return 'corner';
  return opposite.length === null ? 'symmetric' : 'smooth';
}

/** The anchor with other handles; without any it is a corner. */
export function withTangents(point: ControlPoint, tangents: Tangents | undefined): ControlPoint {
  const { tangents: _, ...rest } = point;
  const { before, after } = tangents ?? {};
  if (!before && !after) return rest;
  return { ...rest, tangents: { ...(before && { before }), ...(after && { after }) } };
}

/** A drawn handle as a vector at its anchor. */
const vectorOf = ({ direction, length }: DrawnTangent): Tangent => ({ direction, length });

/**
 * The handles of an anchor as vectors, which move with the anchor. A handle that is opposite to the
 * other one stays opposite.
 */
export function byVectors(
  tangents: Tangents | undefined,
  drawn: DrawnTangents,
  turn: (direction: Vector) => Vector = (direction) => direction,
): Tangents {
  const told = (side: Side): Tangent | undefined => {
    const [tangent, found] = [tangents?.[side], drawn[side]];
    if (!tangent || !found || isOpposite(tangent)) return tangent;
    return { ...vectorOf(found), direction: turn(found.direction) };
  };
  return { before: told('before'), after: told('after') };
}

/**
 * The handles of an anchor after a drag of one handle. The other handle stays opposite and keeps
 * its length; at a symmetric joint it takes the dragged handle's length. At a corner or a broken
 * joint the other handle stays in place.
 */
export function withHandleAt(
  tangents: Tangents | undefined,
  drawn: DrawnTangents,
  side: Side,
  to: Tangent,
  { broken }: { broken: boolean },
): Tangents {
  const other = otherSide(side);
  const found = drawn[other];
  const joint = jointOf(tangents);
  if (joint === 'corner' || broken) {
    const kept = found && tangents?.[other] ? vectorOf(found) : undefined;
    return { [side]: to, ...(kept && { [other]: kept }) };
  }
  return {
    [side]: to,
    [other]: { length: joint === 'symmetric' ? null : (found?.length ?? null) },
  };
}

/** The drawn handles, changed so that they form another joint. */
export function asJoint(
  tangents: Tangents | undefined,
  drawn: DrawnTangents,
  joint: Joint,
): Tangents {
  const { before, after } = drawn;
  if (joint === 'corner') {
    return {
      ...(before && { before: vectorOf(before) }),
      ...(after && { after: vectorOf(after) }),
    };
  }
  const side: Side = isOpposite(tangents?.after) || !after ? 'before' : 'after';
  const lead = drawn[side];
  if (!lead) return {};
  const length = joint === 'symmetric' ? null : (drawn[otherSide(side)]?.length ?? lead.length);
  return { [side]: vectorOf(lead), [otherSide(side)]: { length } };
}

/** Whether a figure's anchors form a closed curve. */
const isClosed = ({ settings, points }: Figure) => settings.closed && points.length > 1;

/** The number of segments of a curve of the pen. */
export const segmentsOf = (figure: Figure) => figure.points.length - (isClosed(figure) ? 0 : 1);

/** A place between two anchors. */
export interface OnSegment {
  /** The indices of the segment's anchors. */
  from: number;
  to: number;
  /** The parameter on the segment, from 0 to 1. */
  t: number;
}

/** The segment at a parameter of the whole curve. */
export function segmentAt(figure: Figure, parameter: number): OnSegment {
  const from = Math.min(Math.floor(parameter), segmentsOf(figure) - 1);
  return { from, to: (from + 1) % figure.points.length, t: parameter - from };
}

/**
 * The curve of anchors with their handles as drawn: a B-spline of degree 3 with threefold knots, so
 * that each segment is the Bézier curve of its two anchors and the handles between them.
 */
export function penOptions(
  figure: Figure,
  drawn: readonly DrawnTangents[],
  options: FieldOptions,
): CurveOptions {
  const { points, settings } = figure;
  const { samples, tolerance } = settings;
  const count = segmentsOf(figure);
  const control: SurfacePoint[] = [];
  const knots = [0];
  for (let i = 0; i < count; i++) {
    const next = (i + 1) % points.length;
    const [from, to] = [plain(points[i]!), plain(points[next]!)];
    control.push(from, drawn[i]?.after?.point ?? from, drawn[next]?.before?.point ?? to);
    knots.push(i, i, i);
  }
  control.push(plain(points[count % points.length]!));
  knots.push(count, count, count, count);
  return {
    ...options,
    kind: 'bspline',
    degree: 3,
    points: control,
    knots,
    ...penLegs(points, drawn, count),
    ...(tolerance === null ? { samples } : { tolerance }),
    ...(options.method !== 'paper' && askedLevels(settings)),
  };
}

/**
 * The indices of an anchor's control points: its own and those of its handles. The anchor at which
 * the curve closes has control points at both ends of the list.
 */
export function controlPointsOf(figure: Figure, anchor: number): number[] {
  const last = 3 * segmentsOf(figure);
  const around = [3 * anchor - 1, 3 * anchor, 3 * anchor + 1].filter((i) => i >= 0 && i <= last);
  return anchor === 0 && isClosed(figure) ? [...around, last - 1, last] : around;
}

/** An anchor with another length of one of its handles; the other handle stays as it is. */
export function withHandleLength(
  anchor: ControlPoint,
  drawn: DrawnTangents,
  side: Side,
  length: number,
): ControlPoint {
  const found = drawn[side];
  if (!found) return anchor;
  const kept = asJoint(anchor.tangents, drawn, 'corner');
  const other = otherSide(side);
  const smooth = jointOf(anchor.tangents) !== 'corner';
  const opposite = smooth && drawn[other] ? { [other]: { length: drawn[other].length } } : {};
  const { direction } = found;
  return withTangents(anchor, { ...kept, [side]: { direction, length }, ...opposite });
}

/**
 * The anchors with a new one at a parameter of the curve. De Casteljau's algorithm gives the
 * handles, so that on a plane the curve does not change. `derivative` is the curve's derivative at
 * the parameter, and `samples` are the curve's samples. If the old segment had a leg, the legs of
 * the two new segments lie along the samples.
 */
export function withAnchorAt(
  figure: Figure,
  drawn: readonly DrawnTangents[],
  parameter: number,
  place: SurfacePoint,
  derivative: Vector,
  samples: Omit<CurveSamples, 'status'>,
): { points: ControlPoint[]; index: number } {
  const { points } = figure;
  const { from: segment, to: next, t } = segmentAt(figure, parameter);
  const speed = Math.hypot(...derivative);
  const direction = derivative.map((value) => value / (speed || 1)) as Vector;
  const shortened = (index: number, side: Side, part: number): ControlPoint => {
    const found = drawn[index]?.[side];
    if (!found) return points[index]!;
    return withHandleLength(points[index]!, drawn[index]!, side, part * found.length);
  };
  const put = withTangents(place, {
    after: { direction, length: ((1 - t) * speed) / 3 },
    before: { length: (t * speed) / 3 },
  });
  const ways = points[segment]!.leg ? waysAlong(samples, segment, t) : [null, null];
  const changed = points
    .with(segment, withLeg(shortened(segment, 'after', t), ways[0]))
    .with(next, shortened(next, 'before', 1 - t));
  const anchor = withOrigin(withLeg(put, ways[1]), points[segment]!.origin);
  return { points: changed.toSpliced(segment + 1, 0, anchor), index: segment + 1 };
}
