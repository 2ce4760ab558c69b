import { Color } from 'three';

/**
 * Colors from near to far, at even steps. They grow darker, so that the order is visible without
 * hues, and stay light enough for curves on them.
 */
const rampColors = ['#fff3c9', '#fcd08a', '#f29e7c', '#d47a9b', '#a274b8'] as const;

/** The color of isolines, which is visible on every color of the ramp. */
export const isolineColor = '#42253f';

export const rampAsCss = `linear-gradient(to right, ${rampColors.join(', ')})`;

export const rampForShader = () => rampColors.map((color) => new Color(color));
