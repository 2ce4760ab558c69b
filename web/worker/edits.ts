/** Edits of a curve that need its mathematics. They return the values of the resulting curves. */
import type { CurveKind, CurveOptions, CurveValue, PointLike } from 'karcher';
import type { RemoteCurve, RemoteMesh } from 'karcher/own-worker';

type Place = [number, number, number];

export type Edit =
  | { type: 'insertPoint'; index: number; point: PointLike }
  | { type: 'removePoint'; index: number }
  | { type: 'setClosed'; closed: boolean }
  | { type: 'reverse' }
  /**
   * Inserts a control point where the curve is nearest to a place. Throws if a knot of a B-spline
   * is within reach.
   */
  | { type: 'insert'; near: Place; within: number }
  /** Cuts the curve where it is nearest to a place, or at a knot within reach. */
  | { type: 'split'; near: Place; within: number }
  /** Joins this curve and another one at the ends that are nearest to each other. */
  | { type: 'join'; other: CurveOptions };

export interface Edited {
  curves: CurveValue[];
  /** The index of the inserted control point. */
  point: number | null;
}

/** The result of an edit of the curve with a value. The edit may change `curve`. */
export async function edited(
  mesh: RemoteMesh,
  curve: RemoteCurve,
  value: CurveOptions,
  edit: Edit,
): Promise<Edited> {
  // The worker answers calls in their order, even those that nobody awaits.
  const set = curve.set(value);
  switch (edit.type) {
    case 'insertPoint':
      return changed(set, curve.insertPoint(edit.index, edit.point), curve.value());
    case 'removePoint':
      return changed(set, curve.removePoint(edit.index), curve.value());
    case 'setClosed':
      return changed(set, curve.setClosed(edit.closed), curve.value());
    case 'reverse':
      return changed(set, curve.reverse(), curve.value());
    case 'insert': {
      await set;
      const { parameter, isKnot } = await meantAt(curve, value.kind, edit);
      if (isKnot && value.kind === 'bspline') throw new Error('the curve has a knot there already');
      const [point, refined] = await Promise.all([curve.insertOnCurve(parameter), curve.value()]);
      return { curves: [refined], point };
    }
    case 'split': {
      await set;
      const { parameter } = await meantAt(curve, value.kind, edit);
      return valuesOf(await curve.split(parameter));
    }
    case 'join': {
      await set;
      const other = await mesh.curve(edit.other);
      try {
        return await valuesOf([await joinedAtEnds(curve, other)]);
      } finally {
        void other.dispose();
      }
    }
  }
}

async function changed(
  set: Promise<unknown>,
  edit: Promise<unknown>,
  value: Promise<CurveValue>,
): Promise<Edited> {
  const [, , after] = await Promise.all([set, edit, value]);
  return { curves: [after], point: null };
}

/** Returns the values of curves and disposes of them. */
async function valuesOf(made: readonly RemoteCurve[]): Promise<Edited> {
  const curves = await Promise.all(made.map((curve) => curve.value()));
  for (const curve of made) void curve.dispose();
  return { curves, point: null };
}

/** The kinds with a single segment, which have no knots. */
const ofOneSegment: readonly CurveKind[] = ['bezier', 'rational', 'barycentric'];

/**
 * The parameter at which the curve is nearest to a place. If a knot is within reach, it is the
 * knot's parameter, since a segment between the knot and the place would be a sliver.
 */
async function meantAt(
  curve: RemoteCurve,
  kind: CurveKind,
  { near, within }: { near: Place; within: number },
): Promise<{ parameter: number; isKnot: boolean }> {
  const { parameter, position } = await curve.nearest(near);
  const knot = Math.round(parameter);
  const isKnot =
    !ofOneSegment.includes(kind) && far((await curve.pointAt(knot)).position, position) <= within;
  return { parameter: isKnot ? knot : parameter, isKnot };
}

const far = (p: Place, q: Place) => Math.hypot(...p.map((value, axis) => value - q[axis]!));

/** Joins two curves at the ends that are nearest to each other, and reverses one if necessary. */
async function joinedAtEnds(a: RemoteCurve, b: RemoteCurve): Promise<RemoteCurve> {
  const ends = async (curve: RemoteCurve) => {
    const { segmentCount } = await curve.view();
    const points = await Promise.all([curve.pointAt(0), curve.pointAt(segmentCount)]);
    return points.map(({ position }) => position) as [Place, Place];
  };
  const [[startA, endA], [startB, endB]] = await Promise.all([ends(a), ends(b)]);
  const ways = [far(endA, startB), far(endA, endB), far(startA, endB), far(startA, startB)];
  const way = ways.indexOf(Math.min(...ways));
  if (way === 1) await b.reverse();
  if (way === 3) await a.reverse();
  return way === 2 ? b.join(a) : a.join(b);
}
