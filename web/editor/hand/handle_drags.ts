import { byRadii, withHandle } from '../../model/circle';
import { type CircleShape, type ControlPoint, type Figure, isCurve } from '../../model/figure';
import { withFittingLegs } from '../../model/legs';
import { type PenAction, penActionAt } from '../../model/pen_hints';
import type { DrawnTangents } from '../../model/pen_legs';
import { Handles } from '../../viewer/handles';
import type { Viewer } from '../../viewer/viewer';
import type { Session } from '../engine/session';
import type { Editor } from '../state/editor';
import type { Selection } from '../state/state';
import { selectionOf, tangentOf, underHandle } from './handle_list';
import type { HeldKeys, PenGestures } from './pen_gestures';
import type { Snapped, Snapping } from './snapping';
import { arrows } from './stage_keys';
import { clickSlop } from './stage_pointer';

/** The state at the start of a handle's drag. */
interface Grabbed {
  x: number;
  y: number;
  circle: CircleShape | null;
  /** The pen's handles at the dragged anchor (`tangents`) and at all anchors (`all`). */
  tangents: DrawnTangents;
  all: readonly DrawnTangents[];
  /** The points to select if the press becomes a click; null if the press has already selected. */
  clicked: readonly number[] | null;
  /** The effect of a click on an anchor of the pen. */
  action: PenAction | null;
}

/** The parts of the page that drags of handles share with the other gestures. */
interface Hand {
  readonly pen: PenGestures;
  readonly snapping: Snapping;
  /** The pressed keys while the pointer moves. */
  keys(): HeldKeys;
  /** Requests a call of `dragNow` before the next frame. */
  schedule(): void;
  /** Closes the edited curve. */
  close(): void;
}

const noKeys: HeldKeys = { alt: false, shift: false, control: false };

