/** Moves, turns and scalings of a selection as a whole, by log and exponential maps at a pivot. */
import type { SurfacePoint } from 'karcher';
import { Vector3 } from 'three';
import type { Command } from '../../model/commands';
import { isDerived } from '../../model/derived';
import { type Drawing, type DrawnObject, objectOf } from '../../model/drawing';
import { type Figure, isEmpty, plain, type Vector, withInside } from '../../model/figure';
import { type Carried, type CarriedTo, carriedOf, movedFigures } from '../../model/moving';
import { withSources } from '../../model/sources';
import { togetherOf } from '../../model/together';
import type { Surface } from '../../viewer/surface';
import type { EngineClient } from '../../worker/client';
import type { Framed } from '../../worker/framed';
import type { Session } from './session';
import { isTorn } from './tearing';

/**
 * The largest missing length of a geodesic that counts as complete, in diagonals of the surface. If
 * more is missing, the geodesic has stopped at the boundary.
 */
const leftAtMost = 1e-9;

/** A placement: the new pivot, a turn around it (counterclockwise, in radians) and a scale. */
export interface Placement {
  point?: SurfacePoint;
  angle?: number;
  scale?: number;
}

/** The result of a placement. */
export interface Placed {
  command: Command;
  /** The figures of the objects, in their order. */
  figures: readonly Figure[];
  /** Other places that move along: their new points, and the directions there. */
  beside: CarriedTo;
}

/** The sentences that say why a move stops. */
export const leaves = 'The move stops where something would leave the surface.';
const tears =
  'The move stops where it would tear a figure: from there its points go different ways round the surface.';

const samePoint = (a: SurfacePoint, b: SurfacePoint) =>
  a.face === b.face && `${a.bary}` === `${b.bary}`;

/** The coordinates x, y, z of each direction; three zeros for a place without a direction. */
export const directionsOf = (carried: readonly Carried[]): Float64Array =>
  Float64Array.from(carried.flatMap(({ direction }) => direction ?? [0, 0, 0]));

/**
 * The objects that a move of the given ones changes. The sources of a derived object move instead
 * of it; locked and empty objects stay.
 */
export function movableObjects(drawing: Drawing, ids: readonly number[]): DrawnObject[] {
  const objects = withSources(drawing, ids).map((id) => objectOf(drawing, id)!);
  const seen = new Set(objects.flatMap(({ visible, group }) => (visible && group ? [group] : [])));
  return (
    objects
      // A hidden object moves only as a source of another one, or with a visible member of its
      // group.
      .filter(({ id, visible, group }) => visible || !ids.includes(id) || seen.has(group ?? ''))
      .filter(({ locked, figure }) => !locked && !isEmpty(figure) && !isDerived(figure.kind))
  );
}

/**
 * The objects to copy with the given ones: all objects that a move would change, and the unlocked
 * derived objects among the given ones and their sources.
 */
export function copiedObjects(drawing: Drawing, ids: readonly number[]): DrawnObject[] {
  const moved = movableObjects(drawing, ids);
  const all = new Set(withSources(drawing, ids));
  return drawing.objects.filter(
    (object) =>
      moved.includes(object) ||
      (all.has(object.id) && !object.locked && isDerived(object.figure.kind)),
  );
}

/** The figures of objects, with the sides that they enclose in the view. */
export const keptFigures = (
  session: Pick<Session, 'insideOf'>,
  objects: readonly DrawnObject[],
): Figure[] =>
  objects.map(({ figure }) => {
    const side = figure.inside ? null : session.insideOf(figure);
    return side ? withInside(figure, side) : figure;
  });

const framedAt = (client: EngineClient, carried: readonly Carried[]): Promise<Framed> =>
  client.framedAt({
    places: carried.map(({ place }) => plain(place)),
    directions: directionsOf(carried),
  });

const axesOf = ({ middle, axes }: Framed): Carried[] =>
  [0, 3].map((axis) => ({
    place: middle,
    direction: [...axes.subarray(axis, axis + 3)] as Vector,
  }));

/** Replaces the figures of objects, as one step. */
export const replacing = (objects: readonly DrawnObject[], to: readonly Figure[]): Command => ({
  type: 'steps',
  steps: objects.map(({ id, figure }, i) => ({
    ...{ type: 'figure', id },
    edit: { type: 'replace', from: figure, to: to[i]! },
  })),
});

/**
 * The unit normal of a point's face, in the surface's coordinates, towards the outer side. Seen
 * from this side, turns are counterclockwise.
 */
