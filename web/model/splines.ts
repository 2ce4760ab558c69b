/** Documents with several splines: one is edited, the others lie beside it. */
import type { CurveOptions, FieldOptions, LegPoints, SurfacePoint } from 'karcher';
import {
  type ControlPoint,
  type CurveDocument,
  defaultSettings,
  isSpline,
  type Kind,
  parameterOf,
  type Spline,
  surfacePoint,
  withParameter,
} from './document';
import { legsOf, withLeg } from './legs';

/** The spline that is edited; null where there is none. */
export function splineOf({ kind, settings, points }: CurveDocument): Spline | null {
  return isSpline(kind) && points.length > 0 ? { kind, settings, points } : null;
}

/** The document with another spline in place of the edited one. */
export const withSpline = (document: CurveDocument, spline: Spline): CurveDocument => ({
  ...document,
  ...spline,
});

/** Edits another spline of the document; the one before takes its place. */
export function activated(document: CurveDocument, index: number): CurveDocument {
  const spline = document.others[index];
  if (!spline) return document;
  const before = splineOf(document);
  const others = document.others.toSpliced(index, 1, ...(before ? [before] : []));
  return { ...withSpline(document, spline), others };
}

/** The edited spline in several pieces: the first is edited, the others lie beside it. */
export function inPieces(document: CurveDocument, pieces: readonly Spline[]): CurveDocument {
  const [first, ...rest] = pieces;
  if (!first) return document;
  return { ...withSpline(document, first), others: [...document.others, ...rest] };
}

/** The document with the edited spline and another one joined. */
export function joined(document: CurveDocument, index: number, whole: Spline): CurveDocument {
  return { ...withSpline(document, whole), others: document.others.toSpliced(index, 1) };
}

/** Kinds that are subdivided; the others are one mean of all their points, or paths. */
export const mayHaveLevels = (kind: Kind) =>
  ['bspline', 'bezier', 'rational', 'catmullrom'].includes(kind);

/** Kinds that follow the legs of their control polygon, or are made of them. */
export const usesLegs = (kind: Kind) => kind === 'polyline' || mayHaveLevels(kind);

/** A spline as the engine takes it: with what its kind has a use for. */
export function curveOptions(spline: Spline, options: FieldOptions): CurveOptions {
  const { kind, points, settings } = spline;
  const { closed, degree, clamped, knots, parametrization, samples, tolerance, levels } = settings;
  const rule = clamped && !closed ? 'clamped' : 'uniform';
  const parameter = parameterOf(kind);
  const numbers = points.map((point) => (parameter && point[parameter]) ?? 1);
  const plain = numbers.every((number) => number === 1);
  return {
    ...options,
    kind,
    points: points.map(({ face, bary }) => ({ face, bary })),
    ...(tolerance === null ? { samples } : { tolerance }),
    closed,
    ...(usesLegs(kind) && legsOf(spline)),
    // The paper's method is one mean a segment.
    ...(options.method !== 'paper' && { levels }),
    ...(kind === 'bspline' && { degree, knots: knots ? [...knots] : rule }),
    ...(kind === 'catmullrom' && { parametrization }),
    ...(parameter === 'weight' && !plain && { weights: numbers }),
    ...(parameter === 'beta' && !plain && { betas: numbers }),
  };
}

/** The points of a leg as the engine gives them, with weights that a link tells to the last bit. */
export const waypointsOf = (leg: LegPoints | undefined): SurfacePoint[] | null =>
  leg?.map((point) => {
    if ('vertex' in point) throw new Error('the engine gives points of faces');
    const { face, bary } = point;
    return surfacePoint(face, bary[1], Math.min(bary[2], 1 - bary[1]));
  }) ?? null;

/** What the engine made of a spline, as one; settings that its kind has no use for are kept. */
export function splineFrom(options: CurveOptions, before: Spline): Spline {
  const { kind, closed = false, degree, knots, parametrization, legs = [] } = options;
  if (kind === 'custom') throw new Error('the page has no curves with a basis of their own');
  const parameter = parameterOf(kind);
  const numbers = parameter === 'beta' ? options.betas : options.weights;
  const points = options.points.map((point, i): ControlPoint => {
    if ('vertex' in point) throw new Error('the engine gives points of faces');
    const { face, bary } = point;
    const plain = withLeg({ face, bary }, waypointsOf(legs[i]));
    return parameter ? withParameter(plain, parameter, numbers?.[i] ?? 1) : plain;
  });
  const settings = {
    ...(before.settings ?? defaultSettings),
    closed,
    ...(degree !== undefined && { degree }),
    ...(parametrization !== undefined && { parametrization }),
    clamped: knots === 'clamped',
    knots: knots === undefined || typeof knots === 'string' ? null : Array.from(knots),
  };
  return { kind, settings, points };
}
