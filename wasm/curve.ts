/// <reference lib="esnext.disposable" preserve="true" />
import { checkBoolean, checkInteger, checkNumber, checkOptions, shown, toVector } from './check.js';
import {
  checkKind,
  engineValue,
  givenNumbers,
  mirrored,
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

/** The properties that a curve keeps from its last view. */
type Facts = Pick<CurveView, 'length' | 'segmentCount' | 'levels' | 'times'>;

/**
 * A curve on a mesh, with control points that can be edited. An edit retraces only the part that it
 * affects. The curve then equals a new one with the same points.
 *
 * A parameter runs from 0 to `segmentCount`: it is the number of a segment plus t in [0, 1]. On a
 * closed curve it may also be negative or larger than `segmentCount`.
 *
 * If the result would not be a valid curve, an edit changes nothing and throws `KarcherError`
 * (tooFewPoints, unreachable, and the errors of a point). After `dispose`, all methods and
 * properties throw disposed.
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
  /** The curve's data, as the engine last returned them; undefined after an edit. */
  #parts: EngineCurveParts | undefined;
  #facts: Facts | undefined;
  #edits = 0;

  /** @internal `Mesh.curve` creates curves. */
  constructor(mesh: MeshHandle, options: CurveOptions) {
    checkOptions(options, curveOptionNames);
    const basis = ownBasis(options.basis);
    const value = engineValue(options, basis);
    this.#mesh = mesh;
    this.#options = { ...options };
    this.#basis = basis;
    this.#handle = this.#guard(() => mesh.made('the curve', (target) => target.curve(value)));
  }

  /**
   * The curve's value: options from which the curve can be created again. It omits numbers that the
   * kind does not use, and options for samples, levels and fields that were not given.
   */
  value(): CurveValue {
    const parts = this.#shape;
    const { basis } = this.#options;
    const own = parts.kind === 'custom' && basis !== undefined && { basis };
    return { ...tracingOf(this.#options), ...optionsOfParts(parts), ...own };
  }

  /**
   * Changes the curve into the one that a value describes, and returns its view. Fields of
   * unchanged points remain, and so do segments whose points and numbers (such as weights) are
   * unchanged. Every other edit has the effect of a call of `set`. To drag points, pass the
   * `drawnLegs` of the previous view as `legs`. Throws what `Mesh.curve` throws.
   */
  set(value: CurveOptions, options: PolylineOptions = {}): CurveView {
    checkOptions(value, curveOptionNames);
    const basis = ownBasis(value.basis, this.#basis);
    const next = engineValue(value, value.basis && basis);
    const wanted = { inDouble: inDouble(options), withPoints: false };
    const set = () => this.#handle.call((curve) => curve.set(next, wanted));
    const bytes = basis ? basis.guard(set) : set();
    this.#options = { ...value };
    this.#basis = basis;
    this.#parts = undefined;
    return this.#seen(bytes);
  }

  /** All data for drawing the curve, in one buffer. Its polyline has 32-bit numbers by default. */
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
   * The intervals in which the curve's points are not centers of mass, with the reasons.
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
   * A number for each point of the path: 1 if the piece before it does not consist of centers of
   * mass, such as on a bridge; else 0.
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

  /** One weight for each point; all 1 if the curve has no weights. */
  weights(): Float64Array {
    return this.#filled(this.#shape.weights);
  }

  /** One beta for each point; all 1 if the curve has no betas. */
  betas(): Float64Array {
    return this.#filled(this.#shape.betas);
  }

  /** The number of segments. Parameters run from 0 to this number. */
  get segmentCount(): number {
    return this.#told.segmentCount;
  }

  /** The number of levels of the curve, even if `levels: 'auto'` chose it. */
  get levels(): number {
    return this.#told.levels;
  }

  /**
   * An estimate of the largest distance of the curve from the curve with `levels: 0`, in the mesh's
   * units; 0 without levels. It is null if the curve with `levels: 0` is not safe (see
   * `CurveOptions.levels`), since the distance then has no meaning.
   */
  get deviation(): number | null {
    const deviation = this.#handle.call((curve) => curve.deviation());
    return deviation >= 0 ? deviation : null;
  }

  /** The number of fields computed since the curve was created. Most edits add few fields. */
  get fieldsComputed(): number {
    return this.#handle.call((curve) => curve.fieldsComputed());
  }

  /** The durations of the steps of the last edit, or of the curve's creation. */
  times(): CurveTimes {
    return { ...this.#told.times };
  }

  /**
   * Moves control point `i`. The curve recomputes the point's field and the segments that the point
   * affects.
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
   * Moves control point `i` as a hand drags it. The legs of the control polygon that meet at the
   * point continue from their present course, even if they are then not shortest, so that the curve
   * moves with the point. They keep this course until another kind of edit moves a point at one of
   * their ends. The legs are part of the curve's value.
   */
  dragPoint(i: number, point: PointLike): void {
    this.#edit('dragPoint', pointNumber(i), wirePoint(point));
  }

  /**
   * Replaces the control points. The fields of points that stay at their places remain. If the
   * number of points changes, weights, betas and custom knots are not allowed.
   */
  setPoints(points: readonly PointLike[]): void {
    this.#edit('setPoints', 0, wirePoints(points));
  }

  /** Appends a control point. */
  addPoint(point: PointLike): void {
    this.insertPoint(
      this.#call((curve) => curve.pointCount()),
      point,
    );
  }

  /**
   * Inserts a control point with the number `i`. The numbers of the points after it grow by one.
   */
  insertPoint(i: number, point: PointLike): void {
    this.#edit('insertPoint', pointNumber(i), wirePoint(point));
  }

  /** Removes control point `i`. The numbers of later points fall by one. */
  removePoint(i: number): void {
    this.#edit('removePoint', pointNumber(i));
  }

  /**
   * Adds a control point at a parameter, and returns the point's number. On a plane the curve stays
   * unchanged, elsewhere nearly so. A B-spline gets a knot at the parameter, and its knots become
   * custom ones. A curve of one segment rises by one degree and gets new inner points. Other kinds
   * get a point on the curve; a Catmull-Rom curve changes a little. Throws `KarcherError`
   * badArgument for the kind `custom`, and if the parameter has a control point or too many knots.
   */
  insertOnCurve(parameter: number): number {
    return this.#edit('insertOnCurve', 0, checkNumber(parameter, 'the parameter'));
  }

  /**
   * Two new curves: the parts of this one before and after a parameter. A closed B-spline,
   * Catmull-Rom curve or polyline gives one new curve, open at the parameter. On a plane the new
   * curves equal the parts exactly, elsewhere nearly. New Catmull-Rom curves deviate a little near
   * the cut, since they do not depend on points beyond it. This curve stays unchanged. Throws
   * `KarcherError` badArgument at the ends of an open curve or of a curve of one segment, and for
   * the kind `custom`.
   */
  split(parameter: number): Curve[] {
    checkNumber(parameter, 'the parameter');
    return this.#call((curve) => curve.splitAt(parameter)).map((parts) =>
      alike(this.#mesh, this.#options, parts),
    );
  }

  /**
   * A new curve along this one and then along another one of the same kind. B-splines and Bezier
   * curves become one B-spline, with a geodesic between the two if they do not meet. Other curves
   * become a curve through the points of both, with the parametrization of this one. The new curve
   * deviates a little where the two meet. Both curves stay unchanged. Throws `KarcherError`
   * badArgument if the kinds or the B-splines' degrees differ, a Bezier degree exceeds 5, a curve
   * is closed, or the kind is `custom`; unreachable if the curves lie on different components.
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

  /** Gives control point `from` the number `to`. The point keeps its weight and beta. */
  movePointInOrder(from: number, to: number): void {
    const index = checkInteger(to, 'the new number of the control point');
    this.#edit('movePointInOrder', pointNumber(from), index);
  }

  /** Reverses the curve, and mirrors its own basis. A closed curve keeps its first point. */
  reverse(): void {
    this.#edit('reverse');
    this.#options = { ...this.#options, basis: mirrored(this.#options.basis) };
  }

  /**
   * Changes the kind. Weights remain only if the kind changes between `bspline` and `rational`.
   * Degree, knots and parametrization become the defaults. `custom` is only for curves that were
   * created with a basis.
   */
  setKind(kind: CurveKind): void {
    this.#edit('setKind', 0, checkKind(kind));
  }

  /** Closes or opens the curve. Its control points stay. */
  setClosed(closed: boolean): void {
    this.#edit('setClosed', 0, checkBoolean(closed, 'closed'));
  }

  /** Sets the weight of point `i`, for the kinds `bspline` and `rational`, without new fields. */
  setWeight(i: number, weight: number): void {
    this.#edit('setWeight', pointNumber(i), checkNumber(weight, 'the weight'));
  }

  /** Sets the weights of all points, as `setWeight` does for one. */
  setWeights(weights: ArrayLike<number>): void {
    this.#edit('setWeights', 0, givenNumbers(weights, 'the weights'));
  }

  /** Sets the beta of point `i`, for the kind `barycentric`, without new fields. */
  setBeta(i: number, beta: number): void {
    this.#edit('setBeta', pointNumber(i), checkNumber(beta, 'the beta'));
  }

  /** Sets the betas of all points, as `setBeta` does for one. */
  setBetas(betas: ArrayLike<number>): void {
    this.#edit('setBetas', 0, givenNumbers(betas, 'the betas'));
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

  /** The point of the curve that is nearest to a place in space. */
  nearest(place: VectorLike): NearestOnCurve {
    const numbers = toVector(place, 'the place');
    return withPoint(this.#call((curve) => curve.nearest(numbers)));
  }

  /** The length from the start to a parameter. At `segmentCount` it is the length of the curve. */
  lengthAt(parameter: number): number {
    checkNumber(parameter, 'the parameter');
    return this.#call((curve) => curve.lengthAt(parameter));
  }

  /** The point of the polyline at a length from the start. */
  pointAtLength(length: number): CurvePoint {
    checkNumber(length, 'the length');
    return withPoint(this.#call((curve) => curve.pointAtLength(length)));
  }

  /**
   * `count` points of the polyline, with equal lengths between neighbors. They include both ends of
   * an open curve, and begin at the start of a closed one.
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

  #edit<Name extends keyof EngineCurveEdits>(name: Name, i = 0, to?: EngineCurveEdits[Name]) {
    const result = this.#call((curve) => curve.edit(name, i, to));
    this.#parts = undefined;
    this.#facts = undefined;
    this.#edits++;
    return result;
  }
}

/** A new curve from the engine's data, with those of the options that determine a curve's trace. */
const alike = (mesh: MeshHandle, options: CurveOptions, parts: EngineCurveParts): Curve =>
  new Curve(mesh, { ...tracingOf(options), ...optionsOfParts(parts) });
