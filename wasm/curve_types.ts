/** The types of curves: what makes one, and what is asked of it. */

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
 * - `bspline`: a B-spline of degree 1 to 5, with weights a NURBS curve; uniform by default, so that
 *   it starts and ends near the middle of its first and last points;
 * - `bezier`: one segment of degree (points - 1);
 * - `rational`: the same with a weight per point;
 * - `barycentric`: one rational segment through all points, shaped by a beta per point
 *   (Ramanantoanina, Hormann 2021); all betas equal is Berrut's interpolant, binomial coefficients
 *   give the polynomial;
 * - `catmullrom`: through all points, with continuous tangents;
 * - `polyline`: paths from point to point, the exact shortest ones unless `legs` says otherwise;
 * - `custom`: one segment with a basis of your own.
 *
 * A curve that should pass through a control point does so exactly on a plane, at the ends of an open
 * curve, and if it is a `polyline`. Elsewhere on a curved mesh its fields are estimates, and it passes
 * within a few hundredths of a mean edge.
 */
export type CurveKind =
  | 'bspline'
  | 'bezier'
  | 'rational'
  | 'barycentric'
  | 'catmullrom'
  | 'polyline'
  | 'custom';

/** The knots of a Catmull-Rom curve: spaced by the root of the distance between points, or evenly. */
export type Parametrization = 'centripetal' | 'uniform';

/**
 * A basis of your own: takes t in [0, 1] to a weight for each control point. The weights sum to 1
 * within 1e-9 and may be negative.
 */
export type CurveBasis = (t: number, points: number) => ArrayLike<number>;

/** What joins the samples of a curve: geodesics, or the curve's own crossings of edges. */
export type CurveGeometry = 'geodesic' | 'exact';

/** The number of levels of a curve, or `auto`. */
export type CurveLevels = number | 'auto' | 'limit';

/** Levels that a curve takes by itself, within a tolerance. */
export interface LevelsTolerance {
  /**
   * How far levels may move a curve whose center of mass is safe without them, in mean edges: .02 is `auto`, 0
   * leaves that curve as it is, and Infinity makes it a draft, as quick as possible.
   */
  tolerance: number;
}

/**
 * The points that a leg of a control polygon goes through; null for the shortest path. Points that all
 * lie on edges, each in one face with the next one, also with the leg's ends, are the leg as it is.
 */
export type LegPoints = readonly PointLike[] | null;

/**
 * All points of a leg as it was drawn, with its ends. Where these are not at the control points, the leg is
 * continued to them as if a hand had drawn it there, whether or not it stays the shortest.
 */
export type DrawnLeg = PointArrays;

export interface CurveOptions extends FieldOptions {
  /** The kind of the curve, which says what weights its points have. */
  kind: CurveKind;
  /** The control points, in their order. */
  points: readonly PointLike[];
  /**
   * The legs of the control polygon, from each point to the next, of a closed curve also from the
   * last to the first: each is the shortest path, or the one that goes the way of a few points and is
   * pulled tight. Curves with levels follow them, and polylines are made of them. All the shortest by
   * default. `drawnLegs` of a view are those that its curve had.
   */
  legs?: readonly (LegPoints | DrawnLeg)[] | undefined;
  /**
   * Samples a segment at t = i / (samples - 1), both ends included; 2 to 100,000. 128 by default.
   * `adaptive`: as many as the tolerance needs.
   */
  samples?: number | 'adaptive' | undefined;
  /**
   * For adaptive samples: the largest distance of the curve from the geodesics between them, as a
   * fraction of the bounding box's diagonal, from 1e-7 to 1; 1e-4 by default. It is checked at a dozen
   * or more places between two samples.
   */
  tolerance?: number | undefined;
  /**
   * What lies between the samples: the `geodesic` that joins them, or `exact`, the curve's own
   * crossings of the mesh's edges. `geodesic` by default.
   */
  geometry?: CurveGeometry | undefined;
  /**
   * How often the control polygon is subdivided, by averages of two points along its legs, before
   * the near points of each piece are averaged: 0 to 8. More levels make a curve of far points
   * steadier on rough surfaces. On a plane all levels give the same curve.
   *
   * - 0: the curve of Mancinelli and Puppo, one center of mass of all the points that a segment blends;
   * - `auto`, the default: that curve wherever it is safe, as on smooth surfaces: where its points
   *   move continuously, and no more roughly than the surface. If all levels lie within .02 mean edges
   *   of it by estimate, as many as make it quickest. Where it is not safe, as on scans with far
   *   points, as many levels as make it so;
   * - `{ tolerance }`: the same with another tolerance;
   * - `limit`: the subdivision curve that many levels approach, which needs no fields. It is traced at
   *   `samples` even parameters, joined by geodesics, whatever `tolerance` and `geometry` ask for.
   *
   * The method `paper` takes 0 only, its default. The kinds `barycentric`, `polyline` and `custom`
   * always have 0.
   */
  levels?: CurveLevels | LevelsTolerance | undefined;
  /**
   * The fewest levels that `auto` takes, 0 to 8; 0 by default. A curve moves a little when its number
   * of levels changes. So that levels do not come and go while a point is dragged, give the most that
   * the curve has had during the drag.
   */
  leastLevels?: number | undefined;
  /**
   * Whether the curve ends where it starts; it then needs at least 3 points. B-splines and Catmull-Rom
   * curves are as smooth there as elsewhere. Curves of one segment and polylines have a corner at their
   * first point. The kind `custom` cannot be closed.
   */
  closed?: boolean | undefined;
  /** The degree of a B-spline, 1 to 5; 3 by default. */
  degree?: number | undefined;
  /**
   * Of a B-spline of n points and degree p: evenly spaced, `clamped` (repeated at the ends, so that
   * the curve runs from its first to its last point), or numbers that do not fall: n + p + 1, of a
   * closed curve n + 1 for its n spans. `uniform` by default.
   */
  knots?: 'uniform' | 'clamped' | ArrayLike<number> | undefined;
  /** One positive weight a point: `bspline`, `rational`. All 1 by default. */
  weights?: ArrayLike<number> | undefined;
  /** One positive number a point: `barycentric`. All 1 by default. */
  betas?: ArrayLike<number> | undefined;
  /** The parametrization of the kind `catmullrom`; `centripetal` by default. */
  parametrization?: Parametrization | undefined;
  /** The basis of the kind `custom`. */
  basis?: CurveBasis | undefined;
}

