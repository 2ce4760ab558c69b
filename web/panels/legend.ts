import { byId, closeIcon, make, write } from './elements';

export interface LegendWords {
  /** The prefix of the ids of the legend's elements. */
  id: string;
  /** The id of the menu item that shows the legend. */
  item: string;
  title: string;
  /** The words for the action of the legend's button, and the action's key. */
  hides: string;
  key: string;
}

/**
 * A legend over the surface: words and a scale. In a narrow window all legends are rows of one
 * strip.
 */
export class Legend {
  readonly #element: HTMLElement;
  readonly #title: HTMLElement;
  readonly #note: HTMLElement;
  readonly #item: HTMLElement;

  constructor(
    { id, item, title, hides, key }: LegendWords,
    scale: readonly HTMLElement[],
    hide: () => void,
  ) {
    this.#item = byId(item);
    this.#element = make('section', '', { id: `${id}-legend`, className: 'legend', hidden: true });
    this.#title = make('h2', title, { id: `${id}-title` });
    this.#element.setAttribute('aria-labelledby', this.#title.id);
    const off = make('button', '', { id: `${id}-off`, type: 'button', className: 'tool' });
    off.title = `Hide (${key})`;
    off.setAttribute('aria-label', hides);
    off.innerHTML = closeIcon;
    off.addEventListener('click', hide);
    const middle = make('div', '', { className: 'legend-scale' });
    middle.append(...scale);
    this.#note = make('p', '', { id: `${id}-note`, className: 'remark' });
    this.#note.setAttribute('aria-live', 'polite');
    this.#element.append(this.#title, off, middle, this.#note);
    byId('legends').append(this.#element);
  }

  /** Shows or hides the legend. */
  set shown(shown: boolean) {
    this.#item.setAttribute('aria-checked', `${shown}`);
    this.#element.hidden = !shown;
  }

  /** Whether the computation of the legend's contents is under way. */
  set busy(busy: boolean) {
    this.#element.setAttribute('aria-busy', `${busy}`);
  }

  tell(title: string, note: string): void {
    say(this.#title, title);
    say(this.#note, note);
  }
}

/**
 * Writes words, also into the tooltip, since they may be too long for their place. Skips unchanged
 * words, which are frequent in a drag.
 */
function say(element: HTMLElement, words: string): void {
  if (element.textContent === words) return;
  write(element, words);
  element.title = words;
}
