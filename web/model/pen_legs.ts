/**
 * The legs of a curve of the pen. Each segment has three legs: from its first anchor to the handle
 * after this anchor, on to the handle before the next anchor, and on to the next anchor. The first
 * anchor stores the middle leg if it is not the shortest path; the other legs are the handles'
 * geodesics.
 */
import type { CurveOptions, CurveSamples, SurfacePoint } from 'karcher';
import type { ControlPoint, Side, Vector } from './figure';

/** A handle's geodesic on the surface. */
export interface DrawnTangent {
  point: SurfacePoint;
  /** The unit direction from the anchor. */
  direction: Vector;
  length: number;
  /** The geodesic from the anchor. */
  path: Float32Array;
  /** A few points on the geodesic, in order. */
  through: readonly SurfacePoint[];
}

export type DrawnTangents = { readonly [Which in Side]?: DrawnTangent };

const legsOfSegment = 3;
const middle = 1;

/** The anchor that stores a leg; null for a leg to or from a handle. */
export const anchorOfLeg = (leg: number): number | null =>
  leg % legsOfSegment === middle ? (leg - middle) / legsOfSegment : null;

/** The legs that anchors store, selected from all legs of the control polygon. */
export const legsOfAnchors = <Leg>(legs: readonly Leg[]): Leg[] =>
  legs.filter((_, i) => anchorOfLeg(i) !== null);

/** The legs of all segments in the engine's form. */
export function penLegs(
  anchors: readonly ControlPoint[],
  drawn: readonly DrawnTangents[],
  segments: number,
): Pick<CurveOptions, 'legs'> {
  const legs = anchors.slice(0, segments).flatMap(({ leg = null }, i) => {
    const next = (i + 1) % anchors.length;
    return [wayOf(drawn[i]?.after), leg, wayOf(drawn[next]?.before)?.toReversed() ?? null];
  });
  return legs.some((leg) => leg !== null) ? { legs } : {};
}

/** The points along a handle's geodesic; null if it stays in one face. */
const wayOf = (handle: DrawnTangent | undefined): readonly SurfacePoint[] | null =>
  handle?.through.length ? handle.through : null;

/** The points along the two parts into which a cut at `t` divides a segment. */
export function waysAlong(
  samples: Omit<CurveSamples, 'status'>,
  segment: number,
  t: number,
): SurfacePoint[][] {
  const before: SurfacePoint[] = [];
  const after: SurfacePoint[] = [];
  for (let i = 0; i < samples.count; i++) {
    if (samples.segment[i] !== segment || samples.t[i] === t) continue;
    const [b0, b1, b2] = samples.bary.subarray(3 * i, 3 * i + 3);
    const part = samples.t[i]! < t ? before : after;
    part.push({ face: samples.face[i]!, bary: [b0!, b1!, b2!] });
  }
  return [before, after].map(throughOf);
}

/**
 * The largest number of points that describe a path. The pieces between them are so short that they
 * are shortest paths even on rough surfaces.
 */
const mostThrough = 3;

/** A few inner points of a path, evenly spread. */
export function throughOf(points: readonly SurfacePoint[]): SurfacePoint[] {
  const inner = points.slice(1, -1);
  if (inner.length <= mostThrough) return inner;
  const parts = Array.from({ length: mostThrough }, (_, i) => (i + 1) / (mostThrough + 1));
  return parts.map((part) => inner[Math.round(part * (inner.length - 1))]!);
}
