import type { Mesh, SurfacePoint } from 'karcher';
import {
  type ComparedMethod,
  type CurvePlan,
  comparedMethods,
  type MethodOptions,
  type MethodResult,
  type Peers,
  Ruler,
  runMethod,
  standardOptions,
  traceReference,
} from 'karcher/peers';
import { randomFrom } from '../../model/random';

/** The compared methods. The paper's method appears twice: with k = 6 and with exact distances. */
export type MeshMethod = ComparedMethod | 'paperExact';

/** The results of each method on a mesh from a folder, for a B-spline of given or seeded points. */
export interface MeshFinding {
  name: string;
  triangles: number;
  methods: { method: MeshMethod; result: MethodResult }[];
}

const meshMethods: readonly MeshMethod[] = comparedMethods.flatMap((method): MeshMethod[] => {
  // Descent joins only two points.
  if (method === 'descent') return [];
  return method === 'paper' ? ['paper', 'paperExact'] : [method];
});

function optionsOf(method: MeshMethod, plan: CurvePlan): MethodOptions {
  if (method !== 'paperExact') return standardOptions(method, plan);
  return { method: 'paper', solver: 'exact', seeds: 'authors' };
}

/** The median residual by exact paths; infinite for a failed method, null if not measured. */
export function residualOn({ methods }: MeshFinding, method: MeshMethod): number | null {
  const result = methods.find((one) => one.method === method)?.result;
  if (!result) return null;
  if (!result.ok) return Number.POSITIVE_INFINITY;
  return result.ruler?.residual?.median ?? null;
}

const samples = 64;
const wandering = 7;

/**
 * Control points for an unknown mesh: a walk from a random face, in straight legs of a tenth of the
 * diagonal. Each leg deviates at random from one common direction.
 */
export function wanderingPoints(mesh: Mesh, seed: number): SurfacePoint[] {
  const random = randomFrom(seed);
  const step = mesh.info.diagonal / 10;
  let here: SurfacePoint = {
    face: Math.floor(mesh.info.triangles * random()),
    bary: [0.4, 0.3, 0.3],
  };
  const way = [random() - 0.5, random() - 0.5, random() - 0.5];
  const result = [here];
  for (let k = 1; k < wandering; k++) {
    const aside = [random() - 0.5, random() - 0.5, random() - 0.5];
    const direction = way.map((x, c) => x + 0.8 * aside[c]!);
    here = mesh.straightest(here, direction, step).end;
    result.push(here);
  }
  return result;
}

/** Compares the methods on a mesh, with given or seeded control points. */
export async function judgeMesh(
  peers: Peers,
  name: string,
  bytes: Uint8Array,
  { seed, budgetMs, points }: { seed: number; budgetMs: number; points?: readonly SurfacePoint[] },
  tell: (what: string) => void,
): Promise<MeshFinding> {
  const mesh = peers.karcher.meshFromObj(bytes);
  try {
    const plan = peers.plan(points ?? wanderingPoints(mesh, seed), samples);
    const reference = await traceReference(peers, mesh, plan);
    const ruler = new Ruler(mesh, plan);
    await ruler.compareWith(reference.samples);
    const methods: MeshFinding['methods'] = [];
    for (const method of meshMethods) {
      tell(`${name}: ${method}`);
      const run = await runMethod(peers, mesh, plan, optionsOf(method, plan), reference.samples, {
        ruler,
        budgetMs,
        once: true,
      });
      const { curve: _, ...result } = run;
      methods.push({ method, result });
    }
    return { name, triangles: mesh.info.triangles, methods };
  } finally {
    mesh.dispose();
  }
}
