import { Ray, Vector3 } from 'three';
import type { Places } from '../model/examples';
import type { Surface } from './surface';

/** A distance from the middle beyond everything in the scene. */
const outside = 4;

/** The search for places of a surface in the scene. */
export function placesOn(surface: Surface): Places {
  return {
    seen([dx, dy, dz], x, y) {
      const back = new Vector3(dx, dy, dz).normalize();
      const right = new Vector3(0, 1, 0).cross(back).normalize();
      const up = back.clone().cross(right);
      const origin = right.multiplyScalar(x).addScaledVector(up, y).addScaledVector(back, outside);
      return surface.pick(new Ray(origin, back.negate()))?.point ?? null;
    },
    near: (place) => surface.nearest(new Vector3(...place)),
  };
}
