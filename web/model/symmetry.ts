/**
 * Mirror planes: a plane through three places, and the one in which a surface is its own mirror
 * image.
 */
import type { Vector } from './figure';
import { cross, dot, minus } from './vectors';

/** A plane: the places whose dot product with the unit normal is the offset. */
export interface Plane {
  normal: Vector;
  offset: number;
}

export interface Symmetry {
  plane: Plane;
  /** The distance from the surface that most mirrored samples do not exceed. */
  apart: number;
}

/** The surface's nearest point to a place, and its unit normal there. */
export type NearestPlace = (place: Vector) => { place: Vector; normal: Vector };

const unit = (a: Vector): Vector => {
  const length = Math.hypot(...a);
  return a.map((value) => value / length) as Vector;
};

export function mirroredPlace({ normal, offset }: Plane, place: Vector): Vector {
  const by = 2 * (dot(normal, place) - offset);
  return place.map((value, axis) => value - by * normal[axis]!) as Vector;
}

export const mirroredDirection = ({ normal }: Plane, direction: Vector): Vector =>
  mirroredPlace({ normal, offset: 0 }, direction);

/** The plane through three places; null if they lie on a line. */
export function planeThrough(a: Vector, b: Vector, c: Vector): Plane | null {
  const [ab, ac] = [minus(b, a), minus(c, a)];
  const normal = cross(ab, ac);
  if (!(Math.hypot(...normal) > 1e-9 * Math.hypot(...ab) * Math.hypot(...ac))) return null;
  const direction = unit(normal);
  return { normal: direction, offset: dot(direction, a) };
}

/**
 * The fraction of the mirrored samples that must lie near the surface. For the rest, the surface
 * may be damaged, or missing at a boundary.
 */
const near = 0.7;
/** The number of directions to try. Every direction lies within some 10 degrees of one of them. */
const tried = 96;
/** The number of best directions for refinement. */
const followed = 8;
const mostSteps = 20;
/** Planes up to this much worse than the best one count as equally good. The first of them wins. */
const asGood = { times: 1.25, more: 1e-4 };

/**
 * The plane in which evenly spread samples of a surface have mirror images nearest to the surface.
 * The search tries many planes through the samples' center and refines the best ones: each
 * refinement brings the mirror images nearer to the tangent planes at their nearest places. The
 * first of the `preferred` directions wins unless others are better. The search awaits `pause` now
 * and then.
 */
export async function symmetryOf(
  samples: readonly Vector[],
  nearest: NearestPlace,
  preferred: readonly Vector[],
  pause: () => Promise<void>,
): Promise<Symmetry | null> {
  if (samples.length === 0) return null;
  const middle = [0, 1, 2].map(
    (axis) => samples.reduce((sum, place) => sum + place[axis]!, 0) / samples.length,
  ) as Vector;
  const few = samples.filter((_, i) => i % Math.ceil(samples.length / 120) === 0);
  const candidates: Symmetry[] = [];
  for (const normal of [...preferred, ...directions(tried)]) {
    const plane = { normal, offset: dot(normal, middle) };
    candidates.push({ plane, apart: apartOf(plane, few, nearest) });
    await pause();
  }
  const rest = candidates.slice(preferred.length).sort((a, b) => a.apart - b.apart);
  const found: Symmetry[] = [];
  for (const { plane } of [...candidates.slice(0, preferred.length), ...rest.slice(0, followed)]) {
    const fitted = fittedPlane(plane, few, nearest);
    found.push({ plane: fitted, apart: apartOf(fitted, few, nearest) });
    await pause();
  }
  const least = Math.min(...found.map(({ apart }) => apart));
  const first = found.find(({ apart }) => apart <= asGood.times * least + asGood.more)!;
  const plane = fittedPlane(first.plane, samples, nearest);
  return { plane, apart: apartOf(plane, samples, nearest) };
}

