import type { Mesh, Status, SurfacePoint } from 'karcher';
import { isThere, type Peers, vectors } from 'karcher/peers';
import { onTorus, torusRadii } from '../figures/surfaces';
import type { LineId, Vector } from '../figures/types';
import { NearestPoints } from '../lab/nearest';
import { splineBy } from './spline';

const { add, dot, length, scaled, subtract } = vectors;

/** A method's error on one mesh of a smooth surface. */
export interface ConvergencePoint {
  surface: 'sphere' | 'torus';
  method: LineId;
  triangles: number;
  meanEdge: number;
  /**
   * The root mean square distance of the samples from the true curve, without lost ones; null if all
   * samples are lost.
   */
  error: number | null;
  lost: number;
  samples: number;
}

/** The methods that trace curves of more than two points. */
export const plottedMethods: readonly LineId[] = [
  'vectorHeat',
  'affineHeat',
  'weightedAverages',
  'bSurf',
  'paper',
  'paperGraph6',
  'karcher',
  'karcherExact',
  'leveled',
];

export const convergenceSizes: readonly number[] = [500, 1_000, 2_000, 5_000, 10_000, 20_000];

const samplesASegment = 33;

/** A smooth surface, and a cubic B-spline on it whose samples have known places. */
interface SmoothCurve {
  points: Vector[];
  project(place: Vector): Vector;
  /** The center of mass of the points with these weights. */
  center(weights: ArrayLike<number>): Vector;
}

const weightedSum = (places: readonly Vector[], weights: ArrayLike<number>): Vector =>
  places.reduce<Vector>((sum, place, i) => add(sum, scaled(place, weights[i]!)), [0, 0, 0]);
const unit = (a: Vector): Vector => scaled(a, 1 / length(a));

/**
 * A curve on the unit sphere. The sphere's logarithm and exponential have closed forms, and a
 * fixed-point iteration finds the mean.
 */
export function sphereCurve(): SmoothCurve {
  const points = [0, 1, 2, 3].map((i) =>
    unit([-0.5 + 0.33 * i, i % 2 ? 0.31 : -0.27, 0.83 + 0.05 * i]),
  );
  return {
    points,
    project: unit,
    center(weights) {
      let mean = unit(weightedSum(points, weights));
      for (let steps = 0; steps < 200; steps++) {
        const logs = points.map((p) => {
          const cosine = Math.min(1, Math.max(-1, dot(mean, p)));
          const angle = Math.acos(cosine);
          const factor = angle > 1e-12 ? angle / Math.sin(angle) : 1;
          return scaled(subtract(p, scaled(mean, cosine)), factor);
        });
        const step = weightedSum(logs, weights);
        const size = length(step);
        if (size < 1e-14) break;
        mean = unit(add(scaled(mean, Math.cos(size)), scaled(step, Math.sin(size) / size)));
      }
      return mean;
    },
  };
}

/**
 * A curve on a circle around the tube of a torus. The circle is a geodesic, so the center of mass
 * of nearby points on the circle is at the mean of their angles. The circle passes through no
 * vertex of the mesh.
 */
export function torusCurve(): SmoothCurve {
  const { major, minor } = torusRadii;
  const longitude = 35.1;
  const angles = [-41, -10, 17, 48];
  return {
    points: angles.map((angle) => onTorus(longitude, angle)),
    project(place) {
      const ring = Math.hypot(place[0], place[1]);
      const middle: Vector = [(major * place[0]) / ring, (major * place[1]) / ring, 0];
      return add(middle, scaled(unit(subtract(place, middle)), minor));
    },
    center: (weights) =>
      onTorus(
        longitude,
        angles.reduce((sum, angle, i) => sum + weights[i]! * angle, 0),
      ),
  };
}

/** The mesh's point that projects to this place of the smooth surface. */
function pointAbove(mesh: Mesh, nearest: NearestPoints, curve: SmoothCurve, place: Vector) {
  let target = place;
  let found: SurfacePoint = nearest.point(target);
  for (let steps = 0; steps < 8; steps++) {
    target = add(target, subtract(place, curve.project(mesh.position(found))));
    found = nearest.point(target);
  }
  return found;
}

/**
 * The error of every method on ever finer meshes of each surface. All meshes of a surface have the
 * same curve.
 */
export async function convergence(
  peers: Peers,
  {
    sizes = convergenceSizes,
    methods = plottedMethods,
    tell = () => {},
  }: {
    sizes?: readonly number[];
    methods?: readonly LineId[];
    tell?: (points: ConvergencePoint[]) => void;
  } = {},
): Promise<ConvergencePoint[]> {
  const result: ConvergencePoint[] = [];
  const curves = { sphere: sphereCurve(), torus: torusCurve() };
  for (const [surface, curve] of Object.entries(curves) as ['sphere' | 'torus', SmoothCurve][]) {
    for (const size of sizes) {
      const mesh = peers.karcher.shape(surface, size);
      const nearest = new NearestPoints(mesh.positions(), mesh.triangles());
      const points = curve.points.map((place) => pointAbove(mesh, nearest, curve, place));
      const plan = peers.plan(points, samplesASegment);
      const truth = Array.from(plan.table.t, (_, i) =>
        curve.center(plan.table.weights.subarray(4 * i, 4 * i + 4)),
      );
      for (const method of methods) {
        const { samples } = await splineBy(peers, mesh, plan, method);
        result.push({
          surface,
          method,
          triangles: mesh.info.triangles,
          meanEdge: mesh.info.meanEdge,
          ...errorOf(samples, curve, truth),
        });
        tell(result);
      }
      mesh.dispose();
    }
  }
  return result;
}

function errorOf(
  samples: { count: number; position: Float64Array; status: readonly Status[] } | null,
  curve: SmoothCurve,
  truth: readonly Vector[],
): Pick<ConvergencePoint, 'error' | 'lost' | 'samples'> {
  if (!samples) return { error: null, lost: truth.length, samples: truth.length };
  let [squares, found] = [0, 0];
  for (let i = 0; i < samples.count; i++) {
    if (!isThere(samples.status[i]!)) continue;
    const place = [...samples.position.slice(3 * i, 3 * i + 3)] as Vector;
    const off = subtract(curve.project(place), truth[i]!);
    squares += dot(off, off);
    found++;
  }
  const error = found > 0 ? Math.sqrt(squares / found) : null;
  return { error, lost: samples.count - found, samples: samples.count };
}
