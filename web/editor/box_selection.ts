import type { Viewer } from '../viewer/viewer';
import type { Editor } from './editor';

/** A press that moves less, in CSS pixels, is a click. */
const clickSlop = 4;
/** How near to a line, in CSS pixels, a click means it. */
const reach = 7;

/**
 * Selects objects with Shift held: a click puts one into the selection or takes it out, a drag selects
 * all that is seen in a box.
 */
export class BoxSelection {
  readonly #box = document.createElement('div');
  #from: { x: number; y: number; id: number } | null = null;

  constructor(
    private readonly editor: Editor,
    private readonly viewer: Viewer,
    private readonly stage: HTMLElement,
  ) {
    this.#box.className = 'selection-box';
    this.#box.hidden = true;
    stage.append(this.#box);
    // Before the view's controls, which listen on the stage too.
    stage.addEventListener('pointerdown', (event) => this.#down(event), { capture: true });
    stage.addEventListener('pointermove', (event) => this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#up(event));
    stage.addEventListener('pointercancel', () => this.#end());
  }

  #down(event: PointerEvent): void {
    const free = event.target === this.stage || event.target instanceof HTMLCanvasElement;
    if (!event.shiftKey || event.button !== 0 || !free) return;
    event.stopPropagation();
    this.stage.focus({ preventScroll: true });
    this.stage.classList.add('pointed');
    this.stage.setPointerCapture(event.pointerId);
    this.#from = { x: event.clientX, y: event.clientY, id: event.pointerId };
  }

  #move({ clientX, clientY, pointerId }: PointerEvent): void {
    if (this.#from?.id !== pointerId) return;
    const { left, top, width, height } = this.#rectangle(clientX, clientY);
    const { box } = this.viewer;
    this.#box.hidden = Math.max(width, height) <= clickSlop;
    this.#box.style.translate = `${left - box.left}px ${top - box.top}px`;
    this.#box.style.width = `${width}px`;
    this.#box.style.height = `${height}px`;
  }

  #up({ clientX, clientY, pointerId }: PointerEvent): void {
    if (this.#from?.id !== pointerId) return;
    const { left, top, width, height } = this.#rectangle(clientX, clientY);
    this.#end();
    const { active } = this.editor.state.drawing;
    if (Math.max(width, height) > clickSlop) {
      const { others, edited } = this.viewer.objectsIn(left, top, width, height);
      this.editor.choose(edited ? [...others, active] : others);
      return;
    }
    const other = this.viewer.pickObject(clientX, clientY, reach);
    if (other !== null) this.editor.toggle(other);
    else if (this.viewer.pickOwn(clientX, clientY, reach)) this.editor.toggle(active);
  }

  #end(): void {
    this.#from = null;
    this.#box.hidden = true;
  }

  #rectangle(x: number, y: number) {
    const from = this.#from!;
    return {
      left: Math.min(x, from.x),
      top: Math.min(y, from.y),
      width: Math.abs(x - from.x),
      height: Math.abs(y - from.y),
    };
  }
}
