import { type DrawnObject, objectOf } from '../model/drawing';
import { placesOf } from '../model/moving';
import type { Viewer } from '../viewer/viewer';
import type { Editor } from './editor';
import { Move } from './moving';
import { Newest } from './newest';
import type { Session } from './session';
import { reach, targetAt } from './targets';
import type { Held } from './two_fingers';

/** A press that moves less, in CSS pixels, is a click. */
const slop = { mouse: 4, touch: 10 };

interface Place {
  x: number;
  y: number;
  touch: boolean;
}

/** A line that is held, and once it is dragged what is moved with it. */
interface Hold extends Place {
  pointer: number;
  move: Promise<Move | null> | null;
  stopped: boolean;
}

/** Drags of a line of an object: it is moved, with all that are selected with it. */
export class MoveGestures implements Held {
  #held: Hold | null = null;
  readonly #newest = new Newest<Place>((place) => this.#moveTo(place));
  /** A move by keys that goes on, and where it has come to. */
  #keyed: { move: Move; x: number; y: number } | null = null;
  #nudges: Promise<void> = Promise.resolve();

  /** `clicked` is called where nothing was dragged; `stopped` where a move would leave the surface. */
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    private readonly stage: HTMLElement,
    private readonly severalFingers: () => boolean,
    private readonly events: { clicked(place: Place): void; stopped(): void },
  ) {
    // Before the view's controls, which listen on the stage too.
    stage.addEventListener('pointerdown', (event) => this.#down(event), { capture: true });
    stage.addEventListener('pointermove', (event) => this.#moved(event));
    stage.addEventListener('pointerup', (event) => this.#up(event));
    stage.addEventListener('pointercancel', () => this.letGo());
  }

  get heldBy(): number | null {
    return this.#held?.pointer ?? null;
  }

  letGo(): void {
    if (!this.#held) return;
    this.#held = null;
    this.#newest.drop();
    this.editor.cancelDrag();
  }

  #down(event: PointerEvent): void {
    const { editor, stage } = this;
    const free = event.target === stage || event.target instanceof HTMLCanvasElement;
    const isPlain = event.button === 0 && !event.shiftKey && !event.ctrlKey && !event.metaKey;
    if (!free || !isPlain || this.#held || this.severalFingers()) return;
    if (!['select', 'insert'].includes(editor.state.tool)) return;
    const touch = event.pointerType === 'touch';
    const place = { x: event.clientX, y: event.clientY, touch };
    const id = this.#lineAt(place);
    // A finger turns the view wherever it lies, but on what is selected.
    if (id === null || (touch && !editor.state.chosen.includes(id))) return;
    event.stopPropagation();
    stage.focus({ preventScroll: true });
    stage.classList.add('pointed');
    stage.setPointerCapture(event.pointerId);
    this.#held = { ...place, pointer: event.pointerId, move: null, stopped: false };
  }

  /** The id of the object whose line is seen at a place; null without one. */
  #lineAt(place: Place): number | null {
    const { state, isOpen } = this.editor;
    const target = targetAt(this.viewer, state, place);
    if (target?.type === 'other') return target.id;
    const within = place.touch ? reach.touch : reach.mouse;
    const own = target?.type === 'curve' || this.viewer.pickOwn(place.x, place.y, within);
    return own && isOpen ? state.drawing.active : null;
  }

  #moved(event: PointerEvent): void {
    const held = this.#held;
    if (held?.pointer !== event.pointerId) return;
    const { clientX: x, clientY: y } = event;
    const far = Math.hypot(x - held.x, y - held.y) > (held.touch ? slop.touch : slop.mouse);
    if (!held.move && !far) return;
    held.move ??= this.#begin(held);
    this.#newest.push({ x, y, touch: held.touch });
  }

  /** Holds what is under the pointer, with what is selected with it. */
  async #begin({ x, y, touch }: Place): Promise<Move | null> {
    const { editor, session, viewer } = this;
    const id = this.#lineAt({ x, y, touch });
    const pivot = viewer.pick(x, y)?.point;
    const { client } = session;
    if (id === null || !pivot || !client || !viewer.surface) return null;
    if (!editor.state.chosen.includes(id)) editor.activate(id);
    const { chosen } = editor.state;
    const objects = this.#selected(chosen.length > 0 ? chosen : [id]);
    return Move.of(client, viewer.surface, objects, pivot).catch(() => null);
  }

  /** Moves what is selected by so many CSS pixels; nudges are one step until `endNudge`. */
  nudge(dx: number, dy: number): void {
    this.#nudges = this.#nudges.then(() => this.#nudge(dx, dy));
  }

  /** The key was let go. */
  endNudge(): void {
    this.#nudges = this.#nudges.then(() => {
      if (this.#keyed) this.editor.commitDrag();
      this.#keyed = null;
    });
  }

  async #nudge(dx: number, dy: number): Promise<void> {
    const { editor, viewer } = this;
    this.#keyed ??= await this.#keyedMove();
    const keyed = this.#keyed;
    if (!keyed) return;
    const [x, y] = [keyed.x + dx, keyed.y + dy];
    const point = viewer.pick(x, y)?.point;
    const command = point && (await keyed.move.to(point).catch(() => null));
    if (!command) {
      this.events.stopped();
      return;
    }
    [keyed.x, keyed.y] = [x, y];
    editor.previewCommand(command);
  }

  /** Holds what is selected at a place of it that is seen. */
  async #keyedMove(): Promise<{ move: Move; x: number; y: number } | null> {
    const { editor, session, viewer } = this;
    const { surface, box } = viewer;
    const { client } = session;
    const objects = this.#selected(editor.state.chosen);
    if (!surface || !client) return null;
    for (const place of objects.flatMap(({ figure }) => placesOf(figure))) {
      const { x, y, hidden } = viewer.project(surface.position(place));
      if (hidden) continue;
      const [left, top] = [box.left + x, box.top + y];
      const pivot = viewer.pick(left, top)?.point;
      if (!pivot) continue;
      const move = await Move.of(client, surface, objects, pivot).catch(() => null);
      return move && { move, x: left, y: top };
    }
    return null;
  }

  /** Those of the objects that may be moved. */
  #selected(ids: readonly number[]): DrawnObject[] {
    const { drawing } = this.editor.state;
    return ids
      .map((id) => objectOf(drawing, id))
      .filter((object) => object !== undefined)
      .filter(({ locked, visible }) => visible && !locked);
  }

  async #moveTo({ x, y }: Place): Promise<void> {
    const held = this.#held;
    const move = await held?.move;
    const point = this.viewer.pick(x, y)?.point;
    if (!held || !move || !point) return;
    const command = await move.to(point).catch(() => null);
    if (this.#held !== held) return;
    if (command) this.editor.previewCommand(command);
    else if (!held.stopped) {
      held.stopped = true;
      this.events.stopped();
    }
  }

  #up(event: PointerEvent): void {
    const held = this.#held;
    if (held?.pointer !== event.pointerId) return;
    if (!held.move) {
      this.#held = null;
      this.events.clicked({ x: held.x, y: held.y, touch: held.touch });
      return;
    }
    const last = { x: event.clientX, y: event.clientY, touch: held.touch };
    void this.#end(held, last);
  }

  async #end(held: Hold, last: Place): Promise<void> {
    this.#newest.drop();
    await this.#moveTo(last);
    if (this.#held !== held) return;
    this.#held = null;
    this.editor.commitDrag();
  }
}
