import type { SurfacePoint } from 'karcher';
import { type ControlPoint, isCurve, plain } from '../../model/figure';
import { methodOptions } from '../../model/methods';
import type { Viewer } from '../../viewer/viewer';
import type { EngineClient } from '../../worker/client';
import { segmentValue } from '../engine/bend';
import { Newest } from '../engine/newest';
import type { Session } from '../engine/session';
import type { Editor } from '../state/editor';

/** The number of places along a curved band. */
const samples = 24;

/**
 * The line that a click would add: the path on the surface to the pointer, or a curve from the last
 * anchor's handle.
 */
export class RubberBand {
  readonly #newest = new Newest<SurfacePoint>((point) => this.#show(point));
  #wanted: SurfacePoint | null = null;
  #isShown = false;

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
  ) {}

  /** Leads the band to the point that a click would add; null removes it. */
  aim(point: SurfacePoint | null): void {
    this.#wanted = point && this.#last ? point : null;
    if (this.#wanted) this.#newest.push(this.#wanted);
    else this.#hide();
  }

  /**
   * The last point of the curve under construction; null if a click begins another curve or adds no
   * point.
   */
  get #last(): ControlPoint | null {
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
    const line = await this.#lineTo(client, from, plain(to)).catch(() => null);
    const isCurrent = line && this.#wanted === to && this.#last === from;
    if (!isCurrent || this.viewer.surface !== surface) return;
    this.#isShown = true;
    this.viewer.aids.showBand(surface.toScene(line));
  }

  async #lineTo(client: EngineClient, from: ControlPoint, to: SurfacePoint) {
    if (!from.tangents?.after) {
      return (await client.mesh.shortestPath(plain(from), to)).polyline();
    }
    const { figure, method } = this.editor.state;
    const piece = { ...figure, points: [from, to] };
    const options = methodOptions(method);
    const value = await segmentValue(client, piece, options, { from: 0, to: 1 }, samples);
    const curve = await client.looseCurve(value);
    try {
      return await curve.polyline();
    } finally {
      curve.dispose();
    }
  }

  #hide(): void {
    if (!this.#isShown) return;
    this.#isShown = false;
    this.viewer.aids.showBand(null);
  }
}
