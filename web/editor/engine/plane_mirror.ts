/** Mirror images of objects in a plane that cuts the surface. */
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
import { mirroredInside } from './mirroring';

/**
 * The largest distance of mirror images from the surface, relative to its diagonal. If an image is
 * farther away, the surface is not symmetric there.
 */
const besideAtMost = 0.05;
/**
 * The largest difference between the two sides of a surface that counts as symmetric, relative to
 * the surface's diagonal.
 */
const apartAtMost = 0.02;
/** The scene's diagonal. */
const diagonal = 2;

/**
 * The surface's plane of symmetry, in the scene, and the difference between the surface's sides
 * relative to its diagonal; null if there is no such plane. A vase has many such planes; the result
 * is then the one that is seen edge-on, with its normal to the right.
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

/**
 * The figures of objects, mirrored in a plane of the scene. Each point moves to the place of the
 * surface nearest to its image. Null if an image is far from the surface.
 */
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
  return movedFigures(figures, carried, { points, directions }, 1).map(mirroredInside);
}
