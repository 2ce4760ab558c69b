/// <reference lib="esnext.disposable" preserve="true" />
import { checkInteger } from './check.js';
import { Curve } from './curve.js';
import * as distances from './distances.js';
import { callback, disposable } from './engine.js';
import type { LogMap, MappedPoints } from './maps.js';
import * as maps from './maps.js';
import { centerOfMass, centerOfMassOfDistances, centersOfMass, weightsOf } from './means.js';
import { MeshPlaces } from './mesh_places.js';
import { checkLongWork } from './options.js';
import type { Path } from './path.js';
import type { Circle, Ellipse, Outline, RegionShape, StraightestPath } from './path_types.js';
import { prepareFields } from './prepare.js';
import { type Region, regions, wireOutlines } from './region.js';
import { checkMeshFits } from './room.js';
import type {
  CenterOfMass,
  CenterOptions,
  CentersOfMass,
  CentersOptions,
  CircleOptions,
  CurveOptions,
  CutPart,
  DistanceOptions,
  EllipseOptions,
  FieldOptions,
  IsolineOptions,
  LongWorkOptions,
  MeanWeights,
  OffsetOptions,
  PointArrays,
  PointLike,
  RadiusOptions,
  RegionOptions,
  StartOptions,
  SurfacePoint,
  VectorLike,
  VectorsLike,
  WeightsOptions,
} from './types.js';

/**
 * A triangle mesh. The mesh and objects created from it live in the engine's memory until
 * `dispose`, or until nobody can reach them any more and JavaScript collects them.
 *
 * Every method throws `KarcherError`: disposed after `dispose`; badIndex for a face or vertex that
 * does not exist, and for a dropped vertex; badPoint for weights outside the face; notFinite for
 * NaN or infinity; badArgument for an unknown option and any other value out of range.
 */
export class Mesh extends MeshPlaces {
  static {
    disposable(Mesh.prototype);
  }

  /** Calls `dispose`, for `using`. */
  declare readonly [Symbol.dispose]: () => void;

  /**
   * A new mesh, refined by Loop subdivision: each of the `levels` (1 to 6) divides every triangle
   * into four. The new mesh has its own vertex and face numbers, and its own `dispose`. Throws
   * `KarcherError` outOfMemory if it cannot fit into memory.
   */
  subdivide(levels = 1): Mesh {
    checkInteger(levels, 'the number of levels');
    if (levels >= 1 && levels <= 6) {
      const what = `${levels} ${levels === 1 ? 'level' : 'levels'} of subdivision make`;
      checkMeshFits(0, 4 ** levels * this.info.triangles, what, this.handle.engine.allocatedBytes);
    }
    return new Mesh(
      this.handle.engine,
      this.handle.call((mesh) => mesh.subdivided(levels)),
    );
  }

  /**
   * The points of the mesh `subdivide(levels)` that correspond to points of this one. They have the
   * same weights with respect to the corners of the original face.
   *
   * @throws {KarcherError} badArgument unless the number of levels is 1 to 6.
   * @example
   * ```ts
   * const [onFine] = mesh.carried([{ face: 17, bary: [0.2, 0.3, 0.5] }], 2);
   * ```
   */
  carried(points: readonly PointLike[], levels = 1): SurfacePoint[] {
    return maps.carried(this.handle, points, levels);
  }

  /**
   * Prepares the mesh's data for fields with these options. It builds the graph of the solver
   * `graph` in slices of a few milliseconds. Without this call, the first method that needs the
   * data computes what is missing without pauses. Rejects with the signal's reason when the signal
   * is aborted; with `KarcherError` disposed if the mesh has been disposed of; and with outOfMemory
   * as soon as it is clear that a graph cannot fit into memory.
   */
  async prepare(options: FieldOptions = {}, work: LongWorkOptions = {}): Promise<void> {
    return prepareFields(this.handle, this.info.triangles, options, work);
  }

