/** A press that moves less, in CSS pixels, is a click. */
const slop = 6;

/** What is dragged: its row, the place it had, and the one it would have. */
interface Dragged {
  row: HTMLElement;
  pointer: number;
  y: number;
  from: number;
  to: number;
  moves: boolean;
}

/**
 * Drags rows of a list to other places: with a mouse anywhere on a row, with a finger by its grip, as a
 * finger elsewhere scrolls. `moved` is told the places from the top, once the row is let go.
 */
export class ListDrag {
  #dragged: Dragged | null = null;

  constructor(
    private readonly list: HTMLElement,
    private readonly moved: (from: number, to: number) => void,
  ) {
    list.addEventListener('pointerdown', (event) => this.#down(event));
    list.addEventListener('pointermove', (event) => this.#move(event));
    list.addEventListener('pointerup', (event) => this.#end(event, true));
    list.addEventListener('pointercancel', (event) => this.#end(event, false));
    window.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.#dragged?.moves) return;
      event.stopPropagation();
      this.#let();
    });
  }

  get #rows(): HTMLElement[] {
    return [...this.list.children] as HTMLElement[];
  }

  #down(event: PointerEvent): void {
    const target = event.target as Element;
    const row = target.closest<HTMLElement>('li');
    const byGrip = target.closest('.row-grip') !== null;
    const onButton = target.closest('.eye, .lock') !== null;
    if (!row || event.button !== 0 || onButton || this.#dragged) return;
    if (event.pointerType === 'touch' && !byGrip) return;
    const from = this.#rows.indexOf(row);
    this.#dragged = {
      row,
      pointer: event.pointerId,
      y: event.clientY,
      from,
      to: from,
      moves: false,
    };
  }

  #move({ pointerId, clientY }: PointerEvent): void {
    const dragged = this.#dragged;
    if (dragged?.pointer !== pointerId) return;
    const moved = clientY - dragged.y;
    if (!dragged.moves) {
      if (Math.abs(moved) <= slop) return;
      dragged.moves = true;
      this.list.setPointerCapture(pointerId);
      dragged.row.classList.add('dragged');
    }
    const rows = this.#rows;
    const height = dragged.row.offsetHeight;
    const most = rows.length - 1;
    dragged.to = Math.min(most, Math.max(0, dragged.from + Math.round(moved / height)));
    for (const [i, row] of rows.entries()) {
      const isPassed = i !== dragged.from && (i - dragged.from) * (i - dragged.to) <= 0;
      const aside = isPassed ? Math.sign(dragged.from - i) * height : 0;
      row.style.translate = `0 ${row === dragged.row ? moved : aside}px`;
    }
  }

  #end({ pointerId }: PointerEvent, done: boolean): void {
    const dragged = this.#dragged;
    if (dragged?.pointer !== pointerId) return;
    const { from, to, moves } = dragged;
    this.#let();
    if (!moves) return;
    // The click that follows is the drag's.
    const stop = (event: Event) => event.stopPropagation();
    this.list.addEventListener('click', stop, { capture: true, once: true });
    setTimeout(() => this.list.removeEventListener('click', stop, { capture: true }));
    if (done && to !== from) this.moved(from, to);
  }

  #let(): void {
    const pointer = this.#dragged?.pointer;
    this.#dragged?.row.classList.remove('dragged');
    this.#dragged = null;
    for (const row of this.#rows) row.style.translate = '';
    if (pointer !== undefined && this.list.hasPointerCapture(pointer)) {
      this.list.releasePointerCapture(pointer);
    }
  }
}
