import type { LongWorkOptions, SurfacePoint } from 'karcher';
import {
  type CurvePlan,
  KarcherError,
  type Peers,
  type ReferenceSamples,
  referenceOptions,
} from 'karcher/peers';
import type { CurveSpec, LineId, LineResult, Vector } from '../figures/types';
import { alongPolyline } from './nearest';
import type { Scene } from './scene';

/** What the lines of a panel are made from. */
export interface Task {
  peers: Peers;
  scene: Scene;
  points: readonly SurfacePoint[];
  places: readonly Vector[];
  curve: CurveSpec;
  samples: number;
}

/** A result with nothing in it. */
export function emptyLine(id: LineId): LineResult {
  return {
    id,
    ok: true,
    reason: null,
    prepareMs: null,
    traceMs: null,
    samples: null,
    lost: null,
    deviation: null,
    turningNoise: null,
    residual: null,
    polylines: [],
    status: [],
    marker: null,
  };
}

/** The weights of a curve, as all methods take them. */
export function planOf({ peers, points, curve, samples }: Task): CurvePlan {
  const whole = (table: CurvePlan['table']): CurvePlan => ({ points, first: [0], table });
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
      return whole(peers.bezier(points.length - 1, samples));
    case 'rational':
      return whole(peers.rational(curve.weights, samples));
    case 'barycentric':
      return whole(peers.barycentric(curve.betas, samples));
    case 'circle':
      throw new KarcherError('badArgument', 'a circle is no curve of one plan');
  }
}

/** The plan's affine averages of the points in space: the truth on a plane. */
export function affineSamples(task: Task): ReferenceSamples {
  const { first, table } = planOf(task);
  const rows = table.t.length;
  const position = new Float64Array(3 * first.length * rows);
  first.forEach((begin, j) => {
    for (let i = 0; i < rows; i++) {
      for (let k = 0; k < table.points; k++) {
        const weight = table.weights[i * table.points + k]!;
        for (let c = 0; c < 3; c++) {
          position[3 * (j * rows + i) + c]! += weight * task.places[begin + k]![c]!;
        }
      }
    }
  });
  return convergedSamples(position);
}

/** Points at the parameters of a plan along the exact shortest path between its two points. */
export function pathSamples(task: Task): ReferenceSamples {
  const path = task.scene.mesh.shortestPath(task.points[0]!, task.points[1]!);
  const polyline = path.polyline({ bits: 64 });
  const { t } = planOf(task).table;
  return convergedSamples(
    Float64Array.from([...t].flatMap((part) => alongPolyline(polyline, part))),
  );
}

function convergedSamples(position: Float64Array): ReferenceSamples {
  const count = position.length / 3;
  return { count, position, status: Array.from({ length: count }, () => 'converged' as const) };
}

/**
 * What a panel's lines are measured against: on a plane the affine curve, between two points the
 * exact shortest path, elsewhere our curve of exact distances.
 */
export async function referenceOf(task: Task, work: LongWorkOptions): Promise<ReferenceSamples> {
  if (task.scene.flat) return affineSamples(task);
  if (task.curve.kind === 'bezier' && task.points.length === 2) return pathSamples(task);
  const method = await task.scene.method(referenceOptions, work);
  const curve = method.curve(planOf(task));
  try {
    await curve.trace(work);
    return curve.samples();
  } finally {
    curve.dispose();
  }
}
