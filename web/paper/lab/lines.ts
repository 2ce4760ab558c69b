import type { CurveSamples, LongWorkOptions } from 'karcher';
import {
  type DragMeasures,
  isThere,
  KarcherError,
  type MethodCurve,
  type MethodOptions,
  measureDrag,
  type ReferenceSamples,
  referenceOptions,
  vectors,
} from 'karcher/peers';
import { lineStyles } from '../figures/lines';
import type { LineId, LineResult, Vector } from '../figures/types';
import { circleArcs, circleDefault, isolineExact, isolineLinear } from './circles';
import { emptyLine } from './empty_line';
import { affineSamples, planOf, type Task } from './task';
import { timed } from './timed';

const { add, at, cross, distance, length, scaled, subtract } = vectors;

/**
 * A line, and the samples that exact paths measure. `samples` is null if there is nothing to
 * measure.
 */
export interface TracedLine {
  line: LineResult;
  samples: CurveSamples | null;
}

type Maker = (
  task: Task,
  id: LineId,
  reference: () => Promise<ReferenceSamples>,
  work: LongWorkOptions,
) => LineResult | TracedLine | Promise<LineResult | TracedLine>;

/** Traces one line of a panel. After a failure, the result has the reason. Rejects if aborted. */
export async function traceLine(
  task: Task,
  id: LineId,
  reference: () => Promise<ReferenceSamples>,
  work: LongWorkOptions,
): Promise<TracedLine> {
  const { options } = lineStyles[id];
  try {
    if (options) return await traceMethod(task, id, options, reference, work);
    const made = await makers[id]!(task, id, reference, work);
    return 'line' in made ? made : { line: made, samples: null };
  } catch (error) {
    work.signal?.throwIfAborted();
    if (!(error instanceof KarcherError)) throw error;
    return { line: { ...emptyLine(id), ok: false, reason: error.message }, samples: null };
  }
}

/** The number of steps in a drag. */
const dragSteps = 20;

/**
 * Measures the behaviour of a method's curve in a drag of a control point. Null for lines without a
 * method, and for methods that fail.
 */
export async function dragLine(
  task: Task,
  id: LineId,
  work: LongWorkOptions,
): Promise<DragMeasures | null> {
  const { options } = lineStyles[id];
  const plan = planOf(task);
  const { mesh } = task.scene;
  try {
    if (!options) return null;
    const curve = (await task.scene.method(options, work)).curve(plan);
    try {
      await curve.trace(work);
      return await measureDrag(curve, mesh, plan, dragSteps, work);
    } finally {
      curve.dispose();
    }
  } catch (error) {
    work.signal?.throwIfAborted();
    if (!(error instanceof KarcherError)) throw error;
    return null;
  }
}

async function traceMethod(
  task: Task,
  id: LineId,
  options: MethodOptions,
  reference: () => Promise<ReferenceSamples>,
  work: LongWorkOptions,
): Promise<TracedLine> {
  const method = await task.scene.method(options, work);
  const curve = method.curve(planOf(task));
  try {
    const traceMs = await curve.trace(work);
    const samples = curve.samples();
    const measures = task.scene.meter.measure(samples, await reference(), affineSamples(task));
    const result = {
      ...emptyLine(id),
      ...measures,
      lostByOwnRule: curve.lostByOwnRule(),
      prepareMs: method.prepareMs,
      traceMs,
    };
    if (measures.lost === measures.samples) {
      result.ok = false;
      result.reason = `no sample converged: ${samples.status[0]}`;
    }
    return { line: { ...result, ...drawn(task, curve) }, samples };
  } finally {
    curve.dispose();
  }
}

/** The visible form of a traced curve. For a center of mass it is a dot. */
function drawn(
  { curve: { kind } }: Task,
  curve: MethodCurve,
): Pick<LineResult, 'polylines' | 'status' | 'marker'> {
  if (kind === 'center') {
    return { polylines: [], status: [], marker: at(curve.samples().position, 0) };
  }
  const { path, unconverged } = curve.line();
  return { polylines: [path.polyline()], status: [unconverged], marker: null };
}

