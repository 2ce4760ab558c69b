import type { Held } from './two_fingers';

/** The largest distance, in CSS pixels, that the pointer may move during a click. */
export const clickSlop = { mouse: 4, touch: 10 };

/** A place of the pointer in the window, in CSS pixels, and the pressed keys. */
export interface Place {
  x: number;
  y: number;
  touch: boolean;
  alt: boolean;
  shift: boolean;
  /** Whether Ctrl or Cmd is down. */
  control: boolean;
}

/** The handlers of a pointer after its press. */
export interface Hold {
  /**
   * Receives a drag at most once a frame: the newest place of the pointer, and all places since the
   * last call. A press that hardly moves is not a drag.
   */
  drag(place: Place, way: readonly Place[]): void;
  /** Receives the release; `dragged` is true after a call of `drag`. */
  release(place: Place, dragged: boolean): void;
  /** Undoes the gesture. */
  cancel(): void;
}

/** Takes a press on the stage, or leaves it to the next taker and finally to the view. */
export type Taker = (press: Place) => Hold | null;

interface Pressed {
  pointer: number;
  from: Place;
  slop: number;
  hold: Hold;
  dragged: boolean;
  way: Place[];
}

const placeOf = (event: PointerEvent): Place => ({
  x: event.clientX,
  y: event.clientY,
  touch: event.pointerType === 'touch',
  alt: event.altKey,
  shift: event.shiftKey,
  control: event.ctrlKey || event.metaKey,
});

/**
 * Takes the focus from a field. Its typed value is an edit, which would interrupt the gesture if it
 * took effect only when the press moves the focus.
 */
function endTyping(): void {
  const { activeElement } = document;
  if (activeElement?.matches('input, textarea')) (activeElement as HTMLElement).blur();
}

/**
 * Distributes presses on the stage to the tools that draw and drag there. The first tool that takes
 * a press keeps the pointer until its release, Escape, or another finger's press.
 */
export class StagePointer implements Held {
  readonly #takers: Taker[] = [];
  #pressed: Pressed | null = null;
  #frame = 0;

  /**
   * `severalFingers` returns whether several fingers are down, so that the view has the pointer.
   */
  constructor(
    private readonly stage: HTMLElement,
    private readonly severalFingers: () => boolean,
  ) {
    // The listener runs before those of the view's controls on the same stage.
    stage.addEventListener('pointerdown', (event) => this.#down(event), { capture: true });
    stage.addEventListener('pointermove', (event) => this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#up(event));
    stage.addEventListener('pointercancel', (event) => {
      if (this.#pressed?.pointer === event.pointerId) this.letGo();
    });
    window.addEventListener('keydown', (event) => this.#key(event), { capture: true });
  }

  /**
   * Adds a taker. Takers receive presses in the order in which they were added. They receive
   * presses with Alt only if `withAlt` is set.
   */
  offer(taker: Taker, { withAlt = false } = {}): void {
    this.#takers.push((press) => (press.alt && !withAlt ? null : taker(press)));
  }

  get heldBy(): number | null {
    return this.#pressed?.pointer ?? null;
  }

  letGo(): void {
    const pressed = this.#pressed;
    this.#pressed = null;
    pressed?.hold.cancel();
  }

  #down(event: PointerEvent): void {
    const { stage } = this;
    endTyping();
    const free = event.target === stage || event.target instanceof HTMLCanvasElement;
    if (!free || event.button !== 0 || this.#pressed || this.severalFingers()) return;
    // The view takes presses while the space bar is down, and presses with Alt that no tool takes.
    if (stage.classList.contains('moving')) return;
    const from = placeOf(event);
    for (const taker of this.#takers) {
      const hold = taker(from);
      if (!hold) continue;
      event.stopPropagation();
      stage.focus({ preventScroll: true });
      stage.classList.add('pointed');
      stage.setPointerCapture(event.pointerId);
      const least = event.pointerType === 'mouse' ? clickSlop.mouse : clickSlop.touch;
      const pointer = event.pointerId;
      this.#pressed = { pointer, from, slop: least, hold, dragged: false, way: [] };
      return;
    }
  }

  #move(event: PointerEvent): void {
    const pressed = this.#pressed;
    if (pressed?.pointer !== event.pointerId) return;
    // On a slow page, one event reports several places of the pointer.
    const events = event.getCoalescedEvents?.() ?? [];
    pressed.way.push(...(events.length > 0 ? events : [event]).map(placeOf));
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#drag();
    });
  }

  #drag(): void {
    const pressed = this.#pressed;
    const place = pressed?.way.at(-1);
    if (!pressed || !place) return;
    const { from, hold, way } = pressed;
    pressed.dragged ||= way.some(({ x, y }) => Math.hypot(x - from.x, y - from.y) > pressed.slop);
    if (!pressed.dragged) return;
    pressed.way = [];
    hold.drag(place, way);
  }

  #up(event: PointerEvent): void {
    const pressed = this.#pressed;
    if (pressed?.pointer !== event.pointerId) return;
    this.#drag();
    this.#pressed = null;
    pressed.hold.release(placeOf(event), pressed.dragged);
  }

  #key(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || !this.#pressed) return;
    event.preventDefault();
    event.stopPropagation();
    this.letGo();
  }
}