/** Moves control points, anchors and circles by their handles, with the pointer or by keys. */
export class HandleDrags {
  readonly handles: Handles;
  #grabbed: Grabbed | null = null;
  /** Whether keys move a handle. */
  #nudges = false;
  /** The pointer's newest place, which the handle has not reached yet. */
  #pointerAt: { id: string; x: number; y: number } | null = null;

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    layer: HTMLElement,
    private readonly hand: Hand,
  ) {
    this.handles = new Handles(viewer, layer, {
      grab: (id, x, y) => this.#grab(id, { x, y }, hand.keys()),
      drag: (id, x, y) => {
        this.#pointerAt = { id, x, y };
        hand.schedule();
      },
      release: (_, cancelled) => this.#release(cancelled),
      focus: (id) => {
        // A press has already made its selection, perhaps of several points.
        if (!this.#grabbed) selectFocused(editor, id);
      },
      key: (id, event) => this.#nudge(id, event),
    });
    layer.addEventListener('keyup', (event) => {
      if (event.key in arrows) this.#endNudge();
    });
    // Without the focus, the layer would miss the release of the key.
    layer.addEventListener('focusout', () => this.#endNudge());
  }

  /** Undoes the drag under way. */
  letGo(): void {
    if (this.#nudges) this.editor.cancelDrag();
    this.#forgetNudge();
    this.handles.letGo();
  }

  /** Moves the handle to the pointer's newest place. */
  dragNow(): void {
    const drag = this.#pointerAt;
    const grabbed = this.#grabbed;
    this.#pointerAt = null;
    if (!drag || !grabbed) return;
    const moved = Math.hypot(drag.x - grabbed.x, drag.y - grabbed.y);
    if (!this.editor.state.dragging && moved <= clickSlop.mouse / 2) return;
    this.#moveTo(drag.id, drag.x, drag.y, grabbed, this.hand.keys());
  }

  #grab(id: string, place: { x: number; y: number }, keys: HeldKeys): Grabbed {
    const { figure } = this.editor.state;
    const selection = selectionOf(id);
    const isPen = figure.kind === 'pen';
    const under = isPen ? underHandle(id) : null;
    const action = under
      ? penActionAt(under, this.hand.pen.state(keys.alt))
      : this.#closesAt(selection)
        ? 'close'
        : null;
    const { view } = this.session;
    const { circle } = figure;
    const clicked = selectPressed(this.editor, id, keys.shift);
    this.#grabbed = {
      ...place,
      circle: circle && byRadii(circle, view.circle),
      tangents: (isPen && typeof selection === 'number' && view.tangents?.[selection]) || {},
      all: (isPen && view.tangents) || [],
      clicked,
      action: clicked && keys.shift ? null : action,
    };
    return this.#grabbed;
  }

  /** Whether a click on a control point closes the curve under construction, as with the pen. */
  #closesAt(point: Selection): boolean {
    const { figure, tool, selection, dragging } = this.editor.state;
    const { kind, points, settings } = figure;
    if (tool !== 'insert' || kind === 'pen' || !isCurve(kind) || settings.closed || dragging)
      return false;
    return point === 0 && points.length > 2 && selection === points.length - 1;
  }

  /**
   * Moves a handle to the surface's point at a place of the window. Beside the surface the handle
   * stays where it was.
   */
  #moveTo(id: string, x: number, y: number, grabbed: Grabbed, keys: HeldKeys): void {
    const selection = selectionOf(id);
    // A handle of the pen is a direction, and does not snap.
    const control = keys.control || tangentOf(id) !== null;
    const picked = this.hand.snapping.pick({ x, y, control }, selection);
    if (!picked) return;
    this.#showSnap(picked);
    const { base } = this.editor.state;
    if (typeof selection === 'number') {
      const from = base.points[selection];
      const side = tangentOf(id)?.side;
      if (!from) return;
      if (side) {
        const to = this.hand.pen.withHandle(from, grabbed.tangents, side, { x, y }, keys);
        if (to) this.editor.preview({ type: 'change', index: selection, from, to });
      } else this.#movePoint(base, selection, picked.point, grabbed, keys);
    } else if (base.circle && grabbed.circle) {
      const to = withHandle(base.circle, grabbed.circle, selection, picked.point);
      this.editor.preview({ type: 'circle', from: base.circle, to });
    }
  }

  /** Moves a point, together with the other selected ones. */
  #movePoint(
    base: Figure,
    index: number,
    point: Snapped['point'],
    { tangents, all }: Grabbed,
    keys: HeldKeys,
  ): void {
    const { pen } = this.hand;
    const moved = (before: ControlPoint, there: Snapped['point'], drawn: DrawnTangents) =>
      base.kind === 'pen' ? pen.moved(before, drawn, there, keys) : { ...before, ...there };
    const from = base.points[index]!;
    const to = moved(from, point, tangents);
    const { more } = this.editor.state;
    if (more.length === 0) {
      this.editor.preview({ type: 'change', index, from, to });
      return;
    }
    const surface = this.viewer.surface!;
    const points = takenAlong(base.points, { index, to, more }, (other, before) =>
      moved(before, surface.along(from, to, before), all[other] ?? {}),
    );
    const replacing = withFittingLegs({ ...base, points }, base);
    this.editor.preview({ type: 'replace', from: base, to: replacing }, [...more, index]);
  }

  #showSnap(snapped: Snapped | null): void {
    if (snapped?.kind) this.handles.showPreview(snapped.position, 'snap', snapped.kind);
    else this.handles.showPreview(null, 'surface');
  }

  #release(cancelled: boolean): void {
    this.dragNow();
    this.#showSnap(null);
    const { editor } = this;
    const click = cancelled || editor.state.dragging ? null : this.#grabbed;
    this.#grabbed = null;
    if (click?.clicked) editor.selectPoints(click.clicked);
    const { selection } = editor.state;
    if (click?.action === 'close') this.hand.close();
    if (click?.action === 'convert' && typeof selection === 'number') {
      this.hand.pen.convert(selection);
    }
    if (cancelled) editor.cancelDrag();
    else editor.commitDrag();
  }

  /** Records the moves by keys as one step of the history. */
  #endNudge(): void {
    if (this.#nudges) this.editor.commitDrag();
    this.#forgetNudge();
  }

  /** Lets the focus select again. */
  #forgetNudge(): void {
    if (this.#nudges) this.#grabbed = null;
    this.#nudges = false;
  }

  #nudge(id: string, event: KeyboardEvent): void {
    const arrow = arrows[event.key];
    if (!arrow || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const step = event.shiftKey ? 16 : 4;
    const place = this.handles.place(id);
    if (!place) return;
    const grabbed = this.editor.state.dragging ? this.#grabbed : this.#grab(id, place, noKeys);
    if (!grabbed) return;
    this.#nudges = true;
    this.#moveTo(id, place.x + step * arrow[0], place.y + step * arrow[1], grabbed, noKeys);
  }
}

/**
 * Selects the point whose handle is under a press. With Shift, or if several points including this
 * one are selected, the other selected points stay selected, so that a drag moves them as well.
 * Returns the points to select if the press becomes a click; null if the press has already
 * selected.
 */
function selectPressed(editor: Editor, id: string, shift: boolean): number[] | null {
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
function selectFocused(editor: Editor, id: string): void {
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
function takenAlong(
  points: readonly ControlPoint[],
  { index, to, more }: { index: number; to: ControlPoint; more: readonly number[] },
  moved: (other: number, before: ControlPoint) => ControlPoint | null | undefined,
): ControlPoint[] {
  return points.map((point, i) => {
    if (i === index) return to;
    return (more.includes(i) && moved(i, point)) || point;
  });
}
