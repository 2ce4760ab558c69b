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

/** The choice of a method, and its settings. */
export interface MethodOptions {
  /** The method that makes the curve. */
  method: ComparedMethod;
  /** `paper` and `karcher`: how distances are found; by default as in `FieldOptions`. */
  solver?: Solver;
  /** `paper` and `karcher`: the k of the solver `graph`, as in `FieldOptions`. */
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
  /** The number of control points of a segment, which is that of the columns. */
  points: number;
  /** The parameter of each row. */
  t: Float64Array;
  /** The weights, row after row. */
  weights: Float64Array;
}

/**
 * A curve by its control points and weights: segment j is the center of mass of as many points as
 * the table has columns, from `first[j]` on, with a sample for each row.
 */
export interface CurvePlan {
  /** The control points of the whole curve. */
  points: readonly PointLike[];
  /** The number of each segment's first control point. */
  first: readonly number[];
  /** The weights of a segment's points at each of its samples. */
  table: WeightTable;
  /** The kind of curve, where it can be subdivided: `bSurf` and `leveled` need it. */
  shape?: { kind: 'bspline' | 'bezier' | 'rational'; weights?: readonly number[] };
}

/** A curve by one of the methods, until `dispose` (compared_curve.ts). */
export interface MethodCurve {
  /** Replaces control point `i`; the segments that it touches are to be traced again. */
  movePoint(i: number, point: PointLike): void;
  /** Starts the searches of each segment at a point of the surface. */
  startAt(point: PointLike): void;
  /** Makes what is missing at once, and returns the milliseconds that it took. */
  finish(): number;
  /** Does the same as `finish` in slices, with pauses that do not count. */
  trace(work?: LongWorkOptions): Promise<number>;
  /** The milliseconds of the last `trace` that its fields took; 0 of methods without fields. */
  readonly fieldsMs: number;
  /** The samples of all segments, and how the search for each ended. */
  samples(): CurveSamples;
  /** The samples joined by geodesics, for drawing. */
  line(): ComparedLine;
  /** The number of samples that the method's own authors would not have accepted either. */
  lostByOwnRule(): number;
  /** The log maps that were made and asked for; null of methods without any. */
  logMaps(): LogMapCounts | null;
  /** Gives the memory back. Safe to repeat. */
  dispose(): void;
}

/** A method prepared on a mesh, until `dispose` (prepared_method.ts). */
export interface PreparedCurves {
  /** The method and its settings. */
  readonly options: MethodOptions;
  /** The milliseconds that the preparation for the mesh took. */
  readonly prepareMs: number;
  /** Makes a curve of a plan; `trace` or `finish` makes its samples. */
  curve(plan: CurvePlan): MethodCurve;
  /** Finds one center of mass by this method. */
  centerOfMass(
    points: readonly PointLike[],
    weights: ArrayLike<number>,
    options?: { start?: PointLike },
  ): ComparedCenter;
  /** Gives the memory back, that of the curves too. Safe to repeat. */
  dispose(): void;
}

/** A curve for drawing. */
export interface ComparedLine {
  /** The path through the samples. */
  path: Path;
  /** A number for each point of the path: 1 where the sample that it leads to did not converge. */
  unconverged: Uint8Array;
}

/** What all methods tell of a center of mass. */
export type ComparedCenter = Pick<CenterOfMass, 'point' | 'position' | 'status'>;

/** Log maps of a heat method's curve: how many were made, and how many asked for. */
export interface LogMapCounts {
  /** The number of log maps that were made. */
  made: number;
  /** The number of log maps that were asked for, each of which a library would make anew. */
  asked: number;
}

/**
 * What a search of the paper's method did.
 * @internal
 */
export interface NewtonSteps {
  converged: boolean;
  /** Whether a zero inside a triangle ended the search. */
  inside: boolean;
  iterations: number;
  /** Geodesics along steps of Newton's method. */
  traced: number;
  /** How many of these were taken to a joint before their end. */
  shortened: number;
  /** How many of those have no smaller gradient at their end than at their start. */
  needed: number;
  /** Geodesics on which no joint has a smaller gradient than their start. */
  stuck: number;
  /** The gradients where the last three iterations began, the last one first; 0 for none. */
  gradients: number[];
}
