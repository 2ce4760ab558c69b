import type { LongWorkOptions, SurfacePoint } from 'karcher';
import {
  alongPath,
  type CurvePlan,
  KarcherError,
  type Peers,
  type ReferenceSamples,
  referenceOptions,
  vectors,
} from 'karcher/peers';
import type { CurveSpec, Vector } from '../figures/types';
import type { Scene } from './scene';

const { add, distance, scaled } = vectors;

/** The input of a panel's lines. */
export interface Task {
  peers: Peers;
  scene: Scene;
  points: readonly SurfacePoint[];
  places: readonly Vector[];
  curve: CurveSpec;
  samples: number;
}

/** The weights of a curve, in the form that all methods take. Throws `badArgument` for a circle. */
export function planOf({ peers, points, curve, samples }: Task): CurvePlan {
  const whole = (table: CurvePlan['table'], shape?: CurvePlan['shape']): CurvePlan => ({
    points,
    first: [0],
    table,
    shape,
  });
  switch (curve.kind) {
    case 'center':
      return whole({
        points: points.length,
        t: Float64Array.of(0),
        weights: Float64Array.from(curve.weights),
      });
    case 'bspline':
      return peers.plan(points, samples);
    case 'bezier':
      return whole(peers.bezier(points.length - 1, samples), { kind: 'bezier' });
    case 'rational':
      return whole(peers.rational(curve.weights, samples), {
        kind: 'rational',
        weights: curve.weights,
      });
    case 'barycentric':
      return whole(peers.barycentric(curve.betas, samples));
    case 'circle':
      throw new KarcherError('badArgument', 'a circle is no curve of one plan');
  }
}

/** The plan's affine averages of the points in space. On a plane, they are the true curve. */
export function affineSamples(task: Task): ReferenceSamples {
  const { first, table } = planOf(task);
  const rows = table.t.length;
  const position = new Float64Array(3 * first.length * rows);
  const energy = new Float64Array(first.length * rows);
  first.forEach((begin, j) => {
    for (let i = 0; i < rows; i++) {
      const terms = Array.from({ length: table.points }, (_, k) => ({
        weight: table.weights[i * table.points + k]!,
        place: task.places[begin + k]!,
      }));
      const sum = (sum: Vector, { weight, place }: (typeof terms)[0]) =>
        add(sum, scaled(place, weight));
      const mean = terms.reduce(sum, [0, 0, 0]);
      position.set(mean, 3 * (j * rows + i));
      energy[j * rows + i] = terms.reduce(
        (sum, { weight, place }) => sum + weight * distance(place, mean) ** 2,
        0,
      );
    }
  });
  return convergedSamples(position, energy);
}

function convergedSamples(position: Float64Array, energy: Float64Array): ReferenceSamples {
  const count = position.length / 3;
  const status = Array.from({ length: count }, () => 'converged' as const);
  return { count, position, energy, status };
}

/**
 * The reference for a panel's lines: the affine curve on a plane, the exact shortest path between
 * two points, and otherwise our curve of exact distances.
 */
export async function referenceOf(task: Task, work: LongWorkOptions): Promise<ReferenceSamples> {
  if (task.scene.flat) return affineSamples(task);
  if (task.curve.kind === 'bezier' && task.points.length === 2) {
    const path = task.scene.mesh.shortestPath(task.points[0]!, task.points[1]!);
    return alongPath(path, planOf(task).table);
  }
  const method = await task.scene.method(referenceOptions, work);
  const curve = method.curve(planOf(task));
  try {
    await curve.trace(work);
    return curve.samples();
  } finally {
    curve.dispose();
  }
}