const makers: Partial<Record<LineId, Maker>> = {
  truth(task, id) {
    const samples = affineSamples(task);
    if (task.curve.kind === 'center') return { ...emptyLine(id), marker: at(samples.position, 0) };
    return { ...emptyLine(id), polylines: [Float32Array.from(samples.position)] };
  },

  exactPath(task, id) {
    const [path, traceMs] = timed(task, 0, (mesh, from, to) => mesh.shortestPath(from, to));
    return { ...emptyLine(id), traceMs, polylines: [path.polyline()] };
  },

  /** The reference does not deviate from itself, but has a residual. */
  async exactLogs(task, id, _, work) {
    const method = await task.scene.method(referenceOptions, work);
    const curve = method.curve(planOf(task));
    try {
      const traceMs = await curve.trace(work);
      const samples = curve.samples();
      const lost = samples.status.filter((status) => !isThere(status)).length;
      const counts = { samples: samples.count, lost, lostByOwnRule: lost };
      const times = { prepareMs: method.prepareMs, traceMs };
      return { line: { ...emptyLine(id), ...counts, ...times, ...drawn(task, curve) }, samples };
    } finally {
      curve.dispose();
    }
  },

  /** Paths from the center of mass to the points. */
  async spokes(task, id, reference) {
    const center = task.scene.nearest.point(at((await reference()).position, 0));
    const polylines = task.points.map((point) =>
      task.scene.mesh.shortestPath(center, point).polyline(),
    );
    return { ...emptyLine(id), polylines };
  },

  /**
   * An arrow in each face, against the gradient of the distance from the first point. The gradient
   * is constant in a face.
   */
  gradients({ scene, points }, id) {
    const distances = scene.mesh.distance(points[0]!);
    const polylines: Float32Array[] = [];
    for (let f = 0; f < scene.triangles.length / 3; f++) {
      const corners = [0, 1, 2].map((k) => scene.triangles[3 * f + k]!);
      const arrow = gradientArrow(
        corners.map((v) => at(scene.positions, v)) as [Vector, Vector, Vector],
        corners.map((v) => distances[v]!),
      );
      if (arrow) polylines.push(...arrow);
    }
    return { ...emptyLine(id), polylines };
  },

  circleArcs,
  circleDefault,
  isolineLinear,
  isolineExact,
};

/**
 * The shaft and the head of an arrow in the middle of a triangle, against the gradient of the
 * values at its corners. Null if the gradient or the triangle's area is zero.
 */
function gradientArrow(
  corners: [Vector, Vector, Vector],
  values: readonly number[],
): Float32Array[] | null {
  const [a, b, c] = corners;
  const normal = cross(subtract(b, a), subtract(c, a));
  const area = length(normal);
  let gradient: Vector = [0, 0, 0];
  for (let k = 0; k < 3; k++) {
    const opposite = subtract(corners[(k + 2) % 3]!, corners[(k + 1) % 3]!);
    gradient = add(gradient, scaled(cross(normal, opposite), values[k]!));
  }
  const steep = length(gradient);
  if (!(steep > 0) || !(area > 0)) return null;
  const down = scaled(gradient, -1 / steep);
  const aside = scaled(cross(normal, down), 1 / area);
  const center = scaled(add(add(a, b), c), 1 / 3);
  // The arrow fits into the triangle.
  const size = 0.3 * Math.min(...corners.map((p) => distance(p, center)));
  const tip = add(center, scaled(down, size));
  const wing = (side: number) =>
    add(tip, add(scaled(down, -0.6 * size), scaled(aside, 0.35 * side * size)));
  const lifted = (p: Vector) => add(p, scaled(normal, (0.02 * size) / area));
  return [
    Float32Array.from([...lifted(add(center, scaled(down, -size))), ...lifted(tip)]),
    Float32Array.from([...lifted(wing(1)), ...lifted(tip), ...lifted(wing(-1))]),
  ];
}
