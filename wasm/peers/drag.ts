import type { Mesh } from '../mesh.js';
import type { CurveSamples, LongWorkOptions } from '../types.js';
import { at, length, subtract, type Vector } from '../vectors.js';
import { isThere } from './status.js';
import type { CurvePlan, MethodCurve } from './types.js';

/** In a step, the curve leaps if a sample moves more than this many times as far as the hand. */
const leapRatio = 5;

/** The length of a drag in mean edges, unless the next control point is nearer. */
const dragEdges = 2;

/** The steadiness of a curve in a drag. In the drag, a control point moves in small even steps. */
export interface DragMeasures {
  /** The number of steps of the drag. */
  steps: number;
  /** The number of steps in which a sample moved more than five times as far as the hand. */
  leaps: number;
  /**
   * The largest move of a sample in a step, divided by the move of the hand; null if each
   * sample was lost before or after each step.
   */
  most: number | null;
}

/**
 * Drags the middle control point of a traced curve towards the next one, in `steps` even steps over
 * two mean edges or less. The drag follows the straightest geodesic that starts as the shortest
 * path between the two points. Traces the curve at each step, and leaves the point at the end. A
 * sample counts for a step if it was lost neither before nor after the step. Rejects with the
 * signal's reason.
 */
export async function measureDrag(
  curve: Pick<MethodCurve, 'movePoint' | 'trace' | 'samples'>,
  mesh: Mesh,
  { points }: CurvePlan,
  steps: number,
  work: LongWorkOptions = {},
): Promise<DragMeasures> {
  const middle = Math.floor((points.length - 1) / 2);
  const path = mesh.shortestPath(points[middle]!, points[middle + 1]!);
  const far = Math.min(path.length, dragEdges * mesh.info.meanEdge);
  const result: DragMeasures = { steps, leaps: 0, most: null };
  if (!(far > 0)) return result;
  const start = path.points()[0]!;
  const direction = directionOf(path.polyline({ bits: 64 }));
  let before = curve.samples();
  for (let k = 1; k <= steps; k++) {
    curve.movePoint(middle, mesh.straightest(start, direction, (far * k) / steps).end);
    await curve.trace(work);
    const after = curve.samples();
    const moved = farthest(before, after);
    before = after;
    if (moved === null) continue;
    const ratio = moved / (far / steps);
    if (ratio > leapRatio) result.leaps++;
    result.most = Math.max(result.most ?? 0, ratio);
  }
  return result;
}

/**
 * The direction from the start of a polyline to its first point that is farther away than a
 * rounding error.
 */
function directionOf(polyline: Float64Array): Vector {
  const from = at(polyline, 0);
  const last = polyline.length / 3 - 1;
  const whole = length(subtract(at(polyline, last), from));
  for (let i = 1; i < last; i++) {
    const step = subtract(at(polyline, i), from);
    if (length(step) > 1e-6 * whole) return step;
  }
  return subtract(at(polyline, last), from);
}

function farthest(before: CurveSamples, after: CurveSamples): number | null {
  let most: number | null = null;
  for (let i = 0; i < after.count; i++) {
    if (!isThere(before.status[i]!) || !isThere(after.status[i]!)) continue;
    most = Math.max(most ?? 0, length(subtract(at(after.position, i), at(before.position, i))));
  }
  return most;
}
