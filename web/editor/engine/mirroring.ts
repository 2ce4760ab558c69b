/** Mirror images of objects in the geodesic through two points. */
import type { SurfacePoint } from 'karcher';
import { type Drawing, type DrawnObject, newObject, objectOf } from '../../model/drawing';
import {
  emptyFigure,
  type Figure,
  isRound,
  opposite,
  plain,
  type Vector,
  withInside,
} from '../../model/figure';
import { carriedOf, movedFigures } from '../../model/moving';
import { enclosedTogether, resolvedFigure, withSources } from '../../model/sources';
import { type EngineClient, KarcherError } from '../../worker/client';
import { directionOf } from './circle_drawing';
import { directionsOf } from './moving';
import type { Session } from './session';

/**
 * The length by which the geodesic extends beyond each of the two points, in diagonals of the
 * surface. A longer geodesic may run round a closed surface back to its start, or end near the
 * mirrored objects.
 */
const beyond = 0.8;
/**
 * The extension in a second attempt, if the first geodesic is too short to pass beside all mirrored
 * objects.
 */
const farther = 1.5;

/**
 * The locally shortest path between two points, extended at both ends by `by` diagonals of the
 * surface, or to the boundary if that comes first.
 */
export async function mirrorLine(
  client: EngineClient,
  from: SurfacePoint,
  to: SurfacePoint,
  by = beyond,
): Promise<SurfacePoint[]> {
  const { mesh, info } = client;
  const path = await mesh.shortestPath(plain(from), plain(to));
  if (!(path.length > 0)) throw new Error('The line to mirror in goes through two points.');
  const points = path.points();
  const polyline = path.polyline({ bits: 64 });
  const onward = async (at: SurfacePoint, direction: Vector) => {
    const line = await mesh.straightest(plain(at), direction, by * info.diagonal);
    return line.path.points();
  };
  const back = (direction: Vector) => direction.map((value) => -value) as Vector;
  const [before, after] = await Promise.all([
    onward(points[0]!, back(directionOf(polyline))),
    onward(points.at(-1)!, back(directionOf(reversed(polyline)))),
  ]);
  return [...before.slice(1).reverse(), ...points, ...after.slice(1)];
}

/**
 * The figures of objects, mirrored in the geodesic through two points; null if a figure would leave
 * the surface.
 */
export async function mirroredAcross(
  client: EngineClient,
  from: SurfacePoint,
  to: SurfacePoint,
  objects: readonly DrawnObject[],
): Promise<Figure[] | null> {
  const mirrored = async (by: number) =>
    mirroredFigures(client, await mirrorLine(client, from, to, by), objects);
  try {
    return await mirrored(beyond);
  } catch (error) {
    if (client.closed || !(error instanceof KarcherError)) throw error;
    return mirrored(farther);
  }
}

/** The figures of objects, mirrored in a geodesic; null if a figure would leave the surface. */
export async function mirroredFigures(
  client: EngineClient,
  line: readonly SurfacePoint[],
  objects: readonly DrawnObject[],
): Promise<Figure[] | null> {
  const figures = objects.map(({ figure }) => figure);
  const carried = carriedOf(figures);
  const mapped = await client.mesh.mirror(
    line,
    carried.map(({ place }) => plain(place)),
    directionsOf(carried),
  );
  const most = 1e-9 * client.info.diagonal;
  if (mapped.remaining.some((left) => left > most)) return null;
  return movedFigures(figures, carried, mapped, 1).map(mirroredInside);
}

/** A mirrored figure, with its inside on the other side of its line. */
export function mirroredInside(figure: Figure): Figure {
  const { inside, kind } = figure;
  // Circles and ellipses keep their inside: their mirror images run the same way around their
  // centers.
  return inside && !isRound(kind) ? withInside(figure, opposite(inside)) : figure;
}

/** The figures of objects in a mirror; null if a figure would leave the surface. */
export type ImagesOf = (
  objects: readonly DrawnObject[],
) => Promise<Figure[] | null> | Figure[] | null;

/**
 * The mirror image of a derived figure. The offset of lines that bound no region moves to their
 * other side, and the choices for parts of a cut move to the mirrored parts.
 */
export async function mirroredDerived(
  session: Pick<Session, 'client' | 'linesOf'>,
  drawing: Drawing,
  object: DrawnObject,
  imagesOf: ImagesOf,
): Promise<Figure> {
  const { figure } = object;
  const { derived } = figure;
  const { offset, parts } = derived ?? {};
  // Locked sources stay, and so do the parts and the side of the offset.
  if (withSources(drawing, [object.id]).some((id) => objectOf(drawing, id)!.locked)) return figure;
  if (parts) {
    const mirrored = parts.map(async (part) => {
      const point = newObject(object.id, { ...emptyFigure, points: [part.point] });
      // The point of a large part may have no image on the surface. It stays, since such a part
      // mostly contains it still.
      const images = await Promise.resolve([point])
        .then(imagesOf)
        .catch(() => null);
      return { ...part, point: plain(images?.[0]?.points[0] ?? part.point) };
    });
    return { ...figure, derived: { ...derived!, parts: await Promise.all(mirrored) } };
  }
  if (!derived || !offset || offset.side === 'both') return figure;
  if (await boundRegion(session, resolvedFigure(drawing, object))) return figure;
  const side = offset.side === 'inwards' ? 'outwards' : 'inwards';
  return { ...figure, derived: { ...derived, offset: { ...offset, side } } };
}

/**
 * Whether the lines of an offset's sources bound a region, which then determines the offset's
 * sides. A loop around a handle of the surface bounds none.
 */
async function boundRegion(
  session: Pick<Session, 'client' | 'linesOf'>,
  { operands = [] }: Figure,
): Promise<boolean> {
  const lines = await session.linesOf(operands.map(({ id }) => id));
  const outlines = lines.flatMap(({ paths }) => paths);
  if (!outlines.every(({ closed }) => closed)) return false;
  const { rule, ...sided } = enclosedTogether(operands);
  try {
    await session.client!.mesh.regions([{ outlines, ...sided }], rule && { rule });
    return true;
  } catch (error) {
    if (error instanceof KarcherError) return false;
    throw error;
  }
}

function reversed(polyline: Float64Array): Float64Array {
  const turned = new Float64Array(polyline.length);
  for (let i = 0; i < polyline.length; i += 3) {
    turned.set(polyline.subarray(i, i + 3), polyline.length - 3 - i);
  }
  return turned;
}

/** Copies of objects, each with another figure in place of its own. */
export const copiesOf = (
  objects: readonly DrawnObject[],
  figures: readonly Figure[],
): DrawnObject[] => objects.map((object, i) => ({ ...object, figure: figures[i]! }));
