/** Objects that keep their places relative to each other in a move. */
import type { Drawing, DrawnObject } from './drawing';
import { placesOf } from './moving';
import { withSources } from './sources';

/**
 * Divides objects into parts that move as one. Objects that share a place of the surface belong
 * together, and so do all sources of one object, such as a union.
 */
export function togetherOf(drawing: Drawing, objects: readonly DrawnObject[]): DrawnObject[][] {
  const partOf = new Map(objects.map((object) => [object, [object]]));
  const join = (one: DrawnObject, other: DrawnObject) => {
    const [part, joined] = [partOf.get(one)!, partOf.get(other)!];
    if (part === joined) return;
    for (const object of joined) partOf.set(object, part);
    part.push(...joined);
  };
  const firstAt = new Map<string, DrawnObject>();
  for (const object of objects) {
    for (const { face, bary } of placesOf(object.figure)) {
      const key = `${face} ${bary}`;
      join(firstAt.get(key) ?? object, object);
      if (!firstAt.has(key)) firstAt.set(key, object);
    }
  }
  for (const { id } of drawing.objects) {
    const ids = new Set(withSources(drawing, [id]));
    const sources = objects.filter((object) => ids.has(object.id));
    for (const source of sources) join(sources[0]!, source);
  }
  return [...new Set(partOf.values())];
}
