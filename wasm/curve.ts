/// <reference lib="esnext.disposable" preserve="true" />
import { checkBoolean, checkInteger, checkNumber, checkOptions, shown, toVector } from './check.js';
import {
  checkKind,
  engineValue,
  givenNumbers,
  type OwnBasis,
  optionsOfParts,
  ownBasis,
  tracingOf,
} from './curve_options.js';
import { disposable, type Handle, type MeshHandle } from './engine.js';
import { KarcherError } from './errors.js';
import type {
  EngineCurve,
  EngineCurveEdits,
  EngineCurveParts,
  EngineViewOptions,
} from './karcher-engine.mjs';
import { curveOptionNames, inDouble } from './options.js';
import { Path } from './path.js';
import type { CurveLeg } from './path_types.js';
import { toSurfacePoints, wirePoint, wirePoints, withPoint } from './points.js';
import type {
  BridgedInterval,
  CurveKind,
  CurveOptions,
  CurvePoint,
  CurvePoints,
  CurveSamples,
  CurveTangent,
  CurveTimes,
  CurveValue,
  NearestOnCurve,
  Parametrization,
  PointLike,
  PolylineOptions,
  SurfacePoint,
  VectorLike,
} from './types.js';
import { CurveView } from './view.js';

const pointNumber = (i: number) => checkInteger(i, 'the number of the control point');

/** The properties that take no work. */
type Facts = Pick<CurveView, 'length' | 'segmentCount' | 'levels' | 'times'>;

/**
 * A curve on a mesh, with control points that can be edited. An edit traces only the part that it
 * affects again. The curve is then equal to a new one with the same points.
 *
 * The parameter runs from 0 to `segmentCount`: the number of a segment plus t in [0, 1]. On a
 * closed curve it may be negative or exceed a turn.
 *
 * Every edit throws `KarcherError`, and changes nothing, if the result would be no curve
 * (tooFewPoints, unreachable, and the errors of a point). Everything throws disposed after
 * `dispose`.
 */
export class Curve {
  static {
    disposable(Curve.prototype);
  }

  /** Calls `dispose`, for `using`. */
  declare readonly [Symbol.dispose]: () => void;
  readonly #mesh: MeshHandle;
  readonly #handle: Handle<EngineCurve>;
  #options: CurveOptions;
  #basis: OwnBasis | undefined;
  /** The curve's data, and the properties that take no work, until the next edit. */
  #parts: EngineCurveParts | undefined;
  #facts: Facts | undefined;
  #edits = 0;

  /** @internal `Mesh.curve` creates curves. */
  constructor(mesh: MeshHandle, options: CurveOptions) {
    checkOptions(options, curveOptionNames);
    const basis = options.basis === undefined ? undefined : ownBasis(options.basis);
    const value = engineValue(options, basis);
    this.#mesh = mesh;
    this.#options = { ...options };
    this.#basis = basis;
    this.#handle = this.#guard(() => mesh.made('the curve', (target) => target.curve(value)));
  }

  /**
   * The curve's value: options from which it can be created again. It omits defaults, and numbers
   * that the curve's kind does not use.
   */
  value(): CurveValue {
    const parts = this.#shape;
    const { basis } = this.#options;
    const own = parts.kind === 'custom' && basis !== undefined && { basis };
    return { ...tracingOf(this.#options), ...optionsOfParts(parts), ...own };
  }

  /**
   * Changes the curve to that of a value, and returns its view. The fields of unchanged points
   * stay, and so do the segments with the same points and numbers. All other edits are calls of
   * this one. For the curve with dragged points, pass the `drawnLegs` of the previous view as
   * `legs`. Throws what `Mesh.curve` throws.
   */
  set(value: CurveOptions, options: PolylineOptions = {}): CurveView {
    checkOptions(value, curveOptionNames);
    const basis =
      value.basis === undefined || value.basis === this.#options.basis
        ? this.#basis
        : ownBasis(value.basis);
    const next = engineValue(value, value.basis && basis);
    const wanted = { inDouble: inDouble(options), withPoints: false };
    const set = () => this.#handle.call((curve) => curve.set(next, wanted));
    const bytes = basis ? basis.guard(set) : set();
    this.#options = { ...value };
    if (value.basis !== undefined) this.#basis = basis;
    this.#parts = undefined;
    return this.#seen(bytes);
  }

  /** All data for drawing the curve, its polyline in 32 bits by default, in one buffer. */
  view(options: PolylineOptions = {}): CurveView {
    return this.#view({ inDouble: inDouble(options), withPoints: false });
  }

  /** The control points. */
  points(): SurfacePoint[] {
    return toSurfacePoints(this.#shape.points);
  }

  /**
   * The samples: the centers of mass that form the curve, with the status of the search for each.
   */
  samples(): CurveSamples {
    return this.view().samples;
  }

  /**
   * The intervals in which the curve is no center of mass, with the reasons.
   *
   * @example
   * ```ts
   * for (const { t0, t1, reason } of curve.bridged()) console.log(t0, t1, reason);
   * ```
   */
  bridged(): BridgedInterval[] {
    return this.view().bridged;
  }

  /** The legs of the control polygon on the surface. */
  legs(): CurveLeg[] {
    return this.#call((curve) => curve.legs()).map(({ path, shorter }) => ({
      path: new Path(path),
      ...(shorter && { shorter: new Path(shorter) }),
    }));
  }

