import { Vector3 } from 'three';
import type { ViewName } from '../model/view_place';

/** Where the camera is for the views that have a name, from the middle of the surface. */
export const views: Readonly<Record<ViewName, Vector3>> = {
  front: new Vector3(0, 0, 1),
  back: new Vector3(0, 0, -1),
  left: new Vector3(-1, 0, 0),
  right: new Vector3(1, 0, 0),
  // Straight above, the camera would not know which way is up.
  top: new Vector3(0, 1, 0.001).normalize(),
  bottom: new Vector3(0, -1, 0.001).normalize(),
};
