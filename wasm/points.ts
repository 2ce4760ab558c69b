import { checkArray, checkPointLike } from './check.js';
import type { Handle } from './engine.js';
import type { EngineMesh } from './karcher-engine.mjs';
import type { PointLike, SurfacePoint } from './types.js';

/** A caller's point, checked against the mesh, as it travels: face, b0, b1, b2. */
export function wirePoint(
  handle: Handle<EngineMesh>,
  point: PointLike,
  what = 'the point',
): Float64Array {
  const wire = checkPointLike(point, what);
  return handle.call((mesh) =>
    typeof wire === 'number' ? mesh.vertexPoint(wire) : mesh.checkedPoint(wire),
  );
}

/** Points one after the other, four numbers each. */
export function wirePoints(handle: Handle<EngineMesh>, points: unknown): Float64Array {
  const array = checkArray(points, 'the points') as PointLike[];
  // Not array.map, which passes over holes.
  const wires = Array.from(array, (point, i) => wirePoint(handle, point, `point ${i}`));
  const all = new Float64Array(4 * wires.length);
  wires.forEach((wire, i) => {
    all.set(wire, 4 * i);
  });
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
