import type { Vector3 } from 'three';
import type { Viewer } from './viewer';

export interface Handle {
  /** The handle's id, which stays with the point while it moves. */
  id: string;
  position: Vector3;
  label: string;
  /** Text beside the handle when it is selected or under the pointer. */
  tag: string;
  look: 'point' | 'center' | 'rim' | 'anchor' | 'tangent' | 'corner' | 'turn' | 'move' | 'pivot';
  selected: boolean;
}

export interface HandleEvents {
  /**
   * `grab` reports the start of a drag, `drag` each step, and `release` the end. The place is the
   * handle's middle in the window, in CSS pixels.
   */
  grab(id: string, clientX: number, clientY: number): void;
  drag(id: string, clientX: number, clientY: number): void;
  release(id: string, cancelled: boolean): void;
  focus(id: string): void;
  key(id: string, event: KeyboardEvent): void;
}

/**
 * Handles of constant size over the canvas: real buttons, accessible to keys and screen readers.
 */
export class Handles {
  readonly #buttons = new Map<string, { button: HTMLButtonElement; handle: Handle }>();
  readonly #preview = document.createElement('div');
  #previewPosition: Vector3 | null = null;
  readonly #center = document.createElement('div');
  #centerPosition: Vector3 | null = null;
  #minima: { element: HTMLElement; position: Vector3 }[] = [];
  readonly #beacon = document.createElement('div');
  #beaconPosition: Vector3 | null = null;
  /** The drag under way: its pointer, and that pointer's offset from the handle's middle. */
  #held: { button: HTMLButtonElement; id: string; pointer: number; x: number; y: number } | null =
    null;
  /** The number of calls of `show`. */
  #shows = 0;
  /** Whether several fingers are down; they move the view. */
  severalFingers: () => boolean = () => false;

