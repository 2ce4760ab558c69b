/** Mirror images of objects in a plane, which cuts the surface. */
import { Vector3 } from 'three';
import type { DrawnObject } from '../../model/drawing';
import type { Figure } from '../../model/figure';
import { carriedOf, movedFigures } from '../../model/moving';
import {
  mirroredDirection,
  mirroredPlace,
  type Plane,
  type Symmetry,
  symmetryOf,
} from '../../model/symmetry';
import { nearestPlaceOf, samplesOf } from '../../viewer/section';
import type { Surface } from '../../viewer/surface';

/**
 * How far mirror images may lie from the surface, as a part of its diagonal. Where they lie farther, the
 * surface is no mirror image of itself.
 */
const besideAtMost = 0.05;
/** A surface whose sides differ by more than that part of its diagonal is not symmetric. */
const apartAtMost = 0.02;
/** The scene's diagonal. */
const diagonal = 2;

/**
 * The plane in which the surface is its own mirror image, in the scene, and how far its sides differ, as a part of
 * its diagonal. A vase has many: of those the one is taken that is seen edge-on, its normal to the right.
 */
export async function planeOfSymmetry(surface: Surface, right: Vector3): Promise<Symmetry | null> {
  const pause = () => new Promise<void>((resolve) => setTimeout(resolve));
  const symmetry = await symmetryOf(
    samplesOf(surface, 600),
    nearestPlaceOf(surface),
    [right.toArray(), [1, 0, 0], [0, 0, 1], [0, 1, 0]],
    pause,
  );
  if (!symmetry || symmetry.apart > apartAtMost * diagonal) return null;
  return { ...symmetry, apart: symmetry.apart / diagonal };
}

/** The figures of objects mirrored in a plane of the scene, each point to the place nearest to its image; null where that is far. */
export function figuresInPlane(
  surface: Surface,
  plane: Plane,
  objects: readonly DrawnObject[],
): Figure[] | null {
  const figures = objects.map(({ figure }) => figure);
  const carried = carriedOf(figures);
  const directions = new Float64Array(3 * carried.length);
  let farthest = 0;
  const points = carried.map(({ place, direction }, i) => {
    const image = new Vector3(...mirroredPlace(plane, surface.position(place).toArray()));
    const point = surface.nearest(image);
    farthest = Math.max(farthest, surface.position(point).distanceTo(image));
    if (direction) {
      const length = Math.hypot(...direction);
      const [a, b, c] = surface.corners(point.face);
      const normal = b.sub(a).cross(c.sub(a)).normalize();
      const turned = surface.directionInScene(direction);
      const ahead = new Vector3(...mirroredDirection(plane, turned.toArray()));
      ahead.addScaledVector(normal, -ahead.dot(normal)).setLength(length);
      directions.set(surface.directionFromScene(ahead), 3 * i);
    }
    return point;
  });
  if (farthest > besideAtMost * diagonal) return null;
  return movedFigures(figures, carried, { points, directions }, 1);
}
