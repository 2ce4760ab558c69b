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
  /** For each of its triangles, the mesh's triangle that it is a part of. */
  faces: Int32Array;
}

/** The distance, the sides and the corners of an offset. */
export interface OffsetOptions {
  /** The distance from the paths, in units of the mesh. */
  distance: number;
  /** `both` by default, which goes round the ends of open paths too. */
  side?: 'left' | 'right' | 'both';
  /**
   * What becomes of corners on their outer side: `round` (the default), `miter`, where the sides continue
   * as geodesics until they meet, or `bevel`. Turns of less than 3.6 degrees, and corners whose offset
   * comes to the boundary of the mesh, are round.
   */
  corners?: 'round' | 'miter' | 'bevel';
  /** How far a mitre may reach from its corner, in distances, as in SVG; beyond it is a bevel. 4 by default. */
  miterLimit?: number;
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
