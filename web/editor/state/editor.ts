import { activation, beginning, deletion, ofKind, withGroups } from '../../model/arranging';
import {
  apply,
  applyToFigure,
  type Command,
  type FigureCommand,
  fitted,
} from '../../model/commands';
import {
  activeObject,
  type Drawing,
  type DrawnObject,
  indexOf,
  objectOf,
} from '../../model/drawing';
import {
  type CircleForm,
  type CurveSettings,
  cleared,
  type Figure,
  type Inside,
  isCurve,
  isEmpty,
  isRound,
  isUnfinished,
  type Kind,
} from '../../model/figure';
import { type History, record, recordActivation, stepBack, stepForth } from '../../model/history';
import type { MethodId } from '../../model/methods';
import { excessOf } from '../../model/saved_drawing';
import { Begun } from './begun';
import { DragStep } from './drag_step';
import { Drawings } from './drawings';
import { ObjectEdits, type PartOfStep } from './object_edits';
import {
  type CurveTool,
  changedState,
  firstState,
  type HowOpened,
  isResting,
  noNumbers,
  type RestingTool,
  type Selection,
  type State,
  type StateChange,
  selectedObjects,
  selectionAfter,
} from './state';

/** The page's single state, and the only way to change it. */
export class Editor {
  #state: State = firstState;
  /** The edits of whole objects. */
  readonly objects = new ObjectEdits(this);
  readonly #listeners: ((state: State, before: State) => void)[] = [];
  readonly #drawings = new Drawings();
  #drag: DragStep | null = null;
  #resting: RestingTool = 'insert';
  readonly begun = new Begun(firstState.drawing);

  /** A listener for the sentence that says why an edit is refused. */
  onRefusal: (sentence: string) => void = () => {};

  /** A listener for an action that interrupts the drag. The gesture of the drag then ends. */
  onInterrupt: () => void = () => {};
  /** The function that returns the edited figure at the end of a drag of its points. */
  onEnded: (figure: Figure) => Figure = (figure) => figure;
  /** The function that returns the side that a figure encloses in the view; drags keep it. */
  insideOf: (figure: Figure) => Inside | null = () => null;

  get state(): State {
    return this.#state;
  }

  subscribe(listener: (state: State, before: State) => void): void {
    this.#listeners.push(listener);
  }

  /**
   * Shows another surface with the last drawing on it, by another method if one is given. The first
   * time, it shows the given drawing with the given history. Undo can still revert earlier steps on
   * the surface.
   */
  open(mesh: string, drawing: Drawing, { history, ...how }: HowOpened = {}): void {
    this.cancelDrag();
    this.#drawings.keep(this.#state.mesh, this.#state.drawing);
    const kept = this.#drawings.of(mesh, drawing, history);
    const part = { mesh, drawing: kept, standIn: false, selection: null, chosen: [], ...how };
    this.begun.keep();
    this.#change({ ...part, tool: this.#resting }, true);
  }

