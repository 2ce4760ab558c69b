import type { LongWorkOptions, MeshInfo } from 'karcher';
import { WorkerClient } from 'karcher/own-worker';
import type { MeshSource } from '../model/meshes';
import type { Calls } from './engine';

export { KarcherError } from 'karcher/own-worker';

type Call<Name extends keyof Calls> = (
  ...args: Parameters<Calls[Name]>
) => Promise<Awaited<ReturnType<Calls[Name]>>>;

/**
 * A surface in a worker of its own. `close` ends the worker and every call that is under way; every
 * call fails with a `KarcherError`.
 */
export class EngineClient {
  readonly #worker = new WorkerClient(
    new Worker(new URL('./engine.ts', import.meta.url), { type: 'module' }),
  );
  #mesh: Awaited<ReturnType<Calls['load']>> | null = null;
  /** Called when the worker ends by itself, as when memory runs out. */
  onStopped: (() => void) | null = null;

  private constructor() {
    this.#worker.onFatal = () => this.onStopped?.();
  }

  /** Starts a worker and makes the surface there; ends the worker if that fails or is aborted. */
  static async load(source: MeshSource, work: LongWorkOptions = {}): Promise<EngineClient> {
    const client = new EngineClient();
    try {
      client.#mesh = await client.#call('load')(source, work);
      return client;
    } catch (error) {
      client.close();
      throw error;
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

  readonly prepare = this.#call('prepare');
  readonly curve = this.#call('curve');
  readonly knots = this.#call('knots');
  readonly measure = this.#call('measure');
  readonly reshape = this.#call('reshape');
  readonly circle = this.#call('circle');
  readonly ellipse = this.#call('ellipse');
  readonly isolines = this.#call('isolines');
  readonly centerOfMass = this.#call('centerOfMass');
  readonly distance = this.#call('distance');
  readonly shortestPath = this.#call('shortestPath');
  readonly straightest = this.#call('straightest');

  get closed(): boolean {
    return this.#worker.disposed;
  }

  close(): void {
    this.#worker.dispose();
  }

  #call<Name extends keyof Calls>(name: Name): Call<Name> {
    return ((...args: unknown[]) => this.#worker.call(name, args)) as Call<Name>;
  }
}
