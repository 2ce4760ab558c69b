import {
  badArgument,
  checkArray,
  checkInteger,
  shown,
  toFloat64,
  toInt32,
  toTriple,
} from './check.js';
import type { PointArrays, PointLike, SurfacePoint } from './types.js';

/**
 * A caller's point as four numbers for the engine, which checks it against the mesh. A point of a
 * face has the face and three weights. A vertex has NaN, its number, 0 and 0.
 */
export function wirePoint(value: unknown, what = 'the point'): Float64Array {
  const point = value as Partial<{ vertex: unknown; face: unknown; bary: unknown }> | null;
  if (typeof point !== 'object' || point === null) {
    throw badArgument(`${what} must be {face, bary} or {vertex}, not ${shown(value)}`);
  }
  if (point.vertex !== undefined) {
    return Float64Array.of(Number.NaN, checkInteger(point.vertex, `the vertex of ${what}`), 0, 0);
  }
  const face = checkInteger(point.face, `the face of ${what}`);
  return Float64Array.of(face, ...toTriple(point.bary, `the weights of ${what}`));
}

/** Points as four numbers each, one after the other. */
export function wirePoints(points: unknown, what = 'the points'): Float64Array {
  const array = checkArray(points, what);
  const all = new Float64Array(4 * array.length);
  for (let i = 0; i < array.length; i++) {
    all.set(wirePoint(array[i], `point ${i}`), 4 * i);
  }
  return all;
}

/** The points of flat arrays as four numbers each, one after the other. */
export function wirePointArrays({ face, bary }: PointArrays): Float64Array {
  const faces = toInt32(face, 'the faces of the points');
  const weights = toFloat64(bary, 'the weights of the points');
  if (weights.length !== 3 * faces.length) {
    throw badArgument(
      `there must be three weights a point: ${3 * faces.length}, not ${weights.length}`,
    );
  }
  const all = new Float64Array(4 * faces.length);
  for (let i = 0; i < faces.length; i++) {
    all[4 * i] = faces[i]!;
    for (let k = 0; k < 3; k++) all[4 * i + k + 1] = weights[3 * i + k]!;
  }
  return all;
}

/** Points of a list or of flat arrays, in the form for the engine. */
export function wirePointsOrArrays(points: readonly PointLike[] | PointArrays): Float64Array {
  if (Array.isArray(points)) return wirePoints(points);
  if (typeof points === 'object' && points !== null) return wirePointArrays(points as PointArrays);
  const sentence = `the points must be a list or {face, bary}, not ${shown(points)}`;
  throw badArgument(sentence);
}

/** Faces and weights of points as flat arrays. */
export function toPointArrays(wire: Float64Array): { face: Int32Array; bary: Float64Array } {
  const count = wire.length / 4;
  const bary = new Float64Array(3 * count);
  for (let i = 0; i < count; i++) bary.set(wire.subarray(4 * i + 1, 4 * i + 4), 3 * i);
  return { face: Int32Array.from({ length: count }, (_, i) => wire[4 * i]!), bary };
}

export function toSurfacePoint(wire: Float64Array, at = 0): SurfacePoint {
  return { face: wire[at]!, bary: [wire[at + 1]!, wire[at + 2]!, wire[at + 3]!] };
}

export function toSurfacePoints(wire: Float64Array): SurfacePoint[] {
  return Array.from({ length: wire.length / 4 }, (_, i) => toSurfacePoint(wire, 4 * i));
}

/** A record with its point as an object of face and weights. */
export const withPoint = <At extends { point: Float64Array }>(
  at: At,
): Omit<At, 'point'> & { point: SurfacePoint } => ({ ...at, point: toSurfacePoint(at.point) });
