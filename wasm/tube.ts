import { badArgument, checkInteger, checkPositive } from './check.js';
import { at, cross, dot, subtract, type Vector } from './vectors.js';

/**
 * Tubes along polylines, as plain arrays. Each point has a ring of vertices in the plane
 * perpendicular to the mean direction of its two segments. The direction to the ring's first vertex
 * is perpendicular to the given normal. Without normals, this direction is transported along the
 * polyline, so that the tube does not twist.
 */

export interface TubeLine {
  /** x, y, z of each point. */
  places: ArrayLike<number>;
  /** The upward direction at each point: x, y, z. */
  normals?: ArrayLike<number>;
  /** Whether the line ends where it starts. The last point may repeat the first. */
  closed: boolean;
}

export interface Tube {
  positions: Float64Array;
  /** The directions from the polyline to the vertices, of length 1. */
  normals: Float64Array;
  triangles: Uint32Array;
}

const plus = (a: Vector, s: number, b: Vector, t: number): Vector => [
  s * a[0] + t * b[0],
  s * a[1] + t * b[1],
  s * a[2] + t * b[2],
];

/** The vector scaled to length 1; null for the zero vector. */
function unit(a: Vector): Vector | null {
  const length = Math.hypot(...a);
  return length > 0 ? [a[0] / length, a[1] / length, a[2] / length] : null;
}

/** A unit vector at right angles to a unit vector, and to the axis of its smallest coordinate. */
function anyAcross(a: Vector): Vector {
  const sizes = a.map(Math.abs);
  const axis = sizes.indexOf(Math.min(...sizes));
  return unit(cross(a, [Number(axis === 0), Number(axis === 1), Number(axis === 2)]))!;
}

/**
 * A tube along a polyline. Points nearer than a thousandth of the radius to the previous one are
 * left out. The tube of a closed polyline is closed; the ends of other tubes are open, or have flat
 * caps. The tube of a single place has no triangles.
 */
export function tubeAlong(
  line: TubeLine,
  { radius, sides = 8, caps = false }: { radius: number; sides?: number; caps?: boolean },
): Tube {
  checkPositive(radius, 'the radius');
  checkInteger(sides, 'the number of sides');
  if (sides < 3 || sides > 64) {
    throw badArgument(`a tube has 3 to 64 sides, not ${sides}`);
  }
  const { places, tangents, across, closed } = framesAlong(line, 1e-3 * radius);
  const rings = places.length > 1 ? places.length : 0;
  const positions = new Float64Array(3 * sides * rings);
  const normals = new Float64Array(3 * sides * rings);
  for (let i = 0; i < rings; i++) {
    const up = cross(across[i]!, tangents[i]!);
    for (let k = 0; k < sides; k++) {
      const angle = (2 * Math.PI * k) / sides;
      const out = plus(across[i]!, Math.cos(angle), up, Math.sin(angle));
      normals.set(out, 3 * (sides * i + k));
      positions.set(plus(places[i]!, 1, out, radius), 3 * (sides * i + k));
    }
  }
  return { positions, normals, triangles: trianglesOf(rings, sides, closed, caps) };
}

/**
 * The places of a polyline, with unit vectors along and across the polyline. Each place is farther
 * than `apart` from the previous one; nearer places are left out.
 */
function framesAlong(line: TubeLine, apart: number) {
  const kept = distinct(line, apart);
  const closed = line.closed && kept.length > 2;
  const places = kept.map((i) => at(line.places, i));
  const tangents = tangentsOf(places, closed);
  const across = line.normals
    ? uprightFrames(
        tangents,
        kept.map((i) => at(line.normals!, i)),
      )
    : carriedFrames(tangents, closed);
  return { places, tangents, across, closed };
}

/** A band along a polyline. It has two vertices at each place, one on each side. */
export interface Ribbon extends Tube {
  /**
   * Two numbers for each vertex: the length from the start, divided by the width of the ribbon, and
   * the side: 0 for the left, 1 for the right.
   */
  uvs: Float64Array;
}

/**
 * A flat band along a polyline. Points nearer than a thousandth of the width to the previous one
 * are left out. On a closed polyline the last two vertices repeat the first.
 */
