import type { View } from '../editor/view';
import { type LostInterval, type LostReason, lostSamples } from '../model/lost';
import { byId, formatCount, make, write } from './elements';

/** Why a part of a curve is no center of mass. */
export const reasons: Record<LostReason, string> = {
  indefinite: 'more than one center',
  jump: 'a jump between two centers',
  boundary: 'the surface ends',
  noProgress: 'the search got stuck',
  limit: 'the search took too long',
  lowerNearby: 'the surface is too rough there to tell a minimum',
};
const mostShown = 40;

/** How many samples the intervals hold; where they are too short for any, how many they are. */
export function countLost(intervals: readonly LostInterval[]): string {
  const samples = lostSamples(intervals);
  return samples > 0 ? formatCount(samples, 'sample') : formatCount(intervals.length, 'place');
}

/** The list of the places where the curve is no center of mass: a click goes there. */
export class LostPanel {
  readonly #group = byId('lost');
  readonly #kinds = byId('lost-kinds');
  #intervals: readonly LostInterval[] = [];
  #next = 0;
  #shown = '';

  constructor(private readonly goTo: (interval: LostInterval) => void) {}

  show({ curve }: View): void {
    this.#intervals = curve?.lost ?? [];
    const text = JSON.stringify(this.#intervals);
    if (text === this.#shown) return;
    this.#shown = text;
    this.#next = 0;
    this.#group.hidden = this.#intervals.length === 0;
    write(byId('lost-count'), countLost(this.#intervals));
    const shown = this.#intervals.slice(0, mostShown);
    const all = [...new Set(shown.map(({ reason }) => reason))];
    this.#kinds.replaceChildren(...all.flatMap((reason) => this.#list(reason, shown)));
    const left = this.#intervals.length - shown.length;
    if (left > 0) this.#kinds.append(make('p', `and ${formatCount(left, 'more place')}`));
  }

  /** Shows one place after the other, around. */
  goToNext(): void {
    const interval = this.#intervals[this.#next % this.#intervals.length];
    if (!interval) return;
    this.#next = (this.#next + 1) % this.#intervals.length;
    this.goTo(interval);
  }

  #list(reason: LostReason, shown: readonly LostInterval[]): HTMLElement[] {
    const all = this.#intervals.filter((interval) => interval.reason === reason);
    const title = make('h3', reasons[reason]);
    title.append(make('span', `${lostSamples(all) || ''}`));
    const list = make('ol', '', { className: 'points' });
    for (const interval of shown.filter((one) => one.reason === reason)) {
      const button = make('button', '', { type: 'button' });
      button.append(make('b', `Segment ${interval.segment + 1}`), make('span', rangeOf(interval)));
      button.title = formatCount(interval.samples, 'sample');
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
  return a === b ? `at t = ${a}` : `t = ${a} to ${b}`;
}
