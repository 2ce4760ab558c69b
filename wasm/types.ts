/**
 * The types of Karcher's JavaScript API.
 *
 * A method returns new arrays and objects, which the caller may change, keep or transfer. Reading a
 * property takes no work. The engine copies the options, points and arrays that it receives.
 *
 * Vertices, faces and control points have numbers from 0, in the caller's own order. Faces are
 * triangles: a polygon counts as its triangles. Lengths are in the units of the mesh.
 */

import type { AddressObject, CompiledModule, FetchedResponse, StopSignal } from './platform.js';
import type {
  DistanceOptions,
  FieldOptions,
  PointLike,
  Status,
  SurfacePoint,
} from './point_types.js';

export type * from './curve_types.js';
export type * from './mesh_types.js';
export type * from './point_types.js';

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

/** A center of mass, or the point where the search for it stopped. */
export interface CenterOfMass {
  /** The center as a point of the surface. */
  point: SurfacePoint;
  /** The place of that point in space. */
  position: [number, number, number];
  /** The status of the search. The center is a minimum if the status is `converged`. */
  status: Status;
  /** The number of steps of the search. */
  iterations: number;
  /**
   * The sum of weight times squared distance over the points, in squared units of the mesh. It is
   * an estimate from the fields, and not comparable with an estimate by another method. For very
   * many points (see `centerOfMass`) it comes from exact distances. `certificate` has the exact
   * energy.
   */
  energy: number;
  /**
   * The quality of the point by exact shortest paths, if `CenterOptions.certificate` requests it.
   */
  certificate?: Certificate;
  /** Whether the center is the only one, as far as is known. */
  uniqueness: Uniqueness;
  /**
   * The other minima at which searches ended, the lowest first. Each is a minimum in the same sense
   * as the center, and lies more than a tenth of the mean edge from all others. `notLooked` if no
   * other minimum was found and no search looked for one all over the surface
   * (`CenterOptions.uniqueness`).
   */
  otherMinima: OtherMinimum[] | 'notLooked';
}

/**
 * The quality of a point as a center of mass, by exact shortest paths to the points. The measure is
 * the same for every method.
 */
export interface Certificate {
  /** The sum of weight times squared distance, in squared units of the mesh. */
  energy: number;
  /**
   * The length of the weighted sum of the points' log vectors, which is half of the energy's slope.
   * It is 0 at a center of mass of a smooth surface. On a mesh it is seldom 0, since the energy has
   * creases: the direction of a path jumps where the path changes from one side of a vertex to the
   * other.
   */
  residual: number;
}

/**
 * The state of knowledge about other minima of the energy.
 *
 * - `certain`: it is proved that no other minimum is lower, and that any other minimum is farther
 *   from the center than all points. The proof needs weights of at least 0, and a ball that
 *   contains the points and in which squared distances are convex. On a mesh, no vertex in or near
 *   the ball may have positive curvature. On the built-in sphere and torus, the ball must be small
 *   compared with the radius of curvature (Karcher 1977); this proof holds for the smooth surface;
 * - `likely`: searches from all points and from 32 places spread over the surface ended at the
 *   center;
 * - `notUnique`: some searches ended at other minima;
 * - `notLooked`: see `CenterOptions.uniqueness`.
 */
export type Uniqueness = 'certain' | 'likely' | 'notUnique' | 'notLooked';

/** Another minimum of the energy. */
export type OtherMinimum = Pick<CenterOfMass, 'point' | 'position' | 'energy'>;

/** Weights with which a given point is the center of mass of points. */
export interface MeanWeights {
  /** One weight for each point; their sum is 1. */
  weights: Float64Array;
  /**
   * Whether a search for the center of mass with these weights stays at the point if it starts
   * there. It leaves the point if the energy's Hessian is not positive definite, which happens with
   * negative weights and with distant points, or if the energy by exact distances is lower nearby
   * (see `Status`).
   */
  isMinimum: boolean;
}

export interface WeightsOptions extends FieldOptions {
  /**
   * The target weights, which the call divides by their sum. Of all possible weights, the result
   * has the least sum of squared differences from the target weights. By default they are equal.
   */
  weights?: ArrayLike<number> | undefined;
  /** Whether no weight may be below 0. */
  nonNegative?: boolean | undefined;
}

/** The start of the search for a center of mass. */
export interface StartOptions {
  /**
   * The point where the search starts. By default the method `karcher` starts at an average of
   * averages, and then searches again from the points near which the energy may be lower. The
   * method `paper` starts at the point with the largest weight.
   */
  start?: PointLike | undefined;
  /**
   * Whether to divide the weights by their sum. If false (the default), a sum other than 1 is an
   * error.
   */
  normalize?: boolean | undefined;
}

