import { Color } from 'three';

/** The colors in the scene, as CSS values. */
export interface ViewerColors {
  /** The background in the middle of the stage. */
  stage: string;
  front: string;
  back: string;
  sky: string;
  ground: string;
  /** The ground below the surface, where the surface hides the sky. */
  shadow: string;
  /** The lit ground around that shadow. */
  floor: string;
  edges: string;
  curve: string;
  lost: string;
  polygon: string;
  marks: string;
  center: string;
  /** The halo around selected objects. */
  chosen: string;
  /** The frame around objects under transformation. */
  frame: string;
}

/** The brightness of most of the surface under the light, relative to its color. */
const surfaceShade = 0.75;

/** The color of most of the surface under the light. */
export const litSurface = ({ front }: ViewerColors): Color =>
  new Color(front).multiplyScalar(surfaceShade);

/**
 * The brightness of the surface's shades relative to its color, from its shadows to the places that
 * face the light.
 */
const shades = [0.15, 0.3, 0.5, 0.75, 1, 1.2];

/**
 * The distance in OKLab from a thin line's color to the surface's. Below this distance, the line is
 * hard to see. It is five times the smallest visible difference.
 */
const leastApart = 5 * 0.02;

/** A color in OKLab, where distances correspond to visible differences. */
function oklab({ r, g, b }: Color): [number, number, number] {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

/** Whether a line of this color is hard to see on some shade of the surface. */
export function isAmongShades(color: string, { front }: ViewerColors): boolean {
  const line = oklab(new Color(color));
  return shades.some((part) => {
    const shade = oklab(new Color(front).multiplyScalar(part));
    return Math.hypot(...line.map((value, i) => value - shade[i]!)) < leastApart;
  });
}

/** The color of a rim: light around a dark line, dark around a light one. */
export const rimColor = (color: string): string =>
  oklab(new Color(color))[0] < 0.5 ? '#ffffff' : '#14171c';
