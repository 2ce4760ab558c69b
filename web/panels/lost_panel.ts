import type { View } from '../editor/engine/view';
import { type LostInterval, type LostReason, lostSamples } from '../model/lost';
import { byId, formatCount, make, write } from './elements';

/** Words for the reasons why points of a curve are not centers of mass. */
export const reasons: Record<LostReason, string> = {
  indefinite: 'more than one center',
  jump: 'a jump between two centers',
  boundary: 'the surface ends',
  noProgress: 'the search got stuck',
  limit: 'the search took too long',
  lowerNearby: 'the surface is too rough there to tell a minimum',
};
/** The advice for each reason. */
const advice: Record<LostReason, string> = {
  indefinite:
    'The curve could go two ways here. Add a point between, or move points nearer together.',
  jump: 'The curve jumps here from one way to another. Add a point between.',
  boundary: 'The surface ends here. Move the points away from its rim.',
  noProgress: 'The surface is rough here, and the curve is only bridged. Move a point, or add one.',
  limit: 'The curve took too long here, and is only bridged. Move a point, or add one.',
  lowerNearby:
    'The surface is rough here, and the curve is only bridged. Move a point, or add one.',
};
const mostShown = 40;

/**
 * The places that the panel shows. It omits places without bad samples, where the line is fine,
 * unless the curve jumps there.
 */
const seenOf = (intervals: readonly LostInterval[]) =>
  intervals.filter(({ samples, reason }) => samples > 0 || reason === 'jump');

/** The number of places to look at, in words; empty if the line is fine. */
export function countLost(intervals: readonly LostInterval[]): string {
  const { length } = seenOf(intervals);
  return length > 0 ? formatCount(length, 'place to check', 'places to check') : '';
}

/**
 * The list of places where the curve's points are not centers of mass. A click goes to the place.
 */
export class LostPanel {
  readonly #group = byId('lost');
  readonly #kinds = byId('lost-kinds');
  #intervals: readonly LostInterval[] = [];
  #next = 0;
  #shown = '';

  constructor(private readonly goTo: (interval: LostInterval) => void) {}

  show({ curve }: View): void {
    this.#intervals = seenOf(curve?.lost ?? []);
    const text = JSON.stringify(this.#intervals);
    if (text === this.#shown) return;
    this.#shown = text;
    this.#next = 0;
    this.#group.hidden = this.#intervals.length === 0;
    write(byId('lost-count'), `${this.#intervals.length}`);
    const shown = this.#intervals.slice(0, mostShown);
    const all = [...new Set(shown.map(({ reason }) => reason))];
    this.#kinds.replaceChildren(...all.flatMap((reason) => this.#list(reason, shown)));
    const left = this.#intervals.length - shown.length;
    if (left > 0) this.#kinds.append(make('p', `and ${formatCount(left, 'more place')}`));
  }

  /** Shows the next place; after the last one, the first. */
  goToNext(): void {
    const interval = this.#intervals[this.#next % this.#intervals.length];
    if (!interval) return;
    this.#next = (this.#next + 1) % this.#intervals.length;
    this.goTo(interval);
  }

  #list(reason: LostReason, shown: readonly LostInterval[]): HTMLElement[] {
    const all = this.#intervals.filter((interval) => interval.reason === reason);
    const title = make('h3', advice[reason]);
    title.title = `${reasons[reason]}: ${formatCount(lostSamples(all), 'sample')}`;
    const list = make('ol', '', { className: 'points' });
    for (const interval of shown.filter((one) => one.reason === reason)) {
      const button = make('button', '', { type: 'button' });
      const range = make('span', rangeOf(interval), { className: 'mathematics' });
      button.append(make('b', `Place ${this.#intervals.indexOf(interval) + 1}`), range);
      button.title = `Segment ${interval.segment + 1}, ${formatCount(interval.samples, 'sample')}`;
      button.addEventListener('click', () => this.goTo(interval));
      const row = make('li');
      row.append(button);
      list.append(row);
    }
    return [title, list];
  }
}

function rangeOf({ from, to }: LostInterval): string {
  const [a, b] = [from.toFixed(2), to.toFixed(2)];
  return a === b ? `t = ${a}` : `t = ${a} to ${b}`;
}
