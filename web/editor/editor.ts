import type { SurfacePoint } from 'karcher';
import type { CircleHandle } from '../model/circle';
import { apply, type Command, invert } from '../model/commands';
import {
  type CircleForm,
  type CurveDocument,
  type CurveSettings,
  cleared,
  emptyDocument,
  isEmpty,
  isRound,
  type Kind,
  withFittingKnots,
} from '../model/document';
import { withFittingLegs, withLeg } from '../model/legs';
import { defaultMethod, type MethodId } from '../model/methods';

/** A control point by its number, or one of a circle's or ellipse's handles. */
export type Selection = number | CircleHandle | null;

export interface State {
  /** The key of the surface that is shown; empty before the first one. */
  readonly mesh: string;
  readonly document: CurveDocument;
  /** Whether this surface stands in for one that could not be opened, and nothing was done on it. */
  readonly standIn: boolean;
  readonly selection: Selection;
  readonly method: MethodId;
  /** Whether the document is a drag's, which may go on. */
  readonly dragging: boolean;
  /** The number of the control point that is dragged. */
  readonly dragged: number | null;
  /** What a click on a curve does; but for `measure` it is for one click. */
  readonly tool: CurveTool;
  /** Grows with every change of the document or the method. */
  readonly revision: number;
  /** Grows where an older curve would be wrong to show: any change but a drag's next position. */
  readonly epoch: number;
}

/** Puts a point into the edited curve, cuts it there, joins another one to it, or measures it. */
export type CurveTool = 'insert' | 'split' | 'join' | 'measure';

interface History {
  done: Command[];
  undone: Command[];
}

const longestHistory = 1000;

/** What a command led to, with legs and knots that fit; replaced documents are as they are wanted. */
function fitted(to: CurveDocument, from: CurveDocument, command: Command): CurveDocument {
  return withFittingKnots(command.type === 'replace' ? to : withFittingLegs(to, from));
}