  /** The samples, joined on the surface as `geometry` specifies. */
  path(): Path {
    return this.#view({ inDouble: true, withPoints: true }).path();
  }

  /** x, y, z of the path's points. */
  polyline(options?: { bits?: 32 }): Float32Array;
  polyline(options: { bits: 64 }): Float64Array;
  polyline(options?: PolylineOptions): Float32Array | Float64Array;
  polyline(options: PolylineOptions = {}): Float32Array | Float64Array {
    return this.view(options).polyline.slice();
  }

  /**
   * A number for each point of the path: 1 if the piece that leads to it is no center of mass, as
   * on a bridge.
   */
  unconverged(): Uint8Array {
    return this.view().unconverged.slice();
  }

  /** The length of the path, in units of the mesh. */
  get length(): number {
    return this.#told.length;
  }

  /** The kind of the curve; `setKind` changes it. */
  get kind(): CurveKind {
    return this.#shape.kind;
  }

  /** Whether the curve ends where it starts; `setClosed` changes it. */
  get closed(): boolean {
    return this.#shape.closed;
  }

  /** The degree of a B-spline. */
  get degree(): number {
    return this.#shape.degree;
  }

  /** The knots of a B-spline; empty for other kinds. */
  knots(): Float64Array {
    return this.view().knots.slice();
  }

  /** The parametrization of a Catmull-Rom curve. */
  get parametrization(): Parametrization {
    return this.#shape.centripetal ? 'centripetal' : 'uniform';
  }

  /** One weight for each point, also for kinds that do not use weights. */
  weights(): Float64Array {
    return this.#filled(this.#shape.weights);
  }

  /** One beta for each point, also for kinds that do not use betas. */
  betas(): Float64Array {
    return this.#filled(this.#shape.betas);
  }

  /** The number of segments; parameters run from 0 to it. */
  get segmentCount(): number {
    return this.#told.segmentCount;
  }

  /** The number of levels of the curve, also if `levels: 'auto'` chose it. */
  get levels(): number {
    return this.#told.levels;
  }

  /**
   * The estimated largest distance, in the mesh's units, between the curve and the curve with
   * `levels: 0`; 0 without levels. It is null if that curve is not safe, so that the distance has
   * no meaning.
   */
  get deviation(): number | null {
    const deviation = this.#handle.call((curve) => curve.deviation());
    return deviation >= 0 ? deviation : null;
  }

  /** The number of fields computed since the curve was created. A good edit adds few. */
  get fieldsComputed(): number {
    return this.#handle.call((curve) => curve.fieldsComputed());
  }

