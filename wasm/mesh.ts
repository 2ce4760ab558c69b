/// <reference lib="esnext.disposable" preserve="true" />
import {
  checkArray,
  checkBoolean,
  checkInteger,
  checkNumber,
  checkOneOf,
  checkOptions,
  shown,
  toFloat64,
  toVector,
} from './check.js';
import { Curve } from './curve.js';
import { givenNumbers } from './curve_options.js';
import { disposable, type Engine, Handle, Made } from './engine.js';
import { KarcherError } from './errors.js';
import type { EngineCircle, EngineMean, EngineMesh } from './karcher-engine.mjs';
import { carriedVectors, type LogMap, type MappedPoints, toMapped, toVectors } from './maps.js';
import { frozenInfo } from './mesh_info.js';
import {
  centerOptionNames,
  centersOptionNames,
  checkLongWork,
  circleOptionNames,
  curveOptionNames,
  distanceOptionNames,
  ellipseOptionNames,
  engineArcs,
  engineFieldOptions,
  fieldOptionNames,
  isolineOptionNames,
  cornerShapes,
  offsetOptionNames,
  offsetSides,
  regionOptionNames,
  startOptionNames,
  weightsOptionNames,
} from './options.js';
import { Path } from './path.js';
import type { Circle, Ellipse, Outline, RegionShape, StraightestPath } from './path_types.js';
import { toPointArrays, toSurfacePoint, wirePoint, wirePointArrays, wirePoints } from './points.js';
import { prepareGraph } from './prepare.js';
import { Region, wireOutlines, wireShapes } from './region.js';
import { checkDistancesFit, checkMeshFits } from './room.js';
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
  FileMarks,
  IsolineOptions,
  LongWorkOptions,
  MeanWeights,
  MeshInfo,
  NearestPoint,
  OffsetOptions,
  PointArrays,
  PointLike,
  RegionOptions,
  StartOptions,
  SurfacePoint,
  VectorLike,
  VectorsLike,
  WeightsOptions,
} from './types.js';
import { CurveView } from './view.js';

/**
 * A triangle mesh. It and what is made from it live in the engine's memory until `dispose`, or until
 * nobody can reach it any more and JavaScript's memory is cleared.
 *
 * Every method throws `KarcherError`: disposed after `dispose`; badIndex for a face or vertex that
 * does not exist or a vertex that was dropped; badPoint for weights outside the face; notFinite for
 * NaN or infinity; badArgument for an option of another name and anything else out of range.
 */
export class Mesh {
  static {
    disposable(Mesh.prototype);
  }

  /** Calls `dispose`, for `using`. */
  declare readonly [Symbol.dispose]: () => void;
  readonly #engine: Engine;
  readonly #handle: Handle<EngineMesh>;
  readonly #curves = new Made<Curve>();

  /** What the mesh consists of, and what was mended while it was read. */
  readonly info: Readonly<MeshInfo>;

