import type { Object3D, Vector3 } from 'three';
import type { ViewerColors } from './colors';

/** A drawing over the surface that is not part of the user's drawing. */
export interface Layer {
  readonly object: Object3D;
  /** Follows the camera to its place before each frame. */
  follow(camera: Vector3): void;
  setColors(colors: ViewerColors): void;
}
