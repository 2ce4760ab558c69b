import type { CheckUp } from 'karcher/checkup';

/** More places of a kind than this are not drawn at once. */
export const mostPlaces = 20_000;

/** A check-up, with its triangles as they are drawn. */
export interface CheckedUp extends CheckUp {
  outlines: Record<'needles' | 'caps', Float32Array>;
}

/** x, y, z of the corners of a triangle, and of its first one again. */
export const outlineLength = 12;
