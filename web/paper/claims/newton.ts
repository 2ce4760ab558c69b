import type { Mesh, SurfacePoint } from 'karcher';
import type { NewtonSteps, Peers } from 'karcher/peers';
import { makeMesh } from '../../model/made_mesh';
import { randomFrom } from '../../model/random';
import type { MeshSpec } from '../figures/types';
import { roughened } from './roughness';
import { studySeed } from './seed';
import { middle, sum } from './words';

/** Statistics of Newton's method on a mesh, over all of its searches. */
export interface NewtonFinding {
  mesh: string;
  triangles: number;
  distances: 'exact' | 'k = 6';
  /**
   * The start of a search: the place of the curve's previous sample, or the point with the largest
   * weight.
   */
  start: 'warm' | 'cold';
  /** The number of searches. */
  searches: number;
  converged: number;
  /** The iterations of a search: the median, the 99th percentile and the maximum. */
  half: number;
  nearlyAll: number;
  most: number;
  /** The number of geodesics along steps of Newton's method. */
  traced: number;
  /** The number of these geodesics that the search cut at a joint before their end. */
  shortened: number;
  /** The number of cut geodesics whose original end has no smaller gradient than their start. */
  needed: number;
  /** The number of geodesics on which no joint has a smaller gradient than their start. */
  stuck: number;
  /** The number of converged searches that ended at a zero of the gradient inside a triangle. */
  inside: number;
  /** The median order of convergence over the last three iterations; null for too few searches. */
  order: number | null;
}

const curvesAMesh = 12;
const samplesACurve = 65;
/** The distance from a control point to the next, in diagonals of the surface. */
const leg = 0.1;
/** Fewer searches than this give no order of convergence. */
const leastOrders = 20;

/** The meshes of the study; the noise is in mean edges. */
const meshes: Record<string, { spec: MeshSpec; noise?: number }> = {
  'a coarse sphere': { spec: { kind: 'shape', name: 'sphere', triangles: 1_000 } },
  'a sphere': { spec: { kind: 'shape', name: 'sphere', triangles: 20_000 } },
  'a coarse torus': { spec: { kind: 'shape', name: 'torus', triangles: 1_000 } },
  'a torus': { spec: { kind: 'shape', name: 'torus', triangles: 20_000 } },
  'a knot': { spec: { kind: 'shape', name: 'knot', triangles: 20_000 } },
  'a surface of genus 3': { spec: { kind: 'shape', name: 'genus3', triangles: 20_000 } },
  'a rough torus': { spec: { kind: 'shape', name: 'torus', triangles: 5_000 }, noise: 0.2 },
  'a plane of fairly regular points': {
    spec: { kind: 'plane', tessellation: 'fair', triangles: 8_000 },
  },
  'a plane of random points': {
    spec: { kind: 'plane', tessellation: 'delaunay', triangles: 8_000 },
  },
};

/**
 * Four points on the surface. Each further point is a leg away from the previous one, in a random
 * direction.
 */
function polygon(mesh: Mesh, random: () => number): SurfacePoint[] {
  const [a, b] = [Math.sqrt(random()), random()];
  const face = Math.floor(mesh.info.triangles * random());
  const points: SurfacePoint[] = [{ face, bary: [1 - a, a * (1 - b), a * b] }];
  while (points.length < 4) {
    const direction = [0, 1, 2].map(() => 2 * random() - 1) as [number, number, number];
    const walked = mesh.straightest(points.at(-1)!, direction, leg * mesh.info.diagonal);
    // The loop ends: from any point, most directions stay on the surface.
    if (walked.stop === 'complete') points.push(walked.end);
  }
  return points;
}

/** Measures the searches for the samples of random B-splines, on meshes of several kinds. */
export async function newton(
  peers: Peers,
  { curves = curvesAMesh, only = Object.keys(meshes) } = {},
): Promise<NewtonFinding[]> {
  const result: NewtonFinding[] = [];
  for (const name of only) {
    const { spec, noise } = meshes[name]!;
    const made = await makeMesh(peers.karcher, spec);
    const mesh = noise ? roughened(peers.karcher, made, noise, studySeed) : made;
    for (const distances of ['exact', 'k = 6'] as const) {
      for (const start of ['warm', 'cold'] as const) {
        const searches = searchesOn(peers, mesh, { curves, distances, start });
        result.push({
          ...{ mesh: name, triangles: mesh.info.triangles, distances, start },
          ...summed(searches),
        });
      }
    }
    if (made !== mesh) made.dispose();
    mesh.dispose();
  }
  return result;
}

function searchesOn(
  peers: Peers,
  mesh: Mesh,
  { curves, distances, start }: { curves: number } & Pick<NewtonFinding, 'distances' | 'start'>,
): NewtonSteps[] {
  const { weights } = peers.bspline(samplesACurve);
  const random = randomFrom(studySeed);
  const solver = distances === 'exact' ? 'exact' : 'graph';
  const warm = start === 'warm';
  return Array.from({ length: curves }, () => {
    const found = peers.newtonSteps(mesh, polygon(mesh, random), weights, { solver, warm });
    // The first sample has no warm start.
    return warm ? found.slice(1) : found;
  }).flat();
}

function summed(searches: readonly NewtonSteps[]) {
  const converged = searches.filter((search) => search.converged);
  const iterations = searches.map((search) => search.iterations).toSorted((a, b) => a - b);
  const all = (key: 'traced' | 'shortened' | 'needed' | 'stuck') =>
    sum(searches.map((search) => search[key]));
  const orders = converged.flatMap(({ gradients: [last, before, first] }) =>
    last! > 0 && before! > last! && first! > before!
      ? [Math.log(before! / last!) / Math.log(first! / before!)]
      : [],
  );
  return {
    ...{ searches: searches.length, converged: converged.length },
    half: middle(iterations),
    nearlyAll: iterations[Math.floor(0.99 * (iterations.length - 1))]!,
    most: iterations.at(-1)!,
    ...{ traced: all('traced'), shortened: all('shortened') },
    ...{ needed: all('needed'), stuck: all('stuck') },
    inside: converged.filter((search) => search.inside).length,
    order: orders.length < leastOrders ? null : middle(orders),
  };
}
