import { pause, sliceTime } from './prepare.js';
import type { LongWorkOptions } from './types.js';

/**
 * A mask for the numbers of items. A loop looks at the clock if the masked number is 0: at every
 * 4096th item.
 */
export const batchMask = 0xfff;

/**
 * Long work in slices of a few milliseconds. Between the slices, the thread does waiting tasks.
 * After each batch a loop checks whether a slice is over, and if so awaits `rest`.
 */
export class Slices {
  readonly #work: LongWorkOptions;
  readonly #stage: string;
  #end = performance.now() + sliceTime;

  constructor(work: LongWorkOptions, stage: string) {
    this.#work = work;
    this.#stage = stage;
    work.signal?.throwIfAborted();
  }

  get over(): boolean {
    return performance.now() >= this.#end;
  }

  /** Reports the progress, a number from 0 to 1, and pauses. Rejects with the signal's reason. */
  async rest(done: number): Promise<void> {
    this.#work.progress?.(Math.min(1, done), this.#stage);
    await pause();
    this.#work.signal?.throwIfAborted();
    this.#end = performance.now() + sliceTime;
  }
}
