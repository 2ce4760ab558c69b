import { checkInteger, checkOneOf } from './check.js';
import type { EngineFieldOptions } from './karcher-engine.mjs';
import type {
  CenterOptions,
  CircleOptions,
  CurveOptions,
  EllipseOptions,
  FieldOptions,
  IsolineOptions,
  LongWorkOptions,
  Method,
  Solver,
} from './types.js';

/** The names of all of a type's options; the compiler misses none. */
export const namesOf = <Options>(all: Record<keyof Options, true>): readonly string[] =>
  Object.keys(all);

const field = { method: true, solver: true, rings: true } as const;
export const fieldOptionNames = namesOf<FieldOptions>(field);
export const longWorkOptionNames = namesOf<LongWorkOptions>({ progress: true, signal: true });
export const centerOptionNames = namesOf<CenterOptions>({ ...field, start: true, normalize: true });
export const curveOptionNames = namesOf<CurveOptions>({
  ...field,
  kind: true,
  points: true,
  samples: true,
  tolerance: true,
  geometry: true,
  closed: true,
  degree: true,
  knots: true,
  weights: true,
  betas: true,
  parametrization: true,
  basis: true,
});
const arcs = { ...field, center: true, arcs: true, samples: true } as const;
export const circleOptionNames = namesOf<CircleOptions>({ ...arcs, radius: true });
export const ellipseOptionNames = namesOf<EllipseOptions>({
  ...arcs,
  radii: true,
  direction: true,
});
export const isolineOptionNames = namesOf<IsolineOptions>({
  center: true,
  radius: true,
  type: true,
  solver: true,
  rings: true,
});

/** The names that callers may give; the first method is the default. */
export const methods: readonly Method[] = ['karcher', 'paper'];
export const solvers: readonly Solver[] = ['fast', 'exact', 'graph'];
export const defaultRings = 6;

/** Field options with every default filled in, as the engine takes them. */
export function engineFieldOptions(options: FieldOptions): EngineFieldOptions {
  const method = options.method ?? methods[0]!;
  const solver = options.solver ?? (method === 'paper' ? 'exact' : 'fast');
  return {
    method: checkOneOf(method, methods, 'the method'),
    solver: checkOneOf(solver, solvers, 'the solver'),
    rings: checkInteger(options.rings ?? defaultRings, 'the number of rings'),
  };
}
