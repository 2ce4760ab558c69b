/** Edits of a curve that need its mathematics: what comes of them, as data. */
import type { Curve, CurveKind, CurveOptions, Mesh } from 'karcher';

type Place = [number, number, number];

export type Reshape =
  /** Puts a control point in where the curve is nearest to a place, if no knot is within reach. */
  | { type: 'insert'; near: Place; within: number }
  /** Cuts the curve where it is nearest to a place, or at the knot within reach. */
  | { type: 'split'; near: Place; within: number }
  /** Makes one curve of this and another one, at the ends that are nearest to each other. */
  | { type: 'join'; other: CurveOptions }
  | { type: 'reverse' };

export interface Reshaped {
  curves: CurveOptions[];
  /** The number of the control point that was put in. */
  point: number | null;
}

/** What an edit makes of the curve with these options; that curve itself stays as it is. */
export function reshaped(mesh: Mesh, curve: Curve, options: CurveOptions, edit: Reshape): Reshaped {
  const made: Curve[] = [];
  const make = (of: CurveOptions) => {
    const copy = mesh.curve(of);
    made.push(copy);
    return copy;
  };
  try {
    if (edit.type === 'reverse') {
      const copy = make(options);
      copy.reverse();
      return { curves: [optionsOf(copy, options)], point: null };
    }
    if (edit.type === 'insert') {
      const copy = make(options);
      const { parameter, isKnot } = meantAt(copy, edit);
      if (isKnot && copy.kind === 'bspline') throw new Error('the curve has a knot there already');
      const point = copy.insertOnCurve(parameter);
      return { curves: [refinedOptions(copy, options)], point };
    }
    if (edit.type === 'split') made.push(...curve.split(meantAt(curve, edit).parameter));
    else made.push(joinedAtEnds(make(options), make(edit.other)));
    const parts = edit.type === 'split' ? made : made.slice(-1);
    return { curves: parts.map((part) => refinedOptions(part, options)), point: null };
  } finally {
    for (const copy of made) copy.dispose();
  }
}

/** The kinds of one segment, which has no knots. */
const ofOneSegment: readonly CurveKind[] = ['bezier', 'rational', 'barycentric'];

/**
 * The parameter that is meant at a place: where the curve is nearest, or the knot within reach of
 * that, next to which a segment would be a sliver.
 */
function meantAt(
  curve: Curve,
  { near, within }: { near: Place; within: number },
): { parameter: number; isKnot: boolean } {
  const { parameter, position } = curve.nearest(near);
  const knot = Math.round(parameter);
  const isKnot =
    !ofOneSegment.includes(curve.kind) && far(curve.pointAt(knot).position, position) <= within;
  return { parameter: isKnot ? knot : parameter, isKnot };
}

/** What a curve is; what it has no word for is as it was before. */
function optionsOf(curve: Curve, before: CurveOptions): CurveOptions {
  const { method, solver, rings, samples, tolerance, levels, parametrization } = before;
  const { kind, closed } = curve;
  const own = before.knots !== undefined && typeof before.knots !== 'string';
  const numbers = (values: Float64Array) =>
    values.some((value) => value !== 1) ? Array.from(values) : undefined;
  const weights = kind === 'bspline' || kind === 'rational' ? numbers(curve.weights()) : undefined;
  const betas = kind === 'barycentric' ? numbers(curve.betas()) : undefined;
  return {
    ...{ method, solver, rings, kind, closed, points: curve.points() },
    ...(tolerance === undefined ? { samples } : { tolerance }),
    ...(levels !== undefined && { levels }),
    ...(kind === 'bspline' && { degree: curve.degree }),
    ...(kind === 'bspline' && { knots: own ? Array.from(curve.knots()) : before.knots }),
    ...(kind === 'catmullrom' && { parametrization }),
    ...(weights && { weights }),
    ...(betas && { betas }),
  };
}

/** The same of a curve whose knots follow no rule any more. */
function refinedOptions(curve: Curve, before: CurveOptions): CurveOptions {
  const knots = Array.from(curve.knots());
  return optionsOf(curve, { ...before, knots });
}

const far = (p: Place, q: Place) => Math.hypot(...p.map((value, axis) => value - q[axis]!));

/** Runs along both, which may be turned around for it. */
function joinedAtEnds(a: Curve, b: Curve): Curve {
  const ends = (curve: Curve) =>
    [0, curve.segmentCount].map((parameter) => curve.pointAt(parameter).position);
  const [startA, endA] = ends(a) as [Place, Place];
  const [startB, endB] = ends(b) as [Place, Place];
  const ways = [far(endA, startB), far(endA, endB), far(startA, endB), far(startA, startB)];
  const way = ways.indexOf(Math.min(...ways));
  if (way === 1) b.reverse();
  if (way === 3) a.reverse();
  return way === 2 ? b.join(a) : a.join(b);
}
