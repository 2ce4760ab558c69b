import { EngineClient } from '../../worker/client';
import { Newest } from './newest';

/** A computation on a given engine, and the function that takes its answer. */
export interface RefinementJob<Result> {
  compute(client: EngineClient): Promise<Result>;
  /** The revision of the state. An answer for another revision has no effect. */
  revision: number;
  done(result: Result): void;
  failed(error: unknown): void;
}

/** The largest number of restarts for one surface, after the engine has stopped by itself. */
const mostRestarts = 2;

/**
 * Computes the exact curve that follows the fast one, in an engine of its own with a copy of the
 * surface, created on first use. Its work never delays an edit, and results that an edit has
 * overtaken have no effect.
 */
export class Refinement<Result> {
  #source: EngineClient | null = null;
  #client: EngineClient | null = null;
  #loading: AbortController | null = null;
  #restarts = 0;
  #wanted = -1;
  readonly #newest = new Newest<RefinementJob<Result>>((job) => this.#run(job));

  /** Changes to another surface, and ends the engine of the previous one. */
  use(source: EngineClient | null): void {
    this.drop();
    this.#loading?.abort();
    this.#loading = null;
    this.#client?.close();
    this.#client = null;
    this.#source = source;
    this.#restarts = 0;
  }

  /** Requests this job as the next one, and drops a waiting job. */
  request(job: RefinementJob<Result>): void {
    if (job.revision === this.#wanted) return;
    this.#wanted = job.revision;
    this.#newest.push(job);
  }

  /** Drops the request, since an edit continues. */
  drop(): void {
    this.#wanted = -1;
    this.#newest.drop();
  }

  /** The engine; null until the first job. */
  get client(): EngineClient | null {
    return this.#client;
  }

  /** Whether a requested answer is still to come. */
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

  /** Whether an ended job is still the requested one. If so, the request counts as answered. */
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
