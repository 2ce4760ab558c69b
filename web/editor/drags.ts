import type { Figure } from '../model/figure';
import type { State } from './editor';

/** A drag of a control point, whose legs the figure that it led to does not tell yet. */
export interface Drag {
  point: number;
  base: Figure;
  to: Figure;
  /** Whether the engine's curve is what the drag made of its base so far. */
  followed: boolean;
}

/**
 * Drags whose legs are to be asked for, and what the engine's curve of the edited object is: its legs are
 * those that the engine continues.
 */
export class Drags {
  /** The newest drag, and the one before it if that has ended and its legs were not asked for. */
  #held: Drag | null = null;
  #heldBefore: Drag | null = null;
  /** The figure that the engine's curve was last made; null where that is not known. */
  made: Figure | null = null;

  /** The drag whose legs the figure does not tell yet. */
  get held(): Drag | null {
    return this.#held;
  }

  /** The state is a step of a drag, which goes on if the one before it was one of the same. */
  hold({ dragged, base, figure }: State, goesOn: boolean): void {
    const before = this.#held;
    if (goesOn && before?.base === base && before.point === dragged) {
      before.to = figure;
      return;
    }
    if (before?.to === base) this.#heldBefore = before;
    this.#held = { point: dragged!, base, to: figure, followed: false };
  }

  /** What was dragged was taken back, or something else was done. */
  drop(): void {
    this.#held = null;
  }

  clear(): void {
    this.#held = null;
    this.#heldBefore = null;
    this.made = null;
  }

  /** Takes the drags that ended before a state, in order. */
  takeEnded({ dragging }: State): Drag[] {
    const ended = [this.#heldBefore, dragging ? null : this.#held];
    this.#heldBefore = null;
    if (!dragging) this.#held = null;
    return ended.filter((drag) => drag !== null);
  }

  /** Whether the engine's curve has to be made the drag's base before its next step. */
  begins(drag: Drag): boolean {
    const { base, followed } = drag;
    drag.followed = true;
    return !followed && this.made !== base;
  }

  /** The engine's curve was made something else. */
  unfollow(): void {
    this.made = null;
    if (this.#held) this.#held.followed = false;
  }
}