  /**
   * The Riemannian center of mass of points with weights. Each point has a weight, which may be
   * negative. The weights sum to 1 within 1e-9, unless `normalize` divides them by their sum. The
   * result is a center of mass only if the status is `converged`; see `Status`.
   *
   * Fields with at most half a million values in total stay until the next call. A call with other
   * weights then needs no new fields, and a moved point needs only its own field. With the method
   * `karcher` and the solvers `fast` and `exact`, 64 different points or more need no fields,
   * except for `uniqueness`, for a negative weight, or if the search ends at a boundary. The search
   * then starts at some of the points, and takes about as long for thousands of points as for
   * hundreds.
   *
   * Throws `KarcherError` badWeights (the number or the sum of the weights is wrong), tooFewPoints
   * (there are none), unreachable (the points lie on several components), badArgument (the limits
   * of exact distances; see `distance`).
   */
  centerOfMass(
    points: readonly PointLike[],
    weights: ArrayLike<number>,
    options: CenterOptions = {},
  ): CenterOfMass {
    return centerOfMass(this.handle, points, weights, options);
  }

  /**
   * The centers of mass of one set of points for many rows of weights. A row has one weight for
   * each point. The rows are a list, or one array of all rows, one after the other. The call
   * computes the fields once, so that each search costs as little as for a sample of a curve. A
   * search starts at the center of equal weights, and then at points near which a lower minimum may
   * lie. The result of a row does not depend on the other rows. Throws what `centerOfMass` throws,
   * and names the row.
   */
  centersOfMass(
    points: readonly PointLike[],
    rows: ArrayLike<number> | readonly ArrayLike<number>[],
    options: CentersOptions = {},
  ): CentersOfMass {
    return centersOfMass(this.handle, points, rows, options);
  }

  /**
   * The inverse of `centerOfMass`: weights with sum 1 for which `point` is the center of mass of
   * the points. Of all such weights they are the nearest to the given ones; for three points they
   * are unique. Such weights transfer a drawing from old points to new ones: `weightsOf` returns
   * the weights of a place for the old points, and `centerOfMass` of the new points with these
   * weights returns the new place.
   *
   * Throws `KarcherError` badArgument if no such weights exist: seen from `point`, the points lie
   * along one line that misses `point`; or, with `nonNegative`, `point` lies outside the convex
   * hull of the points. Also throws badWeights (the number of given weights is wrong, or their sum
   * is not positive), tooFewPoints (there are none), unreachable.
   */
  weightsOf(
    point: PointLike,
    points: readonly PointLike[],
    options: WeightsOptions = {},
  ): MeanWeights {
    return weightsOf(this.handle, point, points, options);
  }

  /**
   * The center of mass of points that are given by their distances to all vertices. The distances
   * may come from any method. Each point has an array in the caller's vertex order; entries at
   * dropped vertices have no effect. Weights are as in `centerOfMass`; the method is `paper`.
   *
   * Throws `KarcherError` badArgument (an array of another length), notFinite (a distance that is
   * negative or not finite), badWeights, tooFewPoints.
   */
  centerOfMassOfDistances(
    distances: readonly ArrayLike<number>[],
    weights: ArrayLike<number>,
    options: StartOptions = {},
  ): CenterOfMass {
    return centerOfMassOfDistances(this.handle, distances, weights, options);
  }

  /**
   * A curve with control points, of one of the kinds of `CurveKind`. The mesh's `dispose` also
   * disposes of it.
   *
   * Throws `KarcherError` tooFewPoints, unreachable (the points lie on several components),
   * badArgument or notFinite (degree, knots, weights, betas), badWeights (a basis whose weights do
   * not sum to 1), and badArgument for the limits of exact distances (see `distance`).
   *
   * @example
   * ```ts
   * const curve = mesh.curve({ kind: 'bspline', points, samples: 128 });
   * curve.polyline(); // x, y, z, …
   * ```
   */
  curve(options: CurveOptions): Curve {
    return new Curve(this.handle, options);
  }

  /**
   * The geodesic circle about a center, made of rational quadratic arcs. Unless `arcs` is given,
   * the circle has so many arcs that its samples keep the radius to within `tolerance`, by default
   * a thousandth. `deviation` is the largest relative error.
   *
   * Throws `KarcherError` boundary (naming the arc whose geodesic from the center meets the
   * boundary), radiusTooLarge (no vertex of the component lies as far from the center).
   *
   * @example
   * ```ts
   * const { path, deviation } = mesh.circle({ vertex: 12 }, { radius: 0.3 });
   * ```
   */
  circle(center: PointLike, options: CircleOptions): Circle {
    return distances.circle(this.handle, center, options);
  }

  /**
   * The ellipse about a center, made of the rational quadratic arcs of a planar ellipse. Geodesics
   * from the center map the control points of these arcs to the surface. Throws as `circle` does,
   * and badArgument if the direction is perpendicular to the center's face.
   */
  ellipse(center: PointLike, options: EllipseOptions): Ellipse {
    return distances.ellipse(this.handle, center, options);
  }

