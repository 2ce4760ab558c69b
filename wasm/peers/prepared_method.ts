import {
  checkArray,
  checkBoolean,
  checkInteger,
  checkOneOf,
  checkOptions,
  namesOf,
  toFloat64,
  toInt32,
} from '../check.js';
import type { Handle } from '../engine.js';
import { KarcherError } from '../errors.js';
import type { Mesh } from '../mesh.js';
import { checkLongWork, engineFieldOptions } from '../options.js';
import { toSurfacePoint, wirePoints } from '../points.js';
import { prepareGraph } from '../prepare.js';
import type { LongWorkOptions, PointLike } from '../types.js';
import { ComparedCurve } from './compared_curve.js';
import { EngineMethod, isOfEngine } from './engine_method.js';
import type { EngineMethodOptions, EnginePreparedMethod, PeersModule } from './karcher-peers.mjs';
import type {
  ComparedCenter,
  ComparedMethod,
  CurvePlan,
  MethodOptions,
  PreparedCurves,
  WeightTable,
} from './types.js';

/** The methods, in the order of tables. */
export const comparedMethods: readonly ComparedMethod[] = [
  'vectorHeat',
  'affineHeat',
  'weightedAverages',
  'descent',
  'bSurf',
  'paper',
  'karcher',
  'leveled',
];

const defaultLandmarks = 500;
const methodOptionNames = namesOf<MethodOptions>({
  method: true,
  solver: true,
  rings: true,
  star: true,
  levels: true,
  seeds: true,
  delaunay: true,
  adaptive: true,
  landmarks: true,
  landmarkDistances: true,
});

const planNames = namesOf<CurvePlan>({ points: true, first: true, table: true, shape: true });
const tableNames = namesOf<WeightTable>({ points: true, t: true, weights: true });

/** A method prepared on a mesh, until `dispose`. */
export class PreparedMethod implements PreparedCurves {
  readonly options: MethodOptions;
  /** The duration of the preparation in milliseconds, without pauses. */
  readonly prepareMs: number;
  readonly #module: PeersModule;
  readonly #handle: Handle<EnginePreparedMethod>;

  /** @internal `Peers.prepare` creates one. */
  constructor(
    module: PeersModule,
    options: MethodOptions,
    handle: Handle<EnginePreparedMethod>,
    prepareMs: number,
  ) {
    this.#module = module;
    this.#handle = handle;
    this.options = { ...options };
    this.prepareMs = prepareMs;
  }

  /**
   * A curve without samples yet. Throws `KarcherError`: badIndex, badPoint, badWeights,
   * unreachable, and badArgument for a curve that the method does not support.
   */
  curve(plan: CurvePlan): ComparedCurve {
    checkOptions(plan, planNames);
    checkOptions(plan.table, tableNames);
    const points = wirePoints(plan.points);
    const first = toInt32(plan.first, 'the first points of the segments');
    const t = toFloat64(plan.table.t, 'the parameters');
    const weights = toFloat64(plan.table.weights, 'the weights');
    const handle = this.#handle.made('the curve', (method) =>
      this.#module.comparedCurve(method, points, first, t, weights),
    );
    return new ComparedCurve(handle);
  }

  /**
   * The center of mass of points with weights that sum to 1. The search starts at `start` or at the
   * point of the largest weight. Throws what `curve` throws.
   */
  centerOfMass(
    points: readonly PointLike[],
    weights: ArrayLike<number>,
    options: { start?: PointLike } = {},
  ): ComparedCenter {
    checkOptions(options, ['start']);
    const { start } = options;
    checkArray(points, 'the points');
    const row = toFloat64(weights, 'the weights');
    const table = { points: points.length, t: Float64Array.of(0), weights: row };
    const curve = this.curve({ points, first: [0], table });
    try {
      if (start !== undefined) curve.startAt(start);
      curve.finish();
      const { face, bary, position, status } = curve.samples();
      return {
        point: toSurfacePoint(Float64Array.of(face[0]!, ...bary)),
        position: [position[0]!, position[1]!, position[2]!],
        status: status[0]!,
      };
    } finally {
      curve.dispose();
    }
  }

  /** Frees the memory of the method and its curves. A second call has no effect. */
  dispose(): void {
    this.#handle.dispose();
  }
}

/** @internal */
export async function prepareMethod(
  module: PeersModule,
  mesh: Mesh,
  options: MethodOptions,
  work: LongWorkOptions,
): Promise<PreparedCurves> {
  const wire = engineOptions(options);
  checkLongWork(work);
  const { progress, signal } = work;
  signal?.throwIfAborted();
  const { method } = options;
  if (isOfEngine(method)) return new EngineMethod(mesh, { ...options, method });
  let worked = 0;
  if (wire.field.solver === 'graph') {
    worked += await prepareGraph(mesh.handle, mesh.info.triangles, wire.field.rings, work);
  }
  const start = performance.now();
  const handle = mesh.handle.made('the method', (target) =>
    module.prepareMethod(target, wire, (landmarks) => {
      progress?.(Math.min(landmarks / wire.landmarks, 1), 'landmarks');
      return !signal?.aborted;
    }),
  );
  worked += performance.now() - start;
  return new PreparedMethod(module, options, handle, worked);
}

function engineOptions(options: MethodOptions): EngineMethodOptions {
  checkOptions(options, methodOptionNames);
  const method = checkOneOf(options.method, comparedMethods, 'a method');
  const ours = method === 'paper' || method === 'karcher';
  const { solver, rings, star } = options;
  checkMeant('seeds', options.seeds, ours, "'paper' and 'karcher'");
  checkMeant('star', options.star, method === 'paper', "'paper'");
  checkMeant('levels', options.levels, method === 'leveled', "'leveled'");
  return {
    method,
    field: engineFieldOptions(ours ? { method, solver, rings, star } : {}),
    seeds: checkOneOf(options.seeds ?? 'heaviest', ['heaviest', 'authors'] as const, 'seeds'),
    delaunay: checkBoolean(options.delaunay ?? false, 'delaunay'),
    adaptive: checkBoolean(options.adaptive ?? false, 'adaptive'),
    landmarks: checkInteger(options.landmarks ?? defaultLandmarks, 'the number of landmarks'),
    landmarkDistances: checkOneOf(
      options.landmarkDistances ?? 'fast',
      ['fast', 'exact'] as const,
      'the distances of the landmarks',
    ),
  };
}

/** Throws if the caller sets an option that the method does not use. */
function checkMeant(name: string, value: unknown, isMeant: boolean, methods: string): void {
  if (value === undefined || isMeant) return;
  throw new KarcherError('badArgument', `the option '${name}' is for the method ${methods} only`);
}
