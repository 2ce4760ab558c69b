import { checkLength, checkNumber, toFloat64, toVector } from './check.js';
import { KarcherError } from './errors.js';
import type { EngineMapped } from './karcher-engine.mjs';
import { toSurfacePoints } from './points.js';
import type { SurfacePoint } from './types.js';

/** Points seen from another one, in its tangent plane: x, y, z each, in space. */
export interface LogMap {
  /** As long as the paths to the points. */
  vectors: Float64Array;
  /** The directions at the points, carried along these paths. */
  directions: Float64Array;
}

/** Where straightest geodesics lead. */
export interface MappedPoints {
  /** The points of the surface, one for each vector. */
  points: SurfacePoint[];
  /** Directions carried along to them: x, y, z each, in the plane of the point's face. */
  directions: Float64Array;
  /** The length of each that was left at the boundary; else 0, or nearly. */
  remaining: Float64Array;
}

/** Vectors of a caller's (`VectorsLike`) one after the other, three finite numbers each. */
export function toVectors(value: unknown, what: string): Float64Array {
  if (Array.isArray(value) && isObject(value[0])) {
    const all = new Float64Array(3 * value.length);
    for (let i = 0; i < value.length; i++) {
      all.set(toVector(value[i], `entry ${i} of ${what}`), 3 * i);
    }
    return all;
  }
  if (isObject(value) && !('length' in value)) return toVector(value, what);
  const numbers = toFloat64(value, what);
  checkLength(numbers, 3, what);
  numbers.forEach((number, i) => {
    checkNumber(number, `entry ${i} of ${what}`);
  });
  return numbers;
}

const isObject = (value: unknown): value is object => typeof value === 'object' && value !== null;

/** The directions at so many points; without any, of length 0. */
export function carriedVectors(directions: unknown, count: number): Float64Array {
  if (directions === undefined) return new Float64Array(3 * count);
  const numbers = toVectors(directions, 'the directions');
  if (numbers.length === 3 * count) return numbers;
  throw new KarcherError(
    'badArgument',
    `there must be a direction a point: ${count}, not ${numbers.length / 3}`,
  );
}

export function toMapped({ points, directions, remaining }: EngineMapped): MappedPoints {
  return { points: toSurfacePoints(points), directions, remaining };
}
