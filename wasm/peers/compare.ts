import { KarcherError } from '../errors.js';
import type { Mesh } from '../mesh.js';
import type { Path } from '../path.js';
import { toSurfacePoint, wirePoint } from '../points.js';
import type { CurveSamples, LongWorkOptions } from '../types.js';
import { type DragMeasures, measureDrag } from './drag.js';
import { alongPath, type CurveMeasures, CurveMeter, type ReferenceSamples } from './measure.js';
import { nextCorner } from './next_corner.js';
import type { Peers } from './peers.js';
import { comparedMethods } from './prepared_method.js';
import type { Ruler, RulerMeasures } from './ruler.js';
import { isThere } from './status.js';
import type {
  ComparedLine,
  ComparedMethod,
  CurvePlan,
  LogMapCounts,
  MethodCurve,
  MethodOptions,
  PreparedCurves,
} from './types.js';
import { warm } from './warm.js';

export { comparedMethods };

/** The results of a method on a mesh; null stands for a missing number. */
export interface MethodResult {
  /** Whether the method gave a curve. */
  ok: boolean;
  /**
   * The reason why the method failed or why some numbers are missing; null if there is no such
   * reason.
   */
  reason: string | null;
  /**
   * The time of the preparation, which a mesh needs once. It excludes the data that every method
   * needs: neighbours, angles, frames.
   */
  prepareMs: number | null;
  /**
   * The time to compute the curve, including all fields, log maps or distances, but not the paths
   * that join the samples.
   */
  traceMs: number | null;
  /** The part of `traceMs` that the fields of the points take; 0 for methods without fields. */
  fieldsMs: number | null;
  /**
   * The time to move the middle point to the next corner and to trace again the segments that the
   * point affects.
   */
  dragMs: number | null;
  /** The part of `dragMs` that the point's field takes. */
  dragFieldMs: number | null;
  /** The memory of the method and its curve, in bytes, without the mesh. */
  memory: number | null;
  /** The number of samples. */
  samples: number | null;
  /** The number of samples that are lost (`isThere`). */
  lost: number | null;
  /**
   * The number of samples that the method's own authors would not accept
   * (`MethodCurve.lostByOwnRule`).
   */
  lostByOwnRule: number | null;
  /**
   * The numbers and the time of a heat method's log maps. A library that computes a map at each
   * request takes about `traceMs + ms * (asked - made) / made`.
   */
  logMaps: LogMapCounts | null;
  /** The distances from the reference (`CurveMeasures.deviation`). */
  deviation: CurveMeasures['deviation'];
  /** The unevenness of the curve's turning (`CurveMeasures.turningNoise`). */
  turningNoise: number | null;
  /** The number of places where the curve leaps (`CurveMeasures.breaks`). */
  breaks: number | null;
  /** The largest angle at a sample (`CurveMeasures.sharpestTurn`). */
  sharpestTurn: CurveMeasures['sharpestTurn'];
  /** The measurements by exact shortest paths, made alike for all methods; null without a ruler. */
  ruler: RulerMeasures | null;
  /** The steadiness of the curve in a drag; null without a drag. */
  drag: DragMeasures | null;
}

/** A result, with the curve if the method gave one. */
export interface MethodRun extends MethodResult {
  /** The samples and the line through them; null if the method failed. */
  curve: ({ samples: CurveSamples } & ComparedLine) | null;
}

export interface CompareOptions extends LongWorkOptions {
  /** The time limit in milliseconds. A method gives up at its first step after this time. */
  budgetMs?: number;
  /**
   * Whether to omit the drag and the repetitions of short measurements, for figures that only show
   * the curve.
   */
  once?: boolean;
  /** The ruler that measures the curve by exact shortest paths. */
  ruler?: Ruler;
  /** The number of steps of the drag that measures the curve's steadiness; 0 for no drag. */
  dragSteps?: number;
}

/**
 * The standard options of a method for a curve. The paper's method has exact distances for two
 * points, and otherwise graph distances with k = 6, as in the paper's Table 1. Its searches start
 * as in the program of the paper's authors.
 */
export function standardOptions(method: ComparedMethod, plan: CurvePlan): MethodOptions {
  if (method === 'karcher') return { method, solver: 'fast' };
  if (method !== 'paper') return { method };
  const exact = plan.points.length === 2;
  return {
    method,
    seeds: 'authors',
    ...(exact ? { solver: 'exact' } : { solver: 'graph', rings: 6 }),
  };
}

