import type { CurveSamples, LongWorkOptions } from 'karcher';
import type { CurvePlan } from 'karcher/peers';
import type { Vector } from '../figures/types';
import { planOf, type Task } from './task';
import { add, at, distance, length, scaled, subtract } from './vectors';

/** Each takes a shortest path for every point with a weight: enough for a median. */
const mostSamples = 32;
/** Nearer to a side of its face, a point's shortest path may begin in another. */
const least = 1e-6;

/**
 * How far samples are from being centers of mass: the median of |sum w_i log(c_i)| in mean edges, with
 * the logarithms of exact shortest paths. At a center of mass the sum is 0, and where the surface bends
 * little its length is about the distance to the center. Null where no sample lies inside a face.
 * Rejects with the signal's reason.
 */
export async function medianResidual(
  task: Task,
  samples: CurveSamples,
  { signal }: LongWorkOptions,
): Promise<number | null> {
  const plan = planOf(task);
  const count = Math.min(mostSamples, samples.count);
  const residuals: number[] = [];
  for (let k = 0; k < count; k++) {
    const i = Math.floor(((k + 0.5) * samples.count) / count);
    if (samples.status[i] !== 'converged' || Math.min(...at(samples.bary, i)) < least) continue;
    residuals.push(residualAt(task, plan, samples, i) / task.scene.mesh.info.meanEdge);
    // A message that cancels is heard between two samples.
    await new Promise((resolve) => setTimeout(resolve));
    signal?.throwIfAborted();
  }
  residuals.sort((a, b) => a - b);
  return residuals[Math.floor(residuals.length / 2)] ?? null;
}

function residualAt(
  { scene }: Task,
  { points, first, table }: CurvePlan,
  { face, bary, segment }: CurveSamples,
  i: number,
): number {
  const here = { face: face[i]!, bary: at(bary, i) };
  const row = (i % table.t.length) * table.points;
  let sum: Vector = [0, 0, 0];
  for (let k = 0; k < table.points; k++) {
    const weight = table.weights[row + k]!;
    if (weight === 0) continue;
    const path = scene.mesh.shortestPath(here, points[first[segment[i]!]! + k]!);
    const polyline = path.polyline({ bits: 64 });
    const [from, to] = [at(polyline, 0), at(polyline, 1)];
    const step = distance(from, to);
    if (step > 0) sum = add(sum, scaled(subtract(to, from), (weight * path.length) / step));
  }
  return length(sum);
}
