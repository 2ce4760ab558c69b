import type { CutPart, PointLike, SurfacePoint } from '../types.js';
import { add, at, cross, dot, scaled, subtract, type Vector } from '../vectors.js';
import type { AnyMesh } from './energy.js';
import { inFace } from './fans.js';

/** The weight of a point beside a vertex, and its direction there, as an angle on the surface. */
interface Pull {
  weight: number;
  direction: number;
}

/** A mesh, and its components with vertices that are all apart. */
export interface Divided {
  mesh: AnyMesh;
  /** The components; the first call computes them. */
  components(): Promise<CutPart[]>;
}

/** A mesh whose components are computed at most once. */
export function divided(mesh: AnyMesh): Divided {
  let parts: Promise<CutPart[]> | undefined;
  return {
    mesh,
    components: () => {
      // Without paths, `cut` divides a mesh into its components.
      parts ??= Promise.resolve(mesh.cut([]));
      return parts;
    },
  };
}

/**
 * The step of Vardi and Zhang from one of the points: undefined if the point is a local median, or
 * else a vector to a lower sum of distances. Points within `least` of the point count as points at
 * its place.
 */
export async function stepFrom(
  { mesh, components }: Divided,
  points: readonly PointLike[],
  weights: readonly number[],
  nearest: number,
  least: number,
): Promise<Vector | undefined> {
  const from = points[nearest]!;
  const fan = await fanAt({ mesh, components }, from);
  const { vectors } = await mesh.logMap(from, [...points, ...(fan?.beside ?? [])]);
  const vectorAt = (i: number) => at(vectors, i);
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
    const turned = direction * scaleOf(fan);
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
  /** Two places near the vertex, on the two edges of the first face. */
  beside: PointLike[];
}

/**
 * The fan of a point at a vertex, otherwise undefined. Its faces are those after the mesh's repairs:
 * the triangles of the file may have opposite orientations, and other parts may touch the vertex.
 */
async function fanAt({ mesh, components }: Divided, from: PointLike): Promise<Fan | undefined> {
  if ('face' in from && from.bary.every((weight) => weight !== 0)) return undefined;
  const place = await mesh.position(from);
  const { face: own } = await inFace(mesh, from);
  for (const { positions, triangles, faces } of await components()) {
    const vertex = triangles.find(
      (corner, i) =>
        faces[Math.floor(i / 3)] === own && at(positions, corner).every((x, k) => x === place[k]),
    );
    if (vertex === undefined) continue;
    // From each edge at the vertex, a face leads to the next one.
    const sides = new Map<number, { to: number; face: number }>();
    triangles.forEach((corner, i) => {
      if (corner !== vertex) return;
      const first = i - (i % 3);
      const [side, to] = [1, 2].map((turn) => triangles[first + ((i + turn) % 3)]!);
      sides.set(side!, { to: to!, face: faces[first / 3]! });
    });
    const ends = new Set([...sides.values()].map(({ to }) => to));
    const open = [...sides.keys()].find((side) => !ends.has(side));
    const way = (side: number) => subtract(at(positions, side), place);
    const first = open ?? [...sides.keys()][0]!;
    const { to, face } = sides.get(first)!;
    const beside = [first, to].map((side) => add(place, scaled(way(side), 1e-3)));
    return {
      total: [...sides].reduce((sum, [side, next]) => sum + angle(way(side), way(next.to)), 0),
      isOpen: open !== undefined,
      beside: await pointsIn(mesh, face, beside),
    };
  }
  return undefined;
}

/** Places in a face, as points of it. */
async function pointsIn(
  mesh: AnyMesh,
  face: number,
  places: readonly Vector[],
): Promise<SurfacePoint[]> {
  const corners = [0, 1, 2].map((k) => ({ face, bary: [0, 1, 2].map((i) => +(i === k)) }));
  const flat = await mesh.positionsOf(corners as SurfacePoint[]);
  const a = at(flat, 0);
  const [u, v] = [subtract(at(flat, 1), a), subtract(at(flat, 2), a)];
  const normal = cross(u, v);
  return places.map((place) => {
    const way = subtract(place, a);
    const [second, third] = [cross(way, v), cross(u, way)].map(
      (area) => dot(area, normal) / dot(normal, normal),
    ) as [number, number];
    return { face, bary: [1 - second - third, second, third] };
  });
}

/** The factor by which the log map scales the angles around a vertex. */
const scaleOf = ({ total, isOpen }: Fan) => (isOpen ? 1 : (2 * Math.PI) / total);

/**
 * The direction, as an angle on the surface, of an angle of the log map from the first place of
 * `beside`. At the boundary it is from 0 to the total angle.
 */
function directionIn(fan: Fan, angle: number): number {
  const { total, isOpen } = fan;
  if (!isOpen) return angle / scaleOf(fan);
  const direction = (angle + 2 * Math.PI) % (2 * Math.PI);
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
