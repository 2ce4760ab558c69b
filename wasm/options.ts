import { checkInteger, checkOneOf } from './check.js';
import type { EngineFieldOptions } from './karcher-engine.mjs';
import type { FieldOptions, Method, Solver } from './types.js';

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
