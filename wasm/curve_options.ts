import {
  badArgument,
  checkArray,
  checkBoolean,
  checkFunction,
  checkInteger,
  checkOneOf,
  checkPositive,
  toFloat64,
} from './check.js';
import { type Callback, callback } from './engine.js';
import type {
  EngineCurveParts,
  EngineCurveShape,
  EngineCurveValue,
  EngineSampling,
} from './karcher-engine.mjs';
import { engineCurveLevels, engineFieldOptions } from './options.js';
import { toSurfacePoints, wirePointArrays, wirePoints } from './points.js';
import type {
  CurveBasis,
  CurveGeometry,
  CurveKind,
  CurveOptions,
  CurveValue,
  DrawnLeg,
  LegPoints,
  Parametrization,
} from './types.js';

const curveKinds: readonly CurveKind[] = [
  'bspline',
  'bezier',
  'rational',
  'barycentric',
  'catmullrom',
  'polyline',
  'custom',
];
const geometries: readonly CurveGeometry[] = ['geodesic', 'exact'];
const defaultSamples = 128;
const defaultTolerance = 1e-4;

const parametrizations: readonly Parametrization[] = ['centripetal', 'uniform'];

export const checkKind = (kind: unknown) => checkOneOf(kind, curveKinds, 'the kind of a curve');

/** A caller's basis in the form that the engine calls. The engine rejects an empty result. */
export interface OwnBasis extends Callback<[points: number, t: number], Float64Array> {
  /** The caller's function. */
  of: CurveBasis;
}

/** The basis of a value; `known` if the value has the same one or none. */
export function ownBasis(basis: CurveBasis | undefined, known?: OwnBasis): OwnBasis | undefined {
  if (basis === undefined || basis === known?.of) return known;
  checkFunction(basis, 'the basis');
  const weights = (points: number, t: number) =>
    toFloat64(basis(t, points), 'the weights of the basis');
  return { ...callback(weights, new Float64Array()), of: basis };
}

/** The basis of the reversed curve. */
export const mirrored = (basis: CurveBasis | undefined): CurveBasis | undefined =>
  basis && ((t, points) => Array.from(basis(1 - t, points)).reverse());

/** The options for sampling and drawing a curve, in the engine's form. */
function engineSampling(options: CurveOptions): EngineSampling {
  const { samples, tolerance } = options;
  const levels = engineCurveLevels(options);
  const geometry = options.geometry ?? 'geodesic';
  const exact = checkOneOf(geometry, geometries, 'the geometry of a curve') === 'exact';
  if (samples !== 'adaptive' && tolerance === undefined) {
    return {
      samples: checkInteger(samples ?? defaultSamples, 'the number of samples'),
      tolerance: 0,
      exact,
      ...levels,
    };
  }
  if (samples !== 'adaptive' && samples !== undefined) {
    throw badArgument('a curve takes a number of samples or a tolerance, not both');
  }
  const part = checkPositive(tolerance ?? defaultTolerance, 'the tolerance');
  return { samples: defaultSamples, tolerance: part, exact, ...levels };
}

/**
 * Options that only one kind uses, each with this kind. The engine itself rejects weights and betas
 * of other kinds.
 */
const ownOptions = [
  ['degree', 'bspline'],
  ['knots', 'bspline'],
  ['parametrization', 'catmullrom'],
  ['basis', 'custom'],
] as const satisfies readonly [keyof CurveOptions, CurveKind][];

function checkOwnOptions(options: CurveOptions): void {
  for (const [name, kind] of ownOptions) {
    if (options[name] === undefined || options.kind === kind) continue;
    throw badArgument(`a curve of the kind '${options.kind}' takes no ${name}; '${kind}' does`);
  }
}

/** The given options for samples, levels and fields, which determine a curve's trace. */
export function tracingOf(options: CurveOptions): Partial<Omit<CurveOptions, 'legs'>> {
  const { method, solver, rings, star, samples, tolerance, geometry, levels, leastLevels } =
    options;
  const all = { method, solver, rings, star, samples, tolerance, geometry, levels, leastLevels };
  return Object.fromEntries(Object.entries(all).filter(([, value]) => value !== undefined));
}

