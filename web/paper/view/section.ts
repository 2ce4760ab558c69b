/** What the page's sections have in common. */
import { make } from '../../panels/elements';

/** The head of a section: what it belongs to, and its title; `more` goes below. */
export function sectionHead(name: string, title: string, ...more: Element[]): HTMLElement {
  const head = make('header', '', { className: 'figure-head' });
  head.append(make('p', name, { className: 'figure-name' }), make('h2', title), ...more);
  return head;
}

/** Calls once an element is about to be seen. */
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
