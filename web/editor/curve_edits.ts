import type { Vector } from './document';
import type { CurveTool, Editor } from './editor';
import type { Session } from './session';
import { activated, inPieces, joined, withSpline } from './splines';

/** Edits of the curve as a whole, which the engine works out: each is one step of the history. */
export class CurveEdits {
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
  ) {}

  /** What a click on the edited curve does, at a place in the surface's coordinates. */
  async atCurve(tool: CurveTool, near: Vector): Promise<void> {
    const { document } = this.editor.state;
    if (tool === 'split') {
      const made = await this.session.reshaped({ type: 'split', near });
      if (made) this.editor.replace(inPieces(document, made.splines));
      else this.editor.setTool('insert');
      return;
    }
    const made = await this.session.reshaped({ type: 'insert', near });
    const spline = made?.splines[0];
    if (spline) this.editor.replace(withSpline(document, spline), made.point);
  }

  /** What a click on another curve does. */
  async atOther(tool: CurveTool, index: number): Promise<void> {
    if (tool === 'join') await this.join(index);
    else this.editor.replace(activated(this.editor.state.document, index));
  }

  /** Makes one curve of the edited one and another. */
  async join(index: number): Promise<void> {
    const { document } = this.editor.state;
    const other = document.others[index];
    const made = other && (await this.session.reshaped({ type: 'join', other }));
    const whole = made?.splines[0];
    if (whole) this.editor.replace(joined(document, index, whole));
    else this.editor.setTool('insert');
  }

  async reverse(): Promise<void> {
    const { document } = this.editor.state;
    const made = await this.session.reshaped({ type: 'reverse' });
    const spline = made?.splines[0];
    if (spline) this.editor.replace(withSpline(document, spline));
  }

  /** Makes ready for a click on the curve to cut. */
  chooseSplit(): void {
    const { tool } = this.editor.state;
    if (this.session.view.curve) this.editor.setTool(tool === 'split' ? 'insert' : 'split');
  }

  /** Joins the only other curve, or makes ready for a click on one of them. */
  chooseJoin(): void {
    const { tool, document } = this.editor.state;
    if (!this.session.view.curve || document.others.length === 0) return;
    if (document.others.length === 1) void this.join(0);
    else this.editor.setTool(tool === 'join' ? 'insert' : 'join');
  }
}
