/** The types of points, and of the methods for their distances and means. */

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

/**
 * Points as flat arrays: a face and three weights for each, such as those of `CurvePoints` and
 * `CentersOfMass`.
 */
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
  /** The distance in space. */
  distance: number;
}

/** A place or a direction in space as an argument: three numbers, or an object with x, y and z. */
export type VectorLike = ArrayLike<number> | { x: number; y: number; z: number };

/**
 * Vectors as an argument: three numbers for each, one vector after the other, or a list of
 * `VectorLike`. A single vector may be an object with x, y and z.
 */
export type VectorsLike = VectorLike | readonly VectorLike[];

/** The format of the coordinates x, y, z of a line's vertices. */
export interface PolylineOptions {
  /** The number of bits of a coordinate: 32 (the default), as in graphics, or 64. */
  bits?: 32 | 64 | undefined;
}

/**
 * The method for geodesic distances.
 *
 * - `fast`: on all meshes tried, the mean error is within .1 % of the exact distances, and errors
 *   are within 1 % except at single vertices; exact on a plane;
 * - `exact`: by windows on the edges, exact on every mesh;
 * - `graph`: along the edges of a graph. The graph joins each vertex to the vertices of its k-ring
 *   that it sees in a straight line across the faces. The graph of the paper's authors also has
 *   edges that turn round saddles. Curves with the authors' graph lie .02 to .08 mean edges from
 *   curves with this graph. The fields of the authors' graph take half the time.
 */
export type Solver = 'fast' | 'exact' | 'graph';

/**
 * The method for a control point's field, and for centers of mass.
 *
 * - `karcher`: by the solver's log vectors, computed only where the search needs them. It is exact
 *   on every triangulation of a plane;
 * - `paper`: by gradients of squared distances at all vertices, and Newton's method along geodesics
 *   (Mancinelli, Puppo, Algorithm 1). It takes the solvers `exact` and `graph`.
 */
export type Method = 'karcher' | 'paper';

/**
 * The faces whose gradients the method `paper` averages at a vertex (Eq. 3 of the paper).
 *
 * - `wide`, the default: the faces around the vertex and the faces across their outer edges, as in
 *   the program with which the paper's authors made its curves and figures;
 * - `ring`: the faces around the vertex (the 1-ring), as the paper says. On fine smooth meshes, the
 *   curves with the two stars lie a few hundredths of a mean edge apart. On coarse and uneven
 *   meshes they lie farther apart, and either may be nearer to the truth.
 */
export type Star = 'wide' | 'ring';

/**
 * The outcome of the search for a center of mass. Only a `converged` point is a center of mass; any
 * other point is where the search stopped.
 *
 * - `converged`: for `centerOfMass` with the method `karcher` and the solvers `fast` and `exact`,
 *   the point is a local minimum of the energy by exact distances. That is, no point on the circle
 *   of radius 0.3 mean edges around it has an energy lower by more than a thousandth of a squared
 *   mean edge. For samples of curves, other solvers and the method `paper`, the estimate of the
 *   energy's gradient from fields vanishes at the point, and the Hessian is positive definite;
 * - `indefinite`: the Hessian is not positive definite; the points lie too far apart;
 * - `boundary`: the minimum lies on the boundary, where the gradient does not vanish;
 * - `noProgress`: no point along the Newton step has a smaller gradient;
 * - `limit`: the search reached its bound on iterations;
 * - `lowerNearby`, only for `centerOfMass`: the estimated gradient vanishes, but points nearby have
 *   a lower energy by exact distances, and a search from there found no minimum. This happens if
 *   the surface is rough or creased there;
 * - `jump`, only as the reason of a bridge: the curve would jump from one local minimum to another;
 * - `bridged`: the sample of a curve lies on a bridge, see `BridgedInterval`;
 * - `subdivided`: the sample lies on a piece of a curve with levels that follows its subdivision
 *   curve instead of centers of mass. Such a piece crosses a face that is larger than the piece,
 *   such as a sliver of a CAD part, and the points of the piece do not see all corners of the faces
 *   along its legs. The curve is no worse there. The reason of the interval is then `subdivided`,
 *   too.
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
 * The options of fields. The default method is `karcher`. The default solver is `fast`; with the
 * method `paper` it is `exact`.
 */
export interface FieldOptions {
  /** The method that estimates log vectors from distances; `karcher` by default. */
  method?: Method | undefined;
  /** The solver of distances; `fast` by default, or `exact` for the method `paper`. */
  solver?: Solver | undefined;
  /** The k of the k-rings of the solver `graph` (see `Solver`), 1 to 10; 6 by default. */
  rings?: number | undefined;
  /**
   * The star of the method `paper`: `wide` (the default), as in its authors' program, or `ring`.
   */
  star?: Star | undefined;
}

/** The options for distances. */
export type DistanceOptions = Pick<FieldOptions, 'solver' | 'rings'>;

/** The part of a surface for which something is computed. */
export interface RadiusOptions {
  /** The largest distance of the part's points, in units of the mesh; unlimited by default. */
  radius?: number | undefined;
}

/**
 * Three unit vectors at a point: along the first edge of its face, across this edge in the face,
 * and along the normal.
 */
export type Frame = [
  along: [number, number, number],
  across: [number, number, number],
  normal: [number, number, number],
];
