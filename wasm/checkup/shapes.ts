import { Places } from '../places.js';
import { batchMask, type Slices } from '../slices.js';

/** In degrees: below the one a triangle is a needle, above the other a cap. */
const [needleAngle, capAngle] = [2, 170];
const degrees = 180 / Math.PI;

export interface Shapes {
  shortestEdge: number;
  longestEdge: number;
  smallestAngle: number;
  largestAngle: number;
  needles: Int32Array;
  caps: Int32Array;
  /** Of each corner, the number of its place: the same where vertices lie at one place. */
  numbers: Int32Array;
}

/** The lengths and angles of triangles; those with two corners at one place, or on a line, are none. */
export async function shapesOf(
  positions: Float64Array,
  triangles: Int32Array,
  slices: Slices,
): Promise<Shapes> {
  const numbers = await numbersOf(positions, triangles, slices);
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
      await slices.rest(0.4 + (0.3 * at) / triangles.length);
    }
    const [i, j, k] = [numbers[at]!, numbers[at + 1]!, numbers[at + 2]!];
    if (i === j || j === k || k === i) continue;
    const [p, q, r] = [triangles[at]!, triangles[at + 1]!, triangles[at + 2]!];
    const [a, b, c] = [length(q, r), length(r, p), length(p, q)];
    const longest = Math.max(a, b, c);
    const shortest = Math.min(a, b, c);
    const middle = a + b + c - longest - shortest;
    // Kahan's product for the area, which keeps the digits of thin triangles.
    const area =
      (longest + (middle + shortest)) *
      (shortest - (longest - middle)) *
      (shortest + (longest - middle)) *
      (longest + (middle - shortest));
    if (!(area > 0)) continue;
    shortestEdge = Math.min(shortestEdge, shortest);
    longestEdge = Math.max(longestEdge, longest);
    const sine = Math.sqrt(area) / 2;
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
  return { shortestEdge, longestEdge, ...angles, ...faces, numbers };
}

async function numbersOf(positions: Float64Array, triangles: Int32Array, slices: Slices) {
  const places = new Places();
  const numbers = new Int32Array(triangles.length);
  for (const [i, vertex] of triangles.entries()) {
    if ((i & batchMask) === 0 && slices.over) await slices.rest((0.4 * i) / triangles.length);
    const at = 3 * vertex;
    numbers[i] = places.number(positions[at]!, positions[at + 1]!, positions[at + 2]!);
  }
  return numbers;
}
