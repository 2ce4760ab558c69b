import { leavingCopies } from '../../model/arranging';
import type { Command } from '../../model/commands';
import { placesOf } from '../../model/moving';
import type { Viewer } from '../../viewer/viewer';
import { copiedObjects, leaves, Move, movableObjects } from '../engine/moving';
import { Newest } from '../engine/newest';
import type { Session } from '../engine/session';
import type { Editor } from '../state/editor';
import { isResting } from '../state/state';
import type { Hold, Place } from './stage_pointer';
import { reach, targetAt } from './targets';

/** A line that the user drags, and the move of the selected objects with it. */
interface HeldLine {
  move: Promise<Move | null>;
  stopped: boolean;
  /** Whether copies stay at the old place. */
  copies: boolean;
  /** Whether only the last step is still under way. */
  released: boolean;
}

/**
 * A move by keys: the place in the window to which it has moved the pivot, and the revision of the
 * drawing after its last step.
 */
interface KeyedMove {
  move: Move;
  x: number;
  y: number;
  revision: number;
}

/** Moves an object by a drag of its line, together with all selected objects. */
export class MoveGestures {
  #held: HeldLine | null = null;
  readonly #newest = new Newest<Place>((place) => this.#moveTo(place));
  /** The move by keys under way. */
  #keyed: KeyedMove | null = null;
  #nudges: Promise<void> = Promise.resolve();

