/**
 * The types of Karcher's JavaScript API.
 *
 * A method returns new arrays and objects, which the caller may change, keep or transfer. A property
 * costs nothing to read. The engine copies the options, points and arrays that it is given.
 *
 * Vertices, faces and control points are numbered from 0 in the caller's own order; faces count
 * triangles, after polygons were cut. Lengths are in the units of the mesh.
 */

import type { AddressObject, CompiledModule, FetchedResponse, StopSignal } from './platform.js';

export type * from './mesh_types.js';

/** A point of the surface: a face and the weights of its corners 0, 1, 2 (at least 0, sum 1). */
export interface SurfacePoint {
  /** The number of the face. */
  face: number;
  /** The barycentric weights of the three corners, which sum to 1. */
  bary: [number, number, number];
}

/** A point as an argument: a surface point, or a vertex by its number. */
export type PointLike =
  | { readonly face: number; readonly bary: readonly [number, number, number] }
  | { readonly vertex: number };

/** Points as flat arrays: a face each, and three weights each, as `CurvePoints` and `CentersOfMass` have them. */
export interface PointArrays {
  /** The face of each point. */
  face: ArrayLike<number>;
  /** Three barycentric weights for each point. */
  bary: ArrayLike<number>;
}

/** The point of the surface that is nearest to a place. */
export interface NearestPoint {
  /** The nearest point of the surface. */
  point: SurfacePoint;
  /** The place of that point in space. */
  position: [number, number, number];
  /** In space. */
  distance: number;
}

/** A place or a direction in space as an argument: three numbers, or an object with x, y and z. */
export type VectorLike = ArrayLike<number> | { x: number; y: number; z: number };

/**
 * Vectors as an argument: numbers one after the other, three each, or a list of `VectorLike`; one alone may
 * be an object with x, y and z.
 */
export type VectorsLike = VectorLike | readonly VectorLike[];

/** The format of the coordinates x, y, z of a line's vertices. */
export interface PolylineOptions {
  /** 32 bits a number, as graphics take them (the default), or 64. */
  bits?: 32 | 64 | undefined;
}

/**
 * How geodesic distances are found.
 *
 * - `fast`: in the mean within .1 % of the exact distances on all meshes that were tried, and within 1 % but
 *   for single vertices; exact on a plane;
 * - `exact`: by windows on the edges, exact on every mesh;
 * - `graph`: along the edges of a graph that joins each vertex to those of its k-ring that it sees in a
 *   straight line across the faces. The graph of the paper's authors also has edges that turn round
 *   saddles: their curves lie .02 to .08 mean edges from these, and their fields take half the time.
 */
export type Solver = 'fast' | 'exact' | 'graph';

/**
 * How a control point's field is made, and how centers of mass are found.
 *
 * - `karcher`: by the log vectors that the solver yields, read only where the search goes. Exact on
 *   every triangulation of a plane;
 * - `paper`: by gradients of squared distances at all vertices, and Newton's method along geodesics
 *   (Mancinelli, Puppo, Algorithm 1). It takes the solvers `exact` and `graph`.
 */
export type Method = 'karcher' | 'paper';

/**
 * Of the method `paper`: the faces whose gradients its Eq. 3 averages at a vertex.
 *
 * - `wide`, the default: those around the vertex and those across their outer edges, as the program of
 *   the paper's authors has it, whose curves and figures these are;
 * - `ring`: those around the vertex, the 1-ring, as the paper prints it. On fine smooth meshes curves of
 *   the two lie a few hundredths of a mean edge apart; on coarse and uneven ones farther, and either may
 *   be the nearer one to the truth.
 */
export type Star = 'wide' | 'ring';

/**
 * How the search for a center of mass ended. Only `converged` means that the point is one; otherwise
 * the point is where the search stopped.
 *
 * - `converged`: of `centerOfMass`, with the method `karcher` and the solvers `fast` and `exact`, a
 *   local minimum of the energy by exact distances: no point on a circle of 0.3 mean edges about it
 *   has a lower energy by more than a thousandth of a square mean edge. Of samples of curves, of
 *   other solvers and of the method `paper`: the gradient of the energy, as the fields estimate it,
 *   vanishes there, and its Hessian is positive definite;
 * - `indefinite`: the Hessian is not positive definite; the points lie too far apart;
 * - `boundary`: the minimum lies on the boundary, where the gradient does not vanish;
 * - `noProgress`: no point along the Newton step has a smaller gradient;
 * - `limit`: the bound on iterations was reached;
 * - `lowerNearby`, only of `centerOfMass`: the estimated gradient vanishes, but points near by have a
 *   lower energy by exact distances, and a search from there found no minimum, as on a surface that
 *   is rough or creased where the center lies;
 * - `jump`, only as the reason of a bridge: the curve would jump from one local minimum to another;
 * - `bridged`: the sample of a curve lies on a bridge, see `BridgedInterval`;
 * - `subdivided`: the sample lies on a piece of a refined curve that is its own subdivision, as it crosses
 *   faces larger than itself that are out of sight of its points (slivers of CAD parts). The curve is as
 *   good there; it is also the reason of the interval.
 */
