import { checkArray, checkPointLike } from './check.js';
import type { PointLike, SurfacePoint } from './types.js';

/** A caller's point as it travels (`checkPointLike`): the engine checks it against the mesh. */
export const wirePoint = (point: PointLike, what = 'the point'): Float64Array =>
  checkPointLike(point, what);

/** Points one after the other, four numbers each. */
export function wirePoints(points: unknown, what = 'the points'): Float64Array {
  const array = checkArray(points, what);
  const all = new Float64Array(4 * array.length);
  for (let i = 0; i < array.length; i++) {
    all.set(checkPointLike(array[i], `point ${i}`), 4 * i);
  }
  return all;
}

export function toSurfacePoint(wire: Float64Array, at = 0): SurfacePoint {
  return { face: wire[at]!, bary: [wire[at + 1]!, wire[at + 2]!, wire[at + 3]!] };
}

export function toSurfacePoints(wire: Float64Array): SurfacePoint[] {
  return Array.from({ length: wire.length / 4 }, (_, i) => toSurfacePoint(wire, 4 * i));
}

/** The corner after the point's nearest one in its face: a drag by about an edge. */
export function nextCorner({ face, bary }: SurfacePoint): SurfacePoint {
  const heaviest = bary.indexOf(Math.max(...bary));
  const corner: [number, number, number] = [0, 0, 0];
  corner[(heaviest + 1) % 3] = 1;
  return { face, bary: corner };
}
