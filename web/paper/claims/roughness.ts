import type { Karcher, Mesh } from 'karcher';
import { type Peers, Ruler, runMethod } from 'karcher/peers';
import { randomFrom } from '../../model/random';
import type { LineId } from '../figures/types';
import { methodOf, plottedMethods } from './convergence';
import { galleryTorus } from './gallery_torus';
import { studySeed } from './seed';

/** What a method does on a surface with noise. */
export interface RoughnessPoint {
  /** In mean edges. */
  noise: number;
  method: LineId;
  lost: number;
  samples: number;
  /** By exact paths, in mean edges: the median. */
  residual: number | null;
  /** Against the curve of exact log vectors. */
  turning: number | null;
}

export const noises: readonly number[] = [0, 0.05, 0.1, 0.2, 0.4];

/** A copy of a mesh whose vertices are moved at random, evenly within a ball of `noise` mean edges. */
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

function inBall(random: () => number): [number, number, number] {
  for (;;) {
    const [x, y, z] = [2 * random() - 1, 2 * random() - 1, 2 * random() - 1];
    if (x * x + y * y + z * z <= 1) return [x, y, z];
  }
}

/** The gallery's B-spline on a torus of so many triangles with ever more noise. */
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
    const exact = methodOf('karcherExact');
    const reference = await runMethod(peers, mesh, plan, exact, null, { once: true });
    for (const method of methods) {
      const truth = reference.curve?.samples ?? null;
      const options = { once: true, ruler };
      const run = await runMethod(peers, mesh, plan, methodOf(method), truth, options);
      result.push({
        noise,
        method,
        lost: run.lost ?? 0,
        samples: run.samples ?? 0,
        residual: run.ruler?.residual?.median ?? null,
        turning: run.turningNoise,
      });
      tell(result);
    }
    mesh.dispose();
  }
  smooth.mesh.dispose();
  return result;
}
