import type { Mesh, SurfacePoint } from 'karcher';
import {
  comparedMethods,
  type MethodResult,
  type Peers,
  Ruler,
  runMethod,
  standardOptions,
  traceReference,
} from 'karcher/peers';
import { randomFrom } from '../../model/random';

/** What each method did on a mesh from a folder: a B-spline through seeded points. */
export interface MeshFinding {
  name: string;
  triangles: number;
  methods: { method: string; result: MethodResult }[];
}

const samples = 64;
const points = 7;

/**
 * Control points for a mesh of which nothing is known: from a random place straight ahead, a tenth of the
 * diagonal each, to the left and to the right by turns.
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
  for (let k = 1; k < points; k++) {
    const aside = [random() - 0.5, random() - 0.5, random() - 0.5];
    const direction = way.map((x, c) => x + 0.8 * aside[c]!);
    here = mesh.straightest(here, direction, step).end;
    result.push(here);
  }
  return result;
}

/** Compares the methods on a mesh. */
export async function judgeMesh(
  peers: Peers,
  name: string,
  bytes: Uint8Array,
  { seed, budgetMs }: { seed: number; budgetMs: number },
  tell: (what: string) => void,
): Promise<MeshFinding> {
  const mesh = peers.karcher.meshFromObj(bytes);
  try {
    const plan = peers.plan(wanderingPoints(mesh, seed), samples);
    const reference = await traceReference(peers, mesh, plan);
    const ruler = new Ruler(mesh, plan);
    await ruler.compareWith(reference.samples);
    const methods: MeshFinding['methods'] = [];
    for (const method of comparedMethods) {
      if (method === 'descent') continue;
      tell(`${name}: ${method}`);
      const options = standardOptions(method, plan);
      const run = await runMethod(peers, mesh, plan, options, reference.samples, {
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
