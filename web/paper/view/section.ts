/** Parts that the page's sections share. */
import { make } from '../../panels/elements';

/** The head of a section: its topic and its title; `more` stands below. */
export function sectionHead(name: string, title: string, ...more: Element[]): HTMLElement {
  const head = make('header', '', { className: 'figure-head' });
  head.append(make('p', name, { className: 'figure-name' }), make('h2', title), ...more);
  return head;
}

/**
 * The end of a text's first sentence: a stop before a capital or a quotation mark. A stop after a
 * single letter belongs to an initial and does not end the sentence.
 */
const sentenceEnd = /(?<=[^\s.][^\s.]|\d)[.?!](?= [A-Z“])/u;

/** A text that shows its first sentence. Its rest appears when the reader unfolds it. */
export class Caption {
  readonly element = make('details', '', { className: 'caption' });
  readonly #first = make('span');
  readonly #rest = make('p');

  constructor(text: string) {
    const summary = make('summary');
    summary.append(this.#first, make('span', '', { className: 'caption-more' }));
    this.element.append(summary, this.#rest);
    this.tell(text);
  }

  tell(text: string): void {
    const end = sentenceEnd.exec(text);
    const length = end ? end.index + 1 : text.length;
    this.#first.textContent = text.slice(0, length);
    this.#rest.textContent = text.slice(length).trim();
  }
}

/** Calls a function when an element is about to come into view. */
export function whenNear(element: Element, call: () => unknown): void {
  const observer = new IntersectionObserver(
    ([entry]) => {
      if (!entry!.isIntersecting) return;
      observer.disconnect();
      void call();
    },
    { rootMargin: '200px' },
  );
  observer.observe(element);
}
