import type { Karcher, Mesh } from 'karcher';
import { CurveMeter, type Peers, Ruler } from 'karcher/peers';
import { randomFrom } from '../../model/random';
import { onTorus } from '../figures/surfaces';
import type { LineId } from '../figures/types';
import { NearestPoints } from '../lab/nearest';
import { plottedMethods } from './convergence';
import { galleryTorus } from './gallery_torus';
import { studySeed } from './seed';
import { measured, splineBy } from './spline';
import { middle } from './words';

/** Results of a method on a surface with noise. */
export interface RoughnessPoint {
  /** The height of the noise in mean edges. */
  noise: number;
  method: LineId;
  lost: number;
  samples: number;
  /** The median residual by exact paths, in mean edges. */
  residual: number | null;
  /** The turning noise, with the curve of exact log vectors as the true curve. */
  turning: number | null;
}

export const noises: readonly number[] = [0, 0.05, 0.1, 0.2, 0.4];

/**
 * A copy of a mesh whose vertices move at random, uniformly within a ball with a radius of `noise`
 * mean edges.
 */
export function roughened(karcher: Karcher, mesh: Mesh, noise: number, seed: number): Mesh {
  const random = randomFrom(seed);
  const positions = mesh.positions();
  const radius = noise * mesh.info.meanEdge;
  for (let v = 0; v < positions.length; v += 3) {
    const [x, y, z] = inBall(random);
    positions[v]! += radius * x;
    positions[v + 1]! += radius * y;
    positions[v + 2]! += radius * z;
  }
  return karcher.meshFromArrays(positions, mesh.triangles());
}

/** Results of a method for control points at a given spacing, summed over rough surfaces. */
export interface SpreadPoint {
  /** The median distance from each control point to the next, in mean edges. */
  apart: number;
  noise: number;
  method: LineId;
  lost: number;
  breaks: number;
  samples: number;
}

/** The angles from each control point to the next along the torus, in degrees. */
const spreads: readonly number[] = [8, 16, 32, 64, 96, 112];
const spreadSamples = 65;

/**
 * Traces one segment of a B-spline on rough tori, for growing distances between its four control
 * points.
 */
export async function spread(
  peers: Peers,
  {
    triangles = 5_000,
    noise = 0.4,
    tori = 4,
  }: { triangles?: number; noise?: number; tori?: number } = {},
): Promise<SpreadPoint[]> {
  const result: SpreadPoint[] = [];
  const smooth = peers.karcher.shape('torus', triangles);
  const nearest = new NearestPoints(smooth.positions(), smooth.triangles());
  const rough = Array.from({ length: tori }, (_, k) =>
    roughened(peers.karcher, smooth, noise, studySeed + k),
  );
  for (const degrees of spreads) {
    const points = [0, 1, 2, 3].map((i) =>
      nearest.point(onTorus(20 + degrees * i, i % 2 ? 95 : 65)),
    );
    const plan = peers.plan(points, spreadSamples);
    const lengths = rough.flatMap((mesh) =>
      points
        .slice(1)
        .map((point, i) => mesh.shortestPath(points[i]!, point).length / mesh.info.meanEdge),
    );
    for (const method of ['paper', 'karcher', 'leveled'] as const) {
      const point: SpreadPoint = {
        ...{ apart: middle(lengths), noise, method },
        ...{ lost: 0, breaks: 0, samples: tori * spreadSamples },
      };
      for (const mesh of rough) {
        const { samples, lost } = await splineBy(peers, mesh, plan, method);
        point.lost += samples ? lost : spreadSamples;
        if (samples) point.breaks += new CurveMeter(mesh).measure(samples, samples).breaks;
      }
      result.push(point);
    }
  }
  for (const mesh of [smooth, ...rough]) mesh.dispose();
  return result;
}

function inBall(random: () => number): [number, number, number] {
  for (;;) {
    const [x, y, z] = [2 * random() - 1, 2 * random() - 1, 2 * random() - 1];
    if (x * x + y * y + z * z <= 1) return [x, y, z];
  }
}

/** Traces the gallery's B-spline on a torus of `triangles` triangles, with growing noise. */
export async function roughness(
  peers: Peers,
  {
    triangles = 5_000,
    methods = plottedMethods,
    tell = () => {},
  }: {
    triangles?: number;
    methods?: readonly LineId[];
    tell?: (points: RoughnessPoint[]) => void;
  } = {},
): Promise<RoughnessPoint[]> {
  const result: RoughnessPoint[] = [];
  const smooth = galleryTorus(peers, triangles);
  for (const noise of noises) {
    const mesh = roughened(peers.karcher, smooth.mesh, noise, studySeed);
    const plan = peers.plan(smooth.points, 65);
    const ruler = new Ruler(mesh, plan);
    const truth = (await splineBy(peers, mesh, plan, 'karcherExact')).samples;
    for (const method of methods) {
      const spline = await splineBy(peers, mesh, plan, method);
      const { lost, of } = spline;
      const worth = await measured(mesh, ruler, spline, truth);
      result.push({ noise, method, lost, samples: of, ...worth });
      tell(result);
    }
    mesh.dispose();
  }
  smooth.mesh.dispose();
  return result;
}