/** A description in words of how a method with these options finds distances or log maps. */
export function solverWords(options: MethodOptions): string {
  const { method, solver, rings = 6, star = 'wide', seeds = 'heaviest' } = options;
  const delaunay = options.delaunay ? ', on the intrinsic Delaunay triangulation' : '';
  switch (method) {
    case 'vectorHeat':
      return `log maps by heat flow${delaunay}`;
    case 'affineHeat':
      return `log maps by affine heat flow${delaunay}`;
    case 'weightedAverages':
      return `an embedding of ${options.landmarks ?? 500} landmarks, ${options.landmarkDistances ?? 'fast'} distances`;
    case 'descent':
      return 'exact distances at the vertices';
    case 'bSurf':
      return 'averages of two points along geodesics';
    case 'leveled':
      if (options.levels === 0) return 'fast distances; bridges over jumps and lost samples';
      return 'near fields of a refined control polygon';
    case 'paper': {
      const faces = star === 'ring' ? 'around a vertex' : 'around a vertex and beyond';
      const start = seeds === 'authors' ? 'authors’ seeds' : 'seeds at the heaviest points';
      const found = solver === 'graph' ? `graph distances, k = ${rings}` : 'exact distances';
      return `${found}; gradients of the faces ${faces}; ${start}`;
    }
    case 'karcher': {
      if (solver === 'graph') return `graph distances, k = ${rings}`;
      return `${solver ?? 'fast'} distances`;
    }
  }
}

/**
 * The options of the reference for curves of more than two points: log vectors of exact distances
 * with the quadratic estimator.
 */
export const referenceOptions: MethodOptions = { method: 'karcher', solver: 'exact' };

/**
 * The reference: for two points the exact shortest path, else the curve of `referenceOptions`.
 * Throws what `Peers.prepare` and `PreparedMethod.curve` throw.
 */
export async function traceReference(
  peers: Peers,
  mesh: Mesh,
  plan: CurvePlan,
  work: LongWorkOptions = {},
): Promise<{ samples: ReferenceSamples; path: Path }> {
  const method = await peers.prepare(mesh, referenceOptions, work);
  try {
    const curve = method.curve(plan);
    if (plan.points.length === 2) {
      const path = mesh.shortestPath(plan.points[0]!, plan.points[1]!);
      return { samples: alongPath(path, plan.table), path };
    }
    await curve.trace(work);
    return { samples: curve.samples(), path: curve.line().path };
  } finally {
    method.dispose();
  }
}

/**
 * Prepares a method on its own copy of the mesh, so that it shares no computed data. Traces the
 * curve, drags a point and measures the curve against a reference. If the method fails, the result
 * has the reason and the values measured before. Rejects with the signal's reason.
 */
export async function runMethod(
  peers: Peers,
  mesh: Mesh,
  plan: CurvePlan,
  options: MethodOptions,
  reference: ReferenceSamples | null,
  {
    progress,
    signal,
    budgetMs = Number.POSITIVE_INFINITY,
    once = false,
    ruler,
    dragSteps = 0,
  }: CompareOptions = {},
): Promise<MethodRun> {
  const run: MethodRun = { ...nothingMeasured, curve: null };
  const budget = new Budget(budgetMs, signal);
  const work: LongWorkOptions = {
    signal: budget.signal,
    progress: (done, stage) => {
      budget.check();
      progress?.(done, stage);
    },
  };
  const own = peers.karcher.meshFromArrays(mesh.positions(), mesh.triangles());
  let method: PreparedCurves | undefined;
  try {
    await warm(peers, options);
    const before = peers.karcher.allocatedBytes();
    method = await peers.prepare(own, options, work);
    run.prepareMs = method.prepareMs;
    const curve = method.curve(plan);
    run.traceMs = await curve.trace(work);
    run.fieldsMs = curve.fieldsMs;
    run.memory = Math.max(0, peers.karcher.allocatedBytes() - before);
    run.curve = { samples: curve.samples(), ...curve.line() };
    Object.assign(run, measures(mesh, run.curve.samples, reference));
    run.lostByOwnRule = curve.lostByOwnRule();
    run.logMaps = curve.logMaps();
    // If more than half of the samples are lost, the result is no curve.
    run.ok = run.lost! <= run.samples! / 2;
    if (!run.ok) run.reason = `${run.lost} of ${run.samples} samples did not converge`;
    if (dragSteps > 0 && run.ok) {
      const dragged = method.curve(plan);
      await dragged.trace(work);
      run.drag = await measureDrag(dragged, own, plan, dragSteps, work);
      dragged.dispose();
    }
    if (!once && run.ok) await repeat(run, { peers, method, curve, mesh: own, plan, work });
  } catch (error) {
    signal?.throwIfAborted();
    // If the time ran out after the curve was complete, the curve counts. Missing numbers are null.
    run.ok = run.ok && budget.reason !== null;
    run.reason = budget.reason ?? reasonOf(error);
  } finally {
    method?.dispose();
    own.dispose();
  }
  // The ruler works outside the method's budget, since its time is not the method's.
  if (ruler && run.curve) run.ruler = await ruler.measure(run.curve.samples, { progress, signal });
  return run;
}

