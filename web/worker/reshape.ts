/** Edits of a curve that need its mathematics: what the curve is afterwards, as data. */
import type { Curve, CurveOptions, Mesh, PointLike } from 'karcher';

export type Reshape =
  /** Puts a control point where the curve is nearest to a place. */
  { type: 'insert'; near: [number, number, number] } | { type: 'reverse' };

/** The options of the curve that an edit makes; the curve itself is left as it was. */
export function reshaped(
  mesh: Mesh,
  curve: Curve,
  options: CurveOptions,
  edit: Reshape,
): CurveOptions {
  if (edit.type === 'insert') return withPointOn(curve, options, edit.near);
  const copy = mesh.curve(options);
  try {
    copy.reverse();
    return optionsOf(copy, options);
  } finally {
    copy.dispose();
  }
}

/** What a curve is, where its knots follow the same rule as before. */
function optionsOf(curve: Curve, before: CurveOptions): CurveOptions {
  const own = before.knots !== undefined && typeof before.knots !== 'string';
  return {
    ...before,
    points: curve.points,
    ...(own && { knots: curve.knots }),
    ...(before.weights && { weights: curve.weights }),
    ...(before.betas && { betas: curve.betas }),
  };
}

/** With a new control point where the curve passes, between those it is between. */
function withPointOn(
  curve: Curve,
  options: CurveOptions,
  near: [number, number, number],
): CurveOptions {
  const { parameter, point } = curve.nearest(near);
  const { points, weights, betas, knots, ...rest } = options;
  const index = indexAt(options, curve.segmentCount, parameter);
  return {
    ...rest,
    points: (points as PointLike[]).toSpliced(index, 0, point),
    ...(typeof knots === 'string' && { knots }),
    ...(weights && { weights: Array.from(weights).toSpliced(index, 0, 1) }),
    ...(betas && { betas: Array.from(betas).toSpliced(index, 0, 1) }),
  };
}

/** The number that a new point between the points around a parameter has. */
function indexAt(options: CurveOptions, segments: number, parameter: number): number {
  const { kind, degree = 3, points, closed } = options;
  const passes = kind === 'catmullrom' || kind === 'polyline';
  // Of a curve of one segment, the points are spread over it; a closed one ends at its first.
  if (segments === 1 && !passes && kind !== 'bspline') {
    const gaps = closed ? points.length : points.length - 1;
    return Math.min(gaps, Math.floor(parameter * gaps) + 1);
  }
  const segment = Math.min(segments - 1, Math.floor(parameter));
  if (passes) return segment + 1;
  // A B-spline's segment lies over the middle of the degree + 1 points that it blends.
  const before = segment + Math.floor((degree + parameter - segment) / 2) + 1;
  return closed ? before % points.length || points.length : Math.min(points.length - 1, before);
}
