import type { CircleHandle } from '../../model/circle';
import { type Command, onlyEditOf } from '../../model/commands';
import { activeObject, type Drawing, emptyDrawing, indexOf } from '../../model/drawing';
import type { Figure } from '../../model/figure';
import type { History } from '../../model/history';
import { defaultMethod, type MethodId } from '../../model/methods';

/**
 * The tool of the pointer on the stage. `select` only selects and moves, `insert` places a point on
 * the surface or in the edited curve, `freehand` draws a stroke, `transform` moves, turns and
 * scales in a frame, and `mirror` mirrors. `split` cuts the curve, `join` joins another one to it,
 * `look` copies the look of another object to the selected ones, and `measure` measures.
 */
export type CurveTool = RestingTool | 'split' | 'join' | 'look' | 'measure' | 'mirror';
/** The tools that stay active: after a tool for one click, the last of these is active again. */
export type RestingTool = 'select' | 'insert' | 'freehand' | 'transform';

export const isResting = (tool: CurveTool): tool is RestingTool =>
  ['select', 'insert', 'freehand', 'transform'].includes(tool);

/** A control point by its index, or a handle of a circle or an ellipse. */
export type Selection = number | CircleHandle | null;

export interface State {
  /** The key of the visible surface; empty before the first one. */
  readonly mesh: string;
  readonly drawing: Drawing;
  /** The figure of the edited object. */
  readonly figure: Figure;
  /** The figure without the drag under way. */
  readonly base: Figure;
  /** Whether this surface stands in for another that did not open, and is still unedited. */
  readonly standIn: boolean;
  /** The selected part of the edited object. */
  readonly selection: Selection;
  /** The indices of selected points besides `selection`. */
  readonly more: readonly number[];
  /** The ids of the selected objects. */
  readonly chosen: readonly number[];
  /**
   * Whether the selection is empty and excludes even the edited object, which then has no handles.
   * The next drawing is a new object.
   */
  readonly none: boolean;
  readonly method: MethodId;
  /** Whether the drawing belongs to an unfinished drag. */
  readonly dragging: boolean;
  /** The indices of the dragged points, or of the anchor with new handles. */
  readonly dragged: readonly number[];
  /** The tool, which determines what a click does; `split`, `join` and `look` are for one click. */
  readonly tool: CurveTool;
  /** The revision, which grows with every change of the surface, the drawing or the method. */
  readonly revision: number;
  /**
   * The epoch. It grows with each change after which older curves must not stay visible; a drag's
   * next position is no such change.
   */
  readonly epoch: number;
}

/** An empty list of points or objects, always the same array. */
export const noNumbers: readonly number[] = [];

/**
 * The selection: the ids of the objects that panels, keys and files act on, including the edited
 * one.
 */
export function selectedObjects({ chosen, none, drawing }: State): readonly number[] {
  if (none) return [];
  return chosen.length > 0 ? chosen : [drawing.active];
}

/** The method by which a surface opens, whether it stands in for another, and its drawing's history. */
export type HowOpened = Partial<Pick<State, 'standIn' | 'method'>> & { history?: History | null };

/** The initial state. */
export const firstState: State = {
  mesh: '',
  drawing: emptyDrawing,
  figure: activeObject(emptyDrawing).figure,
  base: activeObject(emptyDrawing).figure,
  standIn: false,
  selection: null,
  more: noNumbers,
  chosen: [],
  none: false,
  method: defaultMethod,
  dragging: false,
  dragged: noNumbers,
  tool: 'insert',
  revision: 0,
  epoch: 0,
};

/**
 * The fields that a change sets. `changedState` computes the figures, the counts and the fields
 * that depend on others.
 */
export type StateChange = Partial<Omit<State, 'figure' | 'base'>>;

/**
 * The state after a change. `dragBase` is the drawing without the drag under way; null without one.
 */
export function changedState(
  before: State,
  part: StateChange,
  dragBase: Drawing | null,
  newEpoch: boolean,
): State {
  const state = { ...before, ...part };
  // An empty object disappears when another one is edited, and leaves the selection.
  const isThere = (id: number) => indexOf(state.drawing, id) >= 0;
  if (!state.chosen.every(isThere)) state.chosen = state.chosen.filter(isThere);
  // The edited object is always among the selected ones.
  if (!state.chosen.includes(state.drawing.active)) state.chosen = [];
  const count = (drawing: Drawing) => activeObject(drawing).figure.points.length;
  const isOther =
    state.drawing.active !== before.drawing.active ||
    count(state.drawing) !== count(before.drawing);
  if (part.more === undefined && (part.selection !== undefined || isOther)) state.more = noNumbers;
  // A change of the drawing, or the selection of a place, ends the empty selection: the user must
  // see the edited object.
  const isSeen = state.drawing !== before.drawing || state.selection !== null;
  state.none = part.none ?? (before.none && !isSeen && state.chosen.length === 0);
  const traced =
    state.drawing !== before.drawing ||
    state.method !== before.method ||
    state.mesh !== before.mesh;
  return {
    ...state,
    figure: activeObject(state.drawing).figure,
    base: activeObject(dragBase ?? state.drawing).figure,
    standIn: part.standIn ?? (before.standIn && !traced),
    revision: before.revision + (traced ? 1 : 0),
    epoch: before.epoch + (newEpoch ? 1 : 0),
  };
}

/** The selected part of the edited object after undo or redo of a step. */
export function selectionAfter(command: Command, drawing: Drawing, before: Selection): Selection {
  const edit = onlyEditOf(command, drawing.active);
  if (edit?.type === 'insert' || edit?.type === 'change') return edit.index;
  if (edit?.type === 'reorder') return edit.to;
  // A point disappears: the curve continues from the one before it.
  if (edit?.type === 'remove' && edit.index > 0) return edit.index - 1;
  return edit?.type === 'circle' && edit.to ? before : null;
}