  constructor(
    private readonly viewer: Pick<Viewer, 'onFrame' | 'requestFrame' | 'project'>,
    private readonly layer: HTMLElement,
    private readonly events: HandleEvents,
  ) {
    this.#preview.className = 'preview';
    this.#preview.hidden = true;
    this.#beacon.className = 'beacon';
    this.#beacon.hidden = true;
    this.#beacon.addEventListener('animationend', () => {
      this.#beacon.hidden = true;
      this.#beaconPosition = null;
    });
    this.#center.className = 'mass-center';
    this.#center.hidden = true;
    window.addEventListener('keydown', (event) => this.#key(event), { capture: true });
    viewer.onFrame(() => this.#place());
  }

  /** Shows these handles only, and undoes a drag of any other. */
  show(handles: readonly Handle[]): void {
    const ids = new Set(handles.map(({ id }) => id));
    const shows = ++this.#shows;
    if (this.#held && !ids.has(this.#held.id)) this.letGo();
    // The end of the drag may have called `show` with newer handles.
    if (shows !== this.#shows) return;
    for (const [id, { button }] of this.#buttons) {
      if (ids.has(id)) continue;
      button.remove();
      this.#buttons.delete(id);
    }
    let before: Element | null = null;
    for (const handle of handles) {
      const known = this.#buttons.get(handle.id);
      const entry = known ?? { button: this.#make(handle.id), handle };
      // The Tab key visits the handles in their order.
      if (!known && before) before.after(entry.button);
      before = entry.button;
      entry.handle = handle;
      this.#buttons.set(handle.id, entry);
      const { button } = entry;
      button.dataset.look = handle.look;
      button.dataset.tag = handle.tag;
      button.setAttribute('aria-label', handle.label);
      button.setAttribute('aria-pressed', `${handle.selected}`);
    }
    this.viewer.requestFrame();
  }

  /**
   * Marks a measured place, or the place of a point that a click would add: on the surface, on the
   * curve, or on a target to which the point snaps. `name` is the target's name.
   */
  showPreview(
    position: Vector3 | null,
    on: 'surface' | 'curve' | 'measure' | 'snap',
    name = '',
  ): void {
    this.#preview.dataset.on = on;
    this.#preview.dataset.tag = name;
    this.#previewPosition = position;
    this.#mark(this.#preview, position !== null);
    this.#put(this.#preview, position);
    if (position) this.viewer.requestFrame();
  }

  /** Shows the center of mass, which follows from the points and cannot be dragged. */
  showCenter(position: Vector3 | null): void {
    this.#centerPosition = position;
    this.#mark(this.#center, position !== null);
    this.viewer.requestFrame();
  }

  /** Shows the other minima beside the center of mass, each with its energy. */
  showMinima(minima: readonly { position: Vector3; tag: string }[]): void {
    for (const { element } of this.#minima) element.remove();
    this.#minima = minima.map(({ position, tag }) => {
      const element = document.createElement('div');
      element.className = 'mass-center other';
      element.dataset.tag = tag;
      this.layer.append(element);
      return { element, position };
    });
    this.viewer.requestFrame();
  }

  /** Shows rings around a place for a moment. */
  showBeacon(position: Vector3): void {
    this.#beaconPosition = position;
    // The animation starts again if the element is laid out while hidden, and then shown.
    this.#mark(this.#beacon, false);
    void this.#beacon.offsetWidth;
    this.#mark(this.#beacon, true);
    this.viewer.requestFrame();
  }

  /** Shows or hides one of the marks; it stays in the layer after its first use. */
  #mark(mark: HTMLElement, shown: boolean): void {
    if (shown && !mark.isConnected) this.layer.append(mark);
    mark.hidden = !shown;
  }

  focus(id: string): void {
    this.#buttons.get(id)?.button.focus({ preventScroll: true });
  }

  /** The place of a handle in the window, in CSS pixels. */
  place(id: string): { x: number; y: number } | null {
    const handle = this.#buttons.get(id)?.handle;
    if (!handle) return null;
    const { x, y } = this.viewer.project(handle.position);
    const box = this.layer.getBoundingClientRect();
    return { x: box.left + x, y: box.top + y };
  }

  /** The pointer that drags a handle; null without one. */
  get heldBy(): number | null {
    return this.#held?.pointer ?? null;
  }

  /** Undoes the drag under way. */
  letGo(): void {
    const held = this.#held;
    if (!held) return;
    this.#release(true);
    held.button.releasePointerCapture(held.pointer);
  }

  /** Escape undoes the drag under way and ends it. */
  #key(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || !this.#held) return;
    event.preventDefault();
    event.stopPropagation();
    this.letGo();
  }

  #release(cancelled: boolean): void {
    const held = this.#held;
    this.#held = null;
    if (held) this.events.release(held.id, cancelled);
  }

  get hasFocus(): boolean {
    return this.layer.contains(document.activeElement);
  }

  #place(): void {
    for (const { button, handle } of this.#buttons.values()) {
      const { x, y, hidden } = this.viewer.project(handle.position);
      button.style.translate = `${x.toFixed(2)}px ${y.toFixed(2)}px`;
      button.classList.toggle('behind', hidden);
    }
    this.#put(this.#preview, this.#previewPosition);
    this.#put(this.#center, this.#centerPosition);
    for (const { element, position } of this.#minima) this.#put(element, position);
    this.#put(this.#beacon, this.#beaconPosition);
  }

  #put(element: HTMLElement, position: Vector3 | null): void {
    if (!position) return;
    const { x, y, hidden } = this.viewer.project(position);
    element.style.translate = `${x.toFixed(2)}px ${y.toFixed(2)}px`;
    element.classList.toggle('behind', hidden);
  }

  #make(id: string): HTMLButtonElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'handle';
    button.dataset.id = id;
    button.addEventListener('mousedown', (event) => {
      // The menu applies to all selected points, and a focus would select only this one.
      const isMenu = event.button === 2;
      if (isMenu && button.getAttribute('aria-pressed') === 'true') event.preventDefault();
    });
    button.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || this.#held || this.severalFingers()) return;
      // The view's controls listen on the stage and must not receive a drag of a handle.
      event.stopPropagation();
      button.setPointerCapture(event.pointerId);
      const box = button.getBoundingClientRect();
      const x = event.clientX - (box.left + box.width / 2);
      const y = event.clientY - (box.top + box.height / 2);
      this.#held = { button, id, pointer: event.pointerId, x, y };
      this.events.grab(id, event.clientX - x, event.clientY - y);
    });
    const holds = ({ pointerId }: PointerEvent) =>
      this.#held?.button === button && this.#held.pointer === pointerId ? this.#held : null;
    button.addEventListener('pointermove', (event) => {
      const held = holds(event);
      if (!held) return;
      event.stopPropagation();
      this.events.drag(id, event.clientX - held.x, event.clientY - held.y);
    });
    const end = (event: PointerEvent, cancelled: boolean) => {
      if (holds(event)) this.#release(cancelled);
    };
    button.addEventListener('pointerup', (event) => end(event, false));
    button.addEventListener('pointercancel', (event) => end(event, true));
    button.addEventListener('lostpointercapture', (event) => end(event, false));
    button.addEventListener('focus', () => this.events.focus(id));
    button.addEventListener('keydown', (event) => this.events.key(id, event));
    this.layer.append(button);
    return button;
  }
}