/** A time limit. It ends longer work at the first step after the limit. */
class Budget {
  readonly signal: AbortSignal;
  /** The reason why the budget ended the work; null if it did not. */
  reason: string | null = null;
  readonly #controller = new AbortController();
  readonly #start = performance.now();
  readonly #milliseconds: number;

  constructor(milliseconds: number, signal?: AbortSignal) {
    this.#milliseconds = milliseconds;
    const own = this.#controller.signal;
    this.signal = signal ? AbortSignal.any([signal, own]) : own;
  }

  check(): void {
    if (performance.now() - this.#start <= this.#milliseconds) return;
    this.reason ??= `stopped after ${Math.round(this.#milliseconds / 1000)} s`;
    this.#controller.abort();
  }
}

/** The result of a method before any measurement. */
export const nothingMeasured: MethodResult = {
  ok: false,
  reason: null,
  prepareMs: null,
  traceMs: null,
  fieldsMs: null,
  dragMs: null,
  dragFieldMs: null,
  memory: null,
  samples: null,
  lost: null,
  lostByOwnRule: null,
  logMaps: null,
  deviation: null,
  turningNoise: null,
  breaks: null,
  sharpestTurn: null,
  ruler: null,
  drag: null,
};

function measures(mesh: Mesh, samples: CurveSamples, reference: ReferenceSamples | null) {
  if (reference !== null) return new CurveMeter(mesh).measure(samples, reference);
  const lost = samples.status.filter((status) => !isThere(status)).length;
  return { samples: samples.count, lost };
}

/** The reason why a method failed. Rethrows other errors, which are errors of the program. */
function reasonOf(error: unknown): string {
  if (error instanceof KarcherError) return error.message;
  throw error;
}

/**
 * The largest number of runs of short work. Short work runs several times, since a first run is
 * slower than later runs.
 */
const mostRuns = 5;
const longEnoughMs = 400;

interface Repeated {
  peers: Peers;
  method: PreparedCurves;
  curve: MethodCurve;
  /** The mesh of the method. */
  mesh: Mesh;
  plan: CurvePlan;
  work: LongWorkOptions;
}

/** Sets the median times of the preparation, the trace and the drag. */
async function repeat(run: MethodRun, repeated: Repeated): Promise<void> {
  const { method, curve, mesh, plan, work } = repeated;
  // Each repetition needs a new curve. In the same curve, a point that returns to an earlier place
  // would find its cached field.
  const traces = [run.traceMs!];
  const fields = [run.fieldsMs!];
  const logMaps = [run.logMaps?.ms ?? 0];
  const drags = [await drag(curve, mesh, plan, work)];
  const dragFields = [curve.fieldsMs];
  run.dragMs = drags[0]!;
  run.dragFieldMs = dragFields[0]!;
  curve.dispose();
  await whileQuick(traces[0]! + drags[0]!, async () => {
    const again = method.curve(plan);
    traces.push(await again.trace(work));
    fields.push(again.fieldsMs);
    logMaps.push(again.logMaps()?.ms ?? 0);
    drags.push(await drag(again, mesh, plan, work));
    dragFields.push(again.fieldsMs);
    again.dispose();
    return traces.at(-1)! + drags.at(-1)!;
  });
  run.traceMs = median(traces);
  run.fieldsMs = median(fields);
  if (run.logMaps) run.logMaps.ms = median(logMaps);
  run.dragMs = median(drags);
  run.dragFieldMs = median(dragFields);
  run.prepareMs = await medianPreparation(repeated);
}

/**
 * The median time of the method's own preparation and of further preparations, each on a new copy
 * of the mesh.
 */
async function medianPreparation({ peers, method, mesh, work }: Repeated): Promise<number> {
  const times = [method.prepareMs];
  await whileQuick(times[0]!, async () => {
    const copy = peers.karcher.meshFromArrays(mesh.positions(), mesh.triangles());
    try {
      const again = await peers.prepare(copy, method.options, work);
      times.push(again.prepareMs);
      again.dispose();
    } finally {
      copy.dispose();
    }
    return times.at(-1)!;
  });
  return median(times);
}

/**
 * Repeats work until all runs together took `longEnoughMs`, or `mostRuns` times. `spent` is the
 * time of the first run in milliseconds; `run` returns the time of each further run.
 */
async function whileQuick(spent: number, run: () => Promise<number>): Promise<void> {
  for (let all = spent, runs = 1; all < longEnoughMs && runs < mostRuns; runs++) all += await run();
}

/**
 * Moves the middle point to the next corner, and traces all segments that the point affects.
 * Returns the duration of the trace.
 */
function drag(curve: MethodCurve, mesh: Mesh, { points }: CurvePlan, work: LongWorkOptions) {
  const middle = Math.floor(points.length / 2);
  const wire = wirePoint(points[middle]!);
  const here = toSurfacePoint(mesh.handle.call((target) => target.checkedPoint(wire)));
  curve.movePoint(middle, nextCorner(here));
  return curve.trace(work);
}

function median(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)]!;
}
