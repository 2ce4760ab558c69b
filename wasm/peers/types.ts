import type { Path } from '../path.js';
import type {
  CenterOfMass,
  CurveSamples,
  LongWorkOptions,
  PointLike,
  Solver,
  Star,
} from '../types.js';

/**
 * The methods that are compared: the vector heat method (Sharp, Soliman, Crane 2019), the affine
 * heat method (Soliman, Sharp 2025), weighted averages (Panozzo, Baran, Diamanti, Sorkine-Hornung
 * 2013), piecewise-linear descent of the distance field (Kimmel, Sethian 1998), subdivision as in b/Surf
 * (Mancinelli, Nazzaro, Pellacini, Puppo 2022), the paper's method (Mancinelli, Puppo), our centers of mass of
 * all points (`karcher`, level 0) and our default, which refines the control polygon first (`leveled`).
 */
export type ComparedMethod =
  | 'vectorHeat'
  | 'affineHeat'
  | 'weightedAverages'
  | 'descent'
  | 'bSurf'
  | 'paper'
  | 'karcher'
  | 'leveled';

export interface MethodOptions {
  method: ComparedMethod;
  /** `paper` and `karcher`: how distances are found; by default as in `FieldOptions`. */
  solver?: Solver;
  rings?: number;
  /** `paper`: as in `FieldOptions`. */
  star?: Star;
  /**
   * `paper` and `karcher`: where searches start. `heaviest` (the default), as the engine's: the ends of a
   * segment at the control point of the largest weight, other samples at the last that converged, and
   * again at control points where that fails. `authors`, as the program of the paper's authors: the first
   * sample at the geodesic de Boor point, as are those after it until one is found; then each at the last
   * one that was, through all segments, and never again; where a control point has all the weight, as at
   * the ends of a Bezier curve, it is the sample.
   */
  seeds?: 'heaviest' | 'authors';
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
  /** What kind of curve that is, where it is one that can be subdivided: for `bSurf`
   * and `leveled`. */
  shape?: { kind: 'bspline' | 'bezier' | 'rational'; weights?: readonly number[] };
}

/** A curve by one of the methods, until `dispose` (compared_curve.ts). */
export interface MethodCurve {
  movePoint(i: number, point: PointLike): void;
  startAt(point: PointLike): void;
  finish(): number;
  trace(work?: LongWorkOptions): Promise<number>;
  readonly fieldsMs: number;
  samples(): CurveSamples;
  line(): ComparedLine;
  lostByOwnRule(): number;
  logMaps(): LogMapCounts | null;
  dispose(): void;
}

/** A method prepared on a mesh, until `dispose` (prepared_method.ts). */
export interface PreparedCurves {
  readonly options: MethodOptions;
  readonly prepareMs: number;
  curve(plan: CurvePlan): MethodCurve;
  centerOfMass(
    points: readonly PointLike[],
    weights: ArrayLike<number>,
    options?: { start?: PointLike },
  ): ComparedCenter;
  dispose(): void;
}

/** A curve for drawing. */
export interface ComparedLine {
  path: Path;
  /** A number for each point of the path: 1 where the sample that it leads to did not converge. */
  unconverged: Uint8Array;
}

/** What all methods tell of a center of mass. */
export type ComparedCenter = Pick<CenterOfMass, 'point' | 'position' | 'status'>;

/** Log maps of a heat method's curve: how many were made, and how many asked for. */
export interface LogMapCounts {
  made: number;
  asked: number;
}
