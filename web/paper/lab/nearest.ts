import type { SurfacePoint } from 'karcher';
import { vectors } from 'karcher/peers';
import type { Vector } from '../figures/types';

const { at, cross, distance, dot, scaled, subtract } = vectors;

/** A search for points of a mesh near points of space. */
export class NearestPoints {
  readonly #positions: Float64Array;
  readonly #triangles: Int32Array;
  /** The centroid of each triangle, and the radius of a ball around it that contains the triangle. */
  readonly #balls: Float64Array;

  constructor(positions: Float64Array, triangles: Int32Array) {
    this.#positions = positions;
    this.#triangles = triangles;
    this.#balls = new Float64Array((4 * triangles.length) / 3);
    for (let f = 0; f < triangles.length / 3; f++) {
      const corners = this.#corners(f);
      const center = [0, 1, 2].map((c) => corners.reduce((sum, p) => sum + p[c]! / 3, 0)) as Vector;
      this.#balls.set([...center, Math.max(...corners.map((p) => distance(p, center)))], 4 * f);
    }
  }

  /** The point of the surface nearest to `place`. */
  point(place: Vector): SurfacePoint {
    let best = { face: 0, bary: [1, 0, 0] as Vector, distance: Number.POSITIVE_INFINITY };
    for (let f = 0; f < this.#triangles.length / 3; f++) {
      const ball = this.#balls.subarray(4 * f, 4 * f + 4);
      const reach = best.distance + ball[3]!;
      const [dx, dy, dz] = [place[0] - ball[0]!, place[1] - ball[1]!, place[2] - ball[2]!];
      if (dx * dx + dy * dy + dz * dz > reach * reach) continue;
      const corners = this.#corners(f);
      const bary = nearestInTriangle(corners, place);
      const there = [0, 1, 2].map((c) => corners.reduce((s, p, k) => s + bary[k]! * p[c]!, 0));
      const away = distance(place, there as Vector);
      if (away < best.distance) best = { face: f, bary, distance: away };
    }
    return { face: best.face, bary: best.bary };
  }

  /** The index of the vertex nearest to `place`, among the vertices that belong to triangles. */
  vertex(place: Vector): number {
    let [best, least] = [0, Number.POSITIVE_INFINITY];
    for (const v of this.#triangles) {
      const away = distance(place, at(this.#positions, v));
      if (away < least) [best, least] = [v, away];
    }
    return best;
  }

  #corners(f: number): [Vector, Vector, Vector] {
    const corner = (k: number) => at(this.#positions, this.#triangles[3 * f + k]!);
    return [corner(0), corner(1), corner(2)];
  }
}

/** The barycentric weights of the triangle's point that is nearest to p. */
function nearestInTriangle([a, b, c]: [Vector, Vector, Vector], p: Vector): Vector {
  const normal = cross(subtract(b, a), subtract(c, a));
  const area = dot(normal, normal);
  if (area > 0) {
    const v = dot(cross(subtract(p, a), subtract(c, a)), normal) / area;
    const w = dot(cross(subtract(b, a), subtract(p, a)), normal) / area;
    if (v >= 0 && w >= 0 && v + w <= 1) return [1 - v - w, v, w];
  }
  const sides: { weights: (s: number) => Vector; from: Vector; to: Vector }[] = [
    { from: a, to: b, weights: (s) => [1 - s, s, 0] },
    { from: b, to: c, weights: (s) => [0, 1 - s, s] },
    { from: c, to: a, weights: (s) => [s, 0, 1 - s] },
  ];
  let best: Vector = [1, 0, 0];
  let least = Number.POSITIVE_INFINITY;
  for (const { from, to, weights } of sides) {
    const side = subtract(to, from);
    const s = Math.min(1, Math.max(0, dot(subtract(p, from), side) / dot(side, side)));
    const away = distance(p, [0, 1, 2].map((k) => from[k]! + s * side[k]!) as Vector);
    if (away < least) [best, least] = [weights(s), away];
  }
  return best;
}

/** The point at a fraction of a polyline's length. */
export function alongPolyline(polyline: ArrayLike<number>, part: number): Vector {
  const count = polyline.length / 3;
  const lengths = [0];
  for (let i = 1; i < count; i++) {
    lengths.push(lengths[i - 1]! + distance(at(polyline, i - 1), at(polyline, i)));
  }
  const wanted = part * lengths.at(-1)!;
  for (let i = 1; i < count; i++) {
    if (lengths[i]! < wanted && i < count - 1) continue;
    const piece = lengths[i]! - lengths[i - 1]!;
    const s = piece > 0 ? Math.min(1, (wanted - lengths[i - 1]!) / piece) : 0;
    const [from, to] = [at(polyline, i - 1), at(polyline, i)];
    return [0, 1, 2].map((c) => from[c]! + s * (to[c]! - from[c]!)) as Vector;
  }
  return at(polyline, 0);
}

export const middle = (points: readonly Vector[]): Vector =>
  scaled(
    points.reduce((sum, p) => [sum[0] + p[0], sum[1] + p[1], sum[2] + p[2]], [0, 0, 0] as Vector),
    1 / points.length,
  );
