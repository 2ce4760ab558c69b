/** Work for an element of the page, which can be broken off and taken up again. */
export interface Work {
  element: Element;
  /** Resolves when all is done, and once it is broken off. */
  run(signal: AbortSignal): Promise<void>;
}

/** How long something must have been out of sight to be broken off: who scrolls past sees it again. */
const patienceMs = 300;

/** How far an element is from what is seen of the page, in pixels; 0 in sight. */
function distanceFromSight(element: Element): number {
  const { top, bottom } = element.getBoundingClientRect();
  return Math.max(0, -bottom, top - innerHeight);
}

/**
 * Works one after the other, what is in sight first: one that has left it makes room for one that is
 * seen, and is taken up later.
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
    // Those that are asked for together are chosen from together.
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
