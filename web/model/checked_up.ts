import type { CheckUp } from 'karcher/checkup';

/** The largest number of places of one kind that the page draws at once. */
export const mostPlaces = 20_000;

/** A check-up, with its triangles as they are drawn. */
export interface CheckedUp extends CheckUp {
  outlines: Record<'needles' | 'caps', Float32Array>;
}

/** The number of coordinates of a triangle's outline, whose last corner is its first one again. */
export const outlineLength = 12;
