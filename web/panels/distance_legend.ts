import type { ShownDistances } from '../editor/distances';
import type { State } from '../editor/editor';
import { objectOf } from '../model/drawing';
import { methodOptions } from '../model/methods';
import { rampAsCss } from '../viewer/color_ramp';
import { byId, make } from './elements';
import { nameOf } from './object_panel';

/** How many numbers stand below the ramp, beside 0. */
const mostTicks = 4;

/** What the colors of distances mean, in numbers; one click takes all away. */
export class DistanceLegend {
  readonly #legend = byId('distance-legend');

  constructor(hide: () => void) {
    byId('distance-ramp').style.backgroundImage = rampAsCss;
    byId('distance-off').addEventListener('click', hide);
  }

  /** `on` also where the distances are asked for and not yet there. */
  show(shown: ShownDistances | null, on: boolean, state: State): void {
    byId('distances').setAttribute('aria-checked', `${on}`);
    this.#legend.hidden = !on;
    this.#legend.setAttribute('aria-busy', `${on && !shown?.current}`);
    byId('distance-title').textContent = shown ? titleOf(shown, state) : 'Distances';
    if (!shown) {
      byId('distance-ticks').replaceChildren();
      byId('distance-note').textContent = on ? 'Computing…' : '';
      return;
    }
    const { most, step, complete } = shown.traced;
    byId('distance-ticks').replaceChildren(
      ...ticksOf(most, step).map((value) => {
        const tick = make('li', formatDistance(value));
        tick.style.left = `${(100 * value) / most}%`;
        return tick;
      }),
    );
    const unreached = complete ? '' : ' No path leads to what has no color.';
    const graph =
      methodOptions(state.method).solver === 'graph' ? ' Distances are the graph’s.' : '';
    byId('distance-note').textContent = shown.current
      ? `Line every ${formatDistance(step)}, farthest ${most.toPrecision(4)} (surface’s unit).${unreached}${graph}`
      : 'Follows when the point rests.';
  }
}

/** Multiples of the lines' step, evenly spaced, with 0. */
function ticksOf(most: number, step: number): number[] {
  const every = step * Math.ceil(most / step / mostTicks);
  return Array.from({ length: Math.floor(most / every) + 1 }, (_, i) => i * every);
}

const formatDistance = (value: number) => `${Number(value.toPrecision(4))}`;

function titleOf({ origin }: ShownDistances, { drawing }: State): string {
  const { object, handle } = origin;
  const name = nameOf(objectOf(drawing, object)!);
  return handle === 'center' ? `From the center of ${name}` : `From point ${handle + 1} of ${name}`;
}