export type Status =
  | 'converged'
  | 'indefinite'
  | 'boundary'
  | 'noProgress'
  | 'limit'
  | 'lowerNearby'
  | 'jump'
  | 'bridged'
  | 'subdivided';

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
 * A curve that should pass through a control point does so exactly on a plane, and if it is a
 * `polyline`. On a curved mesh its fields are estimates, and it passes within a few hundredths of a
 * mean edge.
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

/** The codes of `KarcherError`. */
export type ErrorCode =
  | 'badFile'
  | 'badIndex'
  | 'notFinite'
  | 'degenerateFace'
  | 'nonManifoldEdge'
  | 'nonManifoldVertex'
  | 'notOrientable'
  | 'badPoint'
  | 'badWeights'
  | 'tooFewPoints'
  | 'badArgument'
  | 'unreachable'
  | 'boundary'
  | 'radiusTooLarge'
  | 'noEmbedding'
  | 'disposed'
  | 'busy'
  | 'notLoaded'
  | 'outOfMemory'
  | 'internal';

/**
 * How fields are made. The default method is `karcher`. The default solver is `fast`, with the method
 * `paper` it is `exact`.
 */
export interface FieldOptions {
  /** How log vectors are estimated from distances; `karcher` by default. */
  method?: Method | undefined;
  /** How distances are found; `fast` by default, of the method `paper` `exact`. */
  solver?: Solver | undefined;
  /** The k of the solver `graph` (see `Solver`, also for the authors' graph), 1 to 10; 6 by default. */
  rings?: number | undefined;
  /** Of the method `paper`: Eq. 3 as its authors' program has it (`wide`, the default) or as printed. */
  star?: Star | undefined;
}

/** How distances are found. */
export type DistanceOptions = Pick<FieldOptions, 'solver' | 'rings'>;

/** A center of mass, or the place where the search for one stopped. */
export interface CenterOfMass {
  /** The center as a point of the surface. */
  point: SurfacePoint;
  /** The place of that point in space. */
  position: [number, number, number];
  /** How the search ended; the center is a minimum where it is `converged`. */
  status: Status;
  /** The number of steps of the search. */
  iterations: number;
  /**
   * Sum of weight times squared distance, in squared units of the mesh: an estimate by the fields, which
   * is not to be compared with another method's; of very many points (see `centerOfMass`) by exact
   * distances. `certificate` has the exact one.
   */
  energy: number;
  /** What the point is worth by exact shortest paths, where `CenterOptions.certificate` asks for it. */
  certificate?: Certificate;
  /** Whether it is the only one. */
  uniqueness: Uniqueness;
  /**
   * Other minima at which searches ended, the lowest first. Each is a minimum in the same sense as the
   * center, and more than a tenth of the mean edge from the others. `notLooked` if only the control
   * points were tried, at most, and none led to another.
   */
  otherMinima: OtherMinimum[] | 'notLooked';
}

/**
 * What a point is worth as a center of mass, by exact shortest paths to the points: the same measure for
 * every method.
 */
export interface Certificate {
  /** The sum of weight times squared distance, in squared units of the mesh. */
  energy: number;
  /**
   * The length of the weighted sum of the vectors along the paths to the points, half of the energy's
   * slope: 0 at a center of mass of a smooth surface. On a mesh it is seldom 0, as the energy has
   * creases: where a path changes sides of a vertex, its direction jumps.
   */
  residual: number;
}

/**
 * What is known of other minima of the energy.
 *
 * - `certain`: it is proved that none is lower, and that none is as near as the farthest point. The
 *   proof needs weights of at least 0 and a ball that holds the points and in which squared distances
 *   are convex. On a mesh no vertex in or near the ball may have positive curvature. On the built-in
 *   sphere and torus the ball must be small beside their curvature (Karcher 1977); this proof is of the
 *   smooth surface;
 * - `likely`: searches from all points and from 32 places spread over the surface ended there;
 * - `notUnique`: some of them ended elsewhere;
 * - `notLooked`: see `CenterOptions.uniqueness`.
 */
export type Uniqueness = 'certain' | 'likely' | 'notUnique' | 'notLooked';

/** Another minimum of the energy. */
export type OtherMinimum = Pick<CenterOfMass, 'point' | 'position' | 'energy'>;

/** Weights of points for which a given point is their center of mass. */
export interface MeanWeights {
  /** One a point; their sum is 1. */
  weights: Float64Array;
  /**
   * Whether the search for the center of mass of these weights, started at the point, stays there. It
   * does not where the energy's Hessian is not positive definite, which happens with negative weights
   * and with points far apart; nor where the energy by exact distances is lower near by, see `Status`.
   */
  isMinimum: boolean;
}

export interface WeightsOptions extends FieldOptions {
  /**
   * The result is the solution nearest to these weights, by the sum of squared differences, after they
   * are divided by their sum. Equal ones by default.
   */
  weights?: ArrayLike<number> | undefined;
  /** Allow no weight below 0. */
  nonNegative?: boolean | undefined;
}