export async function faceNormal(
  client: EngineClient,
  surface: Surface,
  point: SurfacePoint,
): Promise<Vector3> {
  const corners = await client.corners(point.face);
  const [a, b, c] = corners.map((corner) => new Vector3(...corner));
  const normal = b!.sub(a!).cross(c!.sub(a!)).normalize();
  const outside = surface.directionFromScene(surface.normal(point));
  return normal.dot(new Vector3(...outside)) < 0 ? normal.negate() : normal;
}

interface Start {
  client: EngineClient;
  surface: Surface;
  normal: Vector3;
  objects: readonly DrawnObject[];
  kept: readonly Figure[];
  pivot: SurfacePoint;
  /** The places of the objects, in the order of their return to the surface. */
  carried: readonly Carried[];
  beside: readonly Carried[];
  /** The frames, if there are several parts; empty for a single part, which uses the pivot's. */
  framed: readonly Framed[];
  logs: { vectors: Float64Array; directions: Float64Array };
}

/**
 * A move of objects relative to a pivot. Each place becomes its log vector in the tangent plane of
 * the pivot, and each direction is transported to the pivot along the same path. The plane follows
 * the pivot by transport along the shortest path from its start, and the exp map returns everything
 * to the surface. So the positions of a drag do not accumulate errors, and back at the start the
 * objects are unchanged.
 *
 * Objects far from the pivot would become narrower or wider in this way. Therefore, if there are
 * several parts (objects, or sets of objects that belong together), only a frame at the middle of
 * each part moves in this way. The part keeps its places relative to its frame.
 */
export class Move {
  private constructor(private readonly start: Start) {}

  /**
   * Begins a move of objects of a drawing. The places `beside` move along. Rejects if a place has
   * no path to the pivot.
   */
  static async of(
    session: Pick<Session, 'client' | 'insideOf'>,
    surface: Surface,
    { drawing, objects }: { drawing: Drawing; objects: readonly DrawnObject[] },
    pivot: SurfacePoint,
    beside: readonly Carried[] = [],
  ): Promise<Move> {
    const { client } = session;
    if (!client) throw new Error('there is no surface');
    const kept = keptFigures(session, objects);
    const parts = togetherOf(drawing, objects).map((part) =>
      carriedOf(part.map((object) => kept[objects.indexOf(object)]!)),
    );
    const framed =
      parts.length > 1 ? await Promise.all(parts.map((part) => framedAt(client, part))) : [];
    const carried = parts.flat();
    const all = [...(framed.length > 0 ? framed.flatMap(axesOf) : carried), ...beside];
    const logs = await client.mesh.logMap(
      plain(pivot),
      all.map(({ place }) => plain(place)),
      directionsOf(all),
    );
    const normal = await faceNormal(client, surface, pivot);
    const start = { client, surface, normal, objects, kept, carried, beside, framed, logs };
    return new Move({ ...start, pivot: plain(pivot) });
  }

  /** The command that moves the pivot to a point; a sentence if that is impossible. */
  async to(point: SurfacePoint): Promise<Command | string> {
    const placed = await this.placed({ point });
    return typeof placed === 'string' ? placed : placed.command;
  }

  /** The result of the move; a sentence if it is impossible. */
  async placed({ point, angle = 0, scale = 1 }: Placement): Promise<Placed | string> {
    const { client, surface, kept, pivot, carried, objects, framed, logs } = this.start;
    const stays = !point || samePoint(point, pivot);
    if (stays && angle === 0 && scale === 1) return this.#unmoved;
    const vectors = this.#turned(logs.vectors, angle, scale);
    const ways = this.#turned(logs.directions, angle, 1);
    const { points, directions, remaining } = await client.putDown({
      ...{ from: pivot, to: stays ? null : plain(point) },
      ...{ vectors, directions: ways, framed, scale },
    });
    if (remaining.some((left) => left > leftAtMost * client.info.diagonal)) return leaves;
    const figures = movedFigures(kept, carried, { points, directions }, scale);
    if (await isTorn(client, surface, objects, figures, scale)) return tears;
    const own = carried.length;
    return {
      ...{ command: replacing(objects, figures), figures },
      beside: { points: points.slice(own), directions: directions.slice(3 * own) },
    };
  }

  get #unmoved(): Placed {
    const { beside, objects } = this.start;
    return {
      command: { type: 'steps', steps: [] },
      figures: objects.map(({ figure }) => figure),
      beside: { points: beside.map(({ place }) => place), directions: directionsOf(beside) },
    };
  }

  #turned(vectors: Float64Array, angle: number, scale: number): Float64Array {
    if (angle === 0 && scale === 1) return vectors;
    const turned = new Float64Array(vectors.length);
    const vector = new Vector3();
    for (let i = 0; i < vectors.length; i += 3) {
      vector.fromArray(vectors, i).applyAxisAngle(this.start.normal, angle).multiplyScalar(scale);
      turned.set(vector.toArray() as Vector, i);
    }
    return turned;
  }
}
