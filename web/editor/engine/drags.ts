import type { DrawnLeg } from 'karcher';
import type { Figure } from '../../model/figure';
import type { State } from '../state/editor';

/** A drag of control points, whose legs the figure that it led to does not have yet. */
export interface Drag {
  /** The id of its object. */
  object: number;
  points: readonly number[];
  base: Figure;
  to: Figure;
  /** The legs as its last step drew them; null before the first. */
  legs: readonly DrawnLeg[] | null;
}

/** Drags whose legs are to be asked for. */
export class Drags {
  /** The newest drag, and those before it that have ended and whose legs were not asked for. */
  #held: Drag | null = null;
  #ended: Drag[] = [];

  /** The drag whose legs the figure does not have yet. */
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
    this.#held = { object: drawing.active, points: dragged, base, to: figure, legs: null };
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
  }

  /** Takes the drags that ended before a state, in order. */
  takeEnded({ dragging }: State): Drag[] {
    if (!dragging) this.end();
    const ended = this.#ended;
    this.#ended = [];
    return ended;
  }
}
