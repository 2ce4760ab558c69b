import type { PointLike } from '../types.js';
import { add, at, dot, scaled, subtract, type Vector } from '../vectors.js';
import type { AnyMesh } from './energy.js';

/** The weight of a point beside a vertex, and its direction there, as an angle on the surface. */
interface Pull {
  weight: number;
  direction: number;
}

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
  const fan = await fanAt(mesh, from);
  const { vectors } = await mesh.logMap(from, [...points, ...(fan?.beside ?? [])]);
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
  let pull: Vector = pulls.reduce(add, [0, 0, 0]);
  if (fan) {
    const [a, b] = [vectorAt(points.length), vectorAt(points.length + 1)];
    const x = scaled(a, 1 / norm(a));
    const across = add(b, scaled(x, -dot(b, x)));
    const y = scaled(across, 1 / norm(across));
    const seen = pulls.map((one) => ({
      weight: norm(one),
      direction: directionIn(fan, Math.atan2(dot(one, y), dot(one, x))),
    }));
    const { weight, direction } = largestPull(seen, fan);
    const turned = (direction - fan.before) * scaleOf(fan);
    pull = add(scaled(x, weight * Math.cos(turned)), scaled(y, weight * Math.sin(turned)));
  }
  const most = norm(pull);
  return most <= held ? undefined : scaled(pull, (1 - held / most) / inverse);
}

/** The faces around a vertex. */
interface Fan {
  /** The sum of the angles around the vertex. */
  total: number;
  /** Whether the vertex lies on the boundary. */
  isOpen: boolean;
  /** The angle from the first side of the fan at the boundary to the first place of `beside`. */
  before: number;
  /** Two places near the vertex, on two edges of a face. */
  beside: PointLike[];
}

/** The fan of a point at a vertex, otherwise undefined. */
async function fanAt(mesh: AnyMesh, from: PointLike): Promise<Fan | undefined> {
  const isInFace = 'face' in from;
  if (isInFace && from.bary.filter((weight) => weight === 0).length < 2) return undefined;
  const place = await mesh.position(from);
  const { face, bary } = isInFace ? from : (await mesh.nearestPoint(place)).point;
  const corner = bary.indexOf(Math.max(...bary));
  const fan: Fan = { total: 0, isOpen: false, before: 0, beside: [] };
  fan.beside = [1, 2].map((turn) => ({ face, bary: near(1e-3, corner, (corner + turn) % 3) }));
  for (const side of [2, 1]) {
    let next: number | undefined = face;
    for (let i = 0; i < mesh.info.triangles && next !== undefined; i++) {
      const corners = await cornersOf(mesh, next);
      const far = corners.map((other) => norm(subtract(other, place)));
      const at = far.indexOf(Math.min(...far));
      const [to, other] = [corners[(at + side) % 3]!, corners[(at + 3 - side) % 3]!];
      if (i > 0 || side === 2) fan.total += angle(subtract(to, place), subtract(other, place));
      if (i > 0 && side === 1) fan.before += angle(subtract(to, place), subtract(other, place));
      next = await faceAcross(mesh, next, corners, near(0.5, at, (at + side) % 3));
      if (next === face) return fan;
    }
    fan.isOpen = true;
  }
  return fan;
}

/** The weights of a place between two corners of a face, at `part` of the way from a to b. */
function near(part: number, a: number, b: number): [number, number, number] {
  const bary: [number, number, number] = [0, 0, 0];
  bary[a]! += 1 - part;
  bary[b]! += part;
  return bary;
}

async function cornersOf(mesh: AnyMesh, face: number): Promise<Vector[]> {
  const places = await mesh.positionsOf([0, 1, 2].map((k) => ({ face, bary: near(0, k, k) })));
  return [0, 1, 2].map((k) => at(places, k));
}

/** The face beyond a place on a side of a face; undefined at the boundary. */
async function faceAcross(
  mesh: AnyMesh,
  face: number,
  corners: readonly Vector[],
  bary: readonly [number, number, number],
): Promise<number | undefined> {
  const third: [number, number, number] = [1 / 3, 1 / 3, 1 / 3];
  const way = corners
    .map((corner, k) => scaled(corner, bary[k]! - third[k]!))
    .reduce(add, [0, 0, 0]);
  const { path } = await mesh.straightest({ face, bary: third }, [...way], 1.1 * norm(way));
  return path.points().find((point) => point.face !== face)?.face;
}

/** The factor by which the log map scales the angles around a vertex. */
const scaleOf = ({ total, isOpen }: Fan) => (isOpen ? 1 : (2 * Math.PI) / total);

/**
 * The direction, as an angle on the surface, of an angle of the log map from the first place of
 * `beside`. At the boundary it is from 0 to the total angle.
 */
function directionIn(fan: Fan, angle: number): number {
  const { total, isOpen, before } = fan;
  if (!isOpen) return angle / scaleOf(fan);
  const direction = (angle + before + 2 * Math.PI) % (2 * Math.PI);
  if (direction <= total) return direction;
  return direction - total < 2 * Math.PI - direction ? total : 0;
}

/**
 * The largest pull of points in a direction at a vertex; its weight is 0 if no pull is positive. A
 * point at the angle a from the direction pulls with its weight times cos(min(a, π)). At the
 * boundary angles are measured inside the fan.
 */
function largestPull(pulls: readonly Pull[], { total, isOpen }: Fan): Pull {
  const reach = isOpen ? Math.PI : Math.min(Math.PI, total / 2);
  // From one of the following directions to the next, the pull is x cos(direction) +
  // y sin(direction) + rest.
  const changes: { direction: number; x: number; y: number; rest: number }[] = [];
  let [x, y, rest] = [0, 0, 0];
  for (const { weight, direction: own } of pulls) {
    rest -= weight;
    for (const turn of isOpen ? [0] : [0, 1]) {
      const direction = own + turn * total;
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
  let most: Pull = { weight: 0, direction: 0 };
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
      const weight = x * Math.cos(direction) + y * Math.sin(direction) + rest;
      if (weight > most.weight) most = { weight, direction };
    }
  }
  return most;
}

const norm = (a: Vector) => Math.hypot(...a);
function angle(a: Vector, b: Vector): number {
  const [u, v] = [scaled(a, 1 / norm(a)), scaled(b, 1 / norm(b))];
  return 2 * Math.atan2(norm(subtract(u, v)), norm(add(u, v)));
}
