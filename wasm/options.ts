import {
  badArgument,
  checkFunction,
  checkInteger,
  checkNumber,
  checkOneOf,
  checkOptions,
  checkPositive,
  namesOf,
  shown,
} from './check.js';
import type { EngineFieldOptions } from './karcher-engine.mjs';
import type {
  ArcOptions,
  CenterOptions,
  CentersOptions,
  CircleOptions,
  CurveLevels,
  CurveOptions,
  DistanceOptions,
  EllipseOptions,
  FieldOptions,
  IsolineOptions,
  LevelsTolerance,
  LongWorkOptions,
  MeshOptions,
  Method,
  OffsetOptions,
  PolylineOptions,
  RadiusOptions,
  RegionOptions,
  Solver,
  Star,
  StartOptions,
  WeightsOptions,
} from './types.js';

const field = { method: true, solver: true, rings: true, star: true } as const;
export const fieldOptionNames = namesOf<FieldOptions>(field);
const radius = { radius: true } as const;
export const radiusOptionNames = namesOf<RadiusOptions>(radius);
export const distanceOptionNames = namesOf<DistanceOptions & RadiusOptions>({
  ...radius,
  solver: true,
  rings: true,
});
const polylineOptionNames = namesOf<PolylineOptions>({ bits: true });
const longWorkOptionNames = namesOf<LongWorkOptions>({ progress: true, signal: true });
const meshOptionNames = namesOf<MeshOptions>({ repair: true, weld: true });
const start = { start: true, normalize: true } as const;
export const startOptionNames = namesOf<StartOptions>(start);
export const centerOptionNames = namesOf<CenterOptions>({
  ...field,
  ...start,
  uniqueness: true,
  certificate: true,
});
export const centersOptionNames = namesOf<CentersOptions>({ ...field, ...start, check: true });
export const weightsOptionNames = namesOf<WeightsOptions>({
  ...field,
  weights: true,
  nonNegative: true,
});
export const curveOptionNames = namesOf<CurveOptions>({
  ...field,
  kind: true,
  points: true,
  legs: true,
  samples: true,
  tolerance: true,
  geometry: true,
  levels: true,
  leastLevels: true,
  closed: true,
  degree: true,
  knots: true,
  weights: true,
  betas: true,
  parametrization: true,
  basis: true,
});
const arcs = { ...field, arcs: true, samples: true, levels: true } as const;
export const circleOptionNames = namesOf<CircleOptions>({ ...arcs, radius: true, tolerance: true });
export const ellipseOptionNames = namesOf<EllipseOptions>({
  ...arcs,
  radii: true,
  direction: true,
});
export const offsetOptionNames = namesOf<OffsetOptions>({
  distance: true,
  side: true,
  corners: true,
  miterLimit: true,
});
/** The sides, in the order of the engine's numbers -1, 0 and 1. */
export const offsetSides = ['right', 'both', 'left'] as const;

/** The shapes of corners, in the order of the engine. */
export const cornerShapes = ['round', 'miter', 'bevel'] as const;

export const isolineOptionNames = namesOf<IsolineOptions>({
  radius: true,
  type: true,
  solver: true,
  rings: true,
});
export const regionOptionNames = namesOf<RegionOptions>({ rule: true, combine: true });

/**
 * The names of methods, solvers and stars that callers may give. The first method is the default.
 */
export const methods: readonly Method[] = ['karcher', 'paper'];
const solvers: readonly Solver[] = ['fast', 'exact', 'graph'];
const stars: readonly Star[] = ['wide', 'ring'];
const defaultRings = 6;

/** Field options with all defaults, in the engine's form. */
export function engineFieldOptions(options: FieldOptions): EngineFieldOptions {
  const method = checkOneOf(options.method ?? methods[0]!, methods, 'the method');
  const byDefault = method === 'paper' ? 'exact' : 'fast';
  const solver = checkOneOf(options.solver ?? byDefault, solvers, 'the solver');
  const rings = checkInteger(options.rings ?? defaultRings, 'the number of rings');
  if (options.rings !== undefined && solver !== 'graph') {
    throw badArgument(`the solver '${solver}' has no rings; 'graph' has`);
  }
  const star = checkOneOf(options.star ?? stars[0]!, stars, 'the star');
  return { method, solver, rings, star };
}

