import type { SurfacePoint } from 'karcher';
import { inherited } from '../../model/combining';
import { applyToFigure, type Command, type FigureCommand } from '../../model/commands';
import { isDerived } from '../../model/derived';
import { activeObject, freeId, indexOf, objectOf, othersOf } from '../../model/drawing';
import {
  type Figure,
  isCurve,
  isEmpty,
  isSpline,
  knotsFit,
  opposite,
  type Spline,
  type Vector,
  withInside,
  withLeg,
} from '../../model/figure';
import { withFittingLegs } from '../../model/legs';
import { withAnchorAt } from '../../model/pen';
import { splineOf, withSpline } from '../../model/splines';
import type { Edit } from '../../worker/edits';
import type { Editor } from '../state/editor';
import type { CurveTool, Selection, State } from '../state/state';
import { withoutAnchor } from './pen_removal';
import type { Session } from './session';

/**
 * The largest number of attempts at an edit. An attempt fails if another edit, such as a drag,
 * overtakes it.
 */
const mostAttempts = 20;

/** A command, and the selection after it. */
interface Step {
  command: FigureCommand;
  selection: Selection;
}

/** The effect of a command on a B-spline's own knots; null if it has none. */
function editOf(command: FigureCommand): Edit | null {
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
 * Edits that need the engine, always or sometimes. Each is one step of the history, and each ends
 * before the next begins, however fast the user is.
 */
export class CurveEdits {
  /** The end of the last edit under way, or null. */
  #last: Promise<void> | null = null;
  /** The number of waiting actions that may lead to another edited object. */
  #turns = 0;

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
  ) {}

  /**
   * Adds a control point after the others. If the object takes none, the point begins another one.
   */
  append(point: SurfacePoint): Promise<void> {
    const { editor } = this;
    const isClosed = !editor.isOpen || isDerived(editor.state.figure.kind);
    const begins = isClosed && this.#turns === 0;
    if (begins && !editor.begin()) return Promise.resolve();
    return this.#edit(({ points }) => ({
      command: { type: 'insert', index: points.length, point },
      selection: points.length,
    }));
  }

  /** Removes the selected control points or anchors, or the circle. */
  removeSelected(): Promise<void> {
    this.editor.interrupt();
    const { figure, selection, more } = this.editor.state;
    if (typeof selection === 'number') {
      const all = [...more, selection].toSorted((a, b) => b - a);
      if (figure.kind === 'pen') return this.removeAnchors(all);
      if (more.length > 0) {
        return this.#edit((from) => {
          const points = from.points.filter((_, i) => !all.includes(i));
          const to = withFittingLegs({ ...from, points }, from);
          const command: FigureCommand = { type: 'replace', from, to };
          return { command, selection: null };
        });
      }
    }
    return this.#edit((figure) => {
      const { selection } = this.editor.state;
      if (selection === null) return null;
      if (typeof selection === 'string') {
        return { command: { type: 'circle', from: figure.circle, to: null }, selection: null };
      }
      const point = figure.points[selection];
      if (!point) return null;
      const left = figure.points.length - 1;
      const next = left === 0 ? null : Math.min(selection, left - 1);
      return { command: { type: 'remove', index: selection, point }, selection: next };
    });
  }

  /** Removes an anchor of the pen; the curve changes as little as possible. */
  removeAnchor(index: number): Promise<void> {
    return this.removeAnchors([index]);
  }

  /**
   * Removes several anchors. Their indices are in descending order, so that each removal leaves the
   * next indices valid.
   */
  removeAnchors(numbers: readonly number[]): Promise<void> {
    const index = numbers.at(-1)!;
    this.editor.interrupt();
    return this.#inOrder(async () => {
      const { drawing, figure } = this.editor.state;
      const { client } = this.session;
      if (!client || !figure.points[index] || this.editor.refuses()) return;
      for (let attempt = 0, from = figure; attempt < mostAttempts; attempt++) {
        let to = from;
        for (const number of numbers) to = await withoutAnchor(client, to, number);
        const { state } = this.editor;
        if (state.figure === from) {
          const left = to.points.length;
          this.editor.replace(to, left === 0 ? null : Math.min(index, left - 1));
          return;
        }
        // A drag may have changed the legs of the same anchors meanwhile: then the removal starts
        // again. It stops if the object or the number of anchors has changed.
        from = state.figure;
        const isSame = from.points.length === figure.points.length;
        if (!isSame || state.drawing.active !== drawing.active) return;
      }
    });
  }

  setClosed(closed: boolean): Promise<void> {
    this.editor.interrupt();
    if (this.editor.state.chosen.length > 1) {
      this.editor.setSettings({ closed });
      return Promise.resolve();
    }
    return this.#setClosed(closed);
  }

  /** Closes the edited curve, even if others are selected with it. */
  close(): Promise<void> {
    this.editor.interrupt();
    return this.#setClosed(true);
  }

  #setClosed(closed: boolean): Promise<void> {
    return this.#edit(({ settings: from }) => {
      if (from.closed === closed) return null;
      const { selection } = this.editor.state;
      return { command: { type: 'settings', from, to: { ...from, closed } }, selection };
    });
  }

  /** Sets a B-spline's knots; resolves to the engine's sentence if they are invalid. */
  async setKnots(knots: readonly number[]): Promise<string | null> {
    let problem: string | null = null;
    await this.#inOrder(async () => {
      const { figure, revision } = this.editor.state;
      const spline = splineOf(figure);
      if (!spline) return;
      const settings = { ...spline.settings, clamped: false, knots };
      problem = await this.session.problemWith({ ...spline, settings });
      if (!problem && this.editor.state.revision === revision) this.editor.setSettings(settings);
    });
    return problem;
  }

  undo(): Promise<void> {
    return this.afterwards(() => this.editor.undo());
  }

  redo(): Promise<void> {
    return this.afterwards(() => this.editor.redo());
  }

  /** Carries out a change after the edits under way. Another object may be the edited one then. */
  afterwards(change: () => void): Promise<void> {
    this.#turns++;
    return this.#inOrder(async () => {
      this.#turns--;
      change();
    });
  }

  /**
   * Carries out a click on the edited curve at a place in the surface's coordinates. If a knot lies
   * within the distance `within`, the click means the knot.
   */
  atCurve(tool: CurveTool, near: Vector, within = 0): Promise<void> {
    return this.#inOrder(() => this.#atCurve(tool, near, within));
  }

  async #atCurve(tool: CurveTool, near: Vector, within: number): Promise<void> {
    const { figure } = this.editor.state;
    if (figure.kind === 'pen') {
      await this.#putAnchor(near);
      return;
    }
    if (tool === 'split') {
      const made = await this.session.reshaped({ type: 'split', near, within });
      if (made) this.#cut(made.splines);
      else this.editor.rest();
      return;
    }
    const made = await this.session.reshaped({ type: 'insert', near, within });
    const spline = made?.splines[0];
    if (spline) this.editor.replace(withSpline(figure, spline), made.point);
  }

  /** Inserts an anchor where the curve of the pen is nearest to a place. */
  async #putAnchor(near: Vector): Promise<void> {
    const { figure } = this.editor.state;
    const { tangents, curve } = this.session.view;
    const measured = await this.session.measured(near);
    if (!measured || !tangents || !curve || this.editor.state.figure !== figure) return;
    const { parameter, point, tangent } = measured;
    const { points, index } = withAnchorAt(
      figure,
      tangents,
      parameter,
      point,
      tangent,
      curve.samples,
    );
    this.editor.replace({ ...figure, points }, index);
  }

  /**
   * Replaces the edited object by the first piece, and adds the other pieces above it in the same
   * style. Objects derived from it are derived from all pieces.
   */
  #cut([first, ...rest]: readonly Spline[]): void {
    const { drawing, figure } = this.editor.state;
    if (!first) return;
    const object = activeObject(drawing);
    const at = indexOf(drawing, object.id);
    const to = withSpline(figure, first);
    const others = rest.map((piece, i) => {
      return { ...object, id: freeId(drawing) + i, figure: withSpline(figure, piece) };
    });
    const steps: Command[] = [
      { type: 'figure', id: object.id, edit: { type: 'replace', from: figure, to } },
      ...others.map((other, i): Command => ({ type: 'add', index: at + 1 + i, object: other })),
      ...inherited(
        drawing,
        object.id,
        [object, ...others].map(({ id }) => id),
      ),
    ];
    this.editor.perform({ type: 'steps', steps }, { selection: null });
  }

  /** Carries out a click on another object. */
  async atOther(tool: CurveTool, id: number): Promise<void> {
    if (tool === 'join') await this.join(id);
    else if (tool === 'look') this.editor.objects.takeLook(id);
    else this.editor.activate(id);
  }

  /** Joins the edited object and another curve into one. */
  join(id: number): Promise<void> {
    this.editor.interrupt();
    return this.#inOrder(() => this.#join(id));
  }

  async #join(id: number): Promise<void> {
    const { drawing, figure } = this.editor.state;
    const object = objectOf(drawing, id);
    const other = object && splineOf(object.figure);
    const made = other && (await this.session.reshaped({ type: 'join', other }));
    const whole = made?.splines[0];
    if (!object || !whole) {
      this.editor.rest();
      return;
    }
    const to = withSpline(figure, whole);
    const steps: Command[] = [
      { type: 'figure', id: drawing.active, edit: { type: 'replace', from: figure, to } },
      ...inherited(drawing, id, [drawing.active]),
      { type: 'delete', index: indexOf(drawing, id), object },
    ];
    this.editor.perform({ type: 'steps', steps }, { selection: null });
  }

  /** Replaces the leg from a control point to the next by the shortest path. */
  takeShortest(index: number): void {
    const { editor } = this;
    const from = editor.state.figure.points[index];
    if (from?.leg) editor.run({ type: 'change', index, from, to: withLeg(from, null) });
  }

  reverse(): Promise<void> {
    this.editor.interrupt();
    return this.#inOrder(() => this.#reverse());
  }

  async #reverse(): Promise<void> {
    const { figure } = this.editor.state;
    const made = await this.session.reshaped({ type: 'reverse' });
    const spline = made?.splines[0];
    if (!spline) return;
    const { inside } = figure;
    const to = withSpline(figure, spline);
    this.editor.replace(inside ? withInside(to, opposite(inside)) : to);
  }

  /**
   * Carries out a step, at once if it needs no engine. If a B-spline's own knots no longer fit, the
   * engine finds new ones; if it finds none, the curve loses its own knots. The step changes the
   * object that is edited now, or after the actions before it.
   */
  #edit(stepOn: (figure: Figure) => Step | null): Promise<void> {
    const { mesh, drawing } = this.editor.state;
    const edited = this.#turns > 0 ? null : drawing.active;
    return this.#inOrder(async () => {
      const id = edited ?? this.editor.state.drawing.active;
      const now = () => objectOf(this.editor.state.drawing, id)?.figure;
      for (let attempt = 0; ; attempt++) {
        const figure = now();
        const step = figure && stepOn(figure);
        if (!step || this.editor.state.mesh !== mesh) return;
        const to = withFittingLegs(applyToFigure(figure, step.command), figure);
        const [before, after] = [splineOf(figure), splineOf(to)];
        const asks = before?.kind === 'bspline' && after && !knotsFit(to);
        const edit = asks && editOf(step.command);
        const knots = edit ? await this.session.knotsAfter(before, edit) : null;
        // If the curve has changed meanwhile, the step starts again from the new one.
        const late = now() !== figure;
        if (late && attempt < mostAttempts) continue;
        const withKnots = { ...to, settings: { ...to.settings, knots } };
        const command: FigureCommand =
          knots && !late ? { type: 'replace', from: figure, to: withKnots } : step.command;
        if (now()) this.editor.run(command, step.selection, id);
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

  /** Waits for a click at which to split the curve. */
  chooseSplit(): void {
    if (!this.#hasSpline() || this.editor.refuses()) return;
    this.#toggle('split');
  }

  /** Measures the curve under the pointer, until the user chooses another tool or edits. */
  chooseMeasure(): void {
    this.editor.select(null);
    this.#toggle('measure');
  }

  /** Joins the only other curve. If there are several, waits for a click on one of them. */
  chooseJoin(): void {
    const others = joinable(this.editor.state);
    if (!this.#hasSpline() || others.length === 0 || this.editor.refuses()) return;
    if (others.length === 1) void this.join(others[0]!);
    else this.#toggle('join');
  }

  #toggle(tool: CurveTool): void {
    if (this.editor.state.tool === tool) this.editor.rest();
    else this.editor.setTool(tool);
  }

  #hasSpline(): boolean {
    return this.#hasCurve() && isSpline(this.editor.state.figure.kind);
  }

  #hasCurve(): boolean {
    const { figure, none } = this.editor.state;
    return this.session.view.curve !== null && isCurve(figure.kind) && !none;
  }
}

/** The ids of the curves that the edited one can join. */
export const joinable = ({ drawing }: State): number[] =>
  othersOf(drawing)
    .filter(({ figure, visible, locked }) => visible && !locked && !isEmpty(figure))
    .filter(({ figure }) => isSpline(figure.kind))
    .map(({ id }) => id);
