import type { Mesh, SurfacePoint } from 'karcher';
import { KarcherError } from 'karcher/peers';
import { carriedSize, drawingInPlane } from '../figures/carried';
import type { Vector } from '../figures/types';
import type { Scene } from './scene';

/** A drawing on its source, and its image on the target. */
export interface Carried {
  source: Float32Array[];
  /** The image of each stroke, cut into parts at points that have no weights or no center. */
  target: Float32Array[];
  /** The numbers of all points, of carried points, and of points with a weight below 0. */
  points: number;
  carried: number;
  negative: number;
  /** A sentence that says why the first missing point has no image. */
  reason: string | null;
  /** The places of the control points. */
  places: { source: Vector[]; target: Vector[] };
  milliseconds: number;
}

/** The drawing on the source, along straightest geodesics from the drawing's middle. */
function drawingOn({ mesh, nearest }: Scene, middle: Vector): SurfacePoint[][] {
  const center = nearest.point(middle);
  return drawingInPlane().map((stroke) =>
    stroke.map(([x, y]) => {
      const length = carriedSize * Math.hypot(x, y);
      if (length === 0) return center;
      return mesh.straightest(center, [x, y, 0], length).end;
    }),
  );
}

/** The parts of a line between its missing points. A part of a single point is omitted. */
function partsOf(mesh: Mesh, points: readonly (SurfacePoint | null)[]): Float32Array[] {
  const parts: Vector[][] = [[]];
  for (const point of points) {
    if (point) parts.at(-1)!.push(mesh.position(point));
    else if (parts.at(-1)!.length > 0) parts.push([]);
  }
  return parts.filter(({ length }) => length > 1).map((part) => Float32Array.from(part.flat()));
}

/**
 * Carries the drawing. Each point has weights for which it is the center of mass of the source's
 * control points. Its image is the center of mass of the target's control points with these
 * weights.
 */
export function carry(
  source: Scene,
  target: Scene,
  middle: Vector,
  places: { source: readonly Vector[]; target: readonly Vector[] },
): Carried {
  const from = places.source.map((place) => source.nearest.point(place));
  const to = places.target.map((place) => target.nearest.point(place));
  const strokes = drawingOn(source, middle);
  const start = performance.now();
  const counts = { points: 0, carried: 0, negative: 0 };
  let reason: string | null = null;
  const carried = strokes.map((stroke) =>
    stroke.map((point) => {
      counts.points++;
      try {
        const { weights } = source.mesh.weightsOf(point, from);
        if (weights.some((weight) => weight < 0)) counts.negative++;
        const center = target.mesh.centerOfMass(to, weights, { normalize: true });
        if (center.status === 'converged') {
          counts.carried++;
          return center.point;
        }
        reason ??= 'no center of mass of these weights was found';
      } catch (error) {
        if (!(error instanceof KarcherError)) throw error;
        reason ??= error.message;
      }
      return null;
    }),
  );
  const milliseconds = performance.now() - start;
  return {
    source: strokes.flatMap((stroke) => partsOf(source.mesh, stroke)),
    target: carried.flatMap((stroke) => partsOf(target.mesh, stroke)),
    ...counts,
    reason,
    places: {
      source: from.map((point) => source.mesh.position(point)),
      target: to.map((point) => target.mesh.position(point)),
    },
    milliseconds,
  };
}
