import type { Drawing } from '../../model/drawing';
import { type History, historyOf } from '../../model/history';
import { drawnKey } from '../../model/meshes';

/** The last drawing on each surface shown so far, and its history. */
export class Drawings {
  readonly #drawings = new Map<string, Drawing>();
  readonly #histories = new Map<string, History>();

  keep(mesh: string, drawing: Drawing): void {
    this.#drawings.set(drawnKey(mesh), drawing);
  }

  /** The drawing kept for a surface; the first time, the given one with the given history. */
  of(mesh: string, first: Drawing, history: History | null | undefined): Drawing {
    const key = drawnKey(mesh);
    if (history && !this.#drawings.has(key)) this.#histories.set(key, history);
    return this.#drawings.get(key) ?? first;
  }

  historyOf(mesh: string): History {
    const key = drawnKey(mesh);
    const history = this.#histories.get(key) ?? historyOf();
    this.#histories.set(key, history);
    return history;
  }
}