  /** Changes the whole drawing, as one step of the history; false if a limit refuses the step. */
  perform(command: Command | null, part: PartOfStep = {}): boolean {
    if (!command) return true;
    this.cancelDrag();
    const whole = this.begun.gone(command, this.#state.drawing);
    const drawing = apply(this.#state.drawing, whole);
    if (!this.#records(command, whole, drawing)) return false;
    this.#change({ drawing, ...part, tool: this.#resting }, true);
    return true;
  }

  /**
   * Changes the edited object, or another one by its id. A B-spline loses its own knots if they no
   * longer fit; `CurveEdits` finds new ones instead.
   */
  run(edit: FigureCommand, selection: Selection = this.#state.selection, of?: number): void {
    this.cancelDrag();
    const { id } = this.active;
    if (this.refuses(objectOf(this.#state.drawing, of ?? id))) return;
    this.perform(this.#commandOf(edit, of), (of ?? id) === id ? { selection } : {});
  }

  /**
   * Shows the drawing after an unfinished edit: a drag's next position. An edit that moves several
   * points names them in `dragged`.
   */
  preview(edit: FigureCommand, dragged: readonly number[] = noNumbers): void {
    if (!this.#drag && this.refuses()) return;
    this.#drag ??= new DragStep(this.#state.drawing, this.objects.insideKept(this.active));
    const { base } = this.#drag;
    this.#drag.command = this.#commandOf(edit);
    const drawing = apply(base, this.#drag.withInside(this.#drag.command));
    const single = edit.type === 'change' || edit.type === 'insert';
    this.#change({ drawing, dragging: true, dragged: single ? [edit.index] : dragged }, false);
  }

  /** Shows the drawing after a command on whole objects, as a drag's next position. */
  previewCommand(command: Command): void {
    this.#drag ??= new DragStep(this.#state.drawing);
    this.#drag.command = command;
    const drawing = apply(this.#drag.base, command);
    this.#change({ drawing, dragging: true, dragged: noNumbers }, false);
  }

  /** Shows an edit of a new object of this kind; the object and the edit are one step together. */
  previewBegun(kind: Kind, edit: FigureCommand): void {
    const base = this.baseDrawing;
    const begin = beginning(base, kind);
    if (!begin) {
      this.preview(edit);
      return;
    }
    const { id } = activeObject(apply(base, begin));
    this.previewCommand({ type: 'steps', steps: [begin, { type: 'figure', id, edit }] });
  }

  /** Turns the drag into one step of the history; false if a limit refuses the step. */
  commitDrag(): boolean {
    if (!this.#drag) return true;
    const { base } = this.#drag;
    const ended = this.#drag.command && this.#ended(this.#drag.command, base);
    const made = ended && this.#drag.withInside(ended);
    const command = made && this.begun.gone(made, base);
    const isAsShown = command === this.#drag.command;
    const drawing = isAsShown ? this.#state.drawing : apply(base, command!);
    const changes = made && command && base !== drawing;
    if (changes && !this.#records(made, command, drawing)) return false;
    this.#drag = null;
    this.#change({ drawing, dragging: false, dragged: noNumbers }, false);
    return true;
  }

  /** The command of an ended drag, with the changes that follow from it. */
  #ended(command: Command, base: Drawing): Command {
    if (command.type !== 'figure' || this.#state.dragged.length === 0) return command;
    const { figure } = this.#state;
    const to = this.onEnded(figure);
    if (to === figure) return command;
    const from = objectOf(base, command.id)!.figure;
    return { ...command, edit: { type: 'replace', from, to } };
  }

  /** Makes the drag a step as it is shown, even if another action precedes its last step. */
  releaseDrag(): void {
    if (this.#drag) this.#drag.released = true;
  }

  /** Ends a released drag as it is shown: its gesture is let go, and takes no last step. */
  settleDrag(): void {
    if (!this.#drag?.released) return;
    this.#drag.released = false;
    this.commitDrag();
    this.onInterrupt();
  }

  /** Takes the drag under way back; a released one stays. */
  cancelDrag(): void {
    this.settleDrag();
    const drag = this.#drag;
    this.#drag = null;
    if (drag) this.#change({ drawing: drag.base, dragging: false, dragged: noNumbers }, true);
  }

  /** Ends the drag under way: the next edit starts from the drawing before it, or after a release. */
  interrupt(): void {
    this.onInterrupt();
    this.cancelDrag();
  }

  /** The drawing without the drag under way. */
  get baseDrawing(): Drawing {
    return this.#drag?.base ?? this.#state.drawing;
  }

  get active(): DrawnObject {
    return activeObject(this.#state.drawing);
  }

  get canUndo(): boolean {
    return this.#history.done.length > 0;
  }

  get canRedo(): boolean {
    return this.#history.undone.length > 0;
  }

  /** The history of the visible surface. */
  get history(): Readonly<History> {
    return this.#history;
  }

  /** Undoes the newest step, or the drag under way. */
  undo(): void {
    const dragged = this.#drag !== null && !this.#drag.released;
    this.interrupt();
    if (dragged) return;
    const command = stepBack(this.#history);
    if (!command) return;
    this.#step(command);
    this.begun.follow(this.#state, true);
  }

  redo(): void {
    if (this.#drag) return;
    const command = stepForth(this.#history);
    if (command) this.#step(command);
  }

  setTool(tool: CurveTool): void {
    if (isResting(tool)) this.#resting = tool;
    if (tool === 'select' && isEmpty(this.#state.figure)) this.#dropBegun();
    if (tool !== this.#state.tool) this.#change({ tool }, false);
  }

  /** Clears the selection, and removes the edited object if it was only begun. */
  #dropBegun(): void {
    this.cancelDrag();
    const { drawing } = this.#state;
    const { active, objects } = drawing;
    const drawn = objects.findLast(({ id, figure }) => id !== active && !isEmpty(figure));
    if (!this.begun.is(active) || (!drawn && isEmpty(this.#state.figure))) return;
    const command = drawn ? activation(drawing, drawn.id) : deletion(drawing, [active]);
    if (!command) return;
    const whole = this.begun.gone(command, drawing);
    const part = { selection: null, chosen: [], none: drawn !== undefined };
    this.#leave(whole, whole !== command || !drawn);
    this.#change({ drawing: apply(drawing, whole), ...part }, true);
  }

  /**
   * Records the change to another object. If the change removes points (`drops`), it is a step of
   * its own. If steps have been undone, it is no step, since redo must keep these steps.
   */
  #leave(command: Command, drops: boolean): void {
    if (drops) this.begun.onRemoval();
    const isStep = drops && this.#history.undone.length === 0;
    if (isStep) record(this.#history, command);
    else recordActivation(this.#history, command);
  }

  /** After a tool for one click, returns to the last tool that stays active. */
  rest(): void {
    this.setTool(this.#resting);
  }

  select(selection: Selection): void {
    if (selection !== this.#state.selection) this.#change({ selection }, false);
  }

  /** Selects points of the edited object by their indices; the last is the main one. */
  selectPoints(points: readonly number[]): void {
    this.#change({ selection: points.at(-1) ?? null, more: points.slice(0, -1) }, false);
  }

  /** Selects objects, and a place of the edited object. The edited object stays the same. */
  setSelection(part: PartOfStep): void {
    this.#change(part, false);
  }

  /** Selects objects and edits the last one, without a step (`recordActivation`). */
  choose(ids: readonly number[]): void {
    const chosen = withGroups(this.#state.drawing, ids);
    const edited = ids.findLast((id) => objectOf(this.#state.drawing, id));
    const command = edited === undefined ? null : activation(this.#state.drawing, edited);
    if (command) {
      this.cancelDrag();
      const whole = this.begun.gone(command, this.#state.drawing);
      const drawing = apply(this.#state.drawing, whole);
      this.#leave(whole, whole !== command);
      this.#change({ drawing, selection: null, chosen, tool: this.#resting }, true);
    } else if (`${chosen}` !== `${this.#state.chosen}`) {
      this.#change({ chosen, selection: null, none: false }, false);
    } else if (chosen.length > 0 && this.#state.none) this.#change({ none: false }, false);
  }

  /** Edits another object, and selects it alone or with the rest of its group. */
  activate(id: number): void {
    this.choose([id]);
  }

  /** Adds an object to the selection, or removes it. */
  toggle(id: number): void {
    const { drawing } = this.#state;
    const selected = selectedObjects(this.#state).filter(
      (one) => !isEmpty(objectOf(drawing, one)!.figure),
    );
    if (!selected.includes(id)) {
      this.choose([...selected, id]);
      return;
    }
    const group = withGroups(drawing, [id]);
    const left = selected.filter((one) => !group.includes(one));
    if (left.length > 0) this.choose(left);
    else this.letGo();
  }

  /** Clears the selection, and removes an object that was only begun. */
  letGo(): void {
    const { none, selection, chosen, figure } = this.#state;
    if (isUnfinished(figure) && !this.active.locked) this.#dropBegun();
    if (this.#state.figure !== figure) return;
    if (isEmpty(figure)) this.#change({ selection: null, chosen: [] }, false);
    else if (!none || selection !== null || chosen.length > 0) {
      this.#change({ selection: null, chosen: [], none: true }, false);
    }
  }

  /** Selects the edited object if none is selected, unless the user cleared the selection. */
  chooseSome(): void {
    const { chosen, none, drawing, figure } = this.#state;
    if (none) return;
    if (chosen.length === 0 && !isEmpty(figure)) this.choose([drawing.active]);
  }

  chooseAll(): void {
    const { objects, active } = this.#state.drawing;
    const open = objects.filter(({ visible, locked }) => visible && !locked);
    const chosen = open.flatMap(({ id, figure }) => (isEmpty(figure) ? [] : [id]));
    const last = chosen.includes(active) ? active : chosen.at(-1);
    if (last !== undefined) this.choose([...chosen.filter((id) => id !== last), last]);
  }

  /** Begins another object for the next drawing; false if a limit refuses it. */
  begin(kind?: Kind): boolean {
    this.interrupt();
    this.setTool('insert');
    const command = beginning(this.#state.drawing, kind);
    const isBegun = this.perform(command, { selection: null, chosen: [] });
    if (isBegun && this.#state.chosen.length > 0) this.#change({ chosen: [] }, false);
    return isBegun;
  }

  /** Chooses the kind of the next drawing; a curve with points becomes another kind of curve. */
  setKind(kind: Kind): void {
    this.interrupt();
    this.setTool('insert');
    if (this.#state.none) {
      this.begin(kind);
      return;
    }
    const command = ofKind(this.#state.drawing, kind);
    if (!command) return;
    if (command.type === 'figure') this.run(command.edit, null);
    else this.perform(command, { selection: null, chosen: [] });
  }

  /** Changes settings of the selected curves. */
  setSettings(part: Partial<CurveSettings>): void {
    this.interrupt();
    const { drawing, selection } = this.#state;
    const ids = selectedObjects(this.#state);
    const edit = ({ settings: from }: Figure) =>
      ({ type: 'settings', from, to: { ...from, ...part } }) as const;
    const changed = drawing.objects.filter(({ id, figure }) => {
      const { from, to } = edit(figure);
      return ids.includes(id) && JSON.stringify(to) !== JSON.stringify(from);
    });
    if (ids.length < 2) {
      if (changed[0]) this.run(edit(changed[0].figure));
      return;
    }
    const steps = changed
      .filter(({ figure, locked }) => isCurve(figure.kind) && !locked)
      .map(({ id, figure }) => this.#commandOf(edit(figure), id));
    if (steps.length > 0) this.perform({ type: 'steps', steps }, { selection });
  }

  setCircleForm(part: Partial<CircleForm>): void {
    this.interrupt();
    const from = this.#state.figure.circleForm;
    const to = { ...from, ...part };
    if (JSON.stringify(from) !== JSON.stringify(to)) this.run({ type: 'circleForm', from, to });
  }

  setMethod(method: MethodId): void {
    if (method !== this.#state.method) this.#change({ method }, true);
  }

  /** Moves the selected control point by some places in the order, as far as possible. */
  moveInOrder(steps: number): void {
    this.interrupt();
    const { figure, selection: from } = this.#state;
    if (typeof from !== 'number' || isRound(figure.kind) || !figure.points[from]) return;
    const to = Math.min(Math.max(from + steps, 0), figure.points.length - 1);
    if (to !== from) this.run({ type: 'reorder', from, to }, to);
  }

  /** Replaces the figure of the edited object, as one step of the history. */
  replace(to: Figure, selection: Selection = null): void {
    const from = this.#state.figure;
    if (to !== from) this.run({ type: 'replace', from, to }, selection);
  }

  /** Shows another drawing of the surface, as one step of the history. */
  draw(to: Drawing): void {
    this.interrupt();
    const from = this.#state.drawing;
    this.perform({ type: 'draw', from, to }, { selection: null, chosen: [] });
  }

  clear(): void {
    this.interrupt();
    const { figure } = this.#state;
    if (!isEmpty(figure)) this.replace(cleared(figure));
  }

  /** The command on `baseDrawing` for an edit of an object, by default the active one. */
  #commandOf(edit: FigureCommand, of?: number): Command {
    const base = this.baseDrawing;
    const { id, figure: from } = (of !== undefined && objectOf(base, of)) || activeObject(base);
    // The applied edit only shows whether legs and knots still fit.
    const wanted = applyToFigure(from, edit);
    const to = fitted(wanted, from, edit);
    return { type: 'figure', id, edit: to === wanted ? edit : { type: 'replace', from, to } };
  }

  /** Whether clicks add to the active object: it is selected, visible and not locked. */
  get isOpen(): boolean {
    const { locked, visible } = this.active;
    return visible && !locked && !this.#state.none;
  }

  /** Whether an object, by default the active one, is locked; if so, reports it. */
  refuses({ locked } = this.active): boolean {
    if (locked)
      this.onRefusal('This object is locked. Unlock it in the list of objects to edit it.');
    return locked;
  }

  /**
   * Records a command, as a whole with what it removes. A command that leads beyond a limit of what
   * the page reads is refused; the result is false then.
   */
  #records(command: Command, whole: Command, to: Drawing): boolean {
    const why = command.type === 'draw' || excessOf(this.baseDrawing) ? null : excessOf(to);
    if (why) {
      this.cancelDrag();
      this.onRefusal(why);
      return false;
    }
    record(this.#history, whole);
    if (whole !== command) this.begun.onRemoval();
    return true;
  }

  get #history(): History {
    return this.#drawings.historyOf(this.#state.mesh);
  }

  /** Shows the drawing after undo or redo of a step, and selects the changed place to show it. */
  #step(command: Command): void {
    const drawing = apply(this.#state.drawing, command);
    const chosen = this.#state.chosen.filter((id) => indexOf(drawing, id) >= 0);
    const selection = selectionAfter(command, drawing, this.#state.selection);
    this.#change({ drawing, selection, chosen }, true);
  }

  #change(part: StateChange, newEpoch: boolean): void {
    const before = this.#state;
    this.#state = changedState(before, part, this.#drag?.base ?? null, newEpoch);
    if (!this.#drag) this.begun.follow(this.#state);
    for (const listener of this.#listeners) listener(this.#state, before);
  }
}
