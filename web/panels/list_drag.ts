/**
 * The largest distance, in CSS pixels, that the pointer may move during a click. A longer motion is
 * a drag.
 */
const slop = 6;

/** The dragged object: its row, its former place, and the place that a drop would give it. */
interface Dragged {
  row: HTMLElement;
  pointer: number;
  y: number;
  from: number;
  to: number;
  moves: boolean;
}

export interface ListMoves {
  /** A row begins to move. */
  began(row: HTMLElement): void;
  /** A drop has moved the row; both places count from the top. */
  moved(from: number, to: number): void;
  /** The drag has ended, by a drop or without one. */
  ended(): void;
}

/**
 * Drags rows of a list. A mouse can take a row at any place. A finger takes it by its grip, since a
 * finger elsewhere scrolls the list.
 */
export class ListDrag {
  #dragged: Dragged | null = null;

  constructor(
    private readonly list: HTMLElement,
    private readonly moves: ListMoves,
  ) {
    list.addEventListener('pointerdown', (event) => this.#down(event));
    // The pointer may leave the list before it has moved far enough to drag the row.
    window.addEventListener('pointermove', (event) => this.#move(event));
    window.addEventListener('pointerup', (event) => this.#end(event, true));
    window.addEventListener('pointercancel', (event) => this.#end(event, false));
    window.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.#dragged?.moves) return;
      event.stopPropagation();
      this.letGo();
    });
  }

  /** Ends the drag under way without a move. */
  letGo(): void {
    if (!this.#dragged?.moves) return;
    this.#let();
    this.moves.ended();
  }

  get #rows(): HTMLElement[] {
    return [...this.list.children] as HTMLElement[];
  }

  #down(event: PointerEvent): void {
    const target = event.target as Element;
    const row = target.closest<HTMLElement>('li');
    const byGrip = target.closest('.row-grip') !== null;
    const onButton = target.closest('.eye, .lock, .fold') !== null;
    if (!row || event.button !== 0 || onButton || this.#dragged) return;
    if (event.pointerType === 'touch' && !byGrip) return;
    const place = { from: -1, to: -1 };
    this.#dragged = { row, pointer: event.pointerId, y: event.clientY, ...place, moves: false };
  }

  #move({ pointerId, clientY }: PointerEvent): void {
    const dragged = this.#dragged;
    if (dragged?.pointer !== pointerId) return;
    const moved = clientY - dragged.y;
    if (!dragged.moves) {
      if (Math.abs(moved) <= slop) return;
      // Rows may have come or gone since the press.
      dragged.from = this.#rows.indexOf(dragged.row);
      if (dragged.from < 0) return;
      dragged.moves = true;
      this.list.setPointerCapture(pointerId);
      dragged.row.classList.add('dragged');
      this.moves.began(dragged.row);
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
    // The click that follows a drag does not count as a click on a row.
    const stop = (event: Event) => event.stopPropagation();
    this.list.addEventListener('click', stop, { capture: true, once: true });
    setTimeout(() => this.list.removeEventListener('click', stop, { capture: true }));
    if (done && to !== from) this.moves.moved(from, to);
    this.moves.ended();
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
