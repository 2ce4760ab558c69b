import type { DrawnLeg } from 'karcher';
import type { Figure } from '../../model/figure';
import { type ToldLegs, withTold } from '../../model/legs';
import type { State } from '../state/state';

/** A drag of control points: the legs that meet there go on from where its last step drew them. */
export class Drag {
  readonly base: Figure;
  readonly points: readonly number[];
  /** The legs as its last step drew them; null before the first. */
  legs: readonly DrawnLeg[] | null = null;
  /** The points that tell them. */
  told: ToldLegs;

  constructor({ base, dragged }: State) {
    this.base = base;
    this.points = dragged;
    this.told = base.points.map(({ leg }) => leg ?? null);
  }

  /** Whether a state is a step of this drag. */
  has({ base, dragged }: State): boolean {
    return this.base === base && `${this.points}` === `${dragged}`;
  }

  /** The figure that it led to, with its legs. */
  ended(figure: Figure): Figure {
    const isOther = this.legs === null && figure.points.length !== this.base.points.length;
    return isOther ? figure : withTold(figure, this.points, this.told);
  }
}