/** The radius up to which a result is computed; Infinity by default. */
export const checkRadius = ({ radius = Infinity }: RadiusOptions): number =>
  radius === Infinity ? radius : checkPositive(radius, 'the radius');

/** The engine's numbers for `auto` and `limit`. */
const namedLevels = { auto: -1, limit: -2 } as const;
const mostLevels = 8;
const defaultLevelsTolerance = 0.02;

/** The levels of a curve or of a circle's arcs, in the engine's form. */
export function engineLevels({ levels = 'auto' }: { levels?: CurveLevels | undefined }): number {
  if (levels === 'auto' || levels === 'limit') return namedLevels[levels];
  const number = checkInteger(levels, "the levels, unless 'auto' or 'limit',");
  if (number >= 0 && number <= mostLevels) return number;
  throw badArgument(`a curve takes 0 to ${mostLevels} levels, 'auto' or 'limit', not ${number}`);
}

/** The arcs, samples, levels and field of a circle or an ellipse, in the engine's order. */
export function engineArcs(options: ArcOptions) {
  const { arcs, samples = 32 } = options;
  return [
    arcs === undefined ? arcs : checkInteger(arcs, 'the number of arcs'),
    checkInteger(samples, 'the number of samples'),
    engineLevels(options),
    engineFieldOptions(options),
  ] as const;
}

/** The options that determine a curve's levels. Tolerances are in mean edges. */
export function engineCurveLevels({ levels = 'auto', leastLevels = 0 }: CurveOptions): {
  levels: number;
  levelsTolerance: number;
  leastLevels: number;
} {
  const tolerance = (levels as Partial<LevelsTolerance> | null)?.tolerance;
  const automatic = levels === 'auto' || tolerance !== undefined;
  checkInteger(leastLevels, 'the least number of levels');
  if (leastLevels !== 0 && !automatic) {
    throw badArgument(`a least number of levels is for levels: 'auto', not ${levels}`);
  }
  return {
    levels: automatic ? namedLevels.auto : engineLevels({ levels: levels as CurveLevels }),
    levelsTolerance:
      tolerance === undefined
        ? defaultLevelsTolerance
        : tolerance === Infinity
          ? tolerance
          : checkNumber(tolerance, 'the tolerance of levels'),
    leastLevels,
  };
}

/** The options for reading a mesh, in the engine's form. */
export function engineMeshOptions(options: MeshOptions): { repair: boolean; weld: number } {
  checkOptions(options, meshOptionNames);
  const repair = checkOneOf(options.repair ?? 'safe', ['safe', 'none'], 'the repair') === 'safe';
  if (options.weld === undefined) return { repair, weld: -1 };
  const weld = checkNumber(options.weld, 'the tolerance of welding');
  if (weld < 0) {
    throw badArgument(`the tolerance of welding must be at least 0, not ${weld}`);
  }
  if (!repair) {
    throw badArgument("a tolerance of welding has no use with repair: 'none'");
  }
  return { repair, weld };
}

/** Whether a polyline is to have 64-bit coordinates. */
export function inDouble(options: PolylineOptions): boolean {
  checkOptions(options, polylineOptionNames);
  return checkOneOf(options.bits ?? 32, [32, 64], 'the bits of a polyline') === 64;
}

export function checkLongWork(work: LongWorkOptions): void {
  checkOptions(work, longWorkOptionNames);
  const { progress, signal } = work;
  if (progress !== undefined) checkFunction(progress, 'progress');
  // An instanceof would reject a signal of another realm.
  if (signal !== undefined && typeof signal?.throwIfAborted !== 'function') {
    throw badArgument(`the signal must be an AbortSignal, not ${shown(signal)}`);
  }
}
