import { checkNumber, checkOptions, namesOf, toFloat64 } from '../check.js';
import { KarcherError } from '../errors.js';
import type { EngineRegion } from '../karcher-engine.mjs';
import type { RegionValue } from '../path_values.js';
import { Region } from '../region.js';
import type { PointLike, SurfacePoint } from '../types.js';
import type { AnyMesh } from './energy.js';
import { inFace } from './fans.js';

/** The options of the search for a centroid. */
export interface CentroidOptions {
  /**
   * The point where the search starts; by default the surface's point nearest to the region's
   * centroid in space.
   */
  start?: PointLike | undefined;
  /** The largest number of points that represent the region; 1000 by default. */
  samples?: number | undefined;
  /**
   * The search ends after a step that is shorter than this, relative to the diagonal. The default
   * is 1e-7.
   */
  tolerance?: number | undefined;
  /** The largest number of steps; the default is 100. */
  mostSteps?: number | undefined;
  /**
   * The mass per area: a value of at least 0 for each vertex, linear in triangles. Of welded
   * vertices, the value of the first counts. By default it is 1 everywhere.
   */
  density?: ArrayLike<number> | undefined;
}

/** The centroid of a region, and the result of the search for it. */
export interface Centroid {
  /** The centroid as a point of the surface. It need not lie in the region. */
  point: SurfacePoint;
  /** The place of that point in space. */
  position: [number, number, number];
  /** The number of points that represent the region. */
  samples: number;
  /** The number of steps of the search. */
  steps: number;
  /** Whether the last step was shorter than the tolerance. */
  converged: boolean;
}

const names = namesOf<CentroidOptions>({
  start: true,
  samples: true,
  tolerance: true,
  mostSteps: true,
  density: true,
});

/** A part of the region: the point that represents it, its place in space, and its mass. */
interface Patch {
  point: SurfacePoint;
  place: readonly [number, number, number];
  mass: number;
}

/**
 * The centroid of a region, or with `'all'` of the whole surface. It is the center of mass of the
 * area, or of a density on it: the point where the integral of the squared distance over the region
 * has a minimum.
 *
 * The computation puts the mass of each triangle, or of its part in the region, at the centroid of
 * the triangle or part. This is exact to rounding on a plane; on smooth surfaces the error is of
 * the order of the squared edge length. If there are more points than `samples`, neighbors form
 * groups, and the error is of the order of the groups' squared size. On the unit sphere of 20,000
 * triangles, centroids of caps were up to .0015 off with 1000 samples, and 6e-5 with all. Distances
 * are those of locally shortest paths (`Mesh.logMap`).
 *
 * Rejects with `KarcherError` badArgument for a region without area or mass, for a density that is
 * negative or not finite at a vertex or has another number of values, and for samples below 1;
 * otherwise as `Mesh.logMap` does.
 *
 * @example
 * ```ts
 * const height = Array.from({ length: mesh.info.vertices }, (_, v) => mesh.position({ vertex: v })[2]);
 * const density = height.map((z) => Math.exp(-z * z));
 * (await centroid(mesh, 'all', { density })).point;
 * ```
 */
