import { make } from '../../panels/elements';
import { lineStyles } from '../figures/lines';
import type { LineId, Vector } from '../figures/types';
import type { PanelView } from './panel_view';

/** A dot of a line, or of another center that belongs to no line. */
export interface Dot {
  line: LineId | null;
  place: Vector;
}

/** Converts a place of the stage to a place of a layer, in pixels. */
export type Seen = (at: { x: number; y: number }) => { x: number; y: number };

/** Shows centers of mass as dots in a layer over the view. */
export function showDots(
  layer: HTMLElement,
  view: PanelView,
  dots: readonly Dot[],
  seen: Seen = (at) => at,
): void {
  layer.replaceChildren(
    ...dots.map(({ line, place }) => {
      const at = view.project(view.toScene(place));
      const { x, y } = seen(at);
      const dot = make('i', '', { className: 'marker' });
      dot.classList.toggle('other', line === null);
      dot.classList.toggle('behind', at.hidden);
      dot.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      if (line) {
        dot.style.setProperty('--color', `var(${lineStyles[line].color})`);
        dot.dataset.line = line;
      }
      return dot;
    }),
  );
}
