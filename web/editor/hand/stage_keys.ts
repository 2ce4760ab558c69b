import type { Viewer } from '../../viewer/viewer';
import type { Editor } from '../state/editor';
import type { MoveGestures } from './move_gestures';

/**
 * The step in CSS pixels by which an arrow moves the selection; Shift makes it ten times as long.
 */
const nudgePixels = 4;
/** The steps by which an arrow moves the view, in CSS pixels, and turns it, in radians. */
const panPixels = 40;
const turnAngle = 0.12;
/** The directions of the arrow keys on the screen. */
export const arrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

interface Place {
  x: number;
  y: number;
}

/** The keys of the stage: they turn and zoom the view, move the selection and place points. */
export class StageKeys {
  /** `clicked` receives the clicks by a key, `aimed` the place of the next click. */
  constructor(
    private readonly editor: Editor,
    private readonly viewer: Viewer,
    private readonly stage: HTMLElement,
    private readonly moves: MoveGestures,
    private readonly events: { clicked(place: Place): void; aimed(place: Place): void },
  ) {
    stage.tabIndex = 0;
    stage.addEventListener('keydown', (event) => this.#down(event));
    stage.addEventListener('keyup', (event) => {
      if (event.key in arrows) moves.endNudge();
    });
    window.addEventListener('keydown', (event) => this.#space(event));
    window.addEventListener('keyup', ({ key }) => {
      if (key === ' ') viewer.movesView = false;
    });
    window.addEventListener('blur', () => {
      viewer.movesView = false;
    });
  }

  /**
   * While the space bar is down, the pointer moves the view. If a button or a field has the focus,
   * the space bar acts on this element instead.
   */
  #space(event: KeyboardEvent): void {
    if (event.key !== ' ' || event.defaultPrevented) return;
    const { target } = event;
    const isTaken =
      target instanceof Element &&
      target.closest('button:not(.handle), input, select, textarea, a, summary, dialog, [popover]');
    if (isTaken) return;
    event.preventDefault();
    this.viewer.movesView = true;
  }

  #down(event: KeyboardEvent): void {
    const { stage, viewer } = this;
    if (event.target !== stage || event.altKey) return;
    const arrow = arrows[event.key];
    if (event.ctrlKey || event.metaKey) {
      // Arrow keys with Ctrl move the view, whatever the selection is.
      if (!arrow) return;
      if (event.shiftKey) viewer.pan(panPixels * arrow[0], panPixels * arrow[1]);
      else this.#turn(arrow);
      event.preventDefault();
      return;
    }
    const { left, top, width, height } = viewer.box;
    const middle = { x: left + width / 2, y: top + height / 2 };
    const nudge = event.shiftKey ? 10 * nudgePixels : nudgePixels;
    if (arrow && this.editor.state.chosen.length > 0) {
      this.moves.nudge(nudge * arrow[0], nudge * arrow[1]);
    } else if (arrow) this.#turn(arrow);
    else if (event.key === '+' || event.key === '=') viewer.zoom(1 / 1.15);
    else if (event.key === '-') viewer.zoom(1.15);
    else if (event.key === 'Enter') {
      // After a press of the pointer, clicks place the points, and Enter ends the curve (tools.ts).
      if (stage.classList.contains('pointed')) return;
      this.events.clicked(middle);
    } else return;
    event.preventDefault();
    stage.classList.remove('pointed');
    this.events.aimed(middle);
  }

  #turn([aside, up]: [number, number]): void {
    this.viewer.orbit(turnAngle * aside, turnAngle * up);
  }
}