/** Unit vectors spread evenly over half a sphere, on a spiral. */
function directions(count: number): Vector[] {
  const turn = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, i) => {
    const z = 1 - (i + 0.5) / count;
    const radius = Math.sqrt(1 - z * z);
    return [radius * Math.cos(turn * i), radius * Math.sin(turn * i), z];
  });
}

/** The distance from the surface that most mirrored samples do not exceed. */
function apartOf(plane: Plane, samples: readonly Vector[], nearest: NearestPlace): number {
  const distances = samples
    .map((sample) => {
      const image = mirroredPlace(plane, sample);
      return Math.hypot(...minus(image, nearest(image).place));
    })
    .sort((a, b) => a - b);
  return distances[Math.floor(near * (samples.length - 1))]!;
}

/**
 * The plane, turned and shifted so that the mirrored samples lie nearest to the surface:
 * Gauss-Newton steps in which far samples have little weight.
 */
function fittedPlane(begin: Plane, samples: readonly Vector[], nearest: NearestPlace): Plane {
  let plane = begin;
  for (let step = 0; step < mostSteps; step++) {
    const { normal, offset } = plane;
    const least = normal.map(Math.abs).indexOf(Math.min(...normal.map(Math.abs)));
    const axis = [0, 1, 2].map((i) => Number(i === least)) as Vector;
    const aside = unit(cross(normal, axis));
    const sides = [aside, cross(normal, aside)] as const;
    const images = samples.map((sample) => {
      const image = mirroredPlace(plane, sample);
      const there = nearest(image);
      const gap = minus(image, there.place);
      return { sample, there, gap, far: Math.hypot(...gap) };
    });
    const median = images.map(({ far }) => far).sort((a, b) => a - b)[samples.length >> 1]!;
    const width = Math.max(2 * median, 1e-9);
    const matrix = new Float64Array(9);
    const right = new Float64Array(3);
    for (const { sample, there, gap, far } of images) {
      const weight = 1 / (1 + (far / width) ** 2) ** 2;
      const height = dot(normal, sample) - offset;
      const facing = dot(there.normal, normal);
      const slopes = [
        ...sides.map(
          (side) => -2 * (dot(side, sample) * facing + height * dot(there.normal, side)),
        ),
        2 * facing,
      ];
      const rest = dot(there.normal, gap);
      for (let i = 0; i < 3; i++) {
        right[i]! -= weight * slopes[i]! * rest;
        for (let j = 0; j < 3; j++) matrix[3 * i + j]! += weight * slopes[i]! * slopes[j]!;
      }
    }
    const by = solved(matrix, right);
    if (!by) return plane;
    const moved = normal.map(
      (value, i) => value + by[0] * sides[0][i]! + by[1] * sides[1][i]!,
    ) as Vector;
    const length = Math.hypot(...moved);
    plane = { normal: unit(moved), offset: (offset + by[2]) / length };
    if (Math.hypot(...by) < 1e-9) return plane;
  }
  return plane;
}

/**
 * The solution of three equations, damped for surfaces that a rotation leaves unchanged; null if they
 * have none.
 */
function solved(matrix: Float64Array, right: Float64Array): Vector | null {
  const size = matrix[0]! + matrix[4]! + matrix[8]!;
  if (!(size > 0)) return null;
  const rows = [0, 1, 2].map((i) => [...matrix.slice(3 * i, 3 * i + 3)] as Vector) as [
    Vector,
    Vector,
    Vector,
  ];
  for (let i = 0; i < 3; i++) rows[i]![i]! += 1e-9 * size;
  const [a, b, c] = rows;
  const determinant = dot(a, cross(b, c));
  if (!(determinant > 0)) return null;
  const [x, y, z] = [cross(b, c), cross(c, a), cross(a, b)];
  return [0, 1, 2].map(
    (i) => (x[i]! * right[0]! + y[i]! * right[1]! + z[i]! * right[2]!) / determinant,
  ) as Vector;
}