export async function centroid(
  mesh: AnyMesh,
  region: Region | RegionValue | 'all',
  given: CentroidOptions = {},
): Promise<Centroid> {
  checkOptions(given, names);
  const { samples = 1000, tolerance = 1e-7, mostSteps = 100 } = given;
  const most = Math.floor(checkNumber(samples, 'the samples'));
  if (!(most >= 1)) {
    throw new KarcherError('badArgument', `there must be at least one sample, not ${samples}`);
  }
  const least = checkNumber(tolerance, 'the tolerance') * mesh.info.diagonal;
  const positions = await mesh.positions();
  const triangles = await mesh.triangles();
  const { areFaces } = await mesh.kept();
  const density = checkDensity(given.density, positions.length / 3);
  const data =
    region === 'all'
      ? allOf(triangles)
      : (region instanceof Region ? region : Region.from(region)).data();
  const patches = grouped(patchesOf(data, positions, triangles, areFaces, density), most);
  const mass = patches.reduce((sum, patch) => sum + patch.mass, 0);
  if (!(mass > 0)) {
    const what = given.density ? 'mass' : 'area';
    throw new KarcherError('badArgument', `the region has no ${what}, so it has no centroid`);
  }
  const points = patches.map(({ point }) => point);
  const way = async (from: PointLike): Promise<[number, number, number]> => {
    const { vectors } = await mesh.logMap(from, points);
    const sum: [number, number, number] = [0, 0, 0];
    patches.forEach((patch, i) => {
      for (let k = 0; k < 3; k++) sum[k]! += (patch.mass / mass) * vectors[3 * i + k]!;
    });
    return sum;
  };
  let point = given.start ?? (await mesh.nearestPoint(meanPlace(patches))).point;
  let step = await way(point);
  let part = 1;
  let steps = 0;
  for (; steps < mostSteps && Math.hypot(...step) > least; steps++) {
    const vector = Float64Array.from(step, (value) => part * value);
    const { points: ends } = await mesh.expMap(point, vector);
    const next = await way(ends[0]!);
    // A step that led too far is repeated, half as long.
    if (Math.hypot(...next) > Math.hypot(...step)) {
      part /= 2;
      continue;
    }
    point = ends[0]!;
    step = next;
  }
  return {
    point: await inFace(mesh, point),
    position: await mesh.position(point),
    samples: points.length,
    steps,
    converged: Math.hypot(...step) <= least,
  };
}

/** The given density, checked; by default 1 at each vertex. */
function checkDensity(given: ArrayLike<number> | undefined, vertices: number): ArrayLike<number> {
  if (given === undefined) return new Float64Array(vertices).fill(1);
  const density = toFloat64(given, 'the density');
  if (density.length !== vertices) {
    const sentence = `there are ${vertices} vertices but ${density.length} values of the density`;
    throw new KarcherError('badArgument', sentence);
  }
  const bad = density.findIndex((value) => !(value >= 0 && value < Infinity));
  if (bad < 0) return density;
  const sentence = `the density of vertex ${bad} must be finite and at least 0, not ${density[bad]}`;
  throw new KarcherError('badArgument', sentence);
}

type Parts = Pick<EngineRegion, 'share' | 'triangles' | 'sides'>;

const allOf = (triangles: Int32Array): Parts => ({
  share: new Uint8Array(triangles.length / 3).fill(1),
  triangles: new Int32Array(0),
  sides: new Float64Array(0),
});

/** The sides of a whole triangle, in its second and third weights. */
const whole = Float64Array.of(0, 0, 1, 0, 1, 0, 0, 1, 0, 1, 0, 0);

/**
 * The patches of a region: its whole triangles, and its parts of other triangles, without triangles
 * that are no part of the surface (`EngineKept.areFaces`).
 */
