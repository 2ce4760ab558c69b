import type { Path } from '../path.js';
import type { CenterOfMass, PointLike, Solver } from '../types.js';

/**
 * The methods that are compared: the vector heat method (Sharp, Soliman, Crane 2019), the affine
 * heat method (Soliman, Sharp 2025), weighted averages (Panozzo, Baran, Diamanti, Sorkine-Hornung
 * 2013), piecewise-linear descent of the distance field (Kimmel, Sethian 1998), the paper's method
 * (Mancinelli, Puppo) and ours.
 */
export type ComparedMethod =
  | 'vectorHeat'
  | 'affineHeat'
  | 'weightedAverages'
  | 'descent'
  | 'paper'
  | 'karcher';

export interface MethodOptions {
  method: ComparedMethod;
  /** `paper` and `karcher`: how distances are found; by default as in `FieldOptions`. */
  solver?: Solver;
  rings?: number;
  /** The heat methods: on the intrinsic Delaunay triangulation of the surface. */
  delaunay?: boolean;
  /** `affineHeat`: in the frame that is transported from the source. */
  adaptive?: boolean;
  /** `weightedAverages`: 500 by default. */
  landmarks?: number;
  /** `weightedAverages`: how the landmarks' distances are found; `fast` by default. */
  landmarkDistances?: 'fast' | 'exact';
}

/** Weights at parameters t in [0, 1]: row after row, as many as a segment has control points. */
export interface WeightTable {
  points: number;
  t: Float64Array;
  weights: Float64Array;
}

/**
 * A curve by its control points and weights: segment j is the center of mass of as many points as
 * the table has columns, from `first[j]` on, with a sample for each row.
 */
export interface CurvePlan {
  points: readonly PointLike[];
  first: readonly number[];
  table: WeightTable;
}

/** A curve for drawing. */
export interface ComparedLine {
  path: Path;
  /** A number for each point of the path: 1 where the sample that it leads to did not converge. */
  unconverged: Uint8Array;
}

/** What all methods tell of a center of mass. */
export type ComparedCenter = Pick<CenterOfMass, 'point' | 'position' | 'status'>;
