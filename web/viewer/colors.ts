import { Color } from 'three';

/** The colors of what is drawn in the scene, as CSS has them. */
export interface ViewerColors {
  front: string;
  back: string;
  sky: string;
  ground: string;
  edges: string;
  curve: string;
  lost: string;
  polygon: string;
  marks: string;
  center: string;
  /** Around what is selected. */
  chosen: string;
  /** Of the frame round what is transformed. */
  frame: string;
}

/** How bright the surface is where it is lit as most of it is. */
const surfaceShade = 0.75;

/** The surface's color where it is lit as most of it is. */
export const litSurface = ({ front }: ViewerColors): Color =>
  new Color(front).multiplyScalar(surfaceShade);
