/** The drawings with which a surface opens. */
import { type Drawing, isBlank, withObjectPlaces } from './model/drawing';
import { fitting } from './model/fitting';
import { type Link, lostOf } from './model/link';
import { formatCount } from './panels/elements';
import { showNote } from './panels/messages';
import type { Surface } from './viewer/surface';

/** The part of a link's drawing that lies on the surface; reports the rest. */
export function wantedOf(link: Link) {
  return (surface: Surface): Drawing => {
    const fit = fitting(link.drawing, surface.triangles);
    const { points, circles } = lostOf(link, fit);
    if (points > 0) {
      const counted = formatCount(points, 'point of the link is', 'points of the link are');
      showNote(`${counted} not on this surface and ${points === 1 ? 'was' : 'were'} left out.`);
    }
    if (circles > 0) {
      const counted = formatCount(circles, 'circle of the link is', 'circles of the link are');
      showNote(`${counted} not on this surface and ${circles === 1 ? 'was' : 'were'} left out.`);
    }
    return fit;
  };
}

/** A drawing transferred to another mesh of the same surface, to the nearest points. */
export const carried = (drawing: Drawing, from: Surface, to: Surface): Drawing => ({
  ...drawing,
  objects: drawing.objects.map((object) =>
    withObjectPlaces(object, (point) =>
      to.nearest(to.inScene(from.fromScene(from.position(point)))),
    ),
  ),
});

/**
 * A drawing that comes along to another mesh of a surface; null if it is blank, so that a drawing
 * kept on that mesh stays.
 */
export const unlessBlank = (drawing: Drawing): Drawing | null =>
  isBlank(drawing) ? null : drawing;
