import type { DrawnLeg } from 'karcher';
import { type Figure, isCurve, isRound } from '../../model/figure';
import { type ToldLegs, withTold } from '../../model/legs';
import type { TracedCurve } from '../../model/traced';
import type { State } from '../state/state';
import type { Shown } from './compute';

/**
 * The longest acceptable time of a drag's step, in milliseconds: half of a frame, since the page
 * takes the other half. After several slower steps quicker drafts replace the curve.
 */
const longestDraft = 8;
/**
 * The number of slow steps in a row after which drafts follow. One slow step does not suffice,
 * since the first step also computes data that later steps reuse.
 */
const slowSteps = 2;

/** Whether the tolerance gives a curve more samples than the fixed number in its settings. */
function moreThanFixed({ settings }: Figure, { samples }: TracedCurve): boolean {
  const segments = (samples.segment.at(-1) ?? 0) + 1;
  return settings.tolerance !== null && samples.count > settings.samples * segments;
}

/**
 * A drag of control points. In each step the legs at these points continue from their places after
 * the previous step.
 */
export class Drag {
  readonly base: Figure;
  readonly points: readonly number[];
  /** The legs after the drag's last step; null before the first step. */
  legs: readonly DrawnLeg[] | null = null;
  /** The points from which the engine finds these legs again. */
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

  /** The figure at the end of the drag, with its legs. */
  ended(figure: Figure): Figure {
    const isOther = this.legs === null && figure.points.length !== this.base.points.length;
    return isOther ? figure : withTold(figure, this.points, this.told);
  }
}

/**
 * Chooses the options for traces of a figure during its drag, so that the steps are quick and the
 * curve does not leap.
 */
export class DragTracing {
  /** Whether the tolerance gave the curve more samples than the fixed number in its settings. */
  #manySamples = false;
  /**
   * The number of automatic levels of a curve: between drags the present number, in a drag the
   * largest number so far. 'limit' means that a slow drag uses averages alone.
   */
  #levels: number | 'limit' = 0;
  /**
   * Whether a drag draws a curve without levels as a draft, since steps without a draft were slow.
   */
  #draft = false;
  /** The number of consecutive slow steps of the drag. */
  #slow = 0;

  /** Resets the state for another edited object. */
  forget(): void {
    this.#manySamples = false;
    this.#levels = 0;
  }

  /** Records a trace with the figure's own samples and levels. The next drag starts from these. */
  rested(figure: Figure, { curve }: Shown): void {
    this.#manySamples = curve !== null && isCurve(figure.kind) && moreThanFixed(figure, curve);
    this.#levels = curve?.levels ?? 0;
    this.#draft = false;
  }

  /**
   * Records the trace of a drag's step. The number of levels never decreases in the rest of the
   * drag, and slow steps lead to quicker options.
   */
  stepped(dragging: boolean, { kind }: Figure, { curve }: Shown): void {
    if (dragging && this.#levels !== 'limit' && curve) {
      this.#levels = Math.max(this.#levels, curve.levels);
    }
    const slow = dragging && (curve?.milliseconds ?? 0) > longestDraft;
    this.#slow = slow ? this.#slow + 1 : 0;
    if (this.#slow >= slowSteps && !isRound(kind)) this.#makeQuicker();
  }

  /**
   * Makes the steps of a drag quicker. A curve without levels becomes a draft, whose means are
   * quick since their points lie near each other. If the draft is slow, too, or if the curve has
   * levels, the curve uses averages alone, which need no fields.
   */
  #makeQuicker(): void {
    if (this.#levels === 0 && !this.#draft) {
      this.#draft = true;
      this.#slow = 0;
    } else {
      this.#levels = 'limit';
    }
  }

  /**
   * The figure to trace. In a drag it has the largest number of levels so far, and its fixed number
   * of samples if the tolerance needs more. After the release both are computed anew.
   */
  traced({ figure, dragging }: State): { figure: Figure; coarse: boolean } {
    const { settings } = figure;
    const fewer = dragging && this.#manySamples && settings.tolerance !== null;
    // Circles do not offer a choice of levels.
    const isAutomatic = settings.levels === 'auto' || isRound(figure.kind);
    const keeps = dragging && (this.#levels !== 0 || this.#draft) && isAutomatic;
    if (!fewer && !keeps) return { figure, coarse: false };
    const levels =
      this.#levels === 'limit'
        ? { levels: this.#levels }
        : { leastLevels: this.#levels, draft: this.#draft };
    const held = {
      ...settings,
      ...(fewer && { tolerance: null }),
      ...(keeps && levels),
    };
    return { figure: { ...figure, settings: held }, coarse: true };
  }
}