export interface CenterOptions extends FieldOptions, StartOptions {
  /**
   * Whether to look for other minima all over the surface, and to decide whether the center is the
   * only one. This reads the whole field of each point, which takes about a microsecond for each
   * vertex and point with the solver `fast`.
   */
  uniqueness?: boolean | undefined;
  /**
   * Whether to measure the center by exact shortest paths, whatever the method and the status. This
   * computes exact distances from the center up to the farthest point, which takes about as long as
   * one field of the solver `exact`. For a center on an edge or at a vertex, it computes a shortest
   * path to each point.
   */
  certificate?: boolean | undefined;
}

export interface CentersOptions extends FieldOptions, StartOptions {
  /**
   * Whether to check each center by exact distances, as `centerOfMass` does. Each then costs as
   * much as one call of `centerOfMass`. Without this check, `converged` means the same as for a
   * curve's samples.
   */
  check?: boolean | undefined;
}

/**
 * Centers of mass of one set of points, as flat arrays. An array has one entry, or three, for each
 * row of weights.
 */
export interface CentersOfMass {
  /** The number of rows of weights. */
  count: number;
  /** The face of each center. */
  face: Int32Array;
  /** Three numbers for each row. */
  bary: Float64Array;
  /** Three numbers for each row. */
  position: Float64Array;
  /** The status of the search for each center. */
  status: Status[];
  /** The energies, as in `CenterOfMass`. */
  energy: Float64Array;
}

/**
 * The rule for the inside of outlines. `evenOdd`: the points that an odd number of crossings
 * separates from the outside. `nonZero`: the points around which the outlines wind a nonzero number
 * of times.
 */
export type FillRule = 'evenOdd' | 'nonZero';

/**
 * The combination of several shapes: their union, intersection, difference or exclusion, which has
 * the points in an odd number of shapes.
 */
export type BooleanOperation = 'union' | 'intersection' | 'difference' | 'exclusion';

/**
 * A part of a cut surface: three coordinates for each vertex, and three vertices for each triangle,
 * counterclockwise.
 */
export interface CutPart {
  /** The coordinates x, y, z of each vertex. */
  positions: Float64Array;
  /** Three vertices for each triangle. */
  triangles: Int32Array;
  /** For each triangle of the part, the mesh's triangle in which it lies. */
  faces: Int32Array;
}

/** The distance, the sides and the corners of an offset. */
export interface OffsetOptions {
  /**
   * The distance from the paths, in units of the mesh: a number above 0; or a list of distances at
   * equally spaced places along each path, interpolated linearly by length. Some numbers of a list
   * may be 0.
   *
   * With a list, the offset is the boundary of the union of disks around all points of a path, with
   * these radii and round corners. On an open path, the first and the last distance belong to its
   * ends. On a closed path, the first distance follows the last.
   */
  distance: number | readonly number[];
  /**
   * The side of the paths on which the offset lies. With `both`, the default, it also goes round
   * the ends of open paths.
   */
  side?: 'left' | 'right' | 'both';
  /**
   * The shape of corners on their outer side: `round` (the default), `miter`, which continues the
   * sides as geodesics until they meet, or `bevel`. Turns of less than 3.6 degrees are round, and
   * so are corners whose offset reaches the boundary of the mesh.
   */
  corners?: 'round' | 'miter' | 'bevel';
  /**
   * The largest distance between a miter's tip and its corner, relative to the distance of the
   * offset, as in SVG. A corner with a longer miter has a bevel instead. At least 1; 4 by default.
   */
  miterLimit?: number;
}

/** The options for combining shapes into regions. */
export interface RegionOptions {
  /** The rule; `evenOdd` by default. */
  rule?: FillRule;
  /**
   * The operation that combines the regions of all shapes into one. A difference is the first shape
   * without all others. By default each shape has a region of its own.
   */
  combine?: BooleanOperation;
}

/** The options of isolines. Only the type `linear` takes a solver and its rings. */
export interface IsolineOptions extends DistanceOptions {
  /** The distance of the lines from the center, in units of the mesh. */
  radius: number;
  /**
   * The type of the lines. `exact` (the default): circular arcs in each triangle, whose points have
   * exactly this distance. `linear`: straight lines in each triangle, between points of its edges.
   * At these points, the distance interpolated between the vertices is the radius. The solver
   * computes the distances of the vertices.
   */
  type?: 'exact' | 'linear' | undefined;
}

/**
 * The source of the engine's WebAssembly: its address, its bytes, a response with them, or the
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

/** The options for loading the engine. */
export interface LoadOptions {
  /**
   * The source of the WebAssembly module. The default is the file beside the package's code.
   * Bundlers that know `import.meta.url` find this file. For other bundlers, the package exports it
   * as `karcher/karcher-engine.wasm`, and the file of `karcher/peers` as
   * `karcher/karcher-peers.wasm`.
   */
  wasm?: WasmSource | undefined;
}

/**
 * A function that receives the progress of long work: the completed fraction, and the name of the
 * stage.
 */
export type Progress = (done: number, stage: string) => void;

/** The progress and the cancellation of long work. */
export interface LongWorkOptions {
  /** A function that receives the progress of the work. */
  progress?: Progress | undefined;
  /** A signal that cancels the work when it is aborted. */
  signal?: StopSignal | undefined;
}
