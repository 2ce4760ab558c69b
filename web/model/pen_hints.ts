/** The cursor and the hint that show what the pointer does to a curve of the pen tool. */
import type { Side } from './figure';

export type PenAction =
  | 'draw'
  | 'begin'
  | 'add'
  | 'bend'
  | 'move'
  | 'close'
  | 'anchor'
  | 'convert'
  | 'handle'
  | 'break';

/** The thing under the pointer. */
export type UnderPointer =
  | { type: 'surface' }
  | { type: 'curve' }
  | { type: 'anchor'; index: number }
  | { type: 'handle'; side: Side };

export interface PenState {
  /** The number of anchors. */
  anchors: number;
  closed: boolean;
  /** The index of the selected anchor. */
  selected: number | null;
  /** Whether the object is selected as a whole. */
  chosen: boolean;
  alt: boolean;
}

/**
 * Whether a click on the surface continues the curve. Without a selected anchor, the curve has
 * ended.
 */
export const goesOn = ({ anchors, closed, selected }: PenState) =>
  anchors > 0 && !closed && selected !== null;

/** Whether a click on an anchor closes the curve. */
const closesAt = (index: number, { anchors, closed, selected, alt }: PenState) =>
  index === 0 && !closed && anchors > 1 && selected === anchors - 1 && !alt;

/** Whether a drag of the curve bends it. A drag moves a curve that is selected as a whole. */
export const bends = ({ chosen, selected }: PenState) => !chosen || selected !== null;

export function penActionAt(under: UnderPointer, state: PenState): PenAction {
  switch (under.type) {
    case 'surface':
      return goesOn(state) ? 'add' : 'begin';
    case 'curve':
      return bends(state) ? 'bend' : 'move';
    case 'anchor':
      if (closesAt(under.index, state)) return 'close';
      return state.alt ? 'convert' : 'anchor';
    case 'handle':
      return state.alt ? 'break' : 'handle';
  }
}

export const penWords: Record<PenAction, string> = {
  draw: 'Drag draws a curve, Escape drops it; back at its start it closes',
  begin: 'Click to place a corner, or drag to draw a smooth anchor',
  add: 'Click adds a corner, drag a smooth anchor; Enter ends the curve',
  bend: 'Drag bends the curve, double click adds an anchor',
  move: 'Drag moves the curve, click selects an anchor',
  close: 'Click closes the curve',
  anchor: 'Drag moves the anchor, double click removes it, Alt click makes it a corner or smooth',
  convert: 'Click makes the anchor a corner or smooth, drag draws new handles',
  handle: 'Drag shapes the curve, Shift keeps to 45°, Alt breaks the handles apart',
  break: 'Drag moves this handle alone',
};
