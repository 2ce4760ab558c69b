import type { State } from '../editor/state/state';
import { isEmpty, isRound, parameterOf } from '../model/figure';
import { recall, remember } from '../model/storage';
import { byId, write } from './elements';

/** The largest number of points in a list that is open by default. */
const longest = 6;

/**
 * The folds of the panel: the advanced settings and the list of points. By default, the advanced
 * settings are closed, and the list is open if it is short and has numbers. The browser keeps the
 * user's choices.
 */
export class Folds {
  readonly #advanced = byId<HTMLDetailsElement>('fine');
  readonly #points = byId<HTMLDetailsElement>('points-group');
  #active = 0;

  constructor() {
    this.#advanced.open = recall('advanced') === 'open';
    this.#showAdvanced();
    this.#advanced.addEventListener('toggle', () => {
      this.#showAdvanced();
      remember('advanced', this.#advanced.open ? 'open' : 'closed');
    });
    this.#points.querySelector('summary')!.addEventListener('click', () => {
      remember('points', this.#points.open ? 'closed' : 'open');
    });
  }

  show({ drawing, figure }: State): void {
    const count = isRound(figure.kind) || isEmpty(figure) ? 0 : figure.points.length;
    write(byId('points-count'), count > 0 ? `${count}` : '');
    // The list opens or closes only when another object is edited, so that a growing list never
    // folds under the pointer.
    if (drawing.active === this.#active) return;
    this.#active = drawing.active;
    const said = recall('points');
    const hasNumbers = isRound(figure.kind) || parameterOf(figure.kind) !== null;
    this.#points.open = said ? said === 'open' : hasNumbers && count <= longest;
  }

  /** The status line shows samples and times while the advanced settings are open. */
  #showAdvanced(): void {
    document.documentElement.toggleAttribute('data-advanced', this.#advanced.open);
  }
}