  /**
   * The lines of the points at one geodesic distance from a center. There may be no line; beyond
   * the center's cut locus there may be several. A line that is not closed ends on the boundary.
   * Throws `KarcherError` badArgument if the radius is not positive.
   *
   * @example
   * ```ts
   * const lines = mesh.isolines({ vertex: 12 }, { radius: 0.3 });
   * ```
   */
  isolines(center: PointLike, options: IsolineOptions): Path[] {
    return distances.isolines(this.handle, center, options);
  }

  /**
   * The lines at a distance from the nearest of several paths (or lists of their points), without
   * the parts where an offset intersects itself. There may be no line, or several. Lines on one
   * side have the direction of the paths. The inside of a region lies to the left of its boundary.
   * Points keep the distance to within a thousandth. With several distances, the error is at most a
   * thousandth of the smallest one, or a ten-thousandth of the largest one if that is more. Throws
   * `KarcherError` badArgument for a distance out of range, a path without length, and consecutive
   * points without a common face.
   *
   * @example
   * ```ts
   * const tapered = mesh.offset([path], { distance: [0.02, 0.05] });
   * ```
   */
  offset(paths: readonly Outline[], options: OffsetOptions): Path[] {
    return distances.offset(this.handle, paths, options);
  }

  /**
   * The exact geodesic distance of each point from the nearest of several paths (or lists of their
   * points); NaN for unreachable points. Throws `KarcherError` badArgument for a path without
   * length, consecutive points without a face in common, and the limits of exact distances (see
   * `distance`).
   *
   * @example
   * ```ts
   * const [far] = mesh.distanceFromPaths([path], [{ vertex: 12 }]);
   * ```
   */
  distanceFromPaths(
    paths: readonly Outline[],
    points: readonly PointLike[] | PointArrays,
  ): Float64Array {
    return distances.distanceFromPaths(this.handle, paths, points);
  }

  /**
   * The regions that shapes enclose, one for each shape. With `combine` there is a single region:
   * the union, intersection, difference or exclusion of all shapes. A shape is one outline, or
   * several outlines with a choice of their inside. Outlines may cross, touch and follow each
   * other, the mesh's edges and its boundary. Points nearer to each other than 2^-32 of an edge are
   * merged. An outline from boundary to boundary encloses one of its sides.
   *
   * Throws `KarcherError` badArgument if outlines enclose no region (a single outline round a
   * handle of the surface, or an open outline that ends inside the surface), and for consecutive
   * points without a face in common.
   */
  regions(shapes: readonly (Outline | RegionShape)[], options: RegionOptions = {}): Region[] {
    return regions(this.handle, shapes, options);
  }

  /**
   * The parts into which paths, or lists of their points, cut the mesh. The paths may cross and
   * touch as the outlines of `regions` may. Positions on both sides of a path are equal to the last
   * bit. A path that ends inside a part leaves a slit. `progress` may abort the signal.
   *
   * Throws `KarcherError` badArgument for consecutive points without a face in common, and the
   * signal's reason.
   */
  cut(paths: readonly Outline[], work: LongWorkOptions = {}): CutPart[] {
    checkLongWork(work);
    const outlines = wireOutlines(paths);
    const report = callback((done: number) => {
      work.progress?.(done, 'cut');
      work.signal?.throwIfAborted();
      return true;
    }, false);
    return report.guard(() => this.handle.call((mesh) => mesh.cut(outlines, report.call)));
  }

  /**
   * Geodesic distances from a point, or from the nearest of several points, to the vertices, in the
   * caller's order; NaN at dropped and unreachable vertices. A vertex where parts touch has the
   * distance of the nearest part. They are exact by default.
   *
   * Exact distances have two limits: the longest edge is at most 1e12 times the shortest, and a
   * field takes at most 10,000 windows for each face, where 10 to 100 are usual. Beyond them the
   * call throws `KarcherError` badArgument. The solver `graph` has neither limit. With a `radius`,
   * the distances of vertices beyond it are NaN, and the call takes only the time for the disk.
   */
  distance(
    from: PointLike | readonly PointLike[],
    options: RadiusOptions & DistanceOptions = {},
  ): Float64Array {
    return distances.distance(this.handle, this.info.vertices, from, options);
  }

