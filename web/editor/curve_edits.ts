import type { Reshape } from '../worker/reshape';
import type { Spline, Vector } from './document';
import type { Editor } from './editor';
import type { Session } from './session';
import { activated, samePlace, withSpline } from './splines';

/** Edits of the curve as a whole: each is one step of the history. */
export class CurveEdits {
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
  ) {}

  /** Puts a control point into the curve, near a place in the surface's coordinates. */
  async insert(near: Vector): Promise<void> {
    const { points } = this.editor.state.document;
    const spline = await this.#reshape({ type: 'insert', near });
    if (!spline) return;
    const added = spline.points.findIndex((point, i) => !samePlace(point, points[i]));
    this.editor.select(added < 0 ? null : added);
  }

  async reverse(): Promise<void> {
    await this.#reshape({ type: 'reverse' });
  }

  /** Edits another one of the document's curves. */
  activate(index: number): void {
    this.editor.replace(activated(this.editor.state.document, index));
  }

  async #reshape(edit: Reshape): Promise<Spline | null> {
    const spline = await this.session.reshaped(edit);
    if (spline) this.editor.replace(withSpline(this.editor.state.document, spline));
    return spline;
  }
}
