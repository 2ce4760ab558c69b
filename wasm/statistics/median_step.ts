import type { PointLike } from '../types.js';
import type { AnyMesh } from './energy.js';

type Vector = readonly [number, number, number];
type Plane = readonly [number, number];

/**
 * The step of Vardi and Zhang from one of the points: undefined if the point is a local median, or
 * else a vector to a lower sum of distances. Points within `least` of the point count as points at
 * its place.
 */
export async function stepFrom(
  mesh: AnyMesh,
  points: readonly PointLike[],
  weights: readonly number[],
  at: number,
  least: number,
): Promise<Vector | undefined> {
  const from = points[at]!;
  const beside = await placesBeside(mesh, from);
  const { vectors } = await mesh.logMap(from, [...points, ...beside]);
  const vectorAt = (i: number): Vector => [
    vectors[3 * i]!,
    vectors[3 * i + 1]!,
    vectors[3 * i + 2]!,
  ];
  const pulls: Vector[] = [];
  let held = 0;
  let inverse = 0;
  for (const [i, weight] of weights.entries()) {
    const vector = vectorAt(i);
    const length = norm(vector);
    if (length <= least) {
      held += weight;
    } else {
      pulls.push(scaled(vector, weight / length));
      inverse += weight / length;
    }
  }
  let pull: Vector = pulls.reduce(plus, [0, 0, 0]);
  if (beside.length > 0) {
    // The log map scales the angles around a vertex so that their sum is 360 degrees.
    const [a, b] = [vectorAt(points.length), vectorAt(points.length + 1)];
    const place = await mesh.position(from);
    const [toA, toB] = await Promise.all(
      beside.map(async (point) => plus(await mesh.position(point), scaled(place, -1))),
    );
    const x = scaled(a, 1 / norm(a));
    const across = plus(b, scaled(x, -dot(b, x)));
    const y = scaled(across, 1 / norm(across));
    const total = (2 * Math.PI * angle(toA!, toB!)) / angle(a, b);
    const [u, v] = largestPull(
      pulls.map((one) => [dot(one, x), dot(one, y)]),
      total,
    );
    pull = plus(scaled(x, u), scaled(y, v));
  }
  const most = norm(pull);
  return most <= held ? undefined : scaled(pull, (1 - held / most) / inverse);
}

/** For a point at a vertex, two places beside it on two edges of a face; otherwise none. */
async function placesBeside(mesh: AnyMesh, from: PointLike): Promise<PointLike[]> {
  const isInFace = 'face' in from;
  if (isInFace && from.bary.filter((weight) => weight === 0).length < 2) return [];
  const { face, bary } = isInFace
    ? from
    : (await mesh.nearestPoint(await mesh.position(from))).point;
  const corner = bary.indexOf(Math.max(...bary));
  return [1, 2].map((turn) => {
    const place: [number, number, number] = [0, 0, 0];
    place[corner] = 1 - 1e-3;
    place[(corner + turn) % 3] = 1e-3;
    return { face, bary: place };
  });
}

/**
 * The largest pull of points in a direction at a vertex, as a vector in this direction; 0, 0 if no
 * pull is positive. A point at the angle a from the direction pulls with its weight times
 * cos(min(a, π)), where a is an angle on the surface. `pulls` are vectors as long as the weights,
 * in the plane of the log map, and `total` is the sum of the angles around the vertex.
 */
function largestPull(pulls: readonly Plane[], total: number): Plane {
  const scale = (2 * Math.PI) / total;
  const reach = Math.min(Math.PI, total / 2);
  // From one of the following directions to the next, the pull is x cos(direction) +
  // y sin(direction) + rest.
  const changes: { direction: number; x: number; y: number; rest: number }[] = [];
  let [x, y, rest] = [0, 0, 0];
  for (const pull of pulls) {
    const weight = Math.hypot(...pull);
    rest -= weight;
    for (const turn of [0, 1]) {
      const direction = Math.atan2(pull[1], pull[0]) / scale + turn * total;
      for (const sign of [1, -1]) {
        changes.push({
          direction: Math.max(0, direction - sign * reach),
          x: sign * weight * Math.cos(direction),
          y: sign * weight * Math.sin(direction),
          rest: sign * weight,
        });
      }
    }
  }
  changes.sort((a, b) => a.direction - b.direction);
  let most = 0;
  let best = 0;
  for (const [i, change] of changes.entries()) {
    const from = change.direction;
    if (from >= total) break;
    x += change.x;
    y += change.y;
    rest += change.rest;
    const to = Math.min(total, changes[i + 1]?.direction ?? total);
    if (to - from <= 1e-12) continue;
    const turn = (Math.atan2(y, x) - from) % (2 * Math.PI);
    const highest = from + (turn < 0 ? turn + 2 * Math.PI : turn);
    for (const direction of [from, Math.min(highest, to)]) {
      const pull = x * Math.cos(direction) + y * Math.sin(direction) + rest;
      if (pull > most) [most, best] = [pull, direction];
    }
  }
  return [most * Math.cos(scale * best), most * Math.sin(scale * best)];
}

const plus = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scaled = (a: Vector, factor: number): Vector => [a[0] * factor, a[1] * factor, a[2] * factor];
const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const norm = (a: Vector) => Math.hypot(...a);
const angle = (a: Vector, b: Vector) => Math.acos(dot(a, b) / norm(a) / norm(b));
