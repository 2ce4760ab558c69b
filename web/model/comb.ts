/**
 * A curvature comb: teeth along a curve, whose lengths show its curvature within the surface. The
 * curvature at a point is the curvature of a circle through three points: this point, and the
 * points before and after it at a fixed distance, the window. The component of the curvature in the
 * tangent plane is the geodesic curvature, exact for circles in space.
 */
import type { Vector } from './figure';
import { cross, dot, minus, scaled } from './vectors';

export interface Tooth {
  /** The foot of the tooth, on the curve. */
  foot: Vector;
  /** The geodesic curvature, positive where the curve turns left, seen from outside. */
  curvature: number;
  /** The unit vector in the tangent plane to the left of the curve. */
  left: Vector;
}

export interface Comb {
  teeth: Tooth[];
  /** The number of the curve's corners. A corner has no curvature and no teeth. */
  corners: number;
  closed: boolean;
}

/**
 * A polyline has a corner where it turns within the surface by more than this angle, in radians.
 */
const cornerAngle = Math.PI / 6;

/**
 * The teeth of a polyline, evenly spaced by length. `polyline` has x, y, z of each point, and
 * `countOn` returns the number of teeth for a length. The curvature at a tooth follows from the
 * points at the distance `window` before and after it, or at a quarter of the length if that is
 * less. No tooth is nearer than this distance to a corner, or to an end of an open curve.
 * `normalAt` returns the surface's unit normal.
 */
export function combOf(
  polyline: ArrayLike<number>,
  normalAt: (place: Vector) => Vector,
  countOn: (length: number) => number,
  window: number,
): Comb {
  const line = new Arclength(polyline);
  const { length, closed } = line;
  if (!(length > 0)) return { teeth: [], corners: 0, closed };
  const count = countOn(length);
  const reach = Math.min(window, length / 4);
  const [first, room] = closed ? [0, length] : [reach, length - 2 * reach];
  const teeth: Tooth[] = [];
  const corners = line.corners(normalAt);
  for (let i = 0; i < count; i++) {
    const at = first + (room * i) / (closed ? count : Math.max(1, count - 1));
    if (corners.some((corner) => line.between(at, corner) < reach)) continue;
    const foot = line.at(at);
    const [before, after] = [minus(foot, line.at(at - reach)), minus(line.at(at + reach), foot)];
    const [a, b] = [norm(before), norm(after)];
    if (!(a > 0 && b > 0)) continue;
    const [from, to] = [scaled(before, 1 / a), scaled(after, 1 / b)];
    const curvature = scaled(minus(to, from), 2 / (a + b));
    const along = [0, 1, 2].map((axis) => from[axis]! + to[axis]!) as Vector;
    const left = cross(normalAt(foot), along);
    const unit = scaled(left, 1 / norm(left));
    teeth.push({ foot, curvature: dot(curvature, unit), left: unit });
  }
  return { teeth, corners: corners.length, closed };
}

/** The quantile of the teeth's absolute curvatures for the given share; 0 without teeth. */
export function usualCurvature(combs: readonly Comb[], share: number): number {
  const sizes = combs.flatMap(({ teeth }) => teeth.map(({ curvature }) => Math.abs(curvature)));
  sizes.sort((a, b) => a - b);
  return sizes[Math.floor(share * (sizes.length - 1))] ?? 0;
}

/** A polyline parametrized by length. */
class Arclength {
  readonly #lengths: Float64Array;
  readonly closed: boolean;

  constructor(private readonly line: ArrayLike<number>) {
    const count = Math.floor(line.length / 3);
    this.#lengths = new Float64Array(count);
    for (let i = 1; i < count; i++) {
      this.#lengths[i] = this.#lengths[i - 1]! + this.#apart(i - 1, i);
    }
    const gap = count > 2 ? this.#apart(0, count - 1) : Infinity;
    this.closed = gap <= 1e-5 * this.length;
  }

  get length(): number {
    return this.#lengths.at(-1) ?? 0;
  }

  /**
   * The place at a length from the start. On a closed line, lengths below 0 and beyond the end wrap
   * around.
   */
  at(wanted: number): Vector {
    const { length } = this;
    const at = this.closed ? ((wanted % length) + length) % length : wanted;
    let [low, high] = [0, this.#lengths.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.#lengths[middle]! <= at) low = middle;
      else high = middle;
    }
    const step = this.#lengths[high]! - this.#lengths[low]!;
    const part = step > 0 ? Math.min(1, Math.max(0, (at - this.#lengths[low]!) / step)) : 0;
    const [p, q] = [this.#vertex(low), this.#vertex(high)];
    return [0, 1, 2].map((axis) => p[axis]! + part * (q[axis]! - p[axis]!)) as Vector;
  }

  /** The distance between two places along the line. */
  between(a: number, b: number): number {
    const apart = Math.abs(a - b);
    return this.closed ? Math.min(apart, this.length - apart) : apart;
  }

  /** The lengths at which the line has corners. */
  corners(normalAt: (place: Vector) => Vector): number[] {
    const last = this.#lengths.length - 1;
    // Consecutive vertices at the same place have no direction between them.
    const kept = this.#lengths.length > 0 ? [0] : [];
    for (let i = 1; i <= last; i++) if (this.#lengths[i]! > this.#lengths[i - 1]!) kept.push(i);
    const corners: number[] = [];
    for (let k = 0; k < kept.length - 1; k++) {
      const i = kept[k]!;
      if (k === 0 ? !this.closed : i === last) continue;
      const [from, to] = [k === 0 ? kept.at(-2)! : kept[k - 1]!, kept[k + 1]!];
      if (!this.#turns(from, i, to)) continue;
      const at = this.#vertex(i);
      const [before, after] = [minus(at, this.#vertex(from)), minus(this.#vertex(to), at)];
      // A bend over an edge of the surface does not count, since it is no turn within the surface.
      const normal = normalAt(at);
      const within = (p: Vector) => minus(p, scaled(normal, dot(p, normal)));
      if (turns(within(before), within(after))) corners.push(this.#lengths[i]!);
    }
    return corners;
  }

  #apart(i: number, j: number): number {
    return Math.sqrt(this.#dot(i, j, i, j));
  }

  /**
   * Whether the line turns much at a vertex. It allocates nothing, since most vertices do not turn.
   */
  #turns(from: number, at: number, to: number): boolean {
    const lengths = Math.sqrt(this.#dot(from, at, from, at) * this.#dot(at, to, at, to));
    return this.#dot(from, at, at, to) < cornerCosine * lengths;
  }

  /** The dot product of the steps from a to b and from c to d. */
  #dot(a: number, b: number, c: number, d: number): number {
    const { line } = this;
    let sum = 0;
    for (let axis = 0; axis < 3; axis++) {
      const step = line[3 * b + axis]! - line[3 * a + axis]!;
      sum += step * (line[3 * d + axis]! - line[3 * c + axis]!);
    }
    return sum;
  }

  #vertex(i: number): Vector {
    return [this.line[3 * i]!, this.line[3 * i + 1]!, this.line[3 * i + 2]!];
  }
}

const cornerCosine = Math.cos(cornerAngle);
const turns = (p: Vector, q: Vector) => dot(p, q) < cornerCosine * norm(p) * norm(q);
const norm = (p: Vector) => Math.sqrt(dot(p, p));
