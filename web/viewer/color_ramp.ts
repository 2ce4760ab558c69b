import { Color } from 'three';

/**
 * From near to far, at even steps: ever darker, so that the order is seen without telling the hues
 * apart, and light enough for curves to be seen on it.
 */
const rampColors = ['#fff3c9', '#fcd08a', '#f29e7c', '#d47a9b', '#a274b8'] as const;

/** Of isolines, which are seen on all of the ramp. */
export const isolineColor = '#42253f';

export const rampAsCss = `linear-gradient(to right, ${rampColors.join(', ')})`;

export const rampForShader = () => rampColors.map((color) => new Color(color));
