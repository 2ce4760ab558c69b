import type { SurfacePoint } from 'karcher';
import { Vector3 } from 'three';
import { type Drawing, type DrawnObject, objectOf } from '../../model/drawing';
import type { Vector } from '../../model/figure';
import { Handles } from '../../viewer/handles';
import type { Viewer } from '../../viewer/viewer';
import type { EngineClient } from '../../worker/client';
import type { Extent } from '../../worker/extent';
import { faceNormal, leaves, Move, movableObjects, type Placement } from '../engine/moving';
import { Newest } from '../engine/newest';
import type { Session } from '../engine/session';
import type { Editor } from '../state/editor';
import {
  acrossFrame,
  carriedFrame,
  extentsOf,
  type FrameHandle,
  frameAt,
  frameOf,
  type ShownFrame,
  type Size,
  shownFrame,
  type TransformFrame,
} from './transform_frame';

/** The steps of a turn's angle and of a scale's factor while Shift is down. */
const angleStep = Math.PI / 12;
const scaleStep = 0.1;
/**
 * The changes of the angle and of the factor by one press of a key. With Shift they are `angleStep`
 * and `scaleStep`.
 */
const keyedAngle = Math.PI / 180;
const keyedScale = 0.01;
const nudgePixels = 4;
const leastScale = 0.01;

const arrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const labels: Record<FrameHandle, string> = {
  turn: 'Turn the selection',
  move: 'Move the selection',
  pivot: 'Pivot of turning and scaling',
  'scale-1': 'Scale the selection, first corner',
  'scale-2': 'Scale the selection, second corner',
  'scale-3': 'Scale the selection, third corner',
  'scale-4': 'Scale the selection, fourth corner',
};

/**
 * A placement by numbers: lengths along the frame's axes, an angle and a scale. The new length of a
 * side may be given instead of the scale.
 */
export interface Numbers extends Omit<Placement, 'point'>, Partial<Size> {
  x?: number;
  y?: number;
}

type Steps = Required<Omit<Numbers, keyof Size>>;

/** The scale that changes a side's length from `of` to `length`; null if `of` is 0. */
const scaleTo = (length: number, of: number) => (of > 0 ? length / of : null);

interface Place {
  x: number;
  y: number;
}

/** A handle of the frame that the user drags. */
interface Hold {
  id: FrameHandle;
  from: SurfacePoint;
  frame: TransformFrame;
  move: Promise<Move>;
  /** The log vector of `from` at the pivot. */
  log: Promise<Vector3>;
  stopped: boolean;
  /** Whether only the last steps are still under way. */
  released: boolean;
}

