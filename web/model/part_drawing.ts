/** The part of a drawing that lies on a part of its surface. */
import type { SurfacePoint } from 'karcher';
import { isDerived } from './derived';
import { type Drawing, type DrawnObject, emptyDrawing, withObjectPlaces } from './drawing';
import { isEmpty } from './figure';
import { placesOf } from './moving';

/** All places of a drawing, including the places of choices for the parts of cuts. */
export const placesOfDrawing = ({ objects }: Drawing): SurfacePoint[] =>
  objects.flatMap(({ figure }) => [
    ...placesOf(figure),
    ...(figure.derived?.parts ?? []).map(({ point }) => point),
  ]);

export interface PartDrawing {
  drawing: Drawing;
  /** The number of objects on the part, and the number of objects that were considered. */
  came: number;
  all: number;
}

/**
 * The objects all of whose places have a point in `onPart`, and the objects derived only from such
 * objects. The cut to which the part belongs is not among them.
 */
export function drawingOnPart(
  { objects, active }: Drawing,
  cut: number,
  onPart: ReadonlyMap<SurfacePoint, SurfacePoint | null>,
): PartDrawing {
  const drawn = objects.filter(({ id, figure }) => id !== cut && !isEmpty(figure));
  const stays = new Set(objects.map(({ id }) => id));
  const comes = ({ figure }: DrawnObject) =>
    isDerived(figure.kind)
      ? figure.derived!.sources.every((id) => !stays.has(id))
      : placesOf(figure).every((place) => onPart.get(place));
  // Each round finds the objects that derive only from objects found before.
  for (let before = -1; before !== stays.size; ) {
    before = stays.size;
    for (const object of drawn) if (comes(object)) stays.delete(object.id);
  }
  const came = drawn
    .filter(({ id }) => !stays.has(id))
    .map((object) => withObjectPlaces(object, (place) => onPart.get(place)));
  const all = drawn.length;
  if (came.length === 0) return { drawing: emptyDrawing, came: 0, all };
  const open = came.find(({ id }) => id === active) ?? came.at(-1)!;
  return { drawing: { objects: came, active: open.id }, came: came.length, all };
}
