import type { Vector } from '../../model/figure';
import type { Measured } from '../../model/traced';
import { Newest } from './newest';
import type { Session } from './session';

/** Measures the edited curve at the newest requested place. */
export class Measure {
  #shown: Measured | null = null;
  readonly #newest: Newest<Vector>;

  /** A listener for changes of the measurement. */
  onChange: (measured: Measured | null) => void = () => {};

  constructor(session: Session) {
    this.#newest = new Newest<Vector>(async (near) => {
      const measured = await session.measured(near);
      if (measured) this.#show(measured);
    });
  }

  get shown(): Measured | null {
    return this.#shown;
  }

  /** Measures the curve where it is nearest to a place in the surface's coordinates. */
  at(near: Vector): void {
    this.#newest.push(near);
  }

  /** Discards the measurement, which no longer holds. */
  clear(): void {
    this.#newest.drop();
    if (this.#shown) this.#show(null);
  }

  #show(measured: Measured | null): void {
    this.#shown = measured;
    this.onChange(measured);
  }
}
