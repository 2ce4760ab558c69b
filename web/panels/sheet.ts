import { byId } from './elements';

/** The heights of the panel in a narrow window. */
const stops = ['collapsed', 'half', 'full'] as const;
type Stop = (typeof stops)[number];

/**
 * The largest distance, in CSS pixels, that the pointer may move during a click. A longer motion is
 * a drag.
 */
const slop = 6;
/** The panel's height at each stop as a fraction of the window's height, as in layout.css. */
const parts: Record<Stop, number> = { collapsed: 0, half: 0.38, full: 0.88 };

/**
 * The panel as a sheet over the lower part of a narrow window. The user drags the sheet by its
 * handle. A click on the handle opens or collapses the sheet, the arrow keys move it from stop to
 * stop, and Enter and Space cycle through the stops.
 */
export class Sheet {
  readonly #handle = byId<HTMLButtonElement>('sheet-handle');
  readonly #panel = byId('panel');
  #held: { pointer: number; y: number; height: number; moved: boolean } | null = null;
  #stop: Stop = 'half';

  constructor() {
    const handle = this.#handle;
    handle.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      handle.setPointerCapture(event.pointerId);
      const { height } = this.#panel.getBoundingClientRect();
      this.#held = { pointer: event.pointerId, y: event.clientY, height, moved: false };
    });
    handle.addEventListener('pointermove', (event) => this.#drag(event));
    handle.addEventListener('pointerup', (event) => this.#end(event));
    handle.addEventListener('pointercancel', () => this.#rest(this.#stop));
    handle.addEventListener('keydown', (event) => this.#key(event));
    this.#rest('half');
  }

  /** Raises the panel if it is down. */
  show(): void {
    if (this.#stop === 'collapsed') this.#rest('half');
  }

  #drag({ pointerId, clientY }: PointerEvent): void {
    const held = this.#held;
    if (held?.pointer !== pointerId) return;
    held.moved ||= Math.abs(clientY - held.y) > slop;
    if (!held.moved) return;
    document.documentElement.dataset.sheet = 'held';
    const height = Math.min(held.height + held.y - clientY, parts.full * innerHeight);
    document.documentElement.style.setProperty('--sheet', `${height}px`);
  }

  #end({ pointerId, clientY }: PointerEvent): void {
    const held = this.#held;
    if (held?.pointer !== pointerId) return;
    if (!held.moved) {
      this.#rest(this.#stop === 'collapsed' ? 'half' : 'collapsed');
      return;
    }
    const part = (held.height + held.y - clientY) / innerHeight;
    const away = (stop: Stop) => Math.abs(parts[stop] - part);
    this.#rest(stops.reduce((nearest, stop) => (away(stop) < away(nearest) ? stop : nearest)));
  }

  #key(event: KeyboardEvent): void {
    const step = { ArrowUp: 1, ArrowDown: -1, Enter: 0, ' ': 0 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const at = stops.indexOf(this.#stop);
    const next = step === 0 ? (at + 1) % stops.length : at + step;
    this.#rest(stops[next] ?? this.#stop);
  }

  #rest(stop: Stop): void {
    this.#held = null;
    this.#stop = stop;
    const { documentElement: root } = document;
    root.dataset.sheet = stop;
    root.style.removeProperty('--sheet');
    this.#handle.setAttribute('aria-expanded', `${stop !== 'collapsed'}`);
  }
}
