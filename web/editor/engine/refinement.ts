import { EngineClient } from '../../worker/client';
import { Newest } from './newest';

/** A computation on a given engine, and the function that takes its answer. */
export interface RefinementJob<Result> {
  compute(client: EngineClient): Promise<Result>;
  /** The revision that it belongs to; answers to another one are dropped. */
  revision: number;
  done(result: Result): void;
  failed(error: unknown): void;
}

/** The number of times that an engine that stopped by itself is started again for one surface. */
const mostRestarts = 2;

/**
 * The exact curve behind the fast one. It comes from an engine of its own, with its own copy of the
 * surface, made when it is first needed: so nothing that is computed here is ever in the way of an
 * edit, and what an edit overtakes is dropped.
 */
export class Refinement<Result> {
  #source: EngineClient | null = null;
  #client: EngineClient | null = null;
  #loading: AbortController | null = null;
  #restarts = 0;
  #wanted = -1;
  readonly #newest = new Newest<RefinementJob<Result>>((job) => this.#run(job));

  /** Refines curves on another surface; the engine for the one before ends. */
  use(source: EngineClient | null): void {
    this.drop();
    this.#loading?.abort();
    this.#loading = null;
    this.#client?.close();
    this.#client = null;
    this.#source = source;
    this.#restarts = 0;
  }

  /** Computes this job next, in place of one that waits. */
  request(job: RefinementJob<Result>): void {
    if (job.revision === this.#wanted) return;
    this.#wanted = job.revision;
    this.#newest.push(job);
  }

  /** Drops the request, because an edit goes on. */
  drop(): void {
    this.#wanted = -1;
    this.#newest.drop();
  }

  /** The engine; null until it is needed. */
  get client(): EngineClient | null {
    return this.#client;
  }

  /** Whether an answer that is still wanted is awaited. */
  get busy(): boolean {
    return this.#wanted !== -1;
  }

  async #run(job: RefinementJob<Result>): Promise<void> {
    const source = this.#source;
    try {
      const client = await this.#engine();
      if (job.revision !== this.#wanted) return;
      const result = await job.compute(client);
      if (this.#settle(job, source)) job.done(result);
    } catch (error) {
      if (this.#settle(job, source)) job.failed(error);
    }
  }

  /** Whether a job that has ended is still the one that is wanted; it is then no longer awaited. */
  #settle(job: RefinementJob<Result>, source: EngineClient | null): boolean {
    if (job.revision !== this.#wanted || source !== this.#source) return false;
    this.#wanted = -1;
    return true;
  }

  async #engine(): Promise<EngineClient> {
    if (this.#client && !this.#client.closed) return this.#client;
    const source = this.#source;
    if (!source || this.#restarts > mostRestarts) throw new Error('the second engine stopped');
    this.#restarts++;
    this.#loading = new AbortController();
    const { signal } = this.#loading;
    const { arrays } = source;
    const client = await EngineClient.load({ kind: 'arrays', arrays }, { signal });
    if (signal.aborted) client.close();
    signal.throwIfAborted();
    this.#client = client;
    return client;
  }
}