  /** `clicked` receives a press that was no drag, `stopped` a sentence if a move stops. */
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    private readonly events: { clicked(place: Place): void; stopped(why: string): void },
  ) {}

  /** Takes hold of the line under a press. */
  take(press: Place): Hold | null {
    const { editor } = this;
    if (press.shift || press.control || this.#held) return null;
    if (!isResting(editor.state.tool)) return null;
    // With other tools Alt turns the view.
    if (press.alt && editor.state.tool !== 'select') return null;
    const id = this.#lineAt(press);
    // A finger turns the view everywhere except on the selection.
    if (id === null || (press.touch && !editor.state.chosen.includes(id))) return null;
    return {
      drag: (place) => {
        this.#held ??= {
          ...{ move: this.#begin(press), stopped: false },
          ...{ copies: press.alt, released: false },
        };
        this.#newest.push(place);
      },
      release: (place, dragged) => {
        if (dragged) void this.#end(place);
        else this.events.clicked(press);
      },
      cancel: () => this.letGo(),
    };
  }

  /** Ends the move without further steps: undone, or as it is shown if it was released. */
  letGo(): void {
    const keyed = this.#keyed?.revision === this.editor.state.revision;
    const held = this.#held !== null;
    this.#keyed = null;
    this.#held = null;
    this.#newest.drop();
    if (keyed || held) this.editor.cancelDrag();
  }

  /** The id of the object whose line is at a place of the window; null without one. */
  #lineAt(place: Place): number | null {
    const { state, isOpen } = this.editor;
    const target = targetAt(this.viewer, state, place);
    if (target?.type === 'other') return target.id;
    const within = place.touch ? reach.touch : reach.mouse;
    const own = target?.type === 'curve' || this.viewer.linesAt(place.x, place.y).own(within);
    return own && isOpen ? state.drawing.active : null;
  }

  /** Begins a move of the object under the pointer, together with the selection. */
  async #begin(press: Place): Promise<Move | null> {
    const { editor, session, viewer } = this;
    const id = this.#lineAt(press);
    const pivot = viewer.pick(press.x, press.y)?.point;
    const { client } = session;
    if (id === null || !pivot || !client || !viewer.surface) return null;
    if (!editor.state.chosen.includes(id)) editor.activate(id);
    const { chosen, drawing } = editor.state;
    const objects = movableObjects(drawing, chosen.length > 0 ? chosen : [id]);
    return Move.of(session, viewer.surface, { drawing, objects }, pivot).catch(() => null);
  }

  /** Moves the selection by a number of CSS pixels. All nudges until `endNudge` are one step. */
  nudge(dx: number, dy: number): void {
    // A nudge that fails has no effect; the next one starts afresh.
    this.#nudges = this.#nudges
      .then(() => this.#nudge(dx, dy))
      .catch(() => {
        this.#keyed = null;
      });
  }

  /**
   * Ends a move by keys: at the release of the key, or if the stage loses the focus before that.
   */
  endNudge(): void {
    if (this.#keyed?.revision === this.editor.state.revision) this.editor.releaseDrag();
    this.#nudges = this.#nudges.then(() => {
      if (this.#keyed?.revision === this.editor.state.revision) this.editor.commitDrag();
      this.#keyed = null;
    });
  }

  async #nudge(dx: number, dy: number): Promise<void> {
    const { editor, viewer } = this;
    // After another edit the move starts again from the new drawing.
    if (this.#keyed?.revision !== editor.state.revision) this.#keyed = null;
    // The keys do not move what a pointer drags.
    if (!this.#keyed && editor.state.dragging) return;
    this.#keyed ??= await this.#keyedMove();
    const keyed = this.#keyed;
    if (!keyed || keyed.revision !== editor.state.revision) return;
    const [x, y] = [keyed.x + dx, keyed.y + dy];
    const point = viewer.pick(x, y)?.point;
    const command = point ? await keyed.move.to(point).catch(() => leaves) : leaves;
    if (this.#keyed !== keyed || keyed.revision !== editor.state.revision) return;
    if (typeof command === 'string') {
      this.events.stopped(command);
      return;
    }
    editor.previewCommand(command);
    [keyed.x, keyed.y, keyed.revision] = [x, y, editor.state.revision];
  }

  /** Begins a move of the selection by keys, with one of its visible places as the pivot. */
  async #keyedMove(): Promise<KeyedMove | null> {
    const { editor, session, viewer } = this;
    const { revision, drawing, chosen } = editor.state;
    const { surface, box } = viewer;
    const { client } = session;
    const objects = movableObjects(drawing, chosen);
    if (!surface || !client) return null;
    for (const place of objects.flatMap(({ figure }) => placesOf(figure))) {
      const { x, y, hidden } = viewer.project(surface.position(place));
      if (hidden) continue;
      const [left, top] = [box.left + x, box.top + y];
      const pivot = viewer.pick(left, top)?.point;
      if (!pivot) continue;
      const held = { drawing, objects };
      const move = await Move.of(session, surface, held, pivot).catch(() => null);
      return move && { move, x: left, y: top, revision };
    }
    return null;
  }

  async #moveTo({ x, y }: Place): Promise<void> {
    const held = this.#held;
    const move = await held?.move;
    const point = this.viewer.pick(x, y)?.point;
    if (this.#held !== held || !held || !move || !point) return;
    const command = await move.to(point).catch(() => leaves);
    if (this.#held !== held) return;
    if (typeof command !== 'string') {
      this.editor.previewCommand(held.copies ? this.#leaving(command) : command);
      if (held.released) this.editor.releaseDrag();
    } else if (!held.stopped) {
      held.stopped = true;
      this.events.stopped(command);
    }
  }

  /** The move, together with copies that stay at the old place, as one step. */
  #leaving(command: Command): Command {
    const { drawing, chosen } = this.editor.state;
    const ids = chosen.length > 0 ? chosen : [drawing.active];
    const copied = copiedObjects(drawing, ids).map(({ id }) => id);
    const copies = leavingCopies(this.editor.baseDrawing, copied);
    return copies ? { type: 'steps', steps: [copies, command] } : command;
  }

  async #end(last: Place): Promise<void> {
    const held = this.#held;
    if (!held) return;
    held.released = true;
    this.editor.releaseDrag();
    this.#newest.drop();
    await this.#moveTo(last);
    if (this.#held !== held) return;
    this.#held = null;
    this.editor.commitDrag();
  }
}