export function ribbonAlong(line: TubeLine, width: number): Ribbon {
  checkPositive(width, 'the width');
  const { places, tangents, across, closed } = framesAlong(line, 1e-3 * width);
  const count = places.length > 1 ? places.length + +closed : 0;
  const positions = new Float64Array(6 * count);
  const normals = new Float64Array(6 * count);
  const uvs = new Float64Array(4 * count);
  const triangles = new Uint32Array(6 * Math.max(0, count - 1));
  let length = 0;
  for (let i = 0; i < count; i++) {
    const k = i % places.length;
    if (i > 0) length += Math.hypot(...subtract(places[k]!, places[i - 1]!)) / width;
    for (const side of [0, 1]) {
      positions.set(plus(places[k]!, 1, across[k]!, (side - 0.5) * width), 6 * i + 3 * side);
      normals.set(cross(across[k]!, tangents[k]!), 6 * i + 3 * side);
      uvs.set([length, side], 4 * i + 2 * side);
    }
    if (i > 0)
      triangles.set(
        [-2, -1, 0, 0, -1, 1].map((from) => 2 * i + from),
        6 * (i - 1),
      );
  }
  return { positions, normals, triangles, uvs };
}

function trianglesOf(rings: number, sides: number, closed: boolean, caps: boolean): Uint32Array {
  const bands = closed ? rings : Math.max(0, rings - 1);
  const fan = caps && !closed && rings > 0 ? sides - 2 : 0;
  const triangles = new Uint32Array(6 * sides * bands + 6 * fan);
  let end = 0;
  const add = (...corners: number[]) => {
    triangles.set(corners, end);
    end += corners.length;
  };
  for (let i = 0; i < bands; i++) {
    for (let k = 0; k < sides; k++) {
      const [a, b] = [sides * i + k, sides * i + ((k + 1) % sides)];
      const [c, d] = [(a + sides) % (sides * rings), (b + sides) % (sides * rings)];
      add(a, c, b, b, c, d);
    }
  }
  const last = sides * (rings - 1);
  for (let k = 1; k <= fan; k++) add(0, k, k + 1, last, last + k + 1, last + k);
  return triangles;
}

/** The numbers of the kept points. Each is farther than `apart` from the previous kept point. */
function distinct({ places, closed }: TubeLine, apart: number): number[] {
  const kept: number[] = [];
  const away = (i: number, j: number) => Math.hypot(...subtract(at(places, i), at(places, j)));
  for (let i = 0; 3 * i < places.length; i++) {
    if (kept.length === 0 || away(i, kept.at(-1)!) > apart) kept.push(i);
  }
  if (closed && kept.length > 1 && away(kept[0]!, kept.at(-1)!) <= apart) kept.pop();
  return kept;
}

/** The mean direction of the two segments at each place. */
function tangentsOf(places: readonly Vector[], closed: boolean): Vector[] {
  const count = places.length;
  let last: Vector = [1, 0, 0];
  return places.map((place, i) => {
    const before = places[i > 0 ? i - 1 : closed ? count - 1 : 0]!;
    const after = places[i + 1 < count ? i + 1 : closed ? 0 : i]!;
    // Where the polyline turns back, the segments have no mean direction.
    last = unit(subtract(after, before)) ?? unit(subtract(after, place)) ?? last;
    return last;
  });
}

/** Unit vectors perpendicular to the tangents and the normals. */
function uprightFrames(tangents: readonly Vector[], normals: readonly Vector[]): Vector[] {
  return tangents.map((tangent, i) => unit(cross(tangent, normals[i]!)) ?? anyAcross(tangent));
}

/**
 * Unit vectors perpendicular to the tangents. Each vector is the previous vector after the smallest
 * rotation from the previous tangent to the present one. Once around a closed polyline, the result
 * may differ from the first vector. The angle between them is distributed over all points.
 */
function carriedFrames(tangents: readonly Vector[], closed: boolean): Vector[] {
  const [first] = tangents;
  if (!first) return [];
  const frames = [anyAcross(first)];
  for (let i = 1; i < tangents.length; i++) {
    frames.push(carried(frames[i - 1]!, tangents[i - 1]!, tangents[i]!));
  }
  if (!closed) return frames;
  const round = carried(frames.at(-1)!, tangents.at(-1)!, first);
  const turn = Math.atan2(dot(cross(round, frames[0]!), first), dot(round, frames[0]!));
  return frames.map((frame, i) => {
    const angle = (turn * i) / frames.length;
    return plus(frame, Math.cos(angle), cross(tangents[i]!, frame), Math.sin(angle));
  });
}

/** A vector perpendicular to one tangent, rotated with this tangent to another one. */
function carried(vector: Vector, from: Vector, to: Vector): Vector {
  const share = 1 + dot(from, to);
  const moved =
    share > 0 ? plus(vector, 1, plus(from, 1, to, 1), -dot(vector, to) / share) : vector;
  // Rounding would otherwise add up along the polyline.
  return unit(plus(moved, 1, to, -dot(moved, to))) ?? anyAcross(to);
}
