import type { Figure } from '../../model/figure';
import type { State } from '../state/editor';

/** A drag of control points, whose legs the figure that it led to does not tell yet. */
export interface Drag {
  /** The id of its object. */
  object: number;
  points: readonly number[];
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
  /** The newest drag, and those before it that have ended and whose legs were not asked for. */
  #held: Drag | null = null;
  #ended: Drag[] = [];
  /** The figure that the engine's curve was last made; null where that is not known. */
  made: Figure | null = null;

  /** The drag whose legs the figure does not tell yet. */
  get held(): Drag | null {
    return this.#held;
  }

  /** The state is a step of a drag, which goes on if the one before it was one of the same. */
  hold({ dragged, base, figure, drawing }: State, goesOn: boolean): void {
    const before = this.#held;
    const isSame = (points: readonly number[]) => `${points}` === `${dragged}`;
    if (goesOn && before?.base === base && isSame(before.points)) {
      before.to = figure;
      return;
    }
    if (before?.to === base) this.#ended.push(before);
    this.#held = { object: drawing.active, points: dragged, base, to: figure, followed: false };
  }

  /** What is dragged is taken back. */
  drop(): void {
    this.#held = null;
  }

  /** Something else is done, after a drag whose legs are asked for yet. */
  end(): void {
    if (this.#held) this.#ended.push(this.#held);
    this.#held = null;
  }

  clear(): void {
    this.#held = null;
    this.#ended = [];
    this.made = null;
  }

  /** Takes the drags that ended before a state, in order. */
  takeEnded({ dragging }: State): Drag[] {
    if (!dragging) this.end();
    const ended = this.#ended;
    this.#ended = [];
    return ended;
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
