import type { Object3D, Vector3 } from 'three';
import type { ViewerColors } from './colors';

/** Something that is drawn over the surface, beside the drawing itself. */
export interface Layer {
  readonly object: Object3D;
  /** Called before each frame, with the camera's place. */
  follow(camera: Vector3): void;
  setColors(colors: ViewerColors): void;
}
