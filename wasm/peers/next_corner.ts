import type { SurfacePoint } from '../types.js';

/**
 * The corner after the corner nearest to a point, in the point's face. It serves as the end of a
 * drag by about an edge.
 */
export function nextCorner({ face, bary }: SurfacePoint): SurfacePoint {
  const heaviest = bary.indexOf(Math.max(...bary));
  const corner: [number, number, number] = [0, 0, 0];
  corner[(heaviest + 1) % 3] = 1;
  return { face, bary: corner };
}