/** The page's one state, and the only way to change it. */
export class Editor {
  #state: State = {
    mesh: '',
    document: emptyDocument,
    standIn: false,
    selection: null,
    method: defaultMethod,
    dragging: false,
    dragged: null,
    tool: 'insert',
    revision: 0,
    epoch: 0,
  };
  readonly #listeners: ((state: State, before: State) => void)[] = [];
  /** The surfaces that were shown: what was done there, and the document it led to. */
  readonly #histories = new Map<string, History>();
  readonly #documents = new Map<string, CurveDocument>();
  /** The document before the drag that is going on, and the drag as one command. */
  #drag: { base: CurveDocument; command: Command | null } | null = null;

  get state(): State {
    return this.#state;
  }

  subscribe(listener: (state: State, before: State) => void): void {
    this.#listeners.push(listener);
  }

  /**
   * Shows another surface, with the document it had when it was last shown, or else with this one.
   * What was done there can still be undone.
   */
  open(mesh: string, document: CurveDocument, { standIn } = { standIn: false }): void {
    this.cancelDrag();
    this.#documents.set(this.#state.mesh, this.#state.document);
    const kept = this.#documents.get(mesh) ?? document;
    this.#change({ mesh, document: kept, standIn, selection: null, tool: 'insert' }, true);
  }

  /** Knots of its own that do not fit any more go: `CurveEdits` knows how they go on. */
  run(command: Command, selection: Selection = this.#state.selection): void {
    this.cancelDrag();
    const from = this.#state.document;
    const wanted = apply(from, command);
    const to = fitted(wanted, from, command);
    this.#record(to === wanted ? command : { type: 'replace', from, to });
    this.#change({ document: to, selection, tool: 'insert' }, true);
  }

  /** Shows the document as it is after a command that is not yet done: a drag's next position. */
  preview(command: Command): void {
    this.#drag ??= { base: this.#state.document, command: null };
    const { base } = this.#drag;
    const wanted = apply(base, command);
    const to = fitted(wanted, base, command);
    this.#drag.command = to === wanted ? command : { type: 'replace', from: base, to };
    const dragged = command.type === 'change' ? command.index : null;
    this.#change({ document: to, dragging: true, dragged }, false);
  }

  /** Makes the drag one step of the history. */
  commitDrag(): void {
    if (this.#drag?.command) this.#record(this.#drag.command);
    const dragged = this.#drag !== null;
    this.#drag = null;
    if (dragged) this.#change({ dragging: false, dragged: null }, false);
  }

  cancelDrag(): void {
    const drag = this.#drag;
    this.#drag = null;
    if (drag) this.#change({ document: drag.base, dragging: false, dragged: null }, true);
  }

  /**
   * Makes the legs that the last drag drew out part of it: those that meet at point `dragged` of the
   * document that it led to. Does nothing where that is not the newest step any more.
   */
  keepLegs(
    document: CurveDocument,
    dragged: number,
    legs: readonly (readonly SurfacePoint[] | null)[],
  ): void {
    const last = this.#history.done.at(-1);
    const base = this.base;
    if (!last || base.points !== document.points) return;
    const before = (dragged + base.points.length - 1) % base.points.length;
    const points = base.points.map((point, i) =>
      i === dragged || i === before ? withLeg(point, legs[i]) : point,
    );
    const to = { ...base, points };
    const from = last.type === 'replace' ? last.from : apply(base, invert(last));
    this.#history.done[this.#history.done.length - 1] = { type: 'replace', from, to };
    if (!this.#drag) this.#change({ document: to }, false);
    else this.#drag.base = to;
  }

  /** Replaces the leg from a control point to the next by the shortest path. */
  takeShortest(index: number): void {
    const from = this.#state.document.points[index];
    if (from?.leg) this.run({ type: 'change', index, from, to: withLeg(from, null) });
  }

  get dragging(): boolean {
    return this.#state.dragging;
  }

  /** The document without the drag that is going on. */
  get base(): CurveDocument {
    return this.#drag?.base ?? this.#state.document;
  }

  get canUndo(): boolean {
    return this.#history.done.length > 0;
  }

  get canRedo(): boolean {
    return this.#history.undone.length > 0;
  }

  undo(): void {
    if (this.#drag) {
      this.cancelDrag();
      return;
    }
    const command = this.#history.done.pop();
    if (!command) return;
    this.#history.undone.push(command);
    this.#step(invert(command));
  }

  redo(): void {
    if (this.#drag) return;
    const command = this.#history.undone.pop();
    if (!command) return;
    this.#history.done.push(command);
    this.#step(command);
  }

  setTool(tool: CurveTool): void {
    if (tool !== this.#state.tool) this.#change({ tool }, false);
  }

  select(selection: Selection): void {
    if (selection !== this.#state.selection) this.#change({ selection }, false);
  }

  setKind(kind: Kind): void {
    const { document } = this.#state;
    if (kind !== document.kind) this.run({ type: 'kind', from: document.kind, to: kind }, null);
  }

  setSettings(part: Partial<CurveSettings>): void {
    const from = this.#state.document.settings;
    const to = { ...from, ...part };
    if (JSON.stringify(from) !== JSON.stringify(to)) this.run({ type: 'settings', from, to });
  }

  setCircleForm(part: Partial<CircleForm>): void {
    const from = this.#state.document.circleForm;
    const to = { ...from, ...part };
    if (JSON.stringify(from) !== JSON.stringify(to)) this.run({ type: 'circleForm', from, to });
  }

  setMethod(method: MethodId): void {
    if (method !== this.#state.method) this.#change({ method }, true);
  }

  /** Makes the selected control point one of so many numbers more, as far as there are points. */
  moveInOrder(steps: number): void {
    const { document, selection: from } = this.#state;
    if (typeof from !== 'number' || isRound(document.kind) || !document.points[from]) return;
    const to = Math.min(Math.max(from + steps, 0), document.points.length - 1);
    if (to !== from) this.run({ type: 'reorder', from, to }, to);
  }

  /** Shows another document of the surface, as one step of the history. */
  replace(to: CurveDocument, selection: Selection = null): void {
    const from = this.#state.document;
    if (to !== from) this.run({ type: 'replace', from, to }, selection);
  }

  clear(): void {
    const { document } = this.#state;
    if (!isEmpty(document)) this.replace(cleared(document));
  }

  get #history(): History {
    const { mesh } = this.#state;
    let history = this.#histories.get(mesh);
    if (!history) {
      history = { done: [], undone: [] };
      this.#histories.set(mesh, history);
    }
    return history;
  }

  #record(command: Command): void {
    const history = this.#history;
    history.done.push(command);
    history.undone = [];
    if (history.done.length > longestHistory) history.done.shift();
  }

  /** One step back or forth; what the step touched is selected, so that it is seen. */
  #step(command: Command): void {
    const document = apply(this.#state.document, command);
    let { selection } = this.#state;
    if (command.type === 'insert' || command.type === 'change') selection = command.index;
    else if (command.type === 'reorder') selection = command.to;
    else if (command.type !== 'circle' || !command.to) selection = null;
    this.#change({ document, selection }, true);
  }

  #change(part: Partial<State>, newEpoch: boolean): void {
    const before = this.#state;
    const state = { ...before, ...part };
    const traced =
      state.document !== before.document ||
      state.method !== before.method ||
      state.mesh !== before.mesh;
    this.#state = {
      ...state,
      standIn: part.standIn ?? (before.standIn && !traced),
      revision: before.revision + (traced ? 1 : 0),
      epoch: before.epoch + (newEpoch ? 1 : 0),
    };
    for (const listener of this.#listeners) listener(this.#state, before);
  }
}
