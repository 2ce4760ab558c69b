import { type Handle, Handles } from '../../viewer/handles';
import type { Panel, Vector } from '../figures/types';
import type { PanelView } from './panel_view';

/** A panel's points as handles that the reader can drag, and move by keys. */
export class PanelPoints {
  readonly #handles: Handles;

  constructor(
    private readonly view: PanelView,
    layer: HTMLElement,
    private readonly panel: Panel,
    /** The listener that receives a point's index and its new place. */
    private readonly moved: (index: number, place: Vector) => void,
  ) {
    this.#handles = new Handles(view, layer, {
      grab: () => {},
      drag: (id, x, y) => this.#move(id, x, y),
      release: () => {},
      focus: () => {},
      key: (id, event) => this.#key(id, event),
    });
  }

  show(places: readonly Vector[]): void {
    this.#handles.show(places.map((place, i) => this.#handle(place, i, places.length)));
  }

  #handle(place: Vector, i: number, count: number): Handle {
    const name = count === 2 ? 'pq'[i]! : `${i + 1}`;
    return {
      id: `${i}`,
      position: this.view.toScene(place),
      label: `Point ${name} of ${this.panel.title}`,
      tag: name,
      look: 'point',
      selected: false,
    };
  }

  #move(id: string, clientX: number, clientY: number): void {
    const place = this.view.pick(clientX, clientY);
    if (place) this.moved(Number(id), place);
  }

  #key(id: string, event: KeyboardEvent): void {
    const step = {
      ArrowLeft: [-6, 0],
      ArrowRight: [6, 0],
      ArrowUp: [0, -6],
      ArrowDown: [0, 6],
    }[event.key];
    const at = this.#handles.place(id);
    if (!step || !at) return;
    event.preventDefault();
    this.#move(id, at.x + step[0]!, at.y + step[1]!);
  }
}
