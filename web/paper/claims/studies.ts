import type { SurfacePoint } from 'karcher';
import { type Peers, runMethod, standardOptions } from 'karcher/peers';
import { randomFrom } from '../../model/random';
import { type ConvergencePoint, convergence } from './convergence';
import { type DescentFinding, descent } from './descent';
import { galleryTorus } from './gallery_torus';
import { type NewtonFinding, newton } from './newton';
import { type RadiusPoint, radius } from './radius';
import { type RoughnessPoint, roughness, type SpreadPoint, spread } from './roughness';
import { studySeed } from './seed';
import { middle } from './words';

/** Measurements that the claims need and the figures do not have. */
export interface Studies {
  /** Points in balls of growing radius, on smooth and on bumpy surfaces. */
  radius: RadiusPoint[];
  /** The searches of random B-splines on meshes of several kinds. */
  newton: NewtonFinding[];
  /**
   * Milliseconds for four fields of distances, and for another center of mass of the same points.
   */
  oneCenter: { fieldsMs: number; centerMs: number };
  /** Milliseconds of a drag with 256 samples a segment: the field, and a segment's searches. */
  update: { fieldMs: number; segmentMs: number; triangles: number };
  /**
   * Milliseconds of the fields when the weights of a rational curve change, and of all the work
   * that this change causes.
   */
  reweigh: { fieldsMs: number; updateMs: number };
  /**
   * Circles of arcs on a sphere: the largest relative deviation from the radius, by Eq. 4 (level 0)
   * and by our default.
   */
  arcs: { arcs: number; worst: number; byDefault: number }[];
  /**
   * Weights of four points for which a random point between them is critical. In `minima` of the
   * cases, the random point is a minimum. In `back` of these cases, a search with the weights
   * returns to the random point. `farthest` is the largest distance, in mean edges, from a random
   * point to the end of its search.
   */
  inverse: { cases: number; minima: number; back: number; farthest: number };
  /** B-splines on a torus with noise of growing height, in mean edges. */
  roughness: RoughnessPoint[];
  /** B-splines on rough tori, with control points at growing distances. */
  spread: SpreadPoint[];
  /** Paths between random pairs of points. */
  descent: DescentFinding[];
  /**
   * Milliseconds of the preparation and the first curve together, on ever finer meshes; null where
   * the method failed.
   */
  growth: { method: string; triangles: number; ms: number | null; reason: string | null }[];
  /** B-splines on ever finer meshes of a sphere and a torus. */
  convergence: ConvergencePoint[];
  /**
   * Milliseconds of the preparation and of a drag, on a torus of a quarter of a million triangles.
   */
  large: {
    method: string;
    triangles: number;
    prepareMs: number | null;
    dragMs: number | null;
    reason: string | null;
  }[];
}

function timed<Result>(work: () => Result): [Result, number] {
  const start = performance.now();
  const result = work();
  return [result, performance.now() - start];
}

/** Random weights with sum 1, each at least a twentieth. */
function randomWeights(random: () => number, count: number): number[] {
  const raw = Array.from({ length: count }, () => 0.05 + random());
  const sum = raw.reduce((a, b) => a + b);
  return raw.map((weight) => weight / sum);
}

function oneCenter(peers: Peers): Studies['oneCenter'] {
  const options = { method: 'paper', solver: 'exact' } as const;
  const weights = [0.4, 0.3, 0.2, 0.1];
  // The first center compiles the code. It is on another mesh, since a mesh keeps its fields.
  const first = galleryTorus(peers, 20_000);
  first.mesh.centerOfMass(first.points.slice(0, 4), weights, options);
  first.mesh.dispose();
  const { mesh, points } = galleryTorus(peers, 20_000);
  const four = points.slice(0, 4);
  const [, all] = timed(() => mesh.centerOfMass(four, weights, options));
  const again = Array.from({ length: 9 }, (_, k) => {
    const w = 0.1 + 0.05 * k;
    return timed(() => mesh.centerOfMass(four, [w, 0.3, 0.2, 0.5 - w], options))[1];
  });
  mesh.dispose();
  const centerMs = middle(again);
  return { fieldsMs: all - centerMs, centerMs };
}

function update(peers: Peers): Studies['update'] {
  const { mesh, points } = galleryTorus(peers, 60_000);
  const options = { method: 'paper', solver: 'graph', rings: 6 } as const;
  const curve = mesh.curve({ kind: 'bspline', points, samples: 256, levels: 0, ...options });
  const segments = 4;
  const runs = [0.6, 0.5, 0.4].map((s) => {
    curve.movePoint(3, { face: points[3]!.face, bary: [s, 1 - s, 0] });
    return curve.times();
  });
  const { triangles } = mesh.info;
  mesh.dispose();
  const fieldMs = middle(runs.map(({ fields }) => fields));
  return { fieldMs, segmentMs: middle(runs.map(({ trace }) => trace)) / segments, triangles };
}

function reweigh(peers: Peers): Studies['reweigh'] {
  const { mesh, points } = galleryTorus(peers, 20_000);
  const curve = mesh.curve({
    kind: 'rational',
    points: points.slice(0, 4),
    weights: [1, 1, 1, 1],
    levels: 0,
    samples: 128,
    method: 'paper',
    solver: 'exact',
  });
  const [, updateMs] = timed(() => curve.set({ ...curve.value(), weights: [0.05, 5, 5, 0.05] }));
  const fieldsMs = curve.times().fields;
  mesh.dispose();
  return { fieldsMs, updateMs };
}

