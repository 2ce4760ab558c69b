/** The types of curves: their options, and the results of queries. */

import type {
  FieldOptions,
  PointArrays,
  PointLike,
  Status,
  SurfacePoint,
  VectorLike,
} from './point_types.js';

/**
 * The kind of a curve:
 *
 * - `bspline`: a B-spline of degree 1 to 5; with weights, a NURBS curve. Its knots are uniform by
 *   default, so that an open curve starts near the middle of its first points and ends near the
 *   middle of its last ones;
 * - `bezier`: one segment of degree (points - 1);
 * - `rational`: a Bezier curve with a weight for each point;
 * - `barycentric`: one rational segment through all points, with a beta for each point
 *   (Ramanantoanina, Hormann 2021); equal betas give Berrut's interpolant, and binomial
 *   coefficients give the polynomial;
 * - `catmullrom`: a curve through all points, with continuous tangents;
 * - `polyline`: paths from point to point, the exact shortest ones unless `legs` gives others;
 * - `custom`: one segment with a basis of your own.
 *
 * A curve through its control points meets them exactly on a plane, at the ends of an open curve,
 * and if it is a `polyline`. Otherwise it may miss them by a few hundredths of a mean edge, since
 * fields on a curved mesh are estimates.
 */
export type CurveKind =
  | 'bspline'
  | 'bezier'
  | 'rational'
  | 'barycentric'
  | 'catmullrom'
  | 'polyline'
  | 'custom';

/**
 * The spacing of a Catmull-Rom curve's knots: proportional to the square root of the distance
 * between points (`centripetal`), or equal (`uniform`).
 */
export type Parametrization = 'centripetal' | 'uniform';

/**
 * A basis of your own: a function from t in [0, 1] to a weight for each control point. The weights
 * sum to 1 within 1e-9 and may be negative.
 */
export type CurveBasis = (t: number, points: number) => ArrayLike<number>;

/**
 * The connection between the samples of a curve: geodesics, or the curve's own crossings of edges.
 */
export type CurveGeometry = 'geodesic' | 'exact';

/** The number of levels of a curve, or a rule for it. */
export type CurveLevels = number | 'auto' | 'limit';

/** The tolerance for a number of levels that the curve chooses itself. */
export interface LevelsTolerance {
  /**
   * The largest distance that levels may move a curve, in mean edges, if the curve is safe without
   * levels (see `CurveOptions.levels`). `auto` uses .02. With 0 the curve does not move; with
   * Infinity it is the draft that is quickest to compute.
   */
  tolerance: number;
}

/**
 * The points through which a leg of a control polygon passes; null for the shortest path. If all
 * points lie on edges, and consecutive points share a face (the leg's ends included), the leg
 * consists of exactly these points.
 */
export type LegPoints = readonly PointLike[] | null;

/**
 * All points of a drawn leg, including its ends. If an end is not at its control point, the leg
 * continues to the point as if a hand had dragged the end there. The leg need not stay the shortest
 * path.
 */
export type DrawnLeg = PointArrays;

export interface CurveOptions extends FieldOptions {
  /** The kind of the curve, which determines the weights of its points. */
  kind: CurveKind;
  /** The control points, in their order. */
  points: readonly PointLike[];
  /**
   * The legs of the control polygon, from each point to the next, and for a closed curve also from
   * the last to the first. Each is the shortest path, or a path through a few points, pulled tight.
   * Curves with levels follow the legs, and polylines consist of them. By default all legs are
   * shortest paths. The `drawnLegs` of a view are the legs of its curve.
   */
  legs?: readonly (LegPoints | DrawnLeg)[] | undefined;
  /**
   * The number of samples of each segment, both ends included: 2 to 100,000; 128 by default. Sample
   * i lies at t = i / (samples - 1). With `adaptive`, each segment has as many samples as the
   * tolerance requires.
   */
  samples?: number | 'adaptive' | undefined;
  /**
   * The largest distance of the curve from the geodesics between adaptive samples, relative to the
   * bounding box's diagonal: 1e-7 to 1; 1e-4 by default. The engine checks this distance at a dozen
   * or more places between two samples.
   */
  tolerance?: number | undefined;
  /**
   * The connection between the samples. `geodesic` (the default): the geodesic that joins them.
   * `exact`: the curve's own crossings of the mesh's edges.
   */
  geometry?: CurveGeometry | undefined;
  /**
   * The number of subdivisions of the control polygon, 0 to 8. A subdivision takes averages of two
   * points along the legs. Each piece of the curve then consists of centers of mass of the
   * subdivided points near the piece. On rough surfaces, more levels make a curve of distant points
   * steadier. On a plane all levels give the same curve.
   *
   * - 0: the curve of Mancinelli and Puppo: each point is one center of mass of all control points
   *   that its segment blends;
   * - `auto`, the default: the curve of level 0 if it is safe, such as on smooth surfaces. A curve
   *   is safe if its points move continuously, and no more roughly than the surface. If the curves
   *   of all levels lie within .02 mean edges of the curve of level 0, by an estimate, `auto` takes
   *   the number of levels that is fastest to compute. If level 0 is not safe, such as on scans
   *   with distant points, `auto` takes the fewest levels at which the curve is safe, or more if
   *   these are faster to compute;
   * - `{ tolerance }`: the same with another tolerance;
   * - `limit`: the subdivision curve that many levels approach, which needs no fields. Its points
   *   lie at `samples` equally spaced parameters and are joined by geodesics; `tolerance` and
   *   `geometry` have no effect.
   *
   * The method `paper` takes only 0, its default. The kinds `barycentric`, `polyline` and `custom`
   * always have 0.
   */
  levels?: CurveLevels | LevelsTolerance | undefined;
  /**
   * The fewest levels that `auto` takes, 0 to 8; 0 by default. A curve moves a little when its
   * number of levels changes. To avoid this while a point is dragged, pass the largest number of
   * levels that the curve has had during the drag.
   */
  leastLevels?: number | undefined;
  /**
   * Whether the curve ends where it starts; it then needs at least 3 points. B-splines and
   * Catmull-Rom curves are as smooth there as elsewhere. Curves of one segment and polylines have a
   * corner at their first point. The kind `custom` cannot be closed.
   */
  closed?: boolean | undefined;
  /** The degree of a B-spline, 1 to 5; 3 by default. */
  degree?: number | undefined;
  /**
   * The knots of a B-spline with n points and degree p. `uniform` (the default): equally spaced.
   * `clamped`: repeated at the ends, so that the curve runs from its first to its last point. A
   * list: n + p + 1 numbers that do not decrease; for a closed curve n + 1, which bound its n
   * spans.
   */
  knots?: 'uniform' | 'clamped' | ArrayLike<number> | undefined;
  /** One positive weight for each point, for `bspline` and `rational`. All 1 by default. */
  weights?: ArrayLike<number> | undefined;
  /** One positive number for each point, for `barycentric`. All 1 by default. */
  betas?: ArrayLike<number> | undefined;
  /** The parametrization of the kind `catmullrom`; `centripetal` by default. */
  parametrization?: Parametrization | undefined;
  /** The basis of the kind `custom`. */
  basis?: CurveBasis | undefined;
}

