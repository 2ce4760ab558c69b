/** Figures that are splines, in the engine's form and back. */
import type { CurveOptions, CurveValue, FieldOptions } from 'karcher';
import {
  askedLevels,
  type ControlPoint,
  defaultSettings,
  type Figure,
  isSpline,
  type Kind,
  parameterOf,
  type Spline,
  withLeg,
  withParameter,
} from './figure';
import { legsOf, waypointsOf } from './legs';

/** A figure as a spline; null if it is another figure or has no points. */
export function splineOf({ kind, settings, points }: Figure): Spline | null {
  return isSpline(kind) && points.length > 0 ? { kind, settings, points } : null;
}

/** The figure with another spline in place of its own. */
export const withSpline = (figure: Figure, spline: Spline): Figure => ({
  ...figure,
  ...spline,
});

/**
 * Whether a kind allows levels. Curves of the other kinds are means of all their points, or paths.
 */
export const mayHaveLevels = (kind: Kind) =>
  ['bspline', 'bezier', 'rational', 'catmullrom', 'pen'].includes(kind);

/** Whether a kind follows the legs of its control polygon, or consists of them. */
export const usesLegs = (kind: Kind) => kind === 'polyline' || mayHaveLevels(kind);

/** A spline in the engine's form, with the settings that its kind uses. */
export function curveOptions(spline: Spline, options: FieldOptions): CurveOptions {
  const { kind, points, settings } = spline;
  const { closed, degree, clamped, knots, parametrization, samples, tolerance } = settings;
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
    // The paper's method allows no levels.
    ...(options.method !== 'paper' && askedLevels(settings)),
    ...(kind === 'bspline' && { degree, knots: knots ? [...knots] : rule }),
    ...(kind === 'catmullrom' && { parametrization }),
    ...(parameter === 'weight' && !plain && { weights: numbers }),
    ...(parameter === 'beta' && !plain && { betas: numbers }),
  };
}

/** The engine's edited curve as a spline of the drawing; other settings are those of `before`. */
export function splineFrom(options: CurveValue, before: Spline): Spline {
  const { kind, closed = false, degree, knots, parametrization, legs = [] } = options;
  if (kind === 'custom') throw new Error('the page has no curves with a basis of their own');
  const parameter = parameterOf(kind);
  const numbers = parameter === 'beta' ? options.betas : options.weights;
  const points = options.points.map((point, i): ControlPoint => {
    if ('vertex' in point) throw new Error('the engine gives points of faces');
    const { face, bary } = point;
    const plain = withLeg({ face, bary: [...bary] }, waypointsOf(legs[i]));
    return parameter ? withParameter(plain, parameter, numbers?.[i] ?? 1) : plain;
  });
  const settings = {
    ...(before.settings ?? defaultSettings),
    closed,
    ...(degree !== undefined && { degree }),
    ...(parametrization !== undefined && { parametrization }),
    // The knots of other curves do not say whether B-splines are clamped.
    ...(kind === 'bspline' && !closed && { clamped: knots === 'clamped' }),
    knots: knots === undefined || typeof knots === 'string' ? null : Array.from(knots),
  };
  return { kind, settings, points };
}
