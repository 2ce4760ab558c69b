/** Selections of several points of a curve by Shift. The points move along with the dragged one. */
import type { ControlPoint } from '../../model/figure';
import type { Editor } from '../state/editor';
import { selectionOf, tangentOf } from './handle_list';

/**
 * Selects the point whose handle is under a press. With Shift, or if several points including this
 * one are selected, the other selected points stay selected, so that a drag moves them as well.
 * Returns the points to select if the press becomes a click; null if the press has already
 * selected.
 */
export function selectPressed(editor: Editor, id: string, shift: boolean): number[] | null {
  const selection = selectionOf(id);
  const { selection: last, more } = editor.state;
  const before = typeof last === 'number' ? [...more, last] : [];
  const isPoint = typeof selection === 'number' && !tangentOf(id) && editor.isOpen;
  const isIn = isPoint && before.includes(selection);
  if (!isPoint || !(shift || (isIn && more.length > 0))) {
    editor.select(selection);
    return null;
  }
  const others = before.filter((index) => index !== selection);
  editor.selectPoints([...others, selection]);
  if (!shift) return [selection];
  return isIn ? others : [...others, selection];
}

/** Selects the point whose handle has the focus; other points selected with it stay selected. */
export function selectFocused(editor: Editor, id: string): void {
  const { selection, more } = editor.state;
  const focused = selectionOf(id);
  const isIn = typeof focused === 'number' && [...more, selection].includes(focused);
  if (!isIn || more.length === 0 || tangentOf(id)) editor.select(focused);
  else selectPressed(editor, id, false);
}

/**
 * The points after a move of the one at `index`. `moved` returns each of the other selected points
 * at its new place, or null if it stays.
 */
export function takenAlong(
  points: readonly ControlPoint[],
  { index, to, more }: { index: number; to: ControlPoint; more: readonly number[] },
  moved: (other: number, before: ControlPoint) => ControlPoint | null | undefined,
): ControlPoint[] {
  return points.map((point, i) => {
    if (i === index) return to;
    return (more.includes(i) && moved(i, point)) || point;
  });
}
