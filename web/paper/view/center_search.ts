import { make } from '../../panels/elements';
import type { MeshSpec, Vector } from '../figures/types';
import { type KnownCenter, uniquenessWords } from '../lab/center';
import type { LabClient } from '../lab/client';

/** Looks for all centers of a panel's points, and says whether the center is unique. */
export class CenterSearch {
  readonly element = make('p', '', { className: 'panel-note only', hidden: true });
  /** The result for the points of the last search. */
  known: KnownCenter | null = null;
  isLooking = false;
  #next: Parameters<LabClient['center']> | null = null;

  constructor(
    private readonly client: LabClient,
    private readonly found: () => void,
  ) {}

  /** Looks for the centers of these points, after the search under way, if any. */
  async look(spec: MeshSpec, points: readonly Vector[], weights: readonly number[]): Promise<void> {
    this.#next = [spec, points, weights];
    if (this.isLooking) return;
    this.isLooking = true;
    while (this.#next) {
      const asked = this.#next;
      this.#next = null;
      try {
        this.known = await this.client.center(...asked);
        this.element.textContent = uniquenessWords(this.known);
        this.found();
      } catch (error) {
        this.known = null;
        this.element.textContent = error instanceof Error ? error.message : `${error}`;
      }
    }
    this.isLooking = false;
    this.element.hidden = false;
  }
}
