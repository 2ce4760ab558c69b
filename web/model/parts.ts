/** Parts of a cut surface, and the part that contains a point. */
import type { SurfacePoint } from 'karcher';
import type { PartChoice } from './derived';

/** Triangles: coordinates x, y, z of each vertex, and three vertices for each triangle. */
export interface Shell {
  positions: Float64Array;
  triangles: Int32Array;
  area: number;
  closed: boolean;
  /** The volume that the triangles enclose; null if they are not closed. */
  volume: number | null;
}

export interface SurfacePart extends Shell {
  /** The surface's face that contains each triangle. */
  faces: Int32Array;
  /** Two numbers for each corner of a triangle: its second and third weight in that face. */
  weights: Float32Array;
  /** A point inside one of the part's triangles. */
  point: SurfacePoint;
  /**
   * The shell of a part with thickness. `most` is the largest thickness that the part's shape
   * allows, if the chosen thickness exceeds it.
   */
  thick: (Shell & { most: number | null }) | null;
}

/** The choices for parts. If several choices are for one part, the last counts. */
export function choicesOf(
  parts: readonly SurfacePart[],
  choices: readonly PartChoice[],
): ('kept' | 'hidden' | 'deleted')[] {
  const states = parts.map((): 'kept' | 'hidden' | 'deleted' => 'kept');
  for (const { point, state } of choices) {
    const index = parts.findIndex((part) => lies(point, part));
    if (index >= 0) states[index] = state;
  }
  return states;
}

/** Whether a point of the surface lies in a part. */
export function lies({ face, bary }: SurfacePoint, { faces, weights }: SurfacePart): boolean {
  const [, x, y] = bary;
  for (let i = faces.indexOf(face); i >= 0; i = faces.indexOf(face, i + 1)) {
    if (isInTriangle(weights, i, x, y)) return true;
  }
  return false;
}

type Six = [number, number, number, number, number, number];

/**
 * Whether a point of the plane lies in a triangle or on its rim. The triangle's corners begin at
 * index 6 * `i`.
 */
export function isInTriangle(
  corners: Float32Array | Float64Array,
  i: number,
  x: number,
  y: number,
): boolean {
  const [ax, ay, bx, by, cx, cy] = corners.subarray(6 * i, 6 * i + 6) as unknown as Six;
  const side = (px: number, py: number, qx: number, qy: number) =>
    (qx - px) * (y - py) - (qy - py) * (x - px);
  const signs = [side(ax, ay, bx, by), side(bx, by, cx, cy), side(cx, cy, ax, ay)];
  return signs.every((sign) => sign >= 0) || signs.every((sign) => sign <= 0);
}

/** The choices, with a new choice for a part in place of earlier ones. */
export function withChoice(
  choices: readonly PartChoice[],
  part: SurfacePart,
  state: 'kept' | 'hidden' | 'deleted',
): PartChoice[] {
  const others = choices.filter(({ point }) => !lies(point, part));
  return state === 'kept' ? others : [...others, { point: part.point, state }];
}
