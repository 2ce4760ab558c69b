import {
  badArgument,
  checkInteger,
  checkLength,
  checkNumber,
  checkOptions,
  checkPositive,
  toFloat64,
  toVector,
} from './check.js';
import type { MeshHandle } from './engine.js';
import type { EngineMapped } from './karcher-engine.mjs';
import { checkRadius, radiusOptionNames } from './options.js';
import { Path } from './path.js';
import type { Outline, PathPoints, StraightestPath } from './path_types.js';
import { toPointArrays, toSurfacePoint, toSurfacePoints, wirePoint, wirePoints } from './points.js';
import { wireOutline } from './region.js';
import type { PointLike, RadiusOptions, SurfacePoint, VectorLike, VectorsLike } from './types.js';

/** Points as vectors of the tangent plane of another point. Each vector is x, y, z in space. */
export interface LogMap {
  /** The log vectors, as long as the paths to the points. */
  vectors: Float64Array;
  /** The directions at the points, transported to the other point along these paths. */
  directions: Float64Array;
}

/** The end points of straightest geodesics. */
export interface MappedPoints {
  /** The points of the surface, one for each vector. */
  points: SurfacePoint[];
  /**
   * The directions transported to these points: x, y, z for each, in the plane of the point's face.
   */
  directions: Float64Array;
  /**
   * The rest of the length of each geodesic. It is 0, or nearly 0, unless the geodesic met the
   * boundary.
   */
  remaining: Float64Array;
}

export function straightest(
  mesh: MeshHandle,
  from: PointLike,
  direction: VectorLike,
  length: number,
): StraightestPath {
  const wire = wirePoint(from);
  checkNumber(length, 'the length');
  const vector = toVector(direction, 'the direction');
  const line = mesh.call((target) => target.straightest(wire, vector, length));
  return { ...line, end: toSurfacePoint(line.end), path: new Path(line.path) };
}

export function logMap(
  mesh: MeshHandle,
  from: PointLike,
  points: readonly PointLike[] | RadiusOptions = {},
  directions: VectorsLike | undefined,
): LogMap {
  const wire = wirePoint(from);
  if (!Array.isArray(points)) {
    if (directions !== undefined) {
      throw badArgument('the log map of all vertices takes no directions');
    }
    checkOptions(points, radiusOptionNames);
    const radius = checkRadius(points as RadiusOptions);
    const vectors = mesh.call((target) => target.logMapOfVertices(wire, radius));
    return { vectors, directions: new Float64Array() };
  }
  const places = wirePoints(points);
  const ways = carriedVectors(directions, points.length);
  return mesh.call((target) => target.logMap(wire, places, ways));
}

export function expMap(
  mesh: MeshHandle,
  from: PointLike,
  vectors: VectorsLike,
  directions: VectorsLike | undefined,
): MappedPoints {
  const wire = wirePoint(from);
  const ways = toVectors(vectors, 'the vectors');
  const carried = carriedVectors(directions, ways.length / 3);
  return toMapped(mesh.call((target) => target.expMap(wire, ways, carried)));
}

export function transport(
  mesh: MeshHandle,
  from: PointLike,
  to: PointLike,
  vectors: VectorsLike,
): Float64Array {
  const wireFrom = wirePoint(from, 'the first point');
  const wireTo = wirePoint(to, 'the second point');
  const ways = toVectors(vectors, 'the vectors');
  return mesh.call((target) => target.transport(wireFrom, wireTo, ways));
}

export function transportAlong(
  mesh: MeshHandle,
  path: Outline,
  vectors: VectorsLike,
): Float64Array {
  const line = wireOutline(path, 'the path');
  const ways = toVectors(vectors, 'the vectors');
  return mesh.call((target) => target.transportAlong(line, ways));
}

export function equallySpaced(mesh: MeshHandle, path: Outline, count: number): PathPoints {
  const what = 'the number of points';
  return pointsAlong(mesh, path, [], checkPositive(checkInteger(count, what), what));
}

export function pointsAlong(
  mesh: MeshHandle,
  path: Outline,
  lengths: ArrayLike<number>,
  count = 0,
): PathPoints {
  const line = wireOutline(path, 'the path');
  const places = toFiniteNumbers(lengths, 'the lengths');
  const whole = Array.isArray(path) ? 0 : checkNumber((path as Path).length, 'the length');
  const found = mesh.call((target) => target.pointsAlong(line, places, whole, count));
  const position = mesh.call((target) => target.positionsOf(found.points));
  return { ...toPointArrays(found.points), position, lengths: found.lengths };
}

export function carried(
  mesh: MeshHandle,
  points: readonly PointLike[],
  levels: number,
): SurfacePoint[] {
  const wire = wirePoints(points);
  checkInteger(levels, 'the number of levels');
  return toSurfacePoints(mesh.call((target) => target.carried(wire, levels)));
}

export function mirror(
  mesh: MeshHandle,
  line: readonly PointLike[],
  points: readonly PointLike[],
  directions: VectorsLike | undefined,
): MappedPoints {
  const wireLine = wirePoints(line, 'the line');
  if (line.length < 2) throw badArgument('a line has at least two points');
  const places = wirePoints(points);
  const ways = carriedVectors(directions, points.length);
  return toMapped(mesh.call((target) => target.mirror(wireLine, places, ways)));
}

/** A caller's vectors (`VectorsLike`) one after the other, three finite numbers for each. */
function toVectors(value: unknown, what: string): Float64Array {
  if (Array.isArray(value) && isObject(value[0])) {
    const all = new Float64Array(3 * value.length);
    for (let i = 0; i < value.length; i++) {
      all.set(toVector(value[i], `entry ${i} of ${what}`), 3 * i);
    }
    return all;
  }
  // Vectors of three.js have a method `length`.
  if (isObject(value) && typeof (value as { length?: unknown }).length !== 'number') {
    return toVector(value, what);
  }
  const numbers = toFiniteNumbers(value, what);
  checkLength(numbers, 3, what);
  return numbers;
}

function toFiniteNumbers(value: unknown, what: string): Float64Array {
  const numbers = toFloat64(value, what);
  numbers.forEach((number, i) => {
    checkNumber(number, `entry ${i} of ${what}`);
  });
  return numbers;
}

const isObject = (value: unknown): value is object => typeof value === 'object' && value !== null;

/** The directions at this number of points; without directions, vectors of length 0. */
function carriedVectors(directions: unknown, count: number): Float64Array {
  if (directions === undefined) return new Float64Array(3 * count);
  const numbers = toVectors(directions, 'the directions');
  if (numbers.length === 3 * count) return numbers;
  throw badArgument(`there must be a direction a point: ${count}, not ${numbers.length / 3}`);
}

function toMapped({ points, directions, remaining }: EngineMapped): MappedPoints {
  return { points: toSurfacePoints(points), directions, remaining };
}
