import type { ShownDistances } from '../editor/engine/distances';
import type { State } from '../editor/state/state';
import { objectOf } from '../model/drawing';
import { methodOptions } from '../model/methods';
import { rampAsCss } from '../viewer/color_ramp';
import { make } from './elements';
import { Legend } from './legend';
import { nameOf } from './object_rows';

/** The largest number of labels below the ramp, besides 0. */
const mostTicks = 4;

/** The legend of the colors of distances; its button removes them. */
export class DistanceLegend {
  readonly #legend: Legend;
  readonly #ticks = make('ol', '', { id: 'distance-ticks', className: 'ticks' });

  constructor(hide: () => void) {
    const ramp = make('div', '', { className: 'ramp' });
    ramp.style.backgroundImage = rampAsCss;
    ramp.ariaHidden = 'true';
    this.#ticks.setAttribute('aria-label', 'Distances, from near to far');
    this.#legend = new Legend(
      {
        ...{ id: 'distance', item: 'distances', title: 'Distances' },
        ...{ hides: 'Hide the distances', key: 'D' },
      },
      [ramp, this.#ticks],
      hide,
    );
  }

  /** Shows the legend. `on` is true once distances are requested, even before they are ready. */
  show(shown: ShownDistances | null, on: boolean, state: State): void {
    this.#legend.shown = on;
    this.#legend.busy = on && !shown?.current;
    if (!shown) {
      this.#ticks.replaceChildren();
      this.#legend.tell('Distances', on ? 'Computing…' : '');
      return;
    }
    const { most, step, complete } = shown.traced;
    this.#ticks.replaceChildren(
      ...ticksOf(most, step).map((value) => {
        const tick = make('li', formatDistance(value));
        tick.style.left = `${(100 * value) / most}%`;
        return tick;
      }),
    );
    const unreached = complete ? '' : ' No path leads to what has no color.';
    const graph =
      methodOptions(state.method).solver === 'graph' ? ' Distances are the graph’s.' : '';
    const told = `Line every ${formatDistance(step)}, farthest ${most.toPrecision(4)} (surface’s unit).${unreached}${graph}`;
    const note = shown.current ? told : 'Follows when the point rests.';
    this.#legend.tell(titleOf(shown, state), note);
  }
}

/** Evenly spaced multiples of the isolines' step, including 0. */
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