function arcs(peers: Peers): Studies['arcs'] {
  const mesh = peers.karcher.shape('sphere', 20_000);
  const center = { face: 100, bary: [0.3, 0.3, 0.4] } as SurfacePoint;
  const radius = 0.8;
  const worstOf = (arcs: number, levels: 0 | 'auto') => {
    const { samples } = mesh.circle(center, { radius, arcs, samples: 9, levels });
    let worst = 0;
    for (let i = 0; i < samples.count; i++) {
      const [a, b, c] = samples.bary.slice(3 * i, 3 * i + 3);
      const point = { face: samples.face[i]!, bary: [a!, b!, c!] } as SurfacePoint;
      worst = Math.max(worst, Math.abs(mesh.shortestPath(center, point).length / radius - 1));
    }
    return worst;
  };
  const result = [3, 7, 16].map((arcs) => ({
    arcs,
    worst: worstOf(arcs, 0),
    byDefault: worstOf(arcs, 'auto'),
  }));
  mesh.dispose();
  return result;
}

function inverse(peers: Peers): Studies['inverse'] {
  const mesh = peers.karcher.shape('torus', 5_000);
  const { triangles, meanEdge } = mesh.info;
  const random = randomFrom(studySeed);
  const cases = 100;
  let [minima, back, farthest] = [0, 0, 0];
  const inside = (face: number): SurfacePoint => {
    const [a, b, c] = randomWeights(random, 3);
    return { face, bary: [a!, b!, c!] };
  };
  for (let k = 0; k < cases; k++) {
    const x = inside(Math.floor(triangles * random()));
    // Four points around x, at distances of at most a third of the tube's girth.
    const points = [0, 1, 2, 3].map((i) => {
      const angle = (Math.PI / 2) * (i + 0.6 * random());
      const direction = [Math.cos(angle), Math.sin(angle), 0.3 * (random() - 0.5)];
      return mesh.straightest(x, direction, 0.25 + 0.5 * random()).end;
    });
    const { weights, isMinimum } = mesh.weightsOf(x, points);
    if (!isMinimum) continue;
    minima++;
    const { point } = mesh.centerOfMass(points, weights, { start: x });
    const away = mesh.shortestPath(x, point).length / meanEdge;
    farthest = Math.max(farthest, away);
    if (away <= 1e-9) back++;
  }
  mesh.dispose();
  return { cases, minima, back, farthest };
}

/** The numbers of triangles of the tori. */
const growthSizes: readonly number[] = [5_000, 20_000, 80_000, 240_000];

/** The time after which a method counts as failed. */
const growthBudgetMs = 120_000;
const growthMethods = ['vectorHeat', 'weightedAverages', 'paper', 'karcher', 'leveled'] as const;

export async function growth(peers: Peers): Promise<Studies['growth']> {
  const result: Studies['growth'] = [];
  for (const size of growthSizes) {
    const { mesh, points } = galleryTorus(peers, size);
    const plan = peers.plan(points, 128);
    for (const method of growthMethods) {
      const options = { once: true, budgetMs: growthBudgetMs };
      const run = await runMethod(peers, mesh, plan, standardOptions(method, plan), null, options);
      const ms = run.ok && run.traceMs !== null ? (run.prepareMs ?? 0) + run.traceMs : null;
      result.push({ method, triangles: mesh.info.triangles, ms, reason: run.reason });
    }
    mesh.dispose();
  }
  return result;
}

async function large(peers: Peers): Promise<Studies['large']> {
  const { mesh, points } = galleryTorus(peers, 250_000);
  const plan = peers.plan(points, 128);
  const result: Studies['large'] = [];
  for (const method of ['paper', 'karcher', 'leveled'] as const) {
    const options = standardOptions(method, plan);
    const { prepareMs, dragMs, reason } = await runMethod(peers, mesh, plan, options, null);
    result.push({ method, triangles: mesh.info.triangles, prepareMs, dragMs, reason });
  }
  mesh.dispose();
  return result;
}

/** Each study by its name, with a description. */
const studies: {
  [Name in keyof Studies]: [string, (peers: Peers) => Studies[Name] | Promise<Studies[Name]>];
} = {
  radius: ['how far apart points may lie', (all) => radius(all)],
  newton: ['Newton’s steps', (all) => newton(all)],
  oneCenter: ['one center of mass', oneCenter],
  update: ['an update', update],
  reweigh: ['a change of weights', reweigh],
  arcs: ['arcs of circles', arcs],
  inverse: ['weights of points', inverse],
  roughness: ['rough surfaces', (all) => roughness(all)],
  spread: ['points far apart', (all) => spread(all)],
  descent: ['paths between pairs of points', (all) => descent(all)],
  growth: ['ever finer meshes', growth],
  convergence: ['convergence', (all) => convergence(all)],
  large: ['a large mesh', large],
};

export const studyNames = Object.keys(studies) as (keyof Studies)[];

/** Runs the studies of these names. All studies together take a minute or two. */
export async function runStudies(
  peers: Peers,
  tell: (what: string) => void = () => {},
  names: readonly (keyof Studies)[] = studyNames,
): Promise<Partial<Studies>> {
  const result: Record<string, unknown> = {};
  for (const name of names) {
    const [what, work] = studies[name];
    tell(`Study: ${what}`);
    result[name] = await work(peers);
  }
  return result as Partial<Studies>;
}