/** The frame around the selection while the tool is `transform`, and the drags of its handles. */
export class TransformGestures {
  readonly #handles: Handles;
  readonly #newest = new Newest<Place>((place) => this.#dragTo(place));
  #frame: TransformFrame | null = null;
  #shown: ShownFrame | null = null;
  /** The state for which the frame was computed. */
  #made: { drawing: Drawing; chosen: string; client: EngineClient } | null = null;
  /** The user's own pivot, with the selection and the surface's engine for which it holds. */
  #pivot: { point: SurfacePoint; chosen: string; client: EngineClient } | null = null;
  #held: Hold | null = null;
  /** The sum of the arrow keys' moves, until their release. */
  #keyed: {
    id: FrameHandle;
    frame: TransformFrame;
    move: Move;
    numbers: Steps;
    released: boolean;
  } | null = null;
  /** The end of the last step by keys or numbers. Each begins after the one before. */
  #lastStep: Promise<void> = Promise.resolve();
  #shift = false;

  /** Settles when the frame is made. */
  #making: Promise<void> | null = null;
  /** The extents inside the frame, with the selection and the drawing for which they hold. */
  #around: { of: string; drawing: Drawing; extents: Promise<Extent[]> } | null = null;

  /**
   * `stopped` receives a sentence if a drag stops, `sized` the size of the frame's contents, or
   * null without a frame.
   */
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    stage: HTMLElement,
    severalFingers: () => boolean,
    private readonly events: { stopped(why: string): void; sized(size: Size | null): void },
  ) {
    const layer = document.createElement('div');
    layer.className = 'handles';
    stage.append(layer);
    this.#handles = new Handles(viewer, layer, {
      grab: (id, x, y) => this.#grab(id as FrameHandle, { x, y }),
      drag: (_, x, y) => this.#newest.push({ x, y }),
      release: (_, cancelled) => void this.#release(cancelled),
      focus: () => {},
      key: (id, event) => this.#key(id as FrameHandle, event),
    });
    this.#handles.severalFingers = severalFingers;
    layer.addEventListener('keyup', (event) => {
      if (event.key in arrows) this.#endKeys();
    });
    // Without the focus, the layer would miss the release of the key.
    layer.addEventListener('focusout', () => this.#endKeys());
    for (const type of ['pointerdown', 'pointermove'] as const) {
      window.addEventListener(type, ({ shiftKey }) => (this.#shift = shiftKey), { capture: true });
    }
  }

  get heldBy(): number | null {
    return this.#handles.heldBy;
  }

  /** Ends the drag without further steps: undone, or as it is shown if it was released. */
  letGo(): void {
    if (this.#held?.released || this.#keyed?.released) this.#settle();
    if (this.#keyed) this.editor.cancelDrag();
    this.#keyed = null;
    this.#handles.letGo();
    if (this.#held) void this.#release(true);
  }

  /**
   * Shows the frame of the editor's state. Computes it again if the drawing, the selection or the
   * engine has changed, but not during a drag.
   */
  show(): void {
    const { tool, drawing, chosen, dragging } = this.editor.state;
    const { client } = this.session;
    const isShown = tool === 'transform' && this.#objects.length > 0 && client;
    if (!isShown) {
      this.#hide();
      return;
    }
    const made = this.#made;
    const same = made?.drawing === drawing && made.chosen === `${chosen}` && made.client === client;
    if (same || dragging) return;
    this.#made = { drawing, chosen: `${chosen}`, client };
    this.#making = this.#makeFrame();
  }

  /** Places the selection by numbers, as one step. */
  place(numbers: Numbers): void {
    this.#inOrder(() => this.#placeBy(numbers));
  }

  /** Takes a step after those before. If it fails, it has no effect. */
  #inOrder(step: () => Promise<void>): void {
    this.#lastStep = this.#lastStep.then(step).catch(() => {});
  }

  async #placeBy({ x = 0, y = 0, angle = 0, ...numbers }: Numbers): Promise<void> {
    // Numbers may come before the lines are measured.
    await this.#making;
    const frame = this.#frame;
    const { width, height } = numbers;
    const scale =
      frame && width !== undefined
        ? scaleTo(width, frame.size.width)
        : frame && height !== undefined
          ? scaleTo(height, frame.size.height)
          : (numbers.scale ?? 1);
    if (scale === null) return;
    const objects = this.#objects;
    // Another edit of the objects, or their drag, makes the numbers void.
    const isWanted = () => {
      const { state, baseDrawing } = this.editor;
      const isSame = ({ id, figure }: DrawnObject) => objectOf(baseDrawing, id)?.figure === figure;
      return !state.dragging && !this.#held && objects.every(isSame);
    };
    const move = frame && (await this.#moveAt(frame.pivot, frame));
    if (!frame || !move) return;
    if (await this.#place(frame, move, { x, y, angle, scale }, isWanted)) this.#commit();
  }

  get #objects(): DrawnObject[] {
    const { drawing, chosen } = this.editor.state;
    return movableObjects(drawing, chosen);
  }

  /** Whether the user's own pivot is for the selection, on this surface. */
  get #hasPivot(): boolean {
    const { chosen } = this.editor.state;
    return this.#pivot?.chosen === `${chosen}` && this.#pivot.client === this.session.client;
  }

  #hide(): void {
    if (!this.#made) return;
    [this.#frame, this.#shown, this.#made] = [null, null, null];
    this.#draw();
  }

  #draw(): void {
    const { lines = [], handles = [] } = this.#shown ?? {};
    this.events.sized(this.#frame?.size ?? null);
    this.viewer.aids.showFrame(lines);
    this.#handles.show(
      handles.map(({ id, position }) => ({
        ...{ id, position, label: labels[id], selected: this.#held?.id === id },
        tag: '',
        look: id.startsWith('scale') ? 'corner' : (id as 'turn' | 'move' | 'pivot'),
      })),
    );
  }

  async #makeFrame(): Promise<void> {
    const { client } = this.session;
    const { surface } = this.viewer;
    const made = this.#made;
    if (!client || !surface || !made) return;
    const own = this.#hasPivot ? this.#pivot!.point : null;
    const { right } = this.viewer;
    const frame = await this.#extents()
      .then((around) => frameOf(client, surface, around, right, own))
      .catch(() => null);
    if (frame && this.#made === made) await this.#showFrame(frame);
  }

  /** The extents inside the frame. */
  #extents(): Promise<Extent[]> {
    const { drawing, chosen } = this.editor.state;
    const known = this.#around;
    if (known?.drawing === drawing && known.of === `${chosen}`) return known.extents;
    const objects = this.#objects;
    // If the lines cannot be computed, the frame surrounds the objects' points.
    const lines = this.session.linesOf(objects.map(({ id }) => id)).catch(() => []);
    const extents = lines.then((found) => extentsOf(objects, found));
    this.#around = { of: `${chosen}`, drawing, extents };
    return extents;
  }

  async #showFrame(frame: TransformFrame): Promise<void> {
    const { client } = this.session;
    const { surface } = this.viewer;
    if (!client || !surface) return;
    this.#frame = frame;
    const shown = await shownFrame(client, surface, frame).catch(() => null);
    if (this.#frame !== frame) return;
    this.#shown = shown;
    this.#draw();
  }

  #moveAt(point: SurfacePoint, frame: TransformFrame): Promise<Move | null> {
    const { surface } = this.viewer;
    if (!this.session.client || !surface) return Promise.resolve(null);
    const { drawing } = this.editor.state;
    const objects = { drawing, objects: this.#objects };
    const move = Move.of(this.session, surface, objects, point, carriedFrame(frame));
    return move.catch(() => null);
  }

  #grab(id: FrameHandle, { x, y }: Place): void {
    const frame = this.#frame;
    const { client } = this.session;
    const { surface } = this.viewer;
    const position = this.#shown?.handles.find((handle) => handle.id === id)?.position;
    if (!frame || !client || !surface || !position) return;
    this.#settle();
    const from = this.viewer.pick(x, y)?.point ?? surface.nearest(position);
    const at = id === 'move' ? from : frame.pivot;
    const move = this.#moveAt(at, frame).then((made) => {
      if (!made) throw new Error('no path leads to what is selected');
      return made;
    });
    const log = client.mesh
      .logMap(frame.pivot, [from])
      .then(({ vectors }) => new Vector3().fromArray(vectors));
    // If one of these fails, the drag has no effect.
    for (const promise of [move, log]) promise.catch(() => {});
    this.#held = { id, from, frame, move, log, stopped: false, released: false };
  }

  async #dragTo({ x, y }: Place): Promise<void> {
    const held = this.#held;
    const point = this.viewer.pick(x, y)?.point;
    if (!held || !point) return;
    if (held.id === 'pivot') {
      await this.#putPivot(point);
      return;
    }
    const placement = await this.#placementAt(held, point).catch(() => null);
    const move = await held.move.catch(() => null);
    const placed = (placement && (await move?.placed(placement).catch(() => leaves))) ?? leaves;
    if (this.#held !== held || !placement) return;
    if (typeof placed === 'string') {
      if (!held.stopped) this.events.stopped(placed);
      held.stopped = true;
      return;
    }
    this.editor.previewCommand(placed.command);
    if (held.released) this.editor.releaseDrag();
    await this.#showFrame(frameAt(held.frame, placed.beside, placement.scale ?? 1));
  }

  async #placementAt({ id, frame, log }: Hold, point: SurfacePoint): Promise<Placement> {
    if (id === 'move') return { point };
    const { client } = this.session;
    const { surface } = this.viewer;
    const { vectors } = await client!.mesh.logMap(frame.pivot, [point]);
    const [from, to] = [await log, new Vector3().fromArray(vectors)];
    if (id === 'turn') {
      const normal = await faceNormal(client!, surface!, frame.pivot);
      const angle = Math.atan2(from.clone().cross(to).dot(normal), from.dot(to));
      return { angle: this.#shift ? Math.round(angle / angleStep) * angleStep : angle };
    }
    const scale = to.length() / (from.length() || 1);
    const kept = this.#shift ? Math.round(scale / scaleStep) * scaleStep : scale;
    return { scale: Math.max(leastScale, kept) };
  }

  /** Makes this point the pivot of turns and scalings. */
  async #putPivot(point: SurfacePoint): Promise<void> {
    const { client } = this.session;
    const { surface } = this.viewer;
    const frame = this.#held?.frame ?? this.#frame;
    if (!client || !surface || !frame) return;
    this.#pivot = { point, chosen: `${this.editor.state.chosen}`, client };
    const moved = await Promise.all([
      this.#extents(),
      client.mesh.transport(frame.pivot, point, frame.right),
    ])
      .then(([around, right]) => frameOf(client, surface, around, [...right] as Vector, point))
      .catch(() => null);
    if (moved) await this.#showFrame(moved);
  }

  async #release(cancelled: boolean): Promise<void> {
    const held = this.#held;
    if (!held) return;
    if (cancelled) {
      this.#held = null;
      this.#newest.drop();
      this.editor.cancelDrag();
      await this.#showFrame(held.frame);
      return;
    }
    held.released = true;
    this.editor.releaseDrag();
    await this.#newest.done();
    if (this.#held !== held) return;
    this.#held = null;
    this.#commit();
  }

  /** Ends a drag, or a move by keys, whose last step is still under way: it stays as it is shown. */
  #settle(): void {
    if (!this.#held && !this.#keyed) return;
    [this.#held, this.#keyed] = [null, null];
    this.#newest.drop();
    this.#commit();
  }

  /** Ends the drag as one step; the frame stays at its new place. */
  #commit(): void {
    const { editor } = this;
    const { client } = this.session;
    const { drawing, chosen } = editor.state;
    if (client) this.#made = { drawing, chosen: `${chosen}`, client };
    if (this.#hasPivot && this.#frame) {
      this.#pivot = { ...this.#pivot!, point: this.#frame.pivot };
    }
    editor.commitDrag();
    this.#draw();
  }

  /**
   * Shows a placement by numbers, as a drag's next position; false if it is impossible or no longer
   * wanted.
   */
  async #place(
    frame: TransformFrame,
    move: Move,
    { x, y, angle, scale }: Steps,
    isWanted: () => boolean,
  ): Promise<boolean> {
    const { client } = this.session;
    const point = await this.#pointAt(frame, x, y);
    if (!client || !point) {
      this.events.stopped(leaves);
      return false;
    }
    const placed = await move.placed({ point, angle, scale }).catch(() => leaves);
    if (typeof placed === 'string') {
      this.events.stopped(placed);
      return false;
    }
    if (!isWanted()) return false;
    this.editor.previewCommand(placed.command);
    await this.#showFrame(frameAt(frame, placed.beside, scale));
    return true;
  }

  /** The point at given lengths along the frame's axes; null beyond the boundary. */
  async #pointAt(frame: TransformFrame, x: number, y: number): Promise<SurfacePoint | null> {
    const { client } = this.session;
    const { surface } = this.viewer;
    if (!client || !surface) return null;
    if (x === 0 && y === 0) return frame.pivot;
    const across = await acrossFrame(client, surface, frame);
    const vector = frame.right.map((value, axis) => x * value + y * across[axis]!);
    const { points, remaining } = await client.mesh.expMap(frame.pivot, vector);
    return remaining[0]! > 1e-9 * client.info.diagonal ? null : points[0]!;
  }

  #key(id: FrameHandle, event: KeyboardEvent): void {
    const arrow = arrows[event.key];
    if (!arrow || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const { shiftKey } = event;
    this.#inOrder(() => this.#keyStep(id, arrow, shiftKey));
  }

  async #keyStep(id: FrameHandle, [dx, dy]: [number, number], shift: boolean): Promise<void> {
    const position = this.#shown?.handles.find((handle) => handle.id === id)?.position;
    const frame = this.#keyed?.frame ?? this.#frame;
    if (!frame || !position) return;
    const length = this.viewer.reach(position, shift ? 10 * nudgePixels : nudgePixels);
    if (id === 'pivot') {
      const point = await this.#pointAt(this.#frame!, dx * length, dy * length);
      if (point) await this.#putPivot(point);
      return;
    }
    if (!this.#keyed) {
      const move = await this.#moveAt(frame.pivot, frame);
      if (!move) return;
      const numbers = { x: 0, y: 0, angle: 0, scale: 1 };
      this.#keyed = { id, frame, move, numbers, released: false };
    }
    const keyed = this.#keyed;
    const { numbers, move } = keyed;
    const [turn, grow] = shift ? [angleStep, scaleStep] : [keyedAngle, keyedScale];
    const next = { ...numbers };
    if (id === 'move') {
      next.x += dx * length;
      next.y += dy * length;
    } else if (id === 'turn') next.angle += (dy - dx) * turn;
    else next.scale = Math.max(leastScale, next.scale + (dx + dy) * grow);
    const isWanted = () => this.#keyed === keyed;
    if (await this.#place(frame, move, next, isWanted)) keyed.numbers = next;
  }

  #endKeys(): void {
    if (this.#keyed) {
      this.#keyed.released = true;
      this.editor.releaseDrag();
    }
    this.#inOrder(async () => {
      if (!this.#keyed) return;
      this.#keyed = null;
      this.#commit();
    });
  }
}
