import type {
  CenterOfMass,
  CenterOptions,
  CircleOptions,
  CurveOptions,
  EllipseOptions,
  ErrorCode,
  FieldOptions,
  IsolineOptions,
  LongWorkOptions,
  MeshInfo,
  PointLike,
  Solver,
} from 'karcher';
import type { MeshSource } from '../model/meshes';
import type {
  Measured,
  TracedCurve,
  TracedIsolines,
  TracedPath,
  TracedStraightestPath,
} from '../model/traced';
import type { CallName, Calls, CurveWork, LoadedMesh, Reply, Request } from './protocol';
import type { Reshape, Reshaped } from './reshape';

/** A failure that the engine names, or `stopped` where its worker ended. */
export class EngineError extends Error {
  override name = 'EngineError';
  constructor(
    message: string,
    readonly code: ErrorCode | 'stopped' | undefined,
  ) {
    super(message);
  }
}

interface Pending {
  resolve(result: unknown): void;
  reject(error: Error): void;
  work: LongWorkOptions;
}

/**
 * A surface in a worker of its own, under the engine's names: every call returns a promise, and
 * `close` ends the worker and every call that is under way. Large arrays are transferred.
 */
export class EngineClient {
  readonly #worker = new Worker(new URL('./engine.ts', import.meta.url), { type: 'module' });
  readonly #pending = new Map<number, Pending>();
  #calls = 0;
  #closed = false;
  #mesh: LoadedMesh | null = null;
  /** Called when the worker ends by itself, as when memory runs out. */
  onStopped: (() => void) | null = null;

  private constructor() {
    this.#worker.onmessage = ({ data }: MessageEvent<Reply>) => this.#receive(data);
    this.#worker.onerror = (event) => {
      event.preventDefault();
      this.#break(event.message || 'the engine could not start');
    };
  }

  /** Starts a worker and makes the surface there; ends the worker if that fails or is aborted. */
  static async load(source: MeshSource, work: LongWorkOptions = {}): Promise<EngineClient> {
    const client = new EngineClient();
    const abort = () => client.close();
    work.signal?.addEventListener('abort', abort, { once: true });
    try {
      work.signal?.throwIfAborted();
      client.#mesh = await client.#call('load', [source], { progress: work.progress });
      return client;
    } catch (error) {
      client.close();
      throw work.signal?.aborted ? work.signal.reason : error;
    } finally {
      work.signal?.removeEventListener('abort', abort);
    }
  }

  get info(): MeshInfo {
    return this.#mesh!.info;
  }

  /** x, y, z of the vertices, in the caller's order. */
  positions(): Float64Array {
    return this.#mesh!.positions;
  }

  /** Vertices of the triangles, in the caller's order. */
  triangles(): Int32Array {
    return this.#mesh!.triangles;
  }

  prepare(options: FieldOptions, work: LongWorkOptions = {}): Promise<void> {
    return this.#call('prepare', [options], work);
  }

  curve(options: CurveOptions, work?: CurveWork): Promise<TracedCurve> {
    return this.#call('curve', [options, work]);
  }

  knots(from: CurveOptions, to: CurveOptions): Promise<number[]> {
    return this.#call('knots', [from, to]);
  }

  measure(options: CurveOptions, near: [number, number, number]): Promise<Measured> {
    return this.#call('measure', [options, near]);
  }

  reshape(options: CurveOptions, edit: Reshape): Promise<Reshaped> {
    return this.#call('reshape', [options, edit]);
  }

  circle(center: PointLike, options: CircleOptions): Promise<TracedCurve> {
    return this.#call('circle', [center, options]);
  }

  ellipse(center: PointLike, options: EllipseOptions): Promise<TracedCurve> {
    return this.#call('ellipse', [center, options]);
  }

  isolines(center: PointLike, options: IsolineOptions): Promise<TracedIsolines> {
    return this.#call('isolines', [center, options]);
  }

  centerOfMass(
    points: PointLike[],
    weights: number[],
    options?: CenterOptions,
  ): Promise<CenterOfMass> {
    return this.#call('centerOfMass', [points, weights, options]);
  }

  distance(point: PointLike, options?: { solver?: Solver; rings?: number }): Promise<Float64Array> {
    return this.#call('distance', [point, options]);
  }

  shortestPath(from: PointLike, to: PointLike): Promise<TracedPath> {
    return this.#call('shortestPath', [from, to]);
  }

  straightest(
    from: PointLike,
    direction: [number, number, number],
    length: number,
  ): Promise<TracedStraightestPath> {
    return this.#call('straightest', [from, direction, length]);
  }

  get closed(): boolean {
    return this.#closed;
  }

  close(): void {
    this.#stop(new EngineError('the surface was closed', 'stopped'));
  }

  #break(message: string): void {
    this.#stop(new EngineError(message, 'stopped'));
    this.onStopped?.();
  }

  #stop(error: EngineError): void {
    this.#closed = true;
    this.#worker.terminate();
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    for (const { reject } of pending) reject(error);
  }

  #call<Name extends CallName>(
    call: Name,
    args: Parameters<Calls[Name]>,
    work: LongWorkOptions = {},
  ): Promise<ReturnType<Calls[Name]>> {
    if (this.#closed) {
      return Promise.reject(new EngineError('the surface was closed', 'stopped'));
    }
    const id = ++this.#calls;
    work.signal?.addEventListener('abort', () => this.#send({ id, call: 'cancel' }), {
      once: true,
    });
    return new Promise((resolve, reject) => {
      this.#pending.set(id, { resolve: resolve as (result: unknown) => void, reject, work });
      this.#send({ id, call, args } as Request);
    });
  }

  #send(request: Request): void {
    if (!this.#closed) this.#worker.postMessage(request);
  }

  #receive(reply: Reply): void {
    const pending = this.#pending.get(reply.id);
    if (!pending) return;
    if ('progress' in reply) {
      pending.work.progress?.(reply.progress, reply.stage);
      return;
    }
    this.#pending.delete(reply.id);
    if ('result' in reply) pending.resolve(reply.result);
    else if (pending.work.signal?.aborted) pending.reject(pending.work.signal.reason);
    else pending.reject(new EngineError(reply.failure.message, reply.failure.code));
    if ('failure' in reply && reply.failure.fatal) this.#break(reply.failure.message);
  }
}