/** What a curve is. */
export type CurveValue = CurveOptions & { legs?: readonly LegPoints[] | undefined };

/** A place on a curve. */
export interface CurvePoint {
  /** The number of the segment plus t in [0, 1]. */
  parameter: number;
  /** The point of the surface. */
  point: SurfacePoint;
  /** The place of that point in space. */
  position: [number, number, number];
  /** Where it is not `converged`, the point lies on the path that joins the samples around it. */
  status: Status;
}

/** The derivative of a curve by its parameter. */
export interface CurveTangent extends CurvePoint {
  /** As changes of the weights of the face's corners; they sum to 0. */
  inFace: [number, number, number];
  /** The same as a vector in space: x, y, z. */
  inSpace: [number, number, number];
}

export interface NearestOnCurve extends CurvePoint {
  /** The distance in space. */
  distance: number;
}

/** Points of a curve as flat arrays of one entry (or three) a point. */
export interface CurvePoints {
  /** The parameter of each point on the curve. */
  parameter: Float64Array;
  /** The face of each point. */
  face: Int32Array;
  /** Three a point. */
  bary: Float64Array;
  /** Three a point. */
  position: Float64Array;
}

/** The samples of a curve, segment by segment, as flat arrays of one entry (or three) a sample. */
export interface CurveSamples {
  /** The number of samples. */
  count: number;
  /** The segment of each sample. */
  segment: Int32Array;
  /** The parameter of each sample within its segment. */
  t: Float64Array;
  /** The face of each sample. */
  face: Int32Array;
  /** Three a sample. */
  bary: Float64Array;
  /** Three a sample. */
  position: Float64Array;
  /** How the search for each sample ended. */
  status: Status[];
}

/**
 * Where a curve is no center of mass: over this interval of a segment's parameter it follows a
 * subdivision curve of the segment's control points, so that it does not break. The samples inside
 * have the status `bridged`, or `subdivided` where that is the reason.
 */
export interface BridgedInterval {
  /** The number of the segment that has the interval. */
  segment: number;
  /** The parameter where the bridge begins. */
  t0: number;
  /** The parameter where the bridge ends. */
  t1: number;
  /** How the search ended in the interval, or `jump`, or `subdivided`. */
  reason: Status;
}

export interface CircleOptions extends ArcOptions {
  /** The radius, in units of the mesh, measured on the surface. */
  radius: number;
  /**
   * A part of the radius: how far samples may be from it where `arcs` is not given; .001 by default.
   * `deviation` of the circle is larger where no arcs keep nearer: beyond the center's cut locus,
   * and where saddles spread the geodesics from the center apart.
   */
  tolerance?: number | undefined;
}

/** Options of circles and ellipses. */
export interface ArcOptions extends FieldOptions {
  /**
   * Rational quadratic arcs, 3 to 64, all as wide. By default a circle has as many as its
   * `tolerance` takes, up to 128, and an ellipse 7.
   */
  arcs?: number | undefined;
  /**
   * Samples an arc, both ends included; 32 by default. Where `arcs` is not given, narrow arcs have
   * fewer, but at least 5.
   */
  samples?: number | undefined;
  /** As those of a curve; `auto` by default. */
  levels?: CurveLevels | undefined;
}

export interface EllipseOptions extends ArcOptions {
  /** The radii along and across the direction. */
  radii: readonly [number, number];
  /** A direction in space, which is projected onto the center's face. */
  direction: VectorLike;
}

/** Milliseconds of a curve's last update. */
export interface CurveTimes {
  /** The legs of the control polygon, where the curve has a use for them. */
  polygon: number;
  /** The fields of the control points. */
  fields: number;
  /** The searches for the samples. */
  trace: number;
  /** The search for jumps between them, and the bridges over these and over what was not found. */
  bridge: number;
  /** The paths between samples. */
  join: number;
}
