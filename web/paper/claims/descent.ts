import type { SurfacePoint } from 'karcher';
import { alongPath, type CurvePlan, type Peers } from 'karcher/peers';
import { randomFrom } from '../../model/random';
import { methodOf } from '../figures/lines';
import { pathFigure } from '../figures/means';
import type { MeshSpec } from '../figures/types';
import { Scene } from '../lab/scene';
import { studySeed } from './seed';
import { middle } from './words';

/** Paths between pairs of points, such as the one in Figure 3. */
export interface DescentFinding {
  mesh: 'coarse' | 'fine';
  /** The number of pairs for which all three methods found a path. */
  pairs: number;
  /** The number of these pairs for which descent is less accurate than the paper's method. */
  worse: number;
  /**
   * The result of each method: its path's median distance from the exact path, in mean edges, and
   * of these distances the median over all pairs.
   */
  descent: number;
  paper: number;
  ours: number;
}

const samplesAPath = 33;
const compared = ['descent', 'paper', 'karcherExact'] as const;

const meshOf = (panel: 'coarse' | 'fine'): MeshSpec =>
  pathFigure.panels.find(({ id }) => id === panel)!.mesh;

/** Compares the paths of random pairs of points on both tori of the figure. */
export async function descent(
  peers: Peers,
  {
    pairs = 40,
    specs = { coarse: meshOf('coarse'), fine: meshOf('fine') },
  }: { pairs?: number; specs?: Record<'coarse' | 'fine', MeshSpec> } = {},
): Promise<DescentFinding[]> {
  const result: DescentFinding[] = [];
  for (const mesh of ['coarse', 'fine'] as const) {
    const scene = await Scene.make(peers, specs[mesh]);
    const random = randomFrom(studySeed);
    const away: number[][] = [];
    for (let k = 0; k < pairs; k++) {
      const points = [randomPoint(scene, random), randomPoint(scene, random)];
      const found = await distances(peers, scene, points);
      if (found) away.push(found);
    }
    const [byDescent, paper, ours] = compared.map((_, i) => middle(away.map((one) => one[i]!)));
    result.push({
      mesh,
      pairs: away.length,
      worse: away.filter(([one, other]) => one! > other!).length,
      ...{ descent: byDescent!, paper: paper!, ours: ours! },
    });
    await scene.dispose();
  }
  return result;
}

function randomPoint({ mesh }: Scene, random: () => number): SurfacePoint {
  const face = Math.floor(mesh.info.triangles * random());
  const [a, b] = [Math.sqrt(random()), random()];
  return { face, bary: [1 - a, a * (1 - b), a * b] };
}

/**
 * For each method, the median distance of its path from the exact path; null if a method found no
 * path.
 */
async function distances(
  peers: Peers,
  scene: Scene,
  points: readonly SurfacePoint[],
): Promise<number[] | null> {
  const table = peers.bezier(1, samplesAPath);
  const plan: CurvePlan = { points, first: [0], table, shape: { kind: 'bezier' } };
  const truth = alongPath(scene.mesh.shortestPath(points[0]!, points[1]!), table);
  const found: number[] = [];
  for (const id of compared) {
    const curve = (await scene.method(methodOf(id), {})).curve(plan);
    await curve.trace();
    const { deviation } = scene.meter.measure(curve.samples(), truth);
    curve.dispose();
    if (!deviation) return null;
    found.push(deviation.median);
  }
  return found;
}