  /**
   * The exact shortest path. Throws `KarcherError` unreachable if no path exists.
   *
   * @example
   * ```ts
   * const path = mesh.shortestPath({ vertex: 12 }, { vertex: 340 });
   * path.length;
   * path.polyline(); // x, y, z, …
   * ```
   */
  shortestPath(from: PointLike, to: PointLike): Path {
    return distances.shortestPath(this.handle, from, to);
  }

  /**
   * The straightest geodesic of a given length from a point in a direction. The direction is a
   * vector in space, which is projected onto the point's face. The path ends early at the boundary,
   * or after a million edges. `stop` is the reason for its end, and `remaining` the rest of the
   * length.
   *
   * Throws `KarcherError` badArgument if the direction is perpendicular to the face or the length
   * is negative.
   *
   * @example
   * ```ts
   * const { path, end } = mesh.straightest({ vertex: 12 }, [1, 0, 0], 0.5);
   * ```
   */
  straightest(from: PointLike, direction: VectorLike, length: number): StraightestPath {
    return maps.straightest(this.handle, from, direction, length);
  }

  /**
   * The log map: points as vectors of the tangent plane at `from`, which is the plane of its face.
   * A vector has the direction in which the path to its point leaves `from`, and the length of the
   * path. The paths are locally shortest, and seldom longer than the shortest by a thousandth. The
   * map also transports `directions` in parallel along the paths to `from`. `directions` has one
   * for each point, in the plane of the point's face; 0, 0, 0 stands for none.
   *
   * Without points, the map has the vectors of all vertices, in the caller's order, at about the
   * cost of one field of distances. With `{ radius }` in place of points, it has only the vectors
   * of vertices within the radius. The lengths are those of the solver `fast`'s paths. The
   * directions are interpolated between neighbors. They are exact on surfaces that unroll into a
   * plane, except near places with three shortest paths, and elsewhere some thousandths of a radian
   * off. Vectors are NaN at dropped and unreachable vertices, and beyond the radius.
   *
   * Throws `KarcherError` unreachable if no path exists, and badArgument unless there is one
   * direction for each point.
   */
  logMap(
    from: PointLike,
    points?: readonly PointLike[] | RadiusOptions,
    directions?: VectorsLike,
  ): LogMap {
    return maps.logMap(this.handle, from, points, directions);
  }

  /**
   * The exp map: the ends of the straightest geodesics from a point along vectors of its tangent
   * plane. Components of a vector perpendicular to the plane have no effect. The map transports
   * directions at `from` along the geodesics. It is the inverse of `logMap` if the geodesics are
   * the paths that `logMap` finds to the end points. Throws what `logMap` throws.
   */
  expMap(from: PointLike, vectors: VectorsLike, directions?: VectorsLike): MappedPoints {
    return maps.expMap(this.handle, from, vectors, directions);
  }

  /**
   * Vectors of the tangent plane at `from`, transported along the log map's path to `to`: x, y, z
   * for each.
   */
  transport(from: PointLike, to: PointLike, vectors: VectorsLike): Float64Array {
    return maps.transport(this.handle, from, to, vectors);
  }

  /**
   * Vectors of the tangent plane at the start of a path, transported along it to its end: x, y, z
   * for each. The path need not be straight. For example, it can be the path of a curve.
   *
   * @throws {KarcherError} badArgument for consecutive points without a face in common.
   * @example
   * ```ts
   * const carried = mesh.transportAlong(curve.path(), [1, 0, 0]);
   * ```
   */
  transportAlong(path: Outline, vectors: VectorsLike): Float64Array {
    return maps.transportAlong(this.handle, path, vectors);
  }

  /**
   * The mirror images of points in a geodesic. `line` is the list of the geodesic's points, as
   * `path.points()` returns it. A point moves along the perpendicular to the geodesic, and on by
   * the same length beyond it. Directions are reflected. Throws what `logMap` throws, and
   * `KarcherError` badArgument for a line without length, for consecutive points without a face in
   * common, and for a point whose nearest point of the line is one of the line's ends.
   */
  mirror(
    line: readonly PointLike[],
    points: readonly PointLike[],
    directions?: VectorsLike,
  ): MappedPoints {
    return maps.mirror(this.handle, line, points, directions);
  }

  /**
   * Frees the memory of the mesh and of its curves. A second call has no effect. Throws
   * `KarcherError` busy if a basis or a progress function calls it while the engine works.
   */
  dispose(): void {
    this.handle.dispose();
  }
}