/** The options of a curve from the engine's data: only those that its kind uses. */
export function optionsOfParts(parts: EngineCurveParts): CurveValue {
  const { kind, closed, degree, clamped, centripetal, points, legs = [] } = parts;
  const given = <Name extends string>(name: Name, values: Float64Array) =>
    // Arrays are plain, so that a value survives JSON.
    (values.length > 0 ? { [name]: Array.from(values) } : {}) as { [key in Name]?: number[] };
  return {
    kind,
    closed,
    ...(kind === 'bspline' && {
      degree,
      ...(clamped ? { knots: 'clamped' as const } : given('knots', parts.knots)),
    }),
    ...(kind === 'catmullrom' && {
      parametrization: centripetal ? ('centripetal' as const) : ('uniform' as const),
    }),
    ...((kind === 'bspline' || kind === 'rational') && given('weights', parts.weights)),
    ...(kind === 'barycentric' && given('betas', parts.betas)),
    points: toSurfacePoints(points),
    ...(legs.some((leg) => leg.length > 0) && {
      legs: legs.map((leg) => (leg.length > 0 ? toSurfacePoints(leg) : null)),
    }),
  };
}

/** A curve in the engine's form. */
export function engineValue(options: CurveOptions, basis: OwnBasis | undefined): EngineCurveValue {
  const shape = engineShape(options, basis);
  const sampling = engineSampling(options);
  const field = engineFieldOptions(options);
  const points = wirePoints(options.points);
  const list = legsOf(options);
  return {
    ...{ points, shape, sampling, field },
    legs: list.map(wireLeg),
    areDrawn: Int32Array.from(list, (leg) => (isDrawn(leg) ? 1 : 0)),
  };
}

/** The legs of a value, also of an open curve's that was closed, or the other way round. */
function legsOf({ points, legs = [], closed }: CurveOptions): readonly (LegPoints | DrawnLeg)[] {
  const list = checkArray(legs, 'the legs') as readonly (LegPoints | DrawnLeg)[];
  const more = points.length - list.length;
  if (closed) return more === 1 && list.length > 0 ? [...list, null] : list;
  return more === 0 ? list.slice(0, -1) : list;
}

const isDrawn = (leg: LegPoints | DrawnLeg): leg is DrawnLeg =>
  typeof leg === 'object' && leg !== null && 'face' in leg;

function wireLeg(leg: LegPoints | DrawnLeg, i: number): Float64Array {
  if (leg === null) return new Float64Array();
  return isDrawn(leg) ? wirePointArrays(leg) : wirePoints(leg, `the points of leg ${i}`);
}

/**
 * The numbers of a list. Throws for an empty list, since in the engine an empty array stands for
 * the default.
 */
export function givenNumbers(values: ArrayLike<number>, what: string): Float64Array {
  const array = toFloat64(values, what);
  if (array.length > 0) return array;
  throw badArgument(`${what} must not be an empty array`);
}

/** The numbers of an option; empty if the caller omits it. */
export const numbersOrNone = (values: ArrayLike<number> | undefined, what: string): Float64Array =>
  values === undefined ? new Float64Array() : givenNumbers(values, what);

function engineShape(options: CurveOptions, basis: OwnBasis | undefined): EngineCurveShape {
  checkKind(options.kind);
  checkOwnOptions(options);
  const { knots = 'uniform', parametrization = 'centripetal' } = options;
  const named = typeof knots === 'string';
  if (named) checkOneOf(knots, ['uniform', 'clamped'], 'the knots');
  checkOneOf(parametrization, parametrizations, 'the parametrization');
  return {
    kind: options.kind,
    closed: checkBoolean(options.closed ?? false, 'closed'),
    degree: checkInteger(options.degree ?? 3, 'the degree'),
    clamped: knots === 'clamped',
    knots: numbersOrNone(named ? undefined : knots, 'the knots'),
    weights: numbersOrNone(options.weights, 'the weights'),
    betas: numbersOrNone(options.betas, 'the betas'),
    centripetal: parametrization === 'centripetal',
    basis: basis?.call,
  };
}
