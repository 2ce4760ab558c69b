/**
 * Runs one job at a time. Meanwhile the newest request waits and replaces older ones. When none
 * waits, `idle` may do less urgent work, one piece at a time, until it returns false.
 */
export class Newest<Job> {
  #waiting: { job: Job } | null = null;
  #running = false;
  #loopEnd: Promise<void> = Promise.resolve();

  constructor(
    private readonly run: (job: Job) => Promise<void>,
    private readonly idle: () => Promise<boolean> = async () => false,
  ) {}

  push(job: Job): void {
    this.#waiting = { job };
    if (!this.#running) this.#loopEnd = this.#loop();
  }

  /** Looks again for idle work, if nothing runs. */
  wake(): void {
    if (!this.#running) this.#loopEnd = this.#loop();
  }

  /** Drops the request that waits; the running one continues. */
  drop(): void {
    this.#waiting = null;
  }

  /** Drops the request that waits; resolves once the running one has ended. */
  async end(): Promise<void> {
    this.drop();
    await this.#loopEnd;
  }

  /** Resolves when nothing runs or waits. */
  done(): Promise<void> {
    return this.#loopEnd;
  }

  get busy(): boolean {
    return this.#running;
  }

  async #loop(): Promise<void> {
    this.#running = true;
    try {
      for (;;) {
        const next = this.#waiting;
        this.#waiting = null;
        if (next) await this.run(next.job);
        else if (!(await this.idle()) && !this.#waiting) break;
      }
    } finally {
      this.#running = false;
    }
  }
}