/** How the search for a center of mass starts. */
export interface StartOptions {
  /**
   * Where the search starts. By default at an average of averages and at the points near which the
   * energy may be lower (`karcher`), or at the point of the largest weight (`paper`).
   */
  start?: PointLike | undefined;
  /** Divide the weights by their sum, instead of an error when the sum is not 1. */
  normalize?: boolean | undefined;
}

export interface CenterOptions extends FieldOptions, StartOptions {
  /**
   * Look for other minima all over the surface, and tell whether the center is the only one. Reads the
   * whole of each point's field: about a microsecond a vertex and point with the fast solver.
   */
  uniqueness?: boolean | undefined;
  /**
   * Measure the point by exact shortest paths, whatever the method and however the search ended. It takes
   * the exact distances from the point out to the farthest of the points, about as long as one field of
   * the solver `exact`; where the center lies on an edge or at a vertex, a shortest path to each point.
   */
  certificate?: boolean | undefined;
}

export interface CentersOptions extends FieldOptions, StartOptions {
  /**
   * Hold each center to exact distances, as `centerOfMass` does; each then costs as much as one of
   * `centerOfMass`. Without it `converged` says what it says of a curve's samples.
   */
  check?: boolean | undefined;
}

/** Centers of mass of one set of points, as flat arrays of one entry (or three) a row of weights. */
export interface CentersOfMass {
  /** The number of rows of weights. */
  count: number;
  /** The face of each center. */
  face: Int32Array;
  /** Three a row. */
  bary: Float64Array;
  /** Three a row. */
  position: Float64Array;
  /** How the search for each center ended. */
  status: Status[];
  /** As that of `CenterOfMass`. */
  energy: Float64Array;
}

/** What joins the samples of a curve: geodesics, or the curve's own crossings of edges. */
export type CurveGeometry = 'geodesic' | 'exact';

/** The number of levels of a curve, or `auto`. */
export type CurveLevels = number | 'auto' | 'limit';

/** Levels that a curve takes by itself, within a tolerance. */
export interface LevelsTolerance {
  /**
   * How far levels may move a curve whose center of mass is safe without them, in mean edges: .02 is
   * `auto`, 0 leaves that curve as it is, and Infinity makes a draft, as quick as can be, of it.
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
  /** Of a B-spline, 1 to 5; 3 by default. */
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
  /** Of the kind `catmullrom`; `centripetal` by default. */
  parametrization?: Parametrization | undefined;
  /** Of the kind `custom`. */
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
  /** In space. */
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

/** Of circles and ellipses. */
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

/**
 * Which sides of outlines are inside: what an odd number of crossings leads to, or what is wound round
 * more often from one side than from the other.
 */
export type FillRule = 'evenOdd' | 'nonZero';

/** What becomes of several shapes: their union, intersection, difference, or what an odd number of them covers. */
export type BooleanOperation = 'union' | 'intersection' | 'difference' | 'exclusion';

/** A part of a surface that was cut: numbers three a vertex and three a triangle, counterclockwise. */
export interface CutPart {
  /** The coordinates x, y, z of each vertex. */
  positions: Float64Array;
  /** Three vertices for each triangle. */
  triangles: Int32Array;
  /** Of each of its triangles the mesh's triangle that it is a part of. */
  faces: Int32Array;
}

/** The distance and the sides of an offset. */
export interface OffsetOptions {
  /** The distance from the paths, in units of the mesh. */
  distance: number;
  /** `both` by default, which goes round the ends of open paths too. */
  side?: 'left' | 'right' | 'both';
}

/** How shapes are combined into regions. */
export interface RegionOptions {
  /** `evenOdd` by default. */
  rule?: FillRule;
  /** Makes one region of those of all shapes; of a difference the first without all others. */
  combine?: BooleanOperation;
}

/** Isolines of the type `linear` alone take a solver and its rings. */
export interface IsolineOptions extends DistanceOptions {
  /** The distance of the lines from the center, in units of the mesh. */
  radius: number;
  /**
   * `exact` (the default): the circular arcs of the points at this distance in each triangle.
   * `linear`: straight in each triangle, between the points of its edges where the distance,
   * interpolated between the vertices' distances by the solver (`exact`), is the radius.
   */
  type?: 'exact' | 'linear' | undefined;
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

/**
 * Where the engine's WebAssembly comes from: its address, its bytes, an answer that has them, or the
 * compiled module.
 */
export type WasmSource =
  | string
  | AddressObject
  | FetchedResponse
  | ArrayBuffer
  | SharedArrayBuffer
  | ArrayBufferView
  | CompiledModule;

/** Where the engine’s module is. */
export interface LoadOptions {
  /**
   * By default the file beside the package's own, which bundlers that know `import.meta.url` find. For
   * others it is exported as `karcher/karcher-engine.wasm`, and that of `karcher/peers` as
   * `karcher/karcher-peers.wasm`.
   */
  wasm?: WasmSource | undefined;
}

/** Progress of long work: the fraction that is done, and what is being done. */
export type Progress = (done: number, stage: string) => void;

/** How long work says how far it is, and is given up. */
export interface LongWorkOptions {
  /** Hears how far the work is. */
  progress?: Progress | undefined;
  /** Gives the work up when it is aborted. */
  signal?: StopSignal | undefined;
}
