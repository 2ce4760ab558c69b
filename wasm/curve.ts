import { checkInteger, checkOneOf } from './check.js';
import { type Engine, Handle } from './engine.js';
import type { EngineCurve, EngineMesh } from './karcher-engine.mjs';
import { engineFieldOptions } from './options.js';
import { toSurfacePoints, wirePoint, wirePoints } from './points.js';
import { toCurveSamples } from './samples.js';
import type {
  BridgedInterval,
  CurveKind,
  CurveOptions,
  CurveSamples,
  CurveTimes,
  Path,
  PointLike,
  SurfacePoint,
} from './types.js';

const kinds: readonly CurveKind[] = ['bspline', 'bezier'];
const defaultSamples = 128;

/**
 * A curve on a mesh, by control points that can be edited. After each edit it is traced again, as
 * far as the edit reaches, and is then the curve that its points would give anew.
 *
 * Arrays are copies, made at each access, for the caller to keep or transfer. Every edit throws
 * `KarcherError`, and changes nothing, where the curve would be none (tooFewPoints, unreachable,
 * and the errors of a point); everything throws disposed after `dispose`.
 */
export class Curve {
  readonly #engine: Engine;
  readonly #mesh: Handle<EngineMesh>;
  readonly #handle: Handle<EngineCurve>;
  readonly #forget: (curve: Curve) => void;
  #times: CurveTimes = { fields: 0, trace: 0, join: 0 };

  /** @internal `Mesh.curve` makes curves. `forget` is called when the curve is disposed of. */
  constructor(
    engine: Engine,
    mesh: Handle<EngineMesh>,
    options: CurveOptions,
    forget: (curve: Curve) => void,
  ) {
    const kind = checkOneOf(options.kind, kinds, 'the kind of a curve');
    const samples = checkInteger(options.samples ?? defaultSamples, 'the number of samples');
    const field = engineFieldOptions(options);
    const points = wirePoints(mesh, options.points);
    this.#engine = engine;
    this.#mesh = mesh;
    this.#forget = forget;
    const target = mesh.call((engineMesh) => engineMesh.curve(points, kind, samples, field));
    this.#handle = new Handle(engine, 'the curve', target);
    try {
      this.#update();
    } catch (error) {
      this.#handle.dispose();
      throw error;
    }
  }

  /** The control points. */
  get points(): SurfacePoint[] {
    return toSurfacePoints(this.#handle.call((curve) => curve.points()));
  }

  get samples(): CurveSamples {
    return toCurveSamples(
      this.#engine,
      this.#handle.call((curve) => curve.samples()),
    );
  }

  /** Where and why the curve is no center of mass. */
  get bridged(): BridgedInterval[] {
    return this.#handle.call((curve) => curve.bridged());
  }

  /**
   * x, y, z of the curve's vertices for drawing, on the surface: the samples, joined by geodesics.
   */
  get polyline(): Float32Array {
    return new Float32Array(this.path.polyline);
  }

  /** The curve's length, and its vertices in double precision. */
  get path(): Path {
    return this.#handle.call((curve) => curve.path());
  }

  /** A number for each vertex of the polyline: 1 where the piece that leads to it is bridged. */
  get polylineStatus(): Uint8Array {
    return this.#handle.call((curve) => curve.polylineStatus());
  }

  get length(): number {
    return this.#handle.call((curve) => curve.length());
  }

  /** How long the last edit took, or the making of the curve. */
  get times(): CurveTimes {
    this.#handle.check();
    return { ...this.#times };
  }

  /** Moves control point `i`: its field and the segments that it touches are computed again. */
  movePoint(i: number, point: PointLike): void {
    const index = checkInteger(i, 'the number of the control point');
    const wire = wirePoint(this.#mesh, point);
    this.#edit((curve) => curve.movePoint(index, wire));
  }

  /** Appends a control point. */
  addPoint(point: PointLike): void {
    const wire = wirePoint(this.#mesh, point);
    this.#edit((curve) => curve.insertPoint(curve.pointCount(), wire));
  }

  /** Makes the point the one of number `i`; those from there on move up by one. */
  insertPoint(i: number, point: PointLike): void {
    const index = checkInteger(i, 'the number of the control point');
    const wire = wirePoint(this.#mesh, point);
    this.#edit((curve) => curve.insertPoint(index, wire));
  }

  removePoint(i: number): void {
    const index = checkInteger(i, 'the number of the control point');
    this.#edit((curve) => curve.removePoint(index));
  }

  setKind(kind: CurveKind): void {
    checkOneOf(kind, kinds, 'the kind of a curve');
    this.#edit((curve) => curve.setKind(kind));
  }

  /**
   * Traces all segments again with the fields as they are.
   * @internal
   */
  retrace(): void {
    this.#edit((curve) => curve.retrace());
  }

  /** Gives the memory back. Safe to repeat. */
  dispose(): void {
    this.#handle.dispose();
    this.#forget(this);
  }

  #edit(change: (curve: EngineCurve) => void): void {
    this.#handle.call(change);
    this.#update();
  }

  #update(): void {
    const start = performance.now();
    this.#handle.call((curve) => curve.updateFields());
    const fieldsDone = performance.now();
    this.#handle.call((curve) => curve.trace());
    const traceDone = performance.now();
    this.#handle.call((curve) => curve.join());
    this.#times = {
      fields: fieldsDone - start,
      trace: traceDone - fieldsDone,
      join: performance.now() - traceDone,
    };
  }
}