  /** The duration of the last edit, or of the creation of the curve. */
  times(): CurveTimes {
    return { ...this.#told.times };
  }

  /**
   * Moves control point `i`: the curve computes its field and the segments that it touches again.
   *
   * @example
   * ```ts
   * curve.movePoint(2, { vertex: 17 });
   * ```
   */
  movePoint(i: number, point: PointLike): void {
    this.#edit('movePoint', pointNumber(i), wirePoint(point));
  }

  /**
   * Moves control point `i` as a hand does. The legs of the control polygon that meet at it
   * continue from their present course, whether or not they stay the shortest, so that the curve
   * moves with the point. They keep this course until another kind of edit moves a point at one of
   * their ends, and are part of the curve's value.
   */
  dragPoint(i: number, point: PointLike): void {
    this.#edit('dragPoint', pointNumber(i), wirePoint(point));
  }

  /**
   * Replaces the control points. The fields of points that stay at their places remain. If the
   * number of points changes, weights, betas and custom knots are not allowed.
   */
  setPoints(points: readonly PointLike[]): void {
    this.#edit('setPoints', wirePoints(points));
  }

  /** Appends a control point. */
  addPoint(point: PointLike): void {
    this.insertPoint(
      this.#call((curve) => curve.pointCount()),
      point,
    );
  }

  /** Inserts the point as number `i`. The numbers of the points from there on grow by one. */
  insertPoint(i: number, point: PointLike): void {
    this.#edit('insertPoint', pointNumber(i), wirePoint(point));
  }

  /** Removes control point `i`. The numbers of later points fall by one. */
  removePoint(i: number): void {
    this.#edit('removePoint', pointNumber(i));
  }

  /**
   * Inserts a control point on the curve at a parameter, and returns its number. The curve stays
   * unchanged on a plane, and nearly unchanged elsewhere. A B-spline has a new knot there, and its
   * knots are custom ones from then on. The degree of a curve of one segment grows by one, so that
   * all inner points are new. Curves through their points have one more, which changes a
   * Catmull-Rom curve a little. Throws `KarcherError` badArgument if the curve cannot have such a
   * point.
   */
  insertOnCurve(parameter: number): number {
    return this.#edit('insertOnCurve', checkNumber(parameter, 'the parameter'));
  }

  /**
   * New curves along this one before and after a parameter. A closed B-spline, Catmull-Rom curve or
   * polyline becomes one curve, opened there. On a plane they are the curve's own parts, and nearly
   * so elsewhere. Those of a Catmull-Rom curve deviate a little next to the cut, since they do not
   * depend on the points beyond it. This curve stays unchanged. Throws `KarcherError` badArgument
   * at the ends of an open curve.
   */
  split(parameter: number): Curve[] {
    checkNumber(parameter, 'the parameter');
    return this.#call((curve) => curve.splitAt(parameter)).map((parts) =>
      alike(this.#mesh, this.#options, parts),
    );
  }

  /**
   * A new curve along this one and then along another of its kind, with a geodesic between them if
   * they do not meet. Bezier curves become a B-spline. Barycentric curves and curves through their
   * points become the curve through the points of both, with this one's parametrization. It
   * deviates a little from both where they meet. Both curves stay unchanged. Throws `KarcherError`
   * badArgument if the kinds or degrees differ, or one is closed.
   */
  join(other: Curve): Curve {
    if (!(other instanceof Curve) || other.#mesh !== this.#mesh) {
      const given = other instanceof Curve ? 'one of another mesh' : shown(other);
      const sentence = `the other curve must be a curve of the same mesh, not ${given}`;
      throw new KarcherError('badArgument', sentence);
    }
    const second = other.#handle.call((target) => target);
    const parts = this.#call((curve) => curve.joined(second));
    return alike(this.#mesh, this.#options, parts);
  }

  /** Moves point `from` in the order so that its number becomes `to`, with its weight and beta. */
  movePointInOrder(from: number, to: number): void {
    const index = checkInteger(to, 'the new number of the control point');
    this.#edit('movePointInOrder', pointNumber(from), index);
  }

  /** Reverses the curve. A closed one keeps its first point. */
  reverse(): void {
    this.#edit('reverse');
  }

  /**
   * Changes the kind, and keeps the properties that the new kind uses, but not degree and knots.
   * Weights stay only if a B-spline becomes rational, or a rational curve a B-spline. `custom` is
   * only for curves that began with a basis.
   */
  setKind(kind: CurveKind): void {
    this.#edit('setKind', checkKind(kind));
  }

  /** Closes or opens the curve. Its control points stay. */
  setClosed(closed: boolean): void {
    this.#edit('setClosed', checkBoolean(closed, 'closed'));
  }

  /** Sets the weight of point `i`, for the kinds `bspline` and `rational`, without new fields. */
  setWeight(i: number, weight: number): void {
    this.#edit('setWeight', pointNumber(i), checkNumber(weight, 'the weight'));
  }

  /** Sets the weights of all points, as `setWeight` does for one. */
  setWeights(weights: ArrayLike<number>): void {
    this.#edit('setWeights', givenNumbers(weights, 'the weights'));
  }

  /** Sets the beta of point `i`, for the kind `barycentric`, without new fields. */
  setBeta(i: number, beta: number): void {
    this.#edit('setBeta', pointNumber(i), checkNumber(beta, 'the beta'));
  }

  /** Sets the betas of all points, as `setBeta` does for one. */
  setBetas(betas: ArrayLike<number>): void {
    this.#edit('setBetas', givenNumbers(betas, 'the betas'));
  }

  /**
   * The curve's point at a parameter. Throws `KarcherError` badArgument outside the curve.
   *
   * @example
   * ```ts
   * const { point, position } = curve.pointAt(0.5);
   * ```
   */
  pointAt(parameter: number): CurvePoint {
    checkNumber(parameter, 'the parameter');
    return withPoint(this.#call((curve) => curve.pointAt(parameter)));
  }

  /** The derivative at a parameter; at a joint, the derivative of the segment that starts there. */
  tangentAt(parameter: number): CurveTangent {
    checkNumber(parameter, 'the parameter');
    return withPoint(this.#call((curve) => curve.tangentAt(parameter)));
  }

  /** The curve's point nearest in space to a place. */
  nearest(place: VectorLike): NearestOnCurve {
    const numbers = toVector(place, 'the place');
    return withPoint(this.#call((curve) => curve.nearest(numbers)));
  }

  /** The length from the start to a parameter. At `segmentCount` it is the length of the curve. */
  lengthAt(parameter: number): number {
    checkNumber(parameter, 'the parameter');
    return this.#call((curve) => curve.lengthAt(parameter));
  }

  /** The point at a length from the start, on the polyline. */
  pointAtLength(length: number): CurvePoint {
    checkNumber(length, 'the length');
    return withPoint(this.#call((curve) => curve.pointAtLength(length)));
  }

  /**
   * `count` points with equal lengths of curve between them, on the polyline. They include both
   * ends of an open curve, and begin at the start of a closed one.
   *
   * @example
   * ```ts
   * const { face, bary } = curve.equallySpaced(10);
   * ```
   */
  equallySpaced(count: number): CurvePoints {
    checkInteger(count, 'the number of points');
    return this.#call((curve) => curve.equallySpaced(count));
  }

  /** Frees the memory. A second call has no effect. */
  dispose(): void {
    this.#handle.dispose();
  }

  /** @internal The number of edits, without those by `set`. */
  edits(): number {
    return this.#edits;
  }

  get #shape(): EngineCurveParts {
    this.#handle.check();
    this.#parts ??= this.#call((curve) => curve.value());
    return this.#parts;
  }

  get #told(): Facts {
    this.#handle.check();
    return this.#facts ?? this.view();
  }

  #filled(numbers: Float64Array): Float64Array {
    return numbers.length > 0
      ? numbers.slice()
      : new Float64Array(this.#shape.points.length / 4).fill(1);
  }

  #view(options: EngineViewOptions): CurveView {
    return this.#seen(this.#call((curve) => curve.view(options)));
  }

  #seen(bytes: Uint8Array): CurveView {
    const view = new CurveView({ bytes, statusNames: this.#handle.engine.statusNames });
    const { length, segmentCount, levels, times } = view;
    this.#facts = { length, segmentCount, levels, times };
    return view;
  }

  #guard<Result>(work: () => Result): Result {
    return this.#basis ? this.#basis.guard(work) : work();
  }

  #call<Result>(work: (curve: EngineCurve) => Result): Result {
    return this.#guard(() => this.#handle.call(work));
  }

  #edit<Name extends keyof EngineCurveEdits>(
    name: Name,
    ...args: Parameters<EngineCurve[Name]>
  ): ReturnType<EngineCurve[Name]> {
    type Edit = (...args: Parameters<EngineCurve[Name]>) => ReturnType<EngineCurve[Name]>;
    const result = this.#call((curve) => (curve[name] as Edit).apply(curve, args));
    this.#parts = undefined;
    this.#facts = undefined;
    this.#edits++;
    return result;
  }
}

/** A curve of the engine's data, with the options that determine its trace. */
const alike = (mesh: MeshHandle, options: CurveOptions, parts: EngineCurveParts): Curve =>
  new Curve(mesh, { ...tracingOf(options), ...optionsOfParts(parts) });