function patchesOf(
  { share, triangles: parts, sides }: Parts,
  positions: Float64Array,
  triangles: Int32Array,
  areFaces: Uint8Array,
  density: ArrayLike<number>,
): Patch[] {
  const patches: Patch[] = [];
  const corner = (face: number, k: number) => {
    const at = 3 * triangles[3 * face + k]!;
    return [positions[at]!, positions[at + 1]!, positions[at + 2]!] as const;
  };
  /** Adds the area that some sides enclose, with its mass and center of mass. */
  const add = (face: number, around: Float64Array) => {
    if (!areFaces[face]) return;
    const [a, b, c] = [corner(face, 0), corner(face, 1), corner(face, 2)];
    const [u, v] = [b, c].map((to) => to.map((value, k) => value - a[k]!)) as [number[], number[]];
    const cross = [0, 1, 2].map((k) => {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      return u[i]! * v[j]! - u[j]! * v[i]!;
    });
    const [d, dx, dy] = [0, 1, 2].map((k) => density[triangles[3 * face + k]!]!) as Three;
    const at = (x: number, y: number) => d + x * (dx - d) + y * (dy - d);
    // Each side adds the triangle between it and the first corner (Green's theorem), in the
    // coordinates of the face.
    let [mass, x, y] = [0, 0, 0];
    for (let i = 0; i < around.length; i += 4) {
      const [ax, ay, bx, by] = around.subarray(i, i + 4) as unknown as Four;
      const turn = ax * by - ay * bx;
      const [atA, atB] = [at(ax, ay), at(bx, by)];
      const sum = d + atA + atB;
      mass += (turn * sum) / 6;
      x += (turn * (ax * (atA + sum) + bx * (atB + sum))) / 24;
      y += (turn * (ay * (atA + sum) + by * (atB + sum))) / 24;
    }
    if (mass === 0) return;
    // In a sliver, rounding may lead out of the triangle.
    x = Math.min(1, Math.max(0, x / mass));
    y = Math.min(1 - x, Math.max(0, y / mass));
    patches.push({
      point: { face, bary: [Math.max(0, 1 - x - y), x, y] },
      place: a.map((value, k) => value + x * u[k]! + y * v[k]!) as unknown as Patch['place'],
      mass: Math.abs(mass) * Math.hypot(...cross),
    });
  };
  share.forEach((part, face) => {
    if (part === 1) add(face, whole);
  });
  for (let i = 0; i < parts.length; ) {
    const first = i;
    while (parts[i] === parts[first]) i++;
    add(parts[first]!, sides.subarray(4 * first, 4 * i));
  }
  return patches;
}

type Three = [number, number, number];
type Four = [number, number, number, number];

/**
 * At most `most` patches: neighbors along a space-filling curve form groups of about the same mass.
 */
function grouped(patches: Patch[], most: number): Patch[] {
  if (patches.length <= most) return patches;
  const low = [0, 1, 2].map((k) => Math.min(...extremes(patches, k)));
  const high = [0, 1, 2].map((k) => Math.max(...extremes(patches, k)));
  const size = Math.max(...high.map((value, k) => value - low[k]!)) || 1;
  const codes = new Map(
    patches.map((patch) => [patch, codeOf(patch.place.map((x, k) => (x - low[k]!) / size))]),
  );
  const order = [...patches].sort((a, b) => codes.get(a)! - codes.get(b)!);
  const each = patches.reduce((sum, { mass }) => sum + mass, 0) / most;
  const groups: Patch[] = [];
  let group: Patch[] = [];
  let mass = 0;
  for (const patch of order) {
    group.push(patch);
    mass += patch.mass;
    if (mass < each * (groups.length + 1) && patch !== order.at(-1)) continue;
    groups.push(middleOf(group));
    group = [];
  }
  return groups;
}

/** The least and the largest coordinate `k` of the patches' places. */
function extremes(patches: readonly Patch[], k: number): [number, number] {
  const within: [number, number] = [Infinity, -Infinity];
  for (const { place } of patches) {
    within[0] = Math.min(within[0], place[k]!);
    within[1] = Math.max(within[1], place[k]!);
  }
  return within;
}

/**
 * The number of a place in the unit cube along Morton's curve: the bits of its coordinates in turn.
 */
function codeOf(place: readonly number[]): number {
  let code = 0;
  for (let bit = 9; bit >= 0; bit--) {
    for (const x of place) code = 2 * code + ((Math.min(1023, Math.floor(1024 * x)) >> bit) & 1);
  }
  return code;
}

const meanPlace = (patches: readonly Patch[]): [number, number, number] => {
  const sum: [number, number, number] = [0, 0, 0];
  let all = 0;
  for (const { place, mass } of patches) {
    all += mass;
    for (let k = 0; k < 3; k++) sum[k]! += mass * place[k]!;
  }
  return sum.map((value) => value / all) as [number, number, number];
};

/** The patch nearest to the middle of a group, with the mass of the whole group. */
function middleOf(group: readonly Patch[]): Patch {
  const middle = meanPlace(group);
  const apart = ({ place }: Patch) => Math.hypot(...place.map((x, k) => x - middle[k]!));
  const nearest = group.reduce((best, patch) => (apart(patch) < apart(best) ? patch : best));
  return { ...nearest, mass: group.reduce((sum, { mass }) => sum + mass, 0) };
}
