import { KarcherError } from '../errors.js';
import type { Mesh } from '../mesh.js';
import type { Path } from '../path.js';
import { nextCorner, toSurfacePoint, wirePoint } from '../points.js';
import type { CurveSamples, LongWorkOptions } from '../types.js';
import { type DragMeasures, measureDrag } from './drag.js';
import { alongPath, type CurveMeasures, CurveMeter, type ReferenceSamples } from './measure.js';
import type { Peers } from './peers.js';
import { comparedMethods } from './prepared_method.js';
import type { Ruler, RulerMeasures } from './ruler.js';
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

/** What a method did on a mesh; null is a number that was not measured. */
export interface MethodResult {
  /** Whether the method gave a curve. */
  ok: boolean;
  /** Why it failed, or what was not measured of it. */
  reason: string | null;
  /** What is done once for the mesh, but for what every method needs: neighbours, angles, frames. */
  prepareMs: number | null;
  /** The curve with all its fields, log maps or distances, not joined. */
  traceMs: number | null;
  /** The part of it that is spent on the fields of the points; 0 of methods without fields. */
  fieldsMs: number | null;
  /** The middle point moved by an edge, and the segments that it touches traced again. */
  dragMs: number | null;
  /** The part of it that is spent on that point's field. */
  dragFieldMs: number | null;
  /** What the method holds with its curve, in bytes, the mesh itself apart. */
  memory: number | null;
  /** The number of samples. */
  samples: number | null;
  /** The number of samples that did not converge. */
  lost: number | null;
  /** Those that its own authors would not have accepted either (`MethodCurve.lostByOwnRule`). */
  lostByOwnRule: number | null;
  /**
   * Log maps of the heat methods. A library that computes one at each evaluation takes about
   * `traceMs * asked / made`.
   */
  logMaps: LogMapCounts | null;
  /** The distances from the reference (`CurveMeasures.deviation`). */
  deviation: CurveMeasures['deviation'];
  /** The unevenness of the curve's turning (`CurveMeasures.turningNoise`). */
  turningNoise: number | null;
  /** Where the curve leaps (`CurveMeasures.breaks`). */
  breaks: number | null;
  /** The largest angle at a sample (`CurveMeasures.sharpestTurn`). */
  sharpestTurn: CurveMeasures['sharpestTurn'];
  /** By exact shortest paths, the same for all methods; null where no ruler was given. */
  ruler: RulerMeasures | null;
  /** How the curve follows a hand; null where no drag was asked for. */
  drag: DragMeasures | null;
}

/** A result with the curve itself, where there is one. */
export interface MethodRun extends MethodResult {
  /** The samples and the line through them; null where the method failed. */
  curve: ({ samples: CurveSamples } & ComparedLine) | null;
}

export interface CompareOptions extends LongWorkOptions {
  /** A method gives up when it has worked for so long, in milliseconds, between two steps. */
  budgetMs?: number;
  /** Leaves out the drag, and the repetitions of what is quickly done: for figures that only show. */
  once?: boolean;
  /** Measures the curve by exact shortest paths too. */
  ruler?: Ruler;
  /** Drags a control point in so many steps, and measures how the curve follows; 0 for none. */
  dragSteps?: number;
}

/**
 * How each method is set up for a curve. The paper's distances are exact for two points, and on the graph
 * with k = 6 else, as in its Table 1; its searches start as its authors' do.
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

/** How a method is set up, in words: what finds its distances, or its log maps. */
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

/** Log vectors of exact distances with the quadratic estimator: what curves of more than two points
 * are measured against. */
export const referenceOptions: MethodOptions = { method: 'karcher', solver: 'exact' };

/**
 * The reference: for two points the exact shortest path, else the curve of `referenceOptions`.
 * Throws as `Peers.prepare` and `PreparedMethod.curve` do.
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
 * Prepares a method on a copy of the mesh of its own, so that it finds nothing that others made;
 * traces the curve, drags a point and measures the curve against a reference. A method that fails
 * tells why in its result; the curve's samples so far are kept.
 *
 * Rejects with the signal's reason.
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
    // With fewer it is no curve.
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
    // A curve that was traced in time stays; what is missing is null.
    run.ok = run.ok && budget.reason !== null;
    run.reason = budget.reason ?? reasonOf(error);
  } finally {
    method?.dispose();
    own.dispose();
  }
  // The time that measuring takes is not the method's.
  if (ruler && run.curve) run.ruler = await ruler.measure(run.curve.samples, { progress, signal });
  return run;
}

/** Ends work that takes too long, at the next step that can be parted. */
class Budget {
  readonly signal: AbortSignal;
  /** Why the work was ended. */
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

/** The result of a method of which nothing was measured. */
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
  const lost = samples.status.filter((status) => status !== 'converged').length;
  return { samples: samples.count, lost };
}

/** The reason of a failure that a method may have; others are not for a table. */
function reasonOf(error: unknown): string {
  if (error instanceof KarcherError) return error.message;
  throw error;
}

/** What is done in a moment is done again, since a first time is not the usual time. */
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

/** Sets the medians of all that was done once, and of drags. */
async function repeat(run: MethodRun, repeated: Repeated): Promise<void> {
  const { method, curve, mesh, plan, work } = repeated;
  // Each on a new curve: a point that comes back to where it was finds what was kept of it.
  const traces = [run.traceMs!];
  const fields = [run.fieldsMs!];
  const drags = [await drag(curve, mesh, plan, work)];
  const dragFields = [curve.fieldsMs];
  run.dragMs = drags[0]!;
  run.dragFieldMs = dragFields[0]!;
  curve.dispose();
  await whileQuick(traces[0]! + drags[0]!, async () => {
    const again = method.curve(plan);
    traces.push(await again.trace(work));
    fields.push(again.fieldsMs);
    drags.push(await drag(again, mesh, plan, work));
    dragFields.push(again.fieldsMs);
    again.dispose();
    return traces.at(-1)! + drags.at(-1)!;
  });
  run.traceMs = median(traces);
  run.fieldsMs = median(fields);
  run.dragMs = median(drags);
  run.dragFieldMs = median(dragFields);
  run.prepareMs = await medianPreparation(repeated);
}

/** The median of preparations on new copies of the mesh, the method's own among them. */
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

/** Runs work that gives its milliseconds until it took long enough, what was `spent` included. */
async function whileQuick(spent: number, run: () => Promise<number>): Promise<void> {
  for (let all = spent, runs = 1; all < longEnoughMs && runs < mostRuns; runs++) all += await run();
}

/** The middle point moved to the next corner: all segments that it touches. */
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
