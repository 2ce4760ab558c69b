/**
 * Robust means, derivatives of the energy, centroids, Voronoi diagrams and isolines of values, for
 * a mesh in this thread or in a worker.
 */
import { checkArray, checkNumber, checkOptions, namesOf } from '../check.js';
import { KarcherError } from '../errors.js';
import type { PointLike, SurfacePoint } from '../types.js';
import { type AnyMesh, checkWeights } from './energy.js';
import { inFace } from './fans.js';
import { divided, stepFrom } from './median_step.js';

export { KarcherError } from '../errors.js';
export { type Centroid, type CentroidOptions, centroid } from './centroid.js';
export {
  type AnyMesh,
  type Energy,
  energyAt,
  type Hessian,
  hessianAt,
  type PointDerivative,
  pointDerivatives,
  weightDerivatives,
} from './energy.js';
export { isolines } from './isolines.js';
export { joinedSegments, type LevelCrossing, levelLines, type SegmentEnd } from './level_lines.js';
export { type Site, type VoronoiDiagram, voronoi } from './voronoi.js';
export type { VoronoiBorder } from './voronoi_cells.js';

/** The options of a search for a robust mean. */
export interface RobustOptions {
  /** The point where the search starts; by default the center of mass. */
  start?: PointLike | undefined;
  /**
   * The search ends after a step that is shorter than this, relative to the diagonal. The default
   * is 1e-7.
   */
  tolerance?: number | undefined;
  /** The largest number of steps; the default is 200. */
  mostSteps?: number | undefined;
}

/** The options of `huberMean`. */
export interface HuberOptions extends RobustOptions {
  /**
   * The threshold distance, in units of the mesh. A point beyond the threshold pulls no more than a
   * point at this distance.
   */
  threshold: number;
}

/** A median or a Huber mean, and the result of the search for it. */
export interface RobustMean {
  /** The mean as a point of the surface. */
  point: SurfacePoint;
  /** The place of that point in space. */
  position: [number, number, number];
  /** The sum that the mean minimizes; for a median, the weighted sum of distances. */
  value: number;
  /** The number of steps of the search. */
  steps: number;
  /** Whether the last step was shorter than the tolerance, or the median is one of the points. */
  converged: boolean;
}

const options = { start: true, tolerance: true, mostSteps: true } as const;
const robustNames = namesOf<RobustOptions>(options);
const huberNames = namesOf<HuberOptions>({ ...options, threshold: true });

/**
 * The geometric median: the point where the weighted sum of distances to points has a minimum. It
 * stays near the majority if less than half of the points lie elsewhere. Weights are positive; each
 * is 1 by default.
 *
 * The search finds the minimum near its start, as the search for a center of mass does. Each of its
 * steps takes one exact shortest path to each point. A point that becomes the nearest is tested
 * once. It is a local minimum if in no direction the other points pull more than the weight of all
 * points at its place. Rejects as `Mesh.centerOfMass` does, and with
 * `KarcherError` badArgument for a weight that is not positive.
 */
export async function median(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights?: ArrayLike<number>,
  given: RobustOptions = {},
): Promise<RobustMean> {
  checkOptions(given, robustNames);
  return search(mesh, points, weights, given, {
    pull: (distance) => 1 / distance,
    cost: (distance) => distance,
    isSharp: true,
  });
}

/**
 * Huber's mean: a center of mass for which points beyond a threshold distance pull no more than
 * points at this distance. It minimizes the weighted sum of d²/2 for distances d within the
 * threshold t, and of t (d - t/2) beyond. With a threshold larger than all distances it is the
 * center of mass; with a very small one it comes close to the median.
 *
 * Rejects as `median` does, and with `KarcherError` badArgument for a threshold that is not
 * positive.
 */
export async function huberMean(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights: ArrayLike<number> | undefined,
  given: HuberOptions,
): Promise<RobustMean> {
  checkOptions(given, huberNames);
  const threshold = checkNumber(given.threshold, 'the threshold');
  if (!(threshold > 0)) {
    throw new KarcherError('badArgument', `the threshold must be positive, not ${threshold}`);
  }
  return search(mesh, points, weights, given, {
    pull: (distance) => Math.min(1, threshold / distance),
    cost: (distance) =>
      distance < threshold ? distance ** 2 / 2 : threshold * (distance - threshold / 2),
    isSharp: false,
  });
}

/** The influence of a point, as functions of its distance. */
interface Rule {
  /** The factor of the point's weight in a center of mass. */
  pull(distance: number): number;
  cost(distance: number): number;
  /** Whether the cost has a kink at the point itself, so that the minimum may lie there. */
  isSharp: boolean;
}

/**
 * The search. Each step leads to the center of mass with weights that depend on the distances from
 * the start of the step (Weiszfeld).
 */
async function search(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights: ArrayLike<number> | undefined,
  { start, tolerance = 1e-7, mostSteps = 200 }: RobustOptions,
  { pull, cost, isSharp }: Rule,
): Promise<RobustMean> {
  const { length } = checkArray(points, 'the points');
  const own = Array.from(checkWeights(points, weights ?? new Float64Array(length).fill(1)));
  if (!own.every((weight) => weight > 0)) {
    const sentence = 'the weights of a median or a Huber mean must be positive';
    throw new KarcherError('badArgument', sentence);
  }
  if (own.length === 0) {
    throw new KarcherError('tooFewPoints', 'a median or a Huber mean needs at least one point');
  }
  const least = checkNumber(tolerance, 'the tolerance') * mesh.info.diagonal;
  const centerOf = (factors: readonly number[], from?: PointLike) =>
    mesh.centerOfMass(points, factors, { normalize: true, start: from });
  const lengthTo = async (from: PointLike, to: PointLike) =>
    (await mesh.shortestPath(from, to)).length;
  let point: PointLike = start ?? (await centerOf(own)).point;
  let distances: number[] = [];
  const measure = async () => {
    distances = [];
    for (const to of points) distances.push(await lengthTo(point, to));
  };
  const valueHere = () => distances.reduce((sum, distance, i) => sum + own[i]! * cost(distance), 0);
  const tried = new Set<number>();
  const surface = divided(mesh);
  let steps = 0;
  let converged = false;
  await measure();
  for (; steps < mostSteps && !converged; steps++) {
    const nearest = distances.indexOf(Math.min(...distances));
    if (isSharp && !tried.has(nearest)) {
      // Near a point that is no median, the usual steps are as short as near a median. So the
      // search goes to a place where the value is lower than at the point, and never comes back.
      tried.add(nearest);
      const before = { point, distances };
      const value = valueHere();
      const step = await stepFrom(surface, points, own, nearest, least);
      const from = points[nearest]!;
      point = step ? (await mesh.expMap(from, step)).points[0]! : from;
      await measure();
      if (valueHere() <= value) {
        if (step) continue;
        converged = true;
        break;
      }
      ({ point, distances } = before);
    }
    const factors = own.map((weight, i) => weight * pull(Math.max(distances[i]!, least)));
    const before = point;
    point = (await centerOf(factors, before)).point;
    await measure();
    converged = (await lengthTo(before, point)) <= least;
  }
  return {
    point: await inFace(mesh, point),
    position: await mesh.position(point),
    value: valueHere(),
    steps,
    converged,
  };
}
