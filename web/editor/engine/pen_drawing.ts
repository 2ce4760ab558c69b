/** The places of the pen's handles on the surface. */
import type { SurfacePoint } from 'karcher';
import type { ControlPoint, Figure, Side, Tangent, Vector } from '../../model/figure';
import { isOpposite, otherSide } from '../../model/pen';
import type { DrawnTangent, DrawnTangents } from '../../model/pen_legs';
import { throughOf } from '../../model/pen_legs';
import type { EngineClient } from '../../worker/client';
import { directionOf } from './circle_drawing';

/**
 * The handles that each engine found, by their anchors. Anchors are immutable, so only new ones
 * need a search.
 */
const found = new WeakMap<EngineClient, WeakMap<ControlPoint, DrawnTangents>>();

/** The handles of each anchor of a figure. */
export async function drawnTangents(
  client: EngineClient,
  { points }: Figure,
): Promise<DrawnTangents[]> {
  return Promise.all(points.map((point) => tangentsAt(client, point)));
}

async function tangentsAt(client: EngineClient, anchor: ControlPoint): Promise<DrawnTangents> {
  const { tangents } = anchor;
  if (!tangents) return {};
  const known = found.get(client) ?? new WeakMap<ControlPoint, DrawnTangents>();
  found.set(client, known);
  const before = known.get(anchor);
  if (before) return before;
  const side: Side = isOpposite(tangents.after) || !tangents.after ? 'before' : 'after';
  const [lead, other] = [tangents[side], tangents[otherSide(side)]];
  const led = lead && (await tangentOf(client, anchor, lead));
  const followed = other && (await otherOf(client, anchor, other, led));
  const drawn = {
    ...(led && { [side]: led }),
    ...(followed && { [otherSide(side)]: followed }),
  };
  known.set(anchor, drawn);
  return drawn;
}

/** A sentence that names a handle without a place on the surface; null if all have one. */
export function missingHandle({ points }: Figure, drawn: readonly DrawnTangents[]): string | null {
  for (const [i, { tangents }] of points.entries()) {
    for (const side of ['before', 'after'] as const) {
      const told = tangents?.[side];
      if (!told || isOpposite(told) || drawn[i]?.[side]) continue;
      return `no path leads from anchor ${i + 1} to the handle ${side} it`;
    }
  }
  return null;
}

/**
 * The place of a stored handle; undefined if no path leads to it. An error would end the search for
 * the other handles, too.
 */
async function tangentOf(
  client: EngineClient,
  anchor: SurfacePoint,
  tangent: Tangent,
): Promise<DrawnTangent | undefined> {
  try {
    return await foundTangent(client, anchor, tangent);
  } catch (error) {
    if (client.closed) throw error;
    return undefined;
  }
}

async function foundTangent(
  client: EngineClient,
  anchor: SurfacePoint,
  tangent: Tangent,
): Promise<DrawnTangent | undefined> {
  const at = { face: anchor.face, bary: anchor.bary };
  if ('face' in tangent) {
    const path = await client.mesh.shortestPath(at, tangent);
    return {
      point: tangent,
      direction: directionOf(path.polyline({ bits: 64 })),
      length: path.length,
      path: path.polyline(),
      through: throughOf(path.points()),
    };
  }
  return 'direction' in tangent ? along(client, at, tangent.direction, tangent.length) : undefined;
}

function otherOf(
  client: EngineClient,
  anchor: SurfacePoint,
  tangent: Tangent,
  lead: DrawnTangent | undefined,
): Promise<DrawnTangent | undefined> {
  if (!isOpposite(tangent)) return tangentOf(client, anchor, tangent);
  if (!lead) return Promise.resolve(undefined);
  const back = lead.direction.map((value) => -value) as Vector;
  const at = { face: anchor.face, bary: anchor.bary };
  return along(client, at, back, tangent.length ?? lead.length);
}

/** The end of a straightest geodesic, or the boundary point where it stops. */
async function along(
  client: EngineClient,
  anchor: SurfacePoint,
  direction: Vector,
  length: number,
): Promise<DrawnTangent> {
  const { end, path } = await client.mesh.straightest(anchor, direction, length);
  const through = throughOf(path.points());
  return { point: end, direction, length, path: path.polyline(), through };
}
