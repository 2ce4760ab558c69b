import type { SurfacePoint } from 'karcher';
import { apply, type Command } from '../model/commands';
import { type CurveDocument, knotsFit, type Vector } from '../model/document';
import { activated, inPieces, joined, splineOf, withSpline } from '../model/splines';
import type { Edit } from '../worker/edits';
import type { CurveTool, Editor, Selection } from './editor';
import type { Session } from './session';

/** How often an edit is begun anew because another one, as a drag, overtook it. */
const mostAttempts = 20;

/** A command, and what is selected after it. */
interface Step {
  command: Command;
  selection: Selection;
}

/** What a command is to a B-spline's own knots; null where they have nothing to do with it. */
function editOf(command: Command): Edit | null {
  switch (command.type) {
    case 'insert':
      return { type: 'insertPoint', index: command.index, point: command.point };
    case 'remove':
      return { type: 'removePoint', index: command.index };
    case 'settings':
      return { type: 'setClosed', closed: command.to.closed };
    default:
      return null;
  }
}

/**
 * Edits that the engine works out, some or all: each is one step of the history. They are made one
 * after the other, however fast they are asked for.
 */
export class CurveEdits {
  /** While edits are under way, the end of the last one. */
  #last: Promise<void> | null = null;

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
  ) {}

  /** Adds a control point after the others. */
  append(point: SurfacePoint): Promise<void> {
    return this.#edit(({ points }) => ({
      command: { type: 'insert', index: points.length, point },
      selection: points.length,
    }));
  }

  /** Removes the selected control point, or the circle. */
  removeSelected(): Promise<void> {
    return this.#edit((document) => {
      const { selection } = this.editor.state;
      if (selection === null) return null;
      if (typeof selection === 'string') {
        return { command: { type: 'circle', from: document.circle, to: null }, selection: null };
      }
      const point = document.points[selection];
      if (!point) return null;
      const left = document.points.length - 1;
      const next = left === 0 ? null : Math.min(selection, left - 1);
      return { command: { type: 'remove', index: selection, point }, selection: next };
    });
  }

  setClosed(closed: boolean): Promise<void> {
    return this.#edit(({ settings: from }) => {
      if (from.closed === closed) return null;
      const { selection } = this.editor.state;
      return { command: { type: 'settings', from, to: { ...from, closed } }, selection };
    });
  }

  /** Gives a B-spline knots; resolves with the engine's sentence where these can be none of its. */
  async setKnots(knots: readonly number[]): Promise<string | null> {
    let problem: string | null = null;
    await this.#inOrder(async () => {
      const { document, revision } = this.editor.state;
      const spline = splineOf(document);
      if (!spline) return;
      const settings = { ...spline.settings, clamped: false, knots };
      problem = await this.session.problemWith({ ...spline, settings });
      if (!problem && this.editor.state.revision === revision) this.editor.setSettings(settings);
    });
    return problem;
  }

  undo(): Promise<void> {
    return this.#inOrder(async () => this.editor.undo());
  }

  redo(): Promise<void> {
    return this.#inOrder(async () => this.editor.redo());
  }

  /**
   * What a click on the edited curve does, at a place in the surface's coordinates; a knot within
   * that distance is meant itself.
   */
  atCurve(tool: CurveTool, near: Vector, within = 0): Promise<void> {
    return this.#inOrder(() => this.#atCurve(tool, near, within));
  }

  async #atCurve(tool: CurveTool, near: Vector, within: number): Promise<void> {
    const { document } = this.editor.state;
    if (tool === 'split') {
      const made = await this.session.reshaped({ type: 'split', near, within });
      if (made) this.editor.replace(inPieces(document, made.splines));
      else this.editor.setTool('insert');
      return;
    }
    const made = await this.session.reshaped({ type: 'insert', near, within });
    const spline = made?.splines[0];
    if (spline) this.editor.replace(withSpline(document, spline), made.point);
  }

  /** What a click on another curve does. */
  async atOther(tool: CurveTool, index: number): Promise<void> {
    if (tool === 'join') await this.join(index);
    else this.editor.replace(activated(this.editor.state.document, index));
  }

  /** Makes one curve of the edited one and another. */
  join(index: number): Promise<void> {
    return this.#inOrder(() => this.#join(index));
  }

  async #join(index: number): Promise<void> {
    const { document } = this.editor.state;
    const other = document.others[index];
    const made = other && (await this.session.reshaped({ type: 'join', other }));
    const whole = made?.splines[0];
    if (whole) this.editor.replace(joined(document, index, whole));
    else this.editor.setTool('insert');
  }

  reverse(): Promise<void> {
    return this.#inOrder(() => this.#reverse());
  }

  async #reverse(): Promise<void> {
    const { document } = this.editor.state;
    const made = await this.session.reshaped({ type: 'reverse' });
    const spline = made?.splines[0];
    if (spline) this.editor.replace(withSpline(document, spline));
  }

  /**
   * Carries out a step, at once where it needs no engine. A B-spline's own knots go on as those of
   * the engine's curve; where there is none, they go.
   */
  #edit(stepOn: (document: CurveDocument) => Step | null): Promise<void> {
    return this.#inOrder(async () => {
      const { mesh } = this.editor.state;
      for (let attempt = 0; ; attempt++) {
        const { document, revision } = this.editor.state;
        const step = stepOn(document);
        if (!step || this.editor.state.mesh !== mesh) return;
        const to = apply(document, step.command);
        const [before, after] = [splineOf(document), splineOf(to)];
        const asks = before?.kind === 'bspline' && after && !knotsFit(to);
        const edit = asks && editOf(step.command);
        const knots = edit ? await this.session.knotsAfter(before, edit) : null;
        // Something else was done in the meantime: the step comes after it.
        const late = this.editor.state.revision !== revision;
        if (late && attempt < mostAttempts) continue;
        if (knots && !late)
          this.editor.replace({ ...to, settings: { ...to.settings, knots } }, step.selection);
        else this.editor.run(step.command, step.selection);
        return;
      }
    });
  }

  #inOrder(work: () => Promise<void>): Promise<void> {
    const last: Promise<void> = (this.#last?.then(work) ?? work()).finally(() => {
      if (this.#last === last) this.#last = null;
    });
    this.#last = last;
    return last;
  }

  /** Makes ready for a click on the curve to cut. */
  chooseSplit(): void {
    const { tool } = this.editor.state;
    if (this.session.view.curve) this.editor.setTool(tool === 'split' ? 'insert' : 'split');
  }

  /** Makes ready to measure the curve, until something else is chosen or done. */
  chooseMeasure(): void {
    const { tool } = this.editor.state;
    if (tool !== 'measure' && !this.session.view.curve) return;
    this.editor.select(null);
    this.editor.setTool(tool === 'measure' ? 'insert' : 'measure');
  }

  /** Joins the only other curve, or makes ready for a click on one of them. */
  chooseJoin(): void {
    const { tool, document } = this.editor.state;
    if (!this.session.view.curve || document.others.length === 0) return;
    if (document.others.length === 1) void this.join(0);
    else this.editor.setTool(tool === 'join' ? 'insert' : 'join');
  }
}
