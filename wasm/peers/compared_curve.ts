import { checkInteger } from '../check.js';
import type { Handle } from '../engine.js';
import { wirePoint } from '../points.js';
import { pause, sliceTime } from '../prepare.js';
import type { CurveSamples, LongWorkOptions, PointLike } from '../types.js';
import { CurveView } from '../view.js';
import type { EngineComparedCurve } from './karcher-peers.mjs';
import type { ComparedLine, LogMapCounts, MethodCurve } from './types.js';

const all = 0x7fffffff;

/** A curve by one of the methods, until `dispose`. */
export class ComparedCurve implements MethodCurve {
  readonly #handle: Handle<EngineComparedCurve>;
  #fieldsMs = 0;

  /** @internal `PreparedMethod.curve` creates curves. */
  constructor(handle: Handle<EngineComparedCurve>) {
    this.#handle = handle;
  }

  /**
   * Replaces a control point. The next `trace` traces again the segments that the point affects.
   */
  movePoint(i: number, point: PointLike): void {
    const index = checkInteger(i, 'the number of the control point');
    const wire = wirePoint(point);
    this.#handle.call((curve) => curve.movePoint(index, wire));
  }

  /**
   * Sets the start of each segment's searches. By default it is the point of the largest weight.
   */
  startAt(point: PointLike): void {
    const wire = wirePoint(point);
    this.#handle.call((curve) => curve.startAt(wire));
  }

  /** Computes all missing fields and samples in one call. Returns the duration in milliseconds. */
  finish(): number {
    const start = performance.now();
    while (!this.#handle.call((curve) => curve.advance(all)));
    return performance.now() - start;
  }

  /**
   * Does the same as `finish` in slices, with pauses between them. The returned duration excludes
   * the pauses. `work.progress` receives the completed fraction of the samples. Rejects with the
   * signal's reason.
   */
  async trace({ progress, signal }: LongWorkOptions = {}): Promise<number> {
    const total = this.#handle.call((curve) => curve.samplesLeft());
    let worked = 0;
    let left = total;
    this.#fieldsMs = 0;
    // Batches grow while they are quick: one sample can take a second, but most take microseconds.
    let batch = 1;
    for (let done = false; !done; ) {
      signal?.throwIfAborted();
      const start = performance.now();
      let now = start;
      while (!done && now - start < sliceTime) {
        const before = now;
        done = this.#handle.call((curve) => curve.advance(batch));
        now = performance.now();
        // A step computes one field, or a batch of samples.
        const leftBefore = left;
        left = this.#handle.call((curve) => curve.samplesLeft());
        if (left === leftBefore) this.#fieldsMs += now - before;
        else if (now - before < 1) batch = Math.min(2 * batch, all);
      }
      worked += now - start;
      progress?.(1 - left / Math.max(total, 1), 'samples');
      if (!done) await pause();
    }
    return worked;
  }

  /** The milliseconds that the fields of the last `trace` took; 0 for methods without fields. */
  get fieldsMs(): number {
    return this.#fieldsMs;
  }

  /** The samples found so far, segment by segment. */
  samples(): CurveSamples {
    return this.#view(this.#handle.call((curve) => curve.samples())).samples;
  }

  /**
   * The number of samples found so far that the method's own authors would not accept. The library
   * of the heat methods accepts a sample if a step is shorter than a third of the root of the face's
   * area. A step is the weighted sum of logarithms; where it does not lower the energy, the library
   * halves it up to seven times. Here a sample converges only at 1e-6 mean edges. For other methods
   * this is the number of samples that did not converge.
   */
  lostByOwnRule(): number {
    return this.#handle.call((curve) => curve.lostByOwnRule());
  }

  /**
   * The numbers of computed and of requested log maps of a heat method, and the milliseconds that
   * the computed ones took. A method computes one log map for each vertex that a search visits. The
   * library of the method's authors computes a map at each request. Null for other methods.
   */
  logMaps(): LogMapCounts | null {
    return this.#handle.call((curve) => curve.logMaps());
  }

  /** The samples joined by geodesics. */
  line(): ComparedLine {
    const view = this.#view(this.#handle.call((curve) => curve.joined()));
    return { path: view.path(), unconverged: view.unconverged };
  }

  /** Frees the memory. A second call has no effect. */
  dispose(): void {
    this.#handle.dispose();
  }

  #view(bytes: Uint8Array): CurveView {
    return new CurveView({ bytes, statusNames: this.#handle.engine.statusNames });
  }
}
