/** The types of the API that hold paths. */
import type { Path } from './path.js';
import type { BridgedInterval, CurveSamples, PointLike, SurfacePoint } from './types.js';

/** A leg of a curve's control polygon. */
export interface CurveLeg {
  /** The path from the one point to the other. */
  path: Path;
  /** The shortest path between its ends, if the leg is another one. */
  shorter?: Path;
}

/**
 * A closed path, or one from boundary to boundary, or its points, of which consecutive ones have a face
 * in common; it is closed where it ends as it starts.
 */
export type Outline = Path | readonly PointLike[];

/** What outlines enclose together. */
export interface RegionShape {
  /** The closed paths that bound the shape. */
  outlines: readonly Outline[];
  /**
   * A point that shall lie inside, or the side of the first outline that is inside where that first
   * divides: it stays so while the outline is moved. Without it the smaller side is inside.
   */
  inside?: PointLike | 'left' | 'right';
}

/** A circle on a surface, as a path and as the curve that it was traced of. */
export interface Circle extends Ellipse {
  /**
   * The largest difference of a sample's exact distance from the center and the radius, as a part of
   * the radius.
   */
  deviation: number;
}

/** An ellipse on a surface, as a path and as the curve that it was traced of. */
export interface Ellipse {
  /** `segment` is the number of the arc. */
  samples: CurveSamples;
  /** `segment` is the number of the arc. */
  bridged: BridgedInterval[];
  /** The samples joined by geodesics. */
  path: Path;
  /** A number for each point of the path: 1 where the piece that leads to it is no center of mass. */
  unconverged: Uint8Array;
  /** How many levels the arcs have, also where `levels` leaves that to them. */
  levels: number;
  /** Numbers of the arcs whose geodesics from the center stopped being shortest. */
  notShortest: number[];
}

/** Where a straightest path leads, and why it ends. */
export interface StraightestPath {
  /** The path itself. */
  path: Path;
  /** The point where the path ends. */
  end: SurfacePoint;
  /**
   * Why the path ended: it has the whole length (`complete`), it met the boundary, or it crossed a
   * million edges (`limit`).
   */
  stop: 'complete' | 'boundary' | 'limit';
  /** The length that was not walked; 0 for `complete`. */
  remaining: number;
}