  /** @internal `Karcher` makes meshes. */
  constructor(engine: Engine, target: EngineMesh) {
    this.#engine = engine;
    this.#handle = new Handle(engine, 'the mesh', target);
    this.info = frozenInfo(this.#handle.call((mesh) => mesh.info()));
  }

  /** @internal The engine that made the mesh. */
  get engine(): Engine {
    return this.#engine;
  }

  /** @internal The mesh in that engine's memory. */
  get handle(): Handle<EngineMesh> {
    return this.#handle;
  }

  /**
   * x, y, z of each vertex, in the caller's order, as a new array. Welded vertices repeat their
   * place; dropped ones keep theirs.
   *
   * @example
   * ```ts
   * const place = mesh.positions().subarray(3 * 12, 3 * 12 + 3); // of vertex 12
   * ```
   */
  positions(): Float64Array {
    return this.#handle.call((mesh) => mesh.positions());
  }

  /**
   * The vertices of each triangle, in the caller's order and numbers, as a new array.
   *
   * @example
   * ```ts
   * const corners = mesh.triangles().subarray(3 * 7, 3 * 7 + 3); // of face 7
   * ```
   */
  triangles(): Int32Array {
    return this.#handle.call((mesh) => mesh.triangles());
  }

  /**
   * What the OBJ file that gave the mesh says beside the surface. Of other meshes it is empty: what other
   * files say `meshFromFile` of `karcher/formats` tells.
   */
  fileMarks(): FileMarks {
    return this.#handle.call((mesh) => mesh.marks());
  }

  /**
   * The mesh refined by Loop subdivision: four triangles for each, `levels` times (1 to 6). The new
   * mesh has a numbering of its own and is disposed of on its own. Throws `KarcherError` outOfMemory
   * where it cannot fit.
   */
  subdivide(levels = 1): Mesh {
    checkInteger(levels, 'the number of levels');
    if (levels >= 1 && levels <= 6) {
      const what = `${levels} ${levels === 1 ? 'level' : 'levels'} of subdivision make`;
      checkMeshFits(0, 4 ** levels * this.info.triangles, what, this.#bytesInUse);
    }
    return new Mesh(
      this.#engine,
      this.#handle.call((mesh) => mesh.subdivided(levels)),
    );
  }

  /**
   * The point of a face with the given weights of its corners, checked and cleaned: weights that
   * leave the face by no more than 1e-6, from rounding, are moved onto it. A raycast of three.js gives
   * them as `faceIndex` and `barycoord`.
   *
   * @example
   * ```ts
   * const middle = mesh.surfacePoint(17, [1 / 3, 1 / 3, 1 / 3]);
   * ```
   */
  surfacePoint(face: number, bary: VectorLike): SurfacePoint {
    const wire = wirePoint({ face, bary } as PointLike);
    return toSurfacePoint(this.#handle.call((mesh) => mesh.checkedPoint(wire)));
  }

  /**
   * The place of a point in space.
   *
   * @example
   * ```ts
   * const [x, y, z] = mesh.position({ vertex: 12 });
   * ```
   */
  position(point: PointLike): [number, number, number] {
    const wire = wirePoint(point);
    return this.#handle.call((mesh) => mesh.position(wire));
  }

  /** The places of points: x, y, z each. Of a list, or of flat arrays, as `CentersOfMass` has them. */
  positionsOf(points: readonly PointLike[] | PointArrays): Float64Array {
    const wire = wirePointsOrArrays(points);
    return this.#handle.call((mesh) => mesh.positionsOf(wire));
  }

  /**
   * The unit normal of a point's face, on the side from which its corners run counterclockwise.
   *
   * @example
   * ```ts
   * const [x, y, z] = mesh.normal({ vertex: 12 });
   * ```
   */
  normal(point: PointLike): [number, number, number] {
    const wire = wirePoint(point);
    return this.#handle.call((mesh) => mesh.normal(wire));
  }

  /**
   * The point of the surface that is nearest to a place in space; of several one of them.
   *
   * @example
   * ```ts
   * const { point, distance } = mesh.nearestPoint([0.1, 0.2, 0.3]);
   * ```
   */
  nearestPoint(place: VectorLike): NearestPoint {
    const vector = toVector(place, 'the place');
    const { point, distance } = this.#handle.call((mesh) => mesh.nearestPoint(vector));
    const position = this.#handle.call((mesh) => mesh.position(point));
    return { point: toSurfacePoint(point), position, distance };
  }

  /**
   * Makes what the given fields need of the mesh; the graph of the graph solver in slices of a few
   * milliseconds. Other methods make at once what is missing.
   *
   * Rejects with the signal's reason when it is aborted, and with `KarcherError` disposed and outOfMemory,
   * the latter as soon as it is known that a graph cannot fit.
   */
  async prepare(options: FieldOptions = {}, work: LongWorkOptions = {}): Promise<void> {
    checkOptions(options, fieldOptionNames);
    checkLongWork(work);
    const field = engineFieldOptions(options);
    if (field.solver === 'graph') {
      await prepareGraph(this.#engine, this.#handle, this.info.triangles, field.rings, work);
    }
    this.#handle.call((mesh) => mesh.prepareFields(field));
  }

  /**
   * The Riemannian center of mass of points with weights, one a point, that sum to 1 within 1e-9 (or
   * are divided by their sum with `normalize`). Some may be negative. Only with the status
   * `converged` the result is a center of mass; see `Status`. The fields of the points are kept until
   * the next call: other weights need no new ones, and a point that moves only its own. Of 64 different
   * points or more whose fields would hold over two million values there are none, unless `uniqueness` is
   * asked for or a weight is negative: the search, from some of the points, takes about as long for
   * thousands as for hundreds.
   *
   * Throws `KarcherError` badWeights (not one a point, or another sum), tooFewPoints (none),
   * unreachable (the points lie on several components), badArgument (the limits of exact distances;
   * see `distance`).
   */
  centerOfMass(
    points: readonly PointLike[],
    weights: ArrayLike<number>,
    options: CenterOptions = {},
  ): CenterOfMass {
    checkOptions(options, centerOptionNames);
    const places = wirePoints(points);
    const masses = toFloat64(weights, 'the weights');
    const start = this.#wireStart(options);
    const field = engineFieldOptions(options);
    const normalize = checkBoolean(options.normalize ?? false, 'normalize');
    const looks = checkBoolean(options.uniqueness ?? false, 'uniqueness');
    const certifies = checkBoolean(options.certificate ?? false, 'certificate');
    return toCenterOfMass(
      this.#handle.call((mesh) =>
        mesh.centerOfMass(places, masses, start, normalize, looks, certifies, field),
      ),
    );
  }

  /**
   * The centers of mass of one set of points for many rows of weights, one a point in each: a list of
   * rows, or all of them one after the other. Fields are made once, and each search costs what a curve's
   * sample does: it starts at the center of equal weights, and then at points near which a lower minimum may
   * lie. The answer of a row does not depend on the other rows. Throws as `centerOfMass` does, and names the row.
   */
  centersOfMass(
    points: readonly PointLike[],
    rows: ArrayLike<number> | readonly ArrayLike<number>[],
    options: CentersOptions = {},
  ): CentersOfMass {
    checkOptions(options, centersOptionNames);
    const places = wirePoints(points);
    const weights = toRows(rows, points.length);
    const start = this.#wireStart(options);
    const field = engineFieldOptions(options);
    const normalize = checkBoolean(options.normalize ?? false, 'normalize');
    const checks = checkBoolean(options.check ?? false, 'check');
    const { point, ...centers } = this.#handle.call((mesh) =>
      mesh.centersOfMass(places, weights, start, normalize, checks, field),
    );
    return { count: point.length / 4, ...toPointArrays(point), ...centers };
  }

  /**
   * The inverse of `centerOfMass`: weights of sum 1 for which a point is the center of mass of the
   * points, the nearest to the given ones; of three points there are only these. So a drawing among
   * some points is carried to others: the weights here, `centerOfMass` there.
   *
   * Throws `KarcherError` badArgument where there are none: all the points are seen from `point`
   * along one line that it does not lie on, or with `nonNegative` it lies outside of their convex
   * hull. Besides badWeights (given ones that are not one a point, or of no positive sum),
   * tooFewPoints (none), unreachable.
   */
  weightsOf(
    point: PointLike,
    points: readonly PointLike[],
    options: WeightsOptions = {},
  ): MeanWeights {
    checkOptions(options, weightsOptionNames);
    const place = wirePoint(point);
    const places = wirePoints(points);
    const { weights } = options;
    const given =
      weights === undefined ? new Float64Array() : givenNumbers(weights, 'the given weights');
    const nonNegative = checkBoolean(options.nonNegative ?? false, 'nonNegative');
    const field = engineFieldOptions(options);
    return this.#handle.call((mesh) => mesh.weightsOf(place, places, given, nonNegative, field));
  }

  /**
   * The center of mass of points that are known by their distances to all vertices, however these
   * were found: for each point an array in the caller's vertex order, whose entries at dropped vertices
   * are not read. Weights as in `centerOfMass`; the method is the paper's.
   *
   * Throws `KarcherError` badArgument (an array of another length), notFinite (a distance that is
   * negative or not finite), badWeights, tooFewPoints.
   */
  centerOfMassOfDistances(
    distances: readonly ArrayLike<number>[],
    weights: ArrayLike<number>,
    options: StartOptions = {},
  ): CenterOfMass {
    checkOptions(options, startOptionNames);
    const vertices = this.#handle.call((mesh) => mesh.inputVertices());
    const arrays = checkArray(distances, 'the distances');
    const all = new Float64Array(vertices * arrays.length);
    for (const [i, entry] of arrays.entries()) {
      const values = toFloat64(entry, `array ${i} of the distances`);
      if (values.length !== vertices) {
        throw new KarcherError(
          'badArgument',
          `array ${i} must hold a distance a vertex: ${vertices}, not ${values.length}`,
        );
      }
      all.set(values, vertices * i);
    }
    const masses = toFloat64(weights, 'the weights');
    const start = this.#wireStart(options);
    const normalize = checkBoolean(options.normalize ?? false, 'normalize');
    return toCenterOfMass(
      this.#handle.call((mesh) => mesh.centerOfMassOfDistances(all, masses, start, normalize)),
    );
  }

  /**
   * A curve with control points, of one of the kinds of `CurveKind`. It is disposed of with the mesh
   * at the latest.
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
    checkOptions(options, curveOptionNames);
    const curve = new Curve(this.#engine, this.#handle, options, {
      make: (others) => this.curve(others),
      forget: (disposed) => this.#curves.delete(disposed),
    });
    this.#curves.add(curve);
    return curve;
  }

  /**
   * The geodesic circle about a center, by rational quadratic arcs: as many as keep its samples within
   * a thousandth of the radius, or a number of your own. `deviation` says how near they are.
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
    checkOptions(options, circleOptionNames);
    const wire = wirePoint(center, 'the center');
    const radius = checkNumber(options.radius, 'the radius');
    const tolerance = checkNumber(options.tolerance ?? 1e-3, 'the tolerance');
    const arcs = engineArcs(options);
    return this.#toCircle(
      this.#handle.call((mesh) => mesh.circle(wire, radius, ...arcs, tolerance)),
    );
  }

  /**
   * The ellipse about a center, by rational quadratic arcs: those of the plane's ellipse, carried to
   * the surface along geodesics from the center. Throws as `circle` does, and badArgument where the
   * direction is perpendicular to the center's face.
   */
  ellipse(center: PointLike, options: EllipseOptions): Ellipse {
    checkOptions(options, ellipseOptionNames);
    const wire = wirePoint(center, 'the center');
    const radii = checkArray(options.radii, 'the radii').map((radius, i) =>
      checkNumber(radius, `radius ${i}`),
    );
    if (radii.length !== 2) throw new KarcherError('badArgument', 'an ellipse takes two radii');
    const [along, across] = radii as [number, number];
    const direction = toVector(options.direction, 'the direction');
    const arcs = engineArcs(options);
    return this.#toCircle(
      this.#handle.call((mesh) => mesh.ellipse(wire, along, across, direction, ...arcs)),
    );
  }

  /**
   * The points at one geodesic distance from a center: lines, of which there may be none, or several
   * beyond the center's cut locus. Where one is not closed both of its ends lie on the boundary.
   * Throws `KarcherError` badArgument where the radius is not positive.
   *
   * @example
   * ```ts
   * const lines = mesh.isolines({ vertex: 12 }, { radius: 0.3 });
   * ```
   */
  isolines(center: PointLike, options: IsolineOptions): Path[] {
    checkOptions(options, isolineOptionNames);
    const wire = wirePoint(center, 'the center');
    const radius = checkNumber(options.radius, 'the radius');
    const type = checkOneOf(options.type ?? 'exact', ['exact', 'linear'], 'the type of isolines');
    for (const name of ['solver', 'rings'] as const) {
      if (type === 'linear' || options[name] === undefined) continue;
      throw new KarcherError(
        'badArgument',
        `isolines of the type 'exact' take no ${name}; those of the type 'linear' do`,
      );
    }
    const { solver = 'exact', rings } = options;
    const field = engineFieldOptions({ solver, rings });
    return this.#handle
      .call((mesh) => mesh.isolines(wire, radius, type === 'exact', field))
      .map((line) => new Path(line));
  }

  /**
   * The points at a distance from the nearest of paths, or of their points: corners are round by default,
   * and what runs into itself is trimmed. Lines of one side run as the paths do; there may be none, or several.
   * Left of the boundary of a region is its inside. Places keep to the distance within a thousandth of it.
   *
   * Throws `KarcherError` badArgument for a distance that is not positive, a path without length,
   * consecutive points without a face in common, and a `miterLimit` below 1.
   */
  offset(paths: readonly Outline[], options: OffsetOptions): Path[] {
    checkOptions(options, offsetOptionNames);
    const outlines = wireOutlines(paths);
    const distance = checkNumber(options.distance, 'the distance');
    const side = checkOneOf(options.side ?? 'both', offsetSides, 'the side');
    const shape = checkOneOf(options.corners ?? 'round', cornerShapes, 'the corners');
    const corners = cornerShapes.indexOf(shape);
    const miterLimit = checkNumber(options.miterLimit ?? 4, 'the miterLimit');
    return this.#handle
      .call((mesh) =>
        mesh.offset(outlines, distance, offsetSides.indexOf(side) - 1, corners, miterLimit),
      )
      .map((line) => new Path(line));
  }

  /**
   * The exact geodesic distances of points from the nearest of paths, or of their points: NaN where no path
   * leads. Throws `KarcherError` badArgument for a path without length, consecutive points without a face in
   * common, and the limits of exact distances (see `distance`).
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
    const outlines = wireOutlines(paths);
    const places = wirePointsOrArrays(points);
    return this.#handle.call((mesh) => mesh.distanceFromPaths(outlines, places));
  }

  /**
   * The regions that shapes enclose, one a shape, or with `combine` one of all: union, intersection,
   * difference or exclusion. A shape is an outline, or several with what is inside. All
   * outlines may cross, touch and run along each other, the mesh's edges and its boundary; what lies
   * nearer than 2^-32 of an edge is one. Outlines from boundary to boundary enclose a side, too.
   *
   * Throws `KarcherError` badArgument where outlines enclose nothing: one alone round a handle of the
   * surface, or an open one that ends inside; and for consecutive points without a face in common.
   */
  regions(shapes: readonly (Outline | RegionShape)[], options: RegionOptions = {}): Region[] {
    checkOptions(options, regionOptionNames);
    const rule = checkOneOf(options.rule ?? 'evenOdd', ['evenOdd', 'nonZero'], 'the rule');
    const combine = checkOneOf(
      options.combine ?? 'none',
      ['none', 'union', 'intersection', 'difference', 'exclusion'],
      'what combines',
    );
    const { outlines, counts, insides } = wireShapes(shapes);
    return this.#handle
      .call((mesh) => mesh.regions(outlines, counts, insides, rule, combine))
      .map((region) => new Region(region));
  }

  /**
   * The mesh cut apart along paths, or their points (`regions` says what they may do): a part for each
   * piece of the surface that they leave. On both sides of a path positions are equal to the last bit;
   * a path that ends inside a part leaves a slit.
   *
   * Throws `KarcherError` badArgument for consecutive points without a face in common.
   */
  cut(paths: readonly Outline[]): CutPart[] {
    const outlines = wireOutlines(paths);
    return this.#handle.call((mesh) => mesh.cut(outlines));
  }

  /**
   * Geodesic distances from a point to the vertices, in the caller's order, or from the nearest of several
   * points: NaN at a dropped vertex and where no path leads. By default exact.
   *
   * Exact distances have two limits: the longest edge is at most 1e12 times the shortest, and a field
   * takes at most 10,000 windows a face, where 10 to 100 are usual. Throws `KarcherError` badArgument
   * beyond them. The solver `graph` has neither.
   */
  distance(from: PointLike | readonly PointLike[], options: DistanceOptions = {}): Float64Array {
    checkOptions(options, distanceOptionNames);
    const wire = Array.isArray(from) ? wirePoints(from) : wirePoint(from as PointLike);
    if (wire.length === 0) {
      throw new KarcherError('tooFewPoints', 'distances are from at least one point');
    }
    const field = engineFieldOptions({ ...options, solver: options.solver ?? 'exact' });
    checkDistancesFit(this.info.vertices, this.#bytesInUse);
    return this.#handle.call((mesh) => mesh.distance(wire, field));
  }

  /**
   * The exact shortest path. Throws `KarcherError` unreachable where no path leads.
   *
   * @example
   * ```ts
   * const path = mesh.shortestPath({ vertex: 12 }, { vertex: 340 });
   * path.length;
   * path.polyline(); // x, y, z, …
   * ```
   */
  shortestPath(from: PointLike, to: PointLike): Path {
    const wireFrom = wirePoint(from, 'the first point');
    const wireTo = wirePoint(to, 'the second point');
    return new Path(this.#handle.call((mesh) => mesh.shortestPath(wireFrom, wireTo)));
  }

  /**
   * The straightest geodesic that leaves a point along a direction in space, which is projected onto
   * the point's face, for the given length. At the boundary it stops, and after a million edges:
   * `stop` tells, and `remaining` how much of the length was left.
   *
   * Throws `KarcherError` badArgument where the direction is perpendicular to the face or the length
   * is negative.
   *
   * @example
   * ```ts
   * const { path, end } = mesh.straightest({ vertex: 12 }, [1, 0, 0], 0.5);
   * ```
   */
  straightest(from: PointLike, direction: VectorLike, length: number): StraightestPath {
    const wire = wirePoint(from);
    checkNumber(length, 'the length');
    const vector = toVector(direction, 'the direction');
    const line = this.#handle.call((mesh) => mesh.straightest(wire, vector, length));
    return { ...line, end: toSurfacePoint(line.end), path: new Path(line.path) };
  }

  /**
   * The log map: points as vectors of the tangent plane at `from`, which is that of its face, each in
   * the direction in which the path to the point leaves and as long as it. The paths are locally
   * shortest, and seldom longer than the shortest by a thousandth. `directions` (one a point, in the
   * planes of the points' faces; 0, 0, 0 for none) are carried along the paths by parallel transport.
   *
   * Without points the vectors are those of all vertices, in the caller's order, at about the cost of one
   * field of distances: paths of the solver `fast`, whose directions are interpolated between those of
   * neighbours. They are exact on surfaces that unroll, and elsewhere off by some thousandths of a radian beside
   * those of the paths. NaN at a dropped vertex and where no path leads.
   *
   * Throws `KarcherError` unreachable where no path leads, and badArgument for directions that are
   * not one a point.
   */
  logMap(from: PointLike, points?: readonly PointLike[], directions?: VectorsLike): LogMap {
    const wire = wirePoint(from);
    if (points === undefined) {
      if (directions !== undefined) {
        throw new KarcherError('badArgument', 'the log map of all vertices takes no directions');
      }
      const vectors = this.#handle.call((mesh) => mesh.logMapOfVertices(wire));
      return { vectors, directions: new Float64Array() };
    }
    const places = wirePoints(points);
    const ways = carriedVectors(directions, points.length);
    return this.#handle.call((mesh) => mesh.logMap(wire, places, ways));
  }

  /**
   * The exp map: the ends of the straightest geodesics from a point along vectors of its tangent
   * plane (what is perpendicular to it is dropped), with directions at `from` carried
   * along. It is the inverse of `logMap` where these geodesics are the paths that are found to their
   * ends. Throws as `logMap` does.
   */
  expMap(from: PointLike, vectors: VectorsLike, directions?: VectorsLike): MappedPoints {
    const wire = wirePoint(from);
    const ways = toVectors(vectors, 'the vectors');
    const carried = carriedVectors(directions, ways.length / 3);
    return toMapped(this.#handle.call((mesh) => mesh.expMap(wire, ways, carried)));
  }

  /** Vectors of the tangent plane at `from`, carried along the log map's path to `to`: x, y, z each. */
  transport(from: PointLike, to: PointLike, vectors: VectorsLike): Float64Array {
    const wireFrom = wirePoint(from, 'the first point');
    const wireTo = wirePoint(to, 'the second point');
    const ways = toVectors(vectors, 'the vectors');
    return this.#handle.call((mesh) => mesh.transport(wireFrom, wireTo, ways));
  }

  /**
   * Points mirrored in a geodesic that is given by its points, as `path.points()` has them: along the
   * perpendicular to it, and as far on beyond; their directions are reflected.
   *
   * Throws as `logMap`, and `KarcherError` badArgument for a line that has no length or two consecutive
   * points without a face in common, and where the line's nearest point is an end of it.
   */
  mirror(
    line: readonly PointLike[],
    points: readonly PointLike[],
    directions?: VectorsLike,
  ): MappedPoints {
    const wireLine = wirePoints(line, 'the line');
    if (line.length < 2) throw new KarcherError('badArgument', 'a line has at least two points');
    const places = wirePoints(points);
    const ways = carriedVectors(directions, points.length);
    return toMapped(this.#handle.call((mesh) => mesh.mirror(wireLine, places, ways)));
  }

  /**
   * Gives the memory back, that of the mesh's curves too. Safe to repeat. Throws `KarcherError` busy
   * from within a basis.
   */
  dispose(): void {
    this.#engine.checkIdle();
    this.#curves.dispose();
    this.#handle.dispose();
  }

  readonly #bytesInUse = () => this.#engine.call((engine) => engine.allocatedBytes());

  #toCircle(circle: EngineCircle): Circle {
    const view = new CurveView({ bytes: circle.view, statusNames: this.#engine.statusNames });
    const { samples, bridged, unconverged, levels } = view;
    const { deviation } = circle;
    const notShortest = [...circle.notShortest];
    return { samples, bridged, path: view.path(), unconverged, levels, notShortest, deviation };
  }

  /** The start of a search as it travels: empty for the engine's choice. */
  #wireStart({ start }: StartOptions): Float64Array {
    return start === undefined ? new Float64Array() : wirePoint(start, 'the start');
  }
}

const wirePointsOrArrays = (points: readonly PointLike[] | PointArrays): Float64Array =>
  Array.isArray(points) ? wirePoints(points) : wirePointArrays(toArrays(points));

function toArrays(points: unknown): PointArrays {
  if (typeof points === 'object' && points !== null) return points as PointArrays;
  throw new KarcherError(
    'badArgument',
    `the points must be a list or {face, bary}, not ${shown(points)}`,
  );
}

/** Rows of weights one after the other. */
function toRows(rows: unknown, width: number): Float64Array {
  if (!Array.isArray(rows) || typeof rows[0] !== 'object') return toFloat64(rows, 'the weights');
  const all = new Float64Array(width * rows.length);
  for (let i = 0; i < rows.length; i++) {
    const row = toFloat64(rows[i], `row ${i} of the weights`);
    if (row.length !== width) {
      throw new KarcherError(
        'badWeights',
        `row ${i}: there are ${width} points but ${row.length} weights`,
      );
    }
    all.set(row, width * i);
  }
  return all;
}

function toCenterOfMass(mean: EngineMean): CenterOfMass {
  const others = mean.otherMinima.map((other) => ({
    ...other,
    point: toSurfacePoint(other.point),
  }));
  const otherMinima = mean.uniqueness === 'notLooked' ? 'notLooked' : others;
  return { ...mean, point: toSurfacePoint(mean.point), otherMinima };
}
