import type { CircleHandle } from '../../model/circle';
import { type Command, onlyEditOf } from '../../model/commands';
import { activeObject, type Drawing, emptyDrawing, indexOf } from '../../model/drawing';
import type { Figure } from '../../model/figure';
import { defaultMethod, type MethodId } from '../../model/methods';
import type { CurveTool } from './tool';

/** A control point by its number, or one of a circle's or ellipse's handles. */
export type Selection = number | CircleHandle | null;

export interface State {
  /** The key of the surface that is shown; empty before the first one. */
  readonly mesh: string;
  readonly drawing: Drawing;
  /** The figure of the object that is edited. */
  readonly figure: Figure;
  /** The same without the drag that is going on. */
  readonly base: Figure;
  /** Whether this surface stands in for one that could not be opened, and nothing was done on it. */
  readonly standIn: boolean;
  /** The selected part of the edited object. */
  readonly selection: Selection;
  /** Points that are selected with the one of `selection`, by their numbers. */
  readonly more: readonly number[];
  /** The objects that are selected, by their ids. */
  readonly chosen: readonly number[];
  /** Whether nothing is selected, the edited object neither: it has no handles, and what is drawn next is another. */
  readonly none: boolean;
  readonly method: MethodId;
  /** Whether the drawing is a drag's, which may go on. */
  readonly dragging: boolean;
  /** The numbers of the points that are dragged, or of the anchor that is drawn out. */
  readonly dragged: readonly number[];
  /** The tool, which determines what a click does; `split` and `join` are for one click. */
  readonly tool: CurveTool;
  /** Grows with every change of the drawing or the method. */
  readonly revision: number;
  /** Grows where an older curve would be wrong to show: any change but a drag's next position. */
  readonly epoch: number;
}

/** No points or objects, which stays the same array. */
export const noNumbers: readonly number[] = [];

/** The one selection: the ids of the objects that panels, keys and files mean; the edited one is among them. */
export function selectedObjects({ chosen, none, drawing }: State): readonly number[] {
  if (none) return [];
  return chosen.length > 0 ? chosen : [drawing.active];
}

/** The state before anything was done. */
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

/** What a change gives anew; figures, counts and what hangs on them follow from it. */
export type StateChange = Partial<Omit<State, 'figure' | 'base'>>;

/** The state after a change. `dragBase` is the drawing without the drag that is going on; null without one. */
export function changedState(
  before: State,
  part: StateChange,
  dragBase: Drawing | null,
  newEpoch: boolean,
): State {
  const state = { ...before, ...part };
  // An empty object goes where another one is edited, and is selected no more.
  const isThere = (id: number) => indexOf(state.drawing, id) >= 0;
  if (!state.chosen.every(isThere)) state.chosen = state.chosen.filter(isThere);
  // The edited object is always among those that are selected.
  if (!state.chosen.includes(state.drawing.active)) state.chosen = [];
  const count = (drawing: Drawing) => activeObject(drawing).figure.points.length;
  const isOther =
    state.drawing.active !== before.drawing.active ||
    count(state.drawing) !== count(before.drawing);
  if (part.more === undefined && (part.selection !== undefined || isOther)) state.more = noNumbers;
  // What was done, and a place that is selected, has to be seen: then nothing is no longer what is selected.
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

/** The selected part of the edited object after a step was undone or redone. */
export function selectionAfter(command: Command, drawing: Drawing, before: Selection): Selection {
  const edit = onlyEditOf(command, drawing.active);
  if (edit?.type === 'insert' || edit?.type === 'change') return edit.index;
  if (edit?.type === 'reorder') return edit.to;
  // The last added point is gone: the curve continues from the one before.
  if (edit?.type === 'remove' && edit.index > 0) return edit.index - 1;
  return edit?.type === 'circle' && edit.to ? before : null;
}
