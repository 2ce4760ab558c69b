import type { Path } from '../path.js';
import type {
  CenterOfMass,
  CurveLevels,
  CurveSamples,
  LongWorkOptions,
  PointLike,
  Solver,
  Star,
} from '../types.js';

/**
 * The compared methods: the vector heat method (Sharp, Soliman, Crane 2019), the affine heat method
 * (Soliman, Sharp 2025), weighted averages (Panozzo, Baran, Diamanti, Sorkine-Hornung 2013),
 * piecewise-linear descent of the distance field (Kimmel, Sethian 1998), subdivision as in b/Surf
 * (Mancinelli, Nazzaro, Pellacini, Puppo 2022), the paper's method (Mancinelli, Puppo), our centers
 * of mass of all points (`karcher`, level 0) and our default with its levels (`leveled`).
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
  /** The method that computes the curve. */
  method: ComparedMethod;
  /** For `paper` and `karcher`: the solver of distances; by default as in `FieldOptions`. */
  solver?: Solver;
  /** For `paper` and `karcher`: the k of the solver `graph`, as in `FieldOptions`. */
  rings?: number;
  /** For `paper`: the star, as in `FieldOptions`. */
  star?: Star;
  /**
   * For `paper` and `karcher`: the starts of searches. With `heaviest` (the default), searches
   * start as in the engine. Searches for the ends of a segment start at the control point of the
   * largest weight; searches for other samples start at the last sample that converged. A search
   * that fails starts again at control points. With `authors`, searches start as in the program of
   * the paper's authors: at the geodesic de Boor point until a search finds a center, then at the
   * last center found in any segment. With `authors`, a search that fails has no second start, and
   * a control point with all the weight, as at the ends of a Bezier curve, is itself the sample.
   */
  seeds?: 'heaviest' | 'authors';
  /**
   * For `leveled`: the levels, `auto` by default. At level 0 a curve is that of `karcher`, with the
   * bridges of the engine.
   */
  levels?: CurveLevels;
  /** For the heat methods: whether to use the intrinsic Delaunay triangulation of the surface. */
  delaunay?: boolean;
  /** For `affineHeat`: whether to use the frame that is transported from the source. */
  adaptive?: boolean;
  /** For `weightedAverages`: the number of landmarks, 500 by default. */
  landmarks?: number;
  /** For `weightedAverages`: the solver of the landmarks' distances, `fast` by default. */
  landmarkDistances?: 'fast' | 'exact';
}

/**
 * A table of weights at parameters t in [0, 1]. A row has a weight for each control point of a
 * segment.
 */
export interface WeightTable {
  /** The number of control points of a segment, which is the number of columns. */
  points: number;
  /** The parameter of each row. */
  t: Float64Array;
  /** The weights, row after row. */
  weights: Float64Array;
}

/**
 * A curve, given by control points and weights. Segment j uses the points from number `first[j]`
 * on, one for each column of the table. It has a sample for each row: the center of mass of its
 * points with the row's weights.
 */
export interface CurvePlan {
  /** The control points of the whole curve. */
  points: readonly PointLike[];
  /** The number of each segment's first control point. */
  first: readonly number[];
  /** The table with the weights of a segment's points at each sample. */
  table: WeightTable;
  /**
   * The kind and the weights of a curve that can be subdivided. `bSurf` and `leveled` need this
   * shape.
   */
  shape?: { kind: 'bspline' | 'bezier' | 'rational'; weights?: readonly number[] };
}

/** A curve by one of the methods, until `dispose` (compared_curve.ts). */
export interface MethodCurve {
  /**
   * Replaces control point `i`. The next trace traces again the segments that the point affects.
   */
  movePoint(i: number, point: PointLike): void;
  /** Starts the searches of each segment at a point of the surface. */
  startAt(point: PointLike): void;
  /**
   * Computes all missing fields and samples in one call. Returns the duration in milliseconds,
   * without the paths that join the samples.
   */
  finish(): number;
  /**
   * Does the same as `finish` in slices. The returned duration excludes the pauses between the
   * slices.
   */
  trace(work?: LongWorkOptions): Promise<number>;
  /** The milliseconds that the fields of the last `trace` took; 0 for methods without fields. */
  readonly fieldsMs: number;
  /** The samples of all segments, each with the status of its search. */
  samples(): CurveSamples;
  /** The samples joined by geodesics, for drawing. */
  line(): ComparedLine;
  /** The number of samples that the method's own authors would not accept. */
  lostByOwnRule(): number;
  /** The numbers of computed and of requested log maps; null for methods without log maps. */
  logMaps(): LogMapCounts | null;
  /** Frees the memory. A second call has no effect. */
  dispose(): void;
}

/** A method prepared on a mesh, until `dispose` (prepared_method.ts). */
export interface PreparedCurves {
  /** The method and its settings. */
  readonly options: MethodOptions;
  /** The milliseconds that the preparation for the mesh took. */
  readonly prepareMs: number;
  /** Creates a curve of a plan. `trace` or `finish` computes its samples. */
  curve(plan: CurvePlan): MethodCurve;
  /** Finds one center of mass by this method. */
  centerOfMass(
    points: readonly PointLike[],
    weights: ArrayLike<number>,
    options?: { start?: PointLike },
  ): ComparedCenter;
  /** Frees the memory of the method and its curves. A second call has no effect. */
  dispose(): void;
}

/** A curve for drawing. */
export interface ComparedLine {
  /** The path through the samples. */
  path: Path;
  /**
   * A number for each point of the path: 1 if the piece that ends there lies on a bridge or leads
   * to a sample that did not converge.
   */
  unconverged: Uint8Array;
}

/** A center of mass by any of the methods. */
export type ComparedCenter = Pick<CenterOfMass, 'point' | 'position' | 'status'>;

/** The numbers of log maps of a heat method's curve, and their time. */
export interface LogMapCounts {
  /** The number of computed log maps. */
  made: number;
  /**
   * The number of requests for log maps. The authors' library would compute a map for each request.
   */
  asked: number;
  /** The milliseconds that the computed log maps took. */
  ms: number;
}

/**
 * The record of one search by the paper's method.
 * @internal
 */
export interface NewtonSteps {
  converged: boolean;
  /** Whether a zero inside a triangle ended the search. */
  inside: boolean;
  iterations: number;
  /** The number of geodesics along steps of Newton's method. */
  traced: number;
  /** The number of these geodesics that the search cut at a joint before their end. */
  shortened: number;
  /** The number of cut geodesics whose original end has no smaller gradient than their start. */
  needed: number;
  /** The number of geodesics with a smaller gradient neither at a joint nor at the end. */
  stuck: number;
  /**
   * The norms of the gradient at the starts of the last three iterations, the last one first; 0 for
   * an iteration that did not take place.
   */
  gradients: number[];
}
