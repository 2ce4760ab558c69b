import type { SurfacePoint } from 'karcher';
import { isCurve } from '../../model/figure';
import type { Viewer } from '../../viewer/viewer';
import type { Editor } from '../state/editor';
import { Newest } from '../engine/newest';
import type { Session } from '../engine/session';

const nothing = new Float32Array();

/** The way on the surface from the last point of the curve that is drawn to the pointer. */
export class RubberBand {
  readonly #newest = new Newest<SurfacePoint>((point) => this.#show(point));
  #wanted: SurfacePoint | null = null;
  #isShown = false;

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
  ) {}

  /** Leads to a point that a click would add; nowhere with null. */
  aim(point: SurfacePoint | null): void {
    this.#wanted = point && this.#last ? point : null;
    if (this.#wanted) this.#newest.push(this.#wanted);
    else this.#hide();
  }

  /** The last point of the curve that is drawn; null where a click begins another one, or adds none. */
  get #last(): SurfacePoint | null {
    const { figure, selection, dragging, tool } = this.editor.state;
    const { kind, points, settings } = figure;
    if (tool !== 'insert' || dragging || !this.editor.isOpen || !isCurve(kind)) return null;
    const goesOn = kind === 'pen' ? selection !== null && !settings.closed : !settings.closed;
    return (goesOn && points.at(-1)) || null;
  }

  async #show(to: SurfacePoint): Promise<void> {
    const from = this.#last;
    const { client } = this.session;
    const { surface } = this.viewer;
    if (!from || !client || !surface || this.#wanted !== to) return;
    const plain = ({ face, bary }: SurfacePoint) => ({ face, bary });
    const path = await client.mesh.shortestPath(plain(from), plain(to)).catch(() => null);
    const isCurrent = path && this.#wanted === to && this.#last === from;
    if (!isCurrent || this.viewer.surface !== surface) return;
    this.#isShown = true;
    this.viewer.showBand(surface.toScene(path.polyline()));
  }

  #hide(): void {
    if (!this.#isShown) return;
    this.#isShown = false;
    this.viewer.showBand(nothing);
  }
}