/** The value of a curve: options from which the curve can be created again. */
export type CurveValue = CurveOptions & { legs?: readonly LegPoints[] | undefined };

/** A place on a curve. */
export interface CurvePoint {
  /** The number of the segment plus t in [0, 1]. */
  parameter: number;
  /** The point of the surface. */
  point: SurfacePoint;
  /** The place of that point in space. */
  position: [number, number, number];
  /**
   * The status. If it is not `converged`, the point lies on the path from the sample before it to
   * the sample after it.
   */
  status: Status;
}

/** The derivative of a curve with respect to its parameter. */
export interface CurveTangent extends CurvePoint {
  /** The derivatives of the three barycentric weights in the point's face; their sum is 0. */
  inFace: [number, number, number];
  /** The derivative as a vector in space: x, y, z. */
  inSpace: [number, number, number];
}

export interface NearestOnCurve extends CurvePoint {
  /** The distance in space. */
  distance: number;
}

/** Points of a curve as flat arrays. An array has one entry, or three, for each point. */
export interface CurvePoints {
  /** The parameter of each point on the curve. */
  parameter: Float64Array;
  /** The face of each point. */
  face: Int32Array;
  /** Three numbers for each point. */
  bary: Float64Array;
  /** Three numbers for each point. */
  position: Float64Array;
}

/**
 * The samples of a curve, segment by segment, as flat arrays. An array has one entry, or three, for
 * each sample.
 */
export interface CurveSamples {
  /** The number of samples. */
  count: number;
  /** The segment of each sample. */
  segment: Int32Array;
  /** The parameter of each sample within its segment. */
  t: Float64Array;
  /** The face of each sample. */
  face: Int32Array;
  /** Three numbers for each sample. */
  bary: Float64Array;
  /** Three numbers for each sample. */
  position: Float64Array;
  /** The status of the search for each sample. */
  status: Status[];
}

/**
 * An interval of a segment's parameter in which the points of a curve are not centers of mass.
 * There the curve follows a subdivision curve of the segment's control points, so that it stays
 * continuous. The samples in the interval have the status `bridged`, or `subdivided` if the reason
 * is `subdivided`.
 */
export interface BridgedInterval {
  /** The number of the segment that contains the interval. */
  segment: number;
  /** The parameter where the bridge begins. */
  t0: number;
  /** The parameter where the bridge ends. */
  t1: number;
  /** The status of the search in the interval, or `jump`, or `subdivided`. */
  reason: Status;
}

export interface CircleOptions extends ArcOptions {
  /** The radius, in units of the mesh, measured on the surface. */
  radius: number;
  /**
   * The largest error of the samples' distances from the center, relative to the radius; .001 by
   * default. It determines the number of arcs unless `arcs` is given. No number of arcs reaches the
   * tolerance beyond the center's cut locus, or where saddles spread the geodesics from the center
   * apart. The circle's `deviation` is larger then.
   */
  tolerance?: number | undefined;
}

/** Options of circles and ellipses. */
export interface ArcOptions extends FieldOptions {
  /**
   * The number of rational quadratic arcs, 3 to 64, all of the same width. By default a circle has
   * as many arcs as its `tolerance` requires, up to 128, and an ellipse has 7.
   */
  arcs?: number | undefined;
  /**
   * The number of samples of each arc, both ends included; 32 by default. Without `arcs`, narrow
   * arcs have fewer, but at least 5.
   */
  samples?: number | undefined;
  /** The levels, as in `CurveOptions`; `auto` by default. */
  levels?: CurveLevels | undefined;
}

export interface EllipseOptions extends ArcOptions {
  /** The radii along and across the direction. */
  radii: readonly [number, number];
  /** A direction in space, which is projected onto the center's face. */
  direction: VectorLike;
}

/** The durations, in milliseconds, of a curve's last update. */
export interface CurveTimes {
  /** The time for the legs of the control polygon, if the curve uses them, and for its levels. */
  polygon: number;
  /** The time for the fields of the control points. */
  fields: number;
  /** The time for the searches for the samples. */
  trace: number;
  /**
   * The time for the search for jumps between samples, and for the bridges over jumps and over
   * missing samples.
   */
  bridge: number;
  /** The time for the paths between samples. */
  join: number;
}
