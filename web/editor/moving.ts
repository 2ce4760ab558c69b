/** Selected objects moved as a whole, by log and exponential maps at the point that is held. */
import type { SurfacePoint } from 'karcher';
import type { Command } from '../model/commands';
import type { DrawnObject } from '../model/drawing';
import type { Vector } from '../model/figure';
import { movedFigure, placesOf } from '../model/moving';
import type { Surface } from '../viewer/surface';
import type { EngineClient } from '../worker/client';
import { directionOf } from './circle_drawing';

/** A place as it is seen from the point that is held. */
interface Log {
  place: SurfacePoint;
  direction: Vector;
  length: number;
}

/** How much of a geodesic may be left at the boundary, as a part of the surface's diagonal. */
const leftAtMost = 1e-9;

const plain = ({ face, bary }: SurfacePoint): SurfacePoint => ({ face, bary });

/**
 * A move of objects that are held at a pivot. Wherever the pivot goes, each place lies the same way
 * from it as at first, in the frame that the surface's normal carries along: positions of a drag do not
 * add up, and back at the pivot the objects are the ones they were.
 */
export class Move {
  private constructor(
    private readonly client: EngineClient,
    private readonly surface: Surface,
    private readonly objects: readonly DrawnObject[],
    private readonly pivot: SurfacePoint,
    private readonly logs: readonly Log[],
  ) {}

  /** Rejects where no path leads from the pivot to a place. */
  static async of(
    client: EngineClient,
    surface: Surface,
    objects: readonly DrawnObject[],
    pivot: SurfacePoint,
  ): Promise<Move> {
    const places = objects.flatMap(({ figure }) => placesOf(figure));
    const logs = places.map(async (place): Promise<Log> => {
      const path = await client.mesh.shortestPath(plain(pivot), plain(place));
      const direction = directionOf(path.polyline({ bits: 64 }));
      return { place, direction, length: path.length };
    });
    return new Move(client, surface, objects, pivot, await Promise.all(logs));
  }

  /** The command that takes the pivot to a point; null where something would leave the surface. */
  async to(point: SurfacePoint): Promise<Command | null> {
    const { client, surface, pivot } = this;
    const isBack = point.face === pivot.face && `${point.bary}` === `${pivot.bary}`;
    if (isBack) return { type: 'steps', steps: [] };
    const { diagonal } = client.info;
    const turn = surface.carry(pivot, point);
    const found = this.logs.map(async ({ place, direction, length }) => {
      if (length === 0) return [place, point] as const;
      const way = turn(direction);
      const { end, remaining } = await client.mesh.straightest(plain(point), way, length);
      return remaining > leftAtMost * diagonal ? null : ([place, end] as const);
    });
    const ends = await Promise.all(found);
    if (ends.some((end) => end === null)) return null;
    const moved = new Map(ends as (readonly [SurfacePoint, SurfacePoint])[]);
    const steps = this.objects.map(({ id, figure: from }): Command => {
      const to = movedFigure(from, (place) => plain(moved.get(place)!), turn);
      return { type: 'figure', id, edit: { type: 'replace', from, to } };
    });
    return { type: 'steps', steps };
  }
}
