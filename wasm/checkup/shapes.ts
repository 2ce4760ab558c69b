import { batchMask, type Slices } from '../slices.js';

/**
 * Angles in degrees. A triangle with an angle above `capAngle` is a cap. Any other triangle with an
 * angle below `needleAngle` is a needle.
 */
const [needleAngle, capAngle] = [2, 170];
const degrees = 180 / Math.PI;

interface Shapes {
  shortestEdge: number;
  longestEdge: number;
  smallestAngle: number;
  largestAngle: number;
  needles: Int32Array;
  caps: Int32Array;
  /** The length of the shortest edge at each vertex. Edges of faces without height count, too. */
  shortest: Float64Array;
}

/**
 * The lengths and angles of triangles. The result omits triangles with one vertex at two corners,
 * and triangles that are no part of the surface (`EngineKept.areFaces`).
 */
export async function shapesOf(
  positions: Float64Array,
  triangles: Int32Array,
  areFaces: Uint8Array,
  slices: Slices,
): Promise<Shapes> {
  const shortestAt = new Float64Array(
    triangles.reduce((most, vertex) => Math.max(most, vertex), 0) + 1,
  ).fill(Infinity);
  const needles: number[] = [];
  const caps: number[] = [];
  let [shortestEdge, longestEdge] = [Infinity, 0];
  let [smallestAngle, largestAngle] = [180, 0];
  const length = (from: number, to: number) => {
    const [p, q] = [3 * from, 3 * to];
    return Math.hypot(
      positions[q]! - positions[p]!,
      positions[q + 1]! - positions[p + 1]!,
      positions[q + 2]! - positions[p + 2]!,
    );
  };
  for (let at = 0; at < triangles.length; at += 3) {
    if (((at / 3) & batchMask) === 0 && slices.over) {
      await slices.rest((0.7 * at) / triangles.length);
    }
    const [p, q, r] = [triangles[at]!, triangles[at + 1]!, triangles[at + 2]!];
    if (p === q || q === r || r === p) continue;
    const [a, b, c] = [length(q, r), length(r, p), length(p, q)];
    for (const [vertex, one, other] of [
      [p, b, c] as const,
      [q, c, a] as const,
      [r, a, b] as const,
    ]) {
      shortestAt[vertex] = Math.min(shortestAt[vertex]!, one, other);
    }
    if (!areFaces[at / 3]) continue;
    const longest = Math.max(a, b, c);
    const shortest = Math.min(a, b, c);
    const middle = a + b + c - longest - shortest;
    const sine = twiceArea(positions, p, q, r);
    shortestEdge = Math.min(shortestEdge, shortest);
    longestEdge = Math.max(longestEdge, longest);
    const angle = (opposite: number, one: number, other: number) =>
      degrees * Math.atan2(sine, (one * one + other * other - opposite * opposite) / 2);
    const least = angle(shortest, middle, longest);
    const most = angle(longest, middle, shortest);
    smallestAngle = Math.min(smallestAngle, least);
    largestAngle = Math.max(largestAngle, most);
    if (most > capAngle) caps.push(at / 3);
    else if (least < needleAngle) needles.push(at / 3);
  }
  const angles = { smallestAngle, largestAngle };
  const faces = { needles: Int32Array.from(needles), caps: Int32Array.from(caps) };
  return { shortestEdge, longestEdge, ...angles, ...faces, shortest: shortestAt };
}

/**
 * Twice a triangle's area: the length of the cross product of two edges, which is accurate for thin
 * triangles, too.
 */
function twiceArea(positions: Float64Array, p: number, q: number, r: number): number {
  const along = (vertex: number, axis: number) =>
    positions[3 * vertex + axis]! - positions[3 * p + axis]!;
  const [ux, uy, uz] = [along(q, 0), along(q, 1), along(q, 2)];
  const [vx, vy, vz] = [along(r, 0), along(r, 1), along(r, 2)];
  return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
}
