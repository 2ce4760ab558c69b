/** Work for an element of the page. It can be interrupted and run again. */
export interface Work {
  element: Element;
  /** Resolves when all is done, and after an interruption. */
  run(signal: AbortSignal): Promise<void>;
}

/** The delay of an interruption, since readers who scroll past often come back soon. */
const patienceMs = 300;

/** The distance of an element from the visible part of the page, in pixels; 0 if it is visible. */
function distanceFromSight(element: Element): number {
  const { top, bottom } = element.getBoundingClientRect();
  return Math.max(0, -bottom, top - innerHeight);
}

/**
 * Runs one work at a time, works of visible elements first. If the present work's element is out of
 * sight and a visible element waits, the present work stops and runs again later.
 */
export class Turns {
  readonly #waiting: Work[] = [];
  #running: { work: Work; controller: AbortController } | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    addEventListener('scroll', () => this.#lookSoon(), { passive: true });
  }

  ask(work: Work): void {
    this.#waiting.push(work);
    if (this.#running) this.#lookSoon();
    // Works that begin to wait together compete for the first turn.
    else queueMicrotask(() => this.#next());
  }

  #lookSoon(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      if (!this.#running || distanceFromSight(this.#running.work.element) === 0) return;
      const inSight = this.#waiting.some(({ element }) => distanceFromSight(element) === 0);
      if (inSight) this.#running.controller.abort();
    }, patienceMs);
  }

  async #next(): Promise<void> {
    if (this.#running || this.#waiting.length === 0) return;
    const distances = this.#waiting.map(({ element }) => distanceFromSight(element));
    const nearest = distances.indexOf(Math.min(...distances));
    const [work] = this.#waiting.splice(nearest, 1);
    const controller = new AbortController();
    this.#running = { work: work!, controller };
    await work!.run(controller.signal);
    this.#running = null;
    if (controller.signal.aborted) this.#waiting.push(work!);
    void this.#next();
  }
}
