import { Vector3 } from 'three';
import type { ViewName } from '../model/view_place';

/** The camera's direction for each named view, from the middle of the surface. */
export const views: Readonly<Record<ViewName, Vector3>> = {
  front: new Vector3(0, 0, 1),
  back: new Vector3(0, 0, -1),
  left: new Vector3(-1, 0, 0),
  right: new Vector3(1, 0, 0),
  // From exactly above, the camera would have no upward direction.
  top: new Vector3(0, 1, 0.001).normalize(),
  bottom: new Vector3(0, -1, 0.001).normalize(),
};
