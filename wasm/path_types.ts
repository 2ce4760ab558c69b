/** The types of the API that hold paths. */
import type { Path } from './path.js';
import type { PathValue } from './path_values.js';
import type { BridgedInterval, CurveSamples, PointLike, SurfacePoint } from './types.js';

/** A leg of a curve's control polygon. */
export interface CurveLeg {
  /** The path of the leg, from one control point to the next. */
  path: Path;
  /** The shortest path between the leg's ends, if the leg is a longer path. */
  shorter?: Path;
}

/** Places on a path, as flat arrays. */
export interface PathPoints {
  /** The face of each point. */
  face: Int32Array;
  /** Three barycentric weights for each point. */
  bary: Float64Array;
  /** The coordinates x, y, z of each point. */
  position: Float64Array;
  /** The length from the start to each point. */
  lengths: Float64Array;
}

/**
 * A closed path, a path from boundary to boundary, the value of either, or a list of points. The
 * list is closed if it ends at its start; consecutive points share a face.
 */
export type Outline = Path | PathValue | readonly PointLike[];

/** The area that outlines enclose together. */
export interface RegionShape {
  /** The outlines that together bound the shape. */
  outlines: readonly Outline[];
  /**
   * A point that must lie inside, or the inner side of the first outline. Left and right refer to
   * the first place where the outline's two sides differ. The choice stays the same when the
   * outline moves. By default the smaller side is inside; of two equal sides, the left one.
   */
  inside?: PointLike | 'left' | 'right';
}

/** A circle on a surface, as a path and as the traced curve. */
export interface Circle extends Ellipse {
  /**
   * The largest difference between a sample's exact distance from the center and the radius,
   * relative to the radius.
   */
  deviation: number;
}

/** An ellipse on a surface, as a path and as the traced curve. */
export interface Ellipse {
  /** The samples; `segment` is the number of the arc. */
  samples: CurveSamples;
  /** The bridged intervals; `segment` is the number of the arc. */
  bridged: BridgedInterval[];
  /** The samples joined by geodesics. */
  path: Path;
  /**
   * A number for each point of the path: 1 if the piece before it does not consist of centers of
   * mass, else 0.
   */
  unconverged: Uint8Array;
  /**
   * The number of levels of the arcs: the given number, or the number that `auto` chose (see the
   * option `levels`).
   */
  levels: number;
  /** The numbers of the arcs for which a geodesic from the center is not a shortest path. */
  notShortest: number[];
}

/** A straightest path, its end, and the reason why it ends there. */
export interface StraightestPath {
  /** The path itself. */
  path: Path;
  /** The point where the path ends. */
  end: SurfacePoint;
  /**
   * The reason for the end: the path has the whole length (`complete`), it met the boundary, or it
   * crossed a million edges (`limit`).
   */
  stop: 'complete' | 'boundary' | 'limit';
  /** The part of the given length beyond the path's end; 0 for `complete`. */
  remaining: number;
}
