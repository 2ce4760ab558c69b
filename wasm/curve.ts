/// <reference lib="esnext.disposable" preserve="true" />
import { checkBoolean, checkInteger, checkNumber, checkOptions, shown, toVector } from './check.js';
import {
  checkKind,
  engineValue,
  givenNumbers,
  OwnBasis,
  optionsOfParts,
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
import { curveOptionNames } from './options.js';
import { Path } from './path.js';
import type { CurveLeg } from './path_types.js';
import { toSurfacePoints, wirePoint, wirePoints, withPoint } from './points.js';
import { inDouble } from './polyline.js';
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

/** What costs nothing to tell. */
type Facts = Pick<CurveView, 'length' | 'segmentCount' | 'levels' | 'times'>;

/**
 * A curve on a mesh, by control points that can be edited. After each edit it is traced again, as
 * far as the edit reaches, and is then the curve that its points would give anew.
 *
 * Its parameter runs from 0 to `segmentCount`: the number of a segment plus t in [0, 1]. That of a
 * closed curve may go round.
 *
 * Every edit throws `KarcherError`, and changes nothing, where the curve would be none (tooFewPoints,
 * unreachable, and the errors of a point); everything throws disposed after `dispose`.
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
  /** What it is, and what costs nothing to tell of it, until the next edit. */
  #parts: EngineCurveParts | undefined;
  #facts: Facts | undefined;
  #edits = 0;

  /** @internal `Mesh.curve` makes curves. */
  constructor(mesh: MeshHandle, options: CurveOptions) {
    checkOptions(options, curveOptionNames);
    const basis = options.basis === undefined ? undefined : new OwnBasis(options.basis);
    const value = engineValue(options, basis);
    this.#mesh = mesh;
    this.#options = { ...options };
    this.#basis = basis;
    this.#handle = this.#guard(() => mesh.made('the curve', (target) => target.curve(value)));
  }

  /**
   * What the curve is: options that make it again. Numbers that it has by default are left out, and
   * what its kind has no use for.
   */
  value(): CurveValue {
    const parts = this.#shape;
    const { basis } = this.#options;
    const own = parts.kind === 'custom' && basis !== undefined && { basis };
    return { ...tracingOf(this.#options), ...optionsOfParts(parts), ...own };
  }

  /**
   * Makes it the curve of a value, and returns its view. What is as before is kept: the fields of
   * points that stay, and the segments that the same points and numbers make; so this is what all
   * edits come to. For the curve with dragged points give it the `drawnLegs` of the view before as
   * `legs`. Throws as `Mesh.curve` does.
   */
  set(value: CurveOptions, options: PolylineOptions = {}): CurveView {
    checkOptions(value, curveOptionNames);
    const basis =
      value.basis === undefined || value.basis === this.#options.basis
        ? this.#basis
        : new OwnBasis(value.basis);
    const next = engineValue(value, value.basis && basis);
    const wanted = { inDouble: inDouble(options), withPoints: false };
    const set = () => this.#handle.call((curve) => curve.set(next, wanted));
    const bytes = basis ? basis.guard(set) : set();
    this.#options = { ...value };
    if (value.basis !== undefined) this.#basis = basis;
    this.#parts = undefined;
    return this.#seen(bytes);
  }

  /** All that is seen of the curve, its polyline in 32 bits by default, in one buffer. */
  view(options: PolylineOptions = {}): CurveView {
    return this.#view({ inDouble: inDouble(options), withPoints: false });
  }

  /** The control points. */
  points(): SurfacePoint[] {
    return toSurfacePoints(this.#shape.points);
  }

  /** The samples: the centers of mass of which the curve is made, and how the search for each ended. */
  samples(): CurveSamples {
    return this.view().samples;
  }

  /**
   * Where and why the curve is no center of mass.
   *
   * @example
   * ```ts
   * for (const { t0, t1, reason } of curve.bridged()) console.log(t0, t1, reason);
   * ```
   */
  bridged(): BridgedInterval[] {
    return this.view().bridged;
  }

  /** The legs of the control polygon as they lie on the surface. */
  legs(): CurveLeg[] {
    return this.#call((curve) => curve.legs()).map(({ path, shorter }) => ({
      path: new Path(path),
      ...(shorter && { shorter: new Path(shorter) }),
    }));
  }

  /** The samples, joined on the surface as `geometry` says. */
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
   * A number for each point of the path: 1 where the piece that leads to it is no center of mass, as
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

  /** A B-spline's knots; of other kinds none. */
  knots(): Float64Array {
    return this.view().knots.slice();
  }

  /** The parametrization of a Catmull-Rom curve. */
  get parametrization(): Parametrization {
    return this.#shape.centripetal ? 'centripetal' : 'uniform';
  }

  /** One weight for each point, also of kinds that do not use weights. */
  weights(): Float64Array {
    return this.#filled(this.#shape.weights);
  }

  /** A beta a point, whether or not the kind has a use for them. */
  betas(): Float64Array {
    return this.#filled(this.#shape.betas);
  }

  /** The number of segments; parameters run from 0 to it. */
  get segmentCount(): number {
    return this.#told.segmentCount;
  }

  /** The number of levels of the curve, also where `levels: 'auto'` chose it. */
  get levels(): number {
    return this.#told.levels;
  }

  /**
   * How far the levels move the curve at most from that of `levels: 0`, by estimate, in the mesh's
   * units: 0 without levels. null where that curve is not safe, so that its distance means nothing.
   */
  get deviation(): number | null {
    const deviation = this.#handle.call((curve) => curve.deviation());
    return deviation >= 0 ? deviation : null;
  }

  /** How many fields were computed since the curve was made: what edits should spare. */
  get fieldsComputed(): number {
    return this.#handle.call((curve) => curve.fieldsComputed());
  }

  /** How long the last edit took, or the making of the curve. */
  times(): CurveTimes {
    return { ...this.#told.times };
  }

  /**
   * Moves control point `i`: its field and the segments that it touches are computed again.
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
   * Moves control point `i` as a hand does: the legs of the control polygon that meet at it are
   * continued from where they lie, whether or not they stay the shortest, so that the curve moves
   * with the point. They stay so until a point at one of their ends is moved otherwise, and are part
   * of the curve's value.
   */
  dragPoint(i: number, point: PointLike): void {
    this.#edit('dragPoint', pointNumber(i), wirePoint(point));
  }

  /**
   * Replaces the control points; the fields of those that stay where they are are kept. With other
   * numbers of points than before, there must be no weights, betas or knots of your own.
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

  /** Inserts the point as number `i`; the numbers of those from there on grow by one. */
  insertPoint(i: number, point: PointLike): void {
    this.#edit('insertPoint', pointNumber(i), wirePoint(point));
  }

  /** Removes control point `i`; those after it move down by one. */
  removePoint(i: number): void {
    this.#edit('removePoint', pointNumber(i));
  }

  /**
   * Puts a control point in on the curve at a parameter, and returns its number; the curve stays as
   * it is on a plane, and nearly elsewhere. A B-spline gets a knot there, and keeps its knots from
   * then on; of curves of one segment the degree is raised, so that all inner points are new; curves
   * through their points get one more, which changes a Catmull-Rom curve a little.
   *
   * Throws `KarcherError` badArgument where none can be put in.
   */
  insertOnCurve(parameter: number): number {
    return this.#edit('insertOnCurve', checkNumber(parameter, 'the parameter'));
  }

  /**
   * New curves that run along this one before and after a parameter; of a closed B-spline,
   * Catmull-Rom curve or polyline one, opened there. On a plane they are the curve's own parts, and
   * nearly elsewhere; those of a Catmull-Rom curve leave it a little next to the cut, where they do
   * not know of the points beyond. This curve stays.
   *
   * Throws `KarcherError` badArgument at the ends of an open curve.
   */
  split(parameter: number): Curve[] {
    checkNumber(parameter, 'the parameter');
    return this.#call((curve) => curve.splitAt(parameter)).map((parts) =>
      alike(this.#mesh, this.#options, parts),
    );
  }

  /**
   * A new curve that runs along this one and on along another of its kind, with a geodesic between
   * them where they do not meet. Bezier curves become a B-spline; curves through their points, and
   * barycentric ones, the curve through the points of both, with this one's parametrization, which
   * leaves both a little where they meet. Both curves stay.
   *
   * Throws `KarcherError` badArgument where the kinds or degrees differ, or one is closed.
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

  /** Makes point `from` the one of number `to`, with its weight and beta. */
  movePointInOrder(from: number, to: number): void {
    const index = checkInteger(to, 'the new number of the control point');
    this.#edit('movePointInOrder', pointNumber(from), index);
  }

  /** Runs the curve backwards. A closed one keeps its first point. */
  reverse(): void {
    this.#edit('reverse');
  }

  /**
   * Keeps what the kind has a use for: degree and knots are dropped, and weights are of a B-spline that
   * becomes rational, or the other way round, alone. `custom` is only for curves that were made with a
   * basis.
   */
  setKind(kind: CurveKind): void {
    this.#edit('setKind', checkKind(kind));
  }

  /** Closes the curve, or opens it; its control points stay. */
  setClosed(closed: boolean): void {
    this.#edit('setClosed', checkBoolean(closed, 'closed'));
  }

  /** Sets the weight of point `i`, for the kinds `bspline` and `rational`. No field is computed. */
  setWeight(i: number, weight: number): void {
    this.#edit('setWeight', pointNumber(i), checkNumber(weight, 'the weight'));
  }

  /** Sets the weights of all points, as `setWeight` does one. */
  setWeights(weights: ArrayLike<number>): void {
    this.#edit('setWeights', givenNumbers(weights, 'the weights'));
  }

  /** Sets the beta of point `i`, for the kind `barycentric`. No field is computed. */
  setBeta(i: number, beta: number): void {
    this.#edit('setBeta', pointNumber(i), checkNumber(beta, 'the beta'));
  }

  /** Sets the betas of all points, as `setBeta` does one. */
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

  /** The derivative at a parameter; at a joint that of the segment that starts there. */
  tangentAt(parameter: number): CurveTangent {
    checkNumber(parameter, 'the parameter');
    return withPoint(this.#call((curve) => curve.tangentAt(parameter)));
  }

  /** The curve's point nearest in space to a place. */
  nearest(place: VectorLike): NearestOnCurve {
    const numbers = toVector(place, 'the place');
    return withPoint(this.#call((curve) => curve.nearest(numbers)));
  }

  /** The length from the start to a parameter; that of the curve at `segmentCount`. */
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
   * `count` points with the same length of curve between them, on the polyline: an open curve's ends
   * included, around a closed one from its start.
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

  /** Gives the memory back. Safe to repeat. */
  dispose(): void {
    this.#handle.dispose();
  }

  /** @internal How many times it was edited, but by `set`. */
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

/** A curve of the engine's parts, traced as options say. */
const alike = (mesh: MeshHandle, options: CurveOptions, parts: EngineCurveParts): Curve =>
  new Curve(mesh, { ...tracingOf(options), ...optionsOfParts(parts) });
