import type { SurfacePoint } from 'karcher';
import { Vector3 } from 'three';
import { byRadii, newCircle, withHandle } from '../../model/circle';
import { isRound, type Vector } from '../../model/figure';
import type { Joint } from '../../model/pen';
import { penActionAt, penWords, type UnderPointer } from '../../model/pen_hints';
import type { Handles } from '../../viewer/handles';
import type { Pick } from '../../viewer/surface';
import type { Viewer } from '../../viewer/viewer';
import type { Session } from '../engine/session';
import type { Editor } from '../state/editor';
import type { CurveTool } from '../state/state';
import { BoxSelection } from './box_selection';
import { FreehandGestures } from './freehand';
import { HandleDrags } from './handle_drags';
import { handlesOf, idOf, underPointer } from './handle_list';
import { MoveGestures } from './move_gestures';
import { type HeldKeys, PenGestures } from './pen_gestures';
import { RubberBand } from './rubber_band';
import { type Snapped, Snapping } from './snapping';
import { StageKeys } from './stage_keys';
import { clickSlop, type Hold, type Place, StagePointer } from './stage_pointer';
import { type Target, targetAt } from './targets';
import type { Size } from './transform_frame';
import { type Numbers, TransformGestures } from './transform_gestures';
import { twoFingersMeanTheView } from './two_fingers';

/** The largest distance from a knot, in CSS pixels, at which a click means the knot. */
const nearKnot = { mouse: 6, touch: 12 };

const modifiers = new Set(['Alt', 'Control', 'Meta', 'Shift']);

/** Receives clicks whose edits need the engine, and other events of gestures. */
export interface CurveClicks {
  surfaceClicked(point: SurfacePoint): void;
  /**
   * A click on the curve. It means a knot or an anchor that lies within the distance `within`, in
   * the surface's unit.
   */
  curveClicked(tool: CurveTool, position: Vector3, within: number): void;
  /** The pointer is over the measured curve, or clicks it. */
  curveMeasured(position: Vector3): void;
  /** The pointer is over the surface, or clicks it, while the tool measures. */
  rulerAimed(point: SurfacePoint): void;
  rulerClicked(point: SurfacePoint): void;
  /** A click on the first point of the edited curve, which closes the curve. */
  closed(): void;
  /** A double click on an anchor of the pen, by its index. */
  anchorRemoved(index: number): void;
  /** Words for the effect of a click at the pointer; empty without an effect. */
  aimed(words: string): void;
  /** A click on another object, by its id. */
  otherClicked(tool: CurveTool, id: number): void;
  /** A click on a shorter path, by its index in the view. */
  shorterClicked(index: number): void;
  /** The pointer is over the surface, or clicks it, while the tool mirrors. */
  mirrorAimed(point: SurfacePoint): void;
  mirrorClicked(point: SurfacePoint): void;
  /** Shows a sentence that says why a gesture stops. */
  stopped(why: string): void;
  /** The size of the frame's contents; null without a frame. */
  sized(size: Size | null): void;
}

/** Turns the actions of pointer and keys on the stage into commands. */
export class Gestures {
  readonly #drags: HandleDrags;
  readonly #handles: Handles;
  #press: { id: number; x: number; y: number; slop: number } | null = null;
  readonly #pointer: StagePointer;
  #keys: HeldKeys = { alt: false, shift: false, control: false };
  readonly freehand: FreehandGestures;
  readonly snapping: Snapping;
  readonly #pen: PenGestures;
  readonly #transforms: TransformGestures;
  readonly #moves: MoveGestures;
  readonly #band: RubberBand;
  #pointers = 0;
  #hover: { x: number; y: number } | null = null;
  /** Whether the pointer is over the stage, and over which handle of the pen. */
  #isOver = false;
  #overHandle: UnderPointer | null = null;
  /** Whether the last mark showed the pointer's place on the surface. */
  #rules = false;
  #frame = 0;
  /** Whether the last frame showed what the pointer aims at. */
  #aims = false;

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    private readonly stage: HTMLElement,
    layer: HTMLElement,
    private readonly events: CurveClicks,
  ) {
    this.snapping = new Snapping(editor, viewer);
    this.#band = new RubberBand(editor, session, viewer);
    const pen = new PenGestures(editor, session, viewer, this.snapping);
    const drags = new HandleDrags(editor, session, viewer, layer, {
      ...{ pen, snapping: this.snapping },
      keys: () => this.#keys,
      schedule: () => this.#inFrame(),
      close: () => events.closed(),
    });
    const { handles } = drags;
    const severalFingers = twoFingersMeanTheView(stage, {
      get heldBy() {
        return handles.heldBy ?? transforms.heldBy ?? pointer.heldBy;
      },
      letGo() {
        handles.letGo();
        transforms.letGo();
        pointer.letGo();
      },
    });
    const pointer = new StagePointer(stage, severalFingers);
    handles.severalFingers = severalFingers;
    const box = new BoxSelection(editor, viewer, stage);
    const moves = new MoveGestures(editor, session, viewer, {
      clicked: (place) => this.#click(place),
      stopped: (why) => events.stopped(why),
    });
    [this.#drags, this.#handles, this.#pointer] = [drags, handles, pointer];
    this.freehand = new FreehandGestures(editor, session, viewer, this.snapping, events.stopped);
    for (const one of [box, this.freehand, pen]) pointer.offer((press) => one.take(press));
    pointer.offer((press) => this.#takeRound(press));
    pointer.offer((press) => moves.take(press), { withAlt: true });
    const transforms = new TransformGestures(editor, session, viewer, stage, severalFingers, {
      stopped: (why) => events.stopped(why),
      sized: (size) => events.sized(size),
    });
    this.#transforms = transforms;
    this.#moves = moves;
    this.#pen = pen;
    const keys = ({ altKey, shiftKey, ctrlKey, metaKey }: PointerEvent) => {
      this.#keys = { alt: altKey, shift: shiftKey, control: ctrlKey || metaKey };
    };
    for (const type of ['pointerdown', 'pointermove'] as const) {
      window.addEventListener(type, keys, { capture: true });
    }
    // The next action begins with what is shown, even before the last step of a released drag.
    window.addEventListener('pointerdown', () => editor.settleDrag(), { capture: true });
    window.addEventListener('keydown', ({ key }) => modifiers.has(key) || editor.settleDrag(), {
      capture: true,
    });
    new StageKeys(editor, viewer, stage, moves, {
      clicked: (place) => this.#click({ ...place, touch: false }, { byKey: true }),
      aimed: (place) => this.#aim(place),
    });
    stage.addEventListener('pointerdown', (event) => this.#down(event));
    stage.addEventListener('pointermove', (event) => this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#up(event));
    stage.addEventListener('pointercancel', () => this.#lift());
    stage.addEventListener('pointerleave', () => {
      this.#isOver = false;
      this.#aim(null);
    });
    for (const type of ['keydown', 'keyup'] as const) {
      window.addEventListener(type, ({ key, altKey }) => {
        if (key !== 'Alt') return;
        this.#keys.alt = altKey;
        this.#inFrame();
      });
    }
    stage.addEventListener('dblclick', (event) => this.#doubleClick(event));
    stage.addEventListener('contextmenu', (event) => event.preventDefault());
    stage.addEventListener('blur', () => {
      moves.endNudge();
      stage.classList.remove('pointed');
      this.#aim(null);
    });
  }

  /**
   * Undoes the pointer's gesture, or ends it as it is shown if it was released. The pointer's
   * release is then no click.
   */
  letGo(): void {
    this.#press = null;
    this.#drags.letGo();
    this.#transforms.letGo();
    this.#pointer.letGo();
    this.#moves.letGo();
    this.#pen.letGo();
  }

  /** Shows the handles of the editor's state. */
  show(): void {
    const { surface } = this.viewer;
    const { view } = this.session;
    // A mirror's line may start at an anchor, so the anchor's handle must not take the click.
    const isEdited = !['transform', 'mirror'].includes(this.editor.state.tool);
    this.#handles.show(surface && isEdited ? handlesOf(this.editor.state, view, surface) : []);
    this.#transforms.show();
    this.#showTangents();
    const { center } = view;
    const others = center && center.otherMinima !== 'notLooked' ? center.otherMinima : [];
    this.#handles.showCenter(surface && center ? surface.position(center.point) : null);
    this.#handles.showMinima(
      surface
        ? others.map(({ point, energy }) => ({
            position: surface.position(point),
            tag: energy.toPrecision(4),
          }))
        : [],
    );
    // The view may have moved, so that something else lies under the pointer.
    if (this.#hover) this.#inFrame();
  }

  /** Joins the selected anchor to its handles by lines. */
  #showTangents(): void {
    const { figure, selection } = this.editor.state;
    if (figure.kind !== 'pen') return;
    const drawn = typeof selection === 'number' && this.editor.isOpen;
    const { before, after } = (drawn && this.session.view.tangents?.[selection as number]) || {};
    const paths = [before, after].flatMap((tangent) => (tangent ? [tangent.path] : []));
    this.viewer.aids.showPolygon(paths, false);
  }

  /** Places the selection by numbers. */
  place(numbers: Numbers): void {
    this.#transforms.place(numbers);
  }

  /**
   * Turns the selected anchor, or all anchors if none is selected, into corners or smooth anchors.
   */
  setJoint(joint: Joint): void {
    this.#pen.setJoint(joint);
  }

  /** Marks the measured place of the curve. */
  showMeasured(position: Vector | null): void {
    const { surface } = this.viewer;
    const place = position && surface?.toScene(Float32Array.from(position));
    this.#handles.showPreview(place ? new Vector3(...place) : null, 'measure');
  }

  /** Turns the view to a place in the surface's coordinates, and marks it for a moment. */
  showPlace(position: Vector): void {
    const { surface } = this.viewer;
    if (!surface) return;
    const place = new Vector3(...surface.toScene(Float32Array.from(position)));
    this.viewer.lookAt(place);
    this.#handles.showBeacon(place);
  }

  /**
   * Carries out a change, such as a removal. If a handle had the focus before, the selected handle
   * has it afterwards, or the stage if none is selected.
   */
  async keepFocus(change: () => Promise<void>): Promise<void> {
    const hadFocus = this.#handles.hasFocus;
    await change();
    const { selection } = this.editor.state;
    if (!hadFocus) return;
    if (selection === null) this.stage.focus({ preventScroll: true });
    else this.#handles.focus(idOf(selection));
  }

  #down(event: PointerEvent): void {
    this.#pointers++;
    this.#aim(null);
    this.stage.classList.add('pointed');
    const slop = event.pointerType === 'mouse' ? clickSlop.mouse : clickSlop.touch;
    const isView = event.altKey || this.stage.classList.contains('moving');
    const alone = this.#pointers === 1 && event.button === 0 && !isView;
    this.#press = alone ? { id: event.pointerId, x: event.clientX, y: event.clientY, slop } : null;
  }

  #move(event: PointerEvent): void {
    const press = this.#press;
    if (press) {
      const moved = Math.hypot(event.clientX - press.x, event.clientY - press.y);
      if (moved > press.slop) this.#press = null;
    }
    const hovers = event.pointerType !== 'touch' && event.buttons === 0;
    const free = event.target === this.stage || event.target instanceof HTMLCanvasElement;
    this.#isOver = event.pointerType !== 'touch';
    this.#overHandle = underPointer(event.target);
    this.#aim(hovers && free ? { x: event.clientX, y: event.clientY } : null);
  }

  #up(event: PointerEvent): void {
    const press = this.#press;
    this.#lift();
    const touch = event.pointerType === 'touch';
    if (press?.id === event.pointerId) this.#click({ x: press.x, y: press.y, touch });
  }

  #lift(): void {
    this.#pointers = Math.max(0, this.#pointers - 1);
    this.#press = null;
  }

  #aim(place: { x: number; y: number } | null): void {
    this.#hover = place;
    this.#inFrame();
  }

  /** Aims at the pointer's newest place and moves the dragged handle, before the next frame. */
  #inFrame(): void {
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      // The pen also acts on handles.
      const aims = this.#hover !== null || this.editor.state.figure.kind === 'pen';
      if (aims || this.#aims) this.#showAim();
      this.#aims = aims;
      this.#drags.dragNow();
    });
  }

  /** Shows what the pointer aims at, and where a click would add a point. */
  #showAim(): void {
    const target = this.#hover && this.#target({ ...this.#hover, touch: false });
    this.#showAction(target);
    this.stage.classList.toggle('aiming', target?.type === 'surface');
    this.stage.classList.toggle('choosing', target?.type === 'other' || target?.type === 'shorter');
    this.#showHovered(target);
    const snapped = this.#hover && this.#snapAt({ ...this.#hover, touch: false }, target);
    const added = snapped ?? (target?.type === 'surface' ? target.pick : null);
    this.#band.aim(added?.point ?? null);
    if (snapped?.kind) {
      this.#handles.showPreview(snapped.position, 'snap', snapped.kind);
      if (this.editor.state.tool === 'measure') this.events.rulerAimed(snapped.point);
    } else if (target?.type === 'surface') {
      this.#handles.showPreview(target.pick.position, 'surface');
      this.#rules = true;
      if (this.editor.state.tool === 'mirror') this.events.mirrorAimed(target.pick.point);
      if (this.editor.state.tool === 'measure') this.events.rulerAimed(target.pick.point);
    } else if (this.editor.state.tool === 'measure') {
      if (target?.type === 'curve') this.events.curveMeasured(target.position);
      // The mark of the measured place stays; the ruler's mark disappears.
      else if (this.#rules) this.#handles.showPreview(null, 'surface');
    } else if (target?.type === 'curve') this.#handles.showPreview(target.position, 'curve');
    else this.#handles.showPreview(null, 'surface');
    if (target?.type !== 'surface') this.#rules = false;
  }

  /** Whether a drag of a line leaves a copy. */
  get #copies(): boolean {
    return this.#keys.alt && this.editor.state.tool === 'select';
  }

  /** Marks the line that a click would take. */
  #showHovered(target: Target | null): void {
    if (target?.type !== 'other') this.viewer.showHovered(undefined);
    else {
      const { active } = this.editor.state.drawing;
      this.viewer.showHovered(target.id === active ? null : target.id);
    }
  }

  /** Shows what a press at the pointer would do: draw, copy a look, or move or copy an object. */
  #showAction(target: Target | null): void {
    const { figure, tool } = this.editor.state;
    const isPen = figure.kind === 'pen' && this.#isOver;
    const drawsThere =
      tool === 'insert' && (target?.type === 'surface' || target?.type === 'curve');
    const under = this.#overHandle ?? (drawsThere ? { type: target.type } : null);
    const draws =
      tool === 'freehand' && this.#hover && this.viewer.pick(this.#hover.x, this.#hover.y);
    const moves = (tool === 'select' || tool === 'transform') && target?.type === 'other';
    const action = draws
      ? 'draw'
      : isPen && under
        ? penActionAt(under, this.#pen.state(this.#keys.alt))
        : null;
    if (action) this.stage.dataset.action = action;
    else if (tool === 'look') this.stage.dataset.action = 'look';
    else if (moves) this.stage.dataset.action = this.#copies ? 'copy' : 'move';
    else delete this.stage.dataset.action;
    this.events.aimed(action ? penWords[action] : '');
  }

  #target(place: { x: number; y: number; touch: boolean }): Target | null {
    return targetAt(this.viewer, this.editor.state, place);
  }

  #click(place: { x: number; y: number; touch: boolean }, { byKey = false } = {}): void {
    const target = this.#target(place);
    const { tool, figure } = this.editor.state;
    const snapped = target?.type === 'curve' ? null : this.#snapAt(place, target);
    if (!target) {
      // A click beside the surface does not end the curve under construction.
      if (tool === 'select' || tool === 'transform') this.editor.letGo();
      else {
        this.editor.select(null);
        this.editor.choose([]);
      }
      if (tool !== 'measure') this.editor.rest();
    } else if (snapped) this.#put(snapped);
    else if (target.type === 'surface') this.#put(target.pick);
    else if (target.type === 'curve' && tool === 'measure') {
      this.events.curveMeasured(target.position);
    } else if (target.type === 'curve' && figure.kind === 'pen' && !byKey) {
      this.#pen.selectNear(target.position);
    } else if (target.type === 'curve') {
      const pixels = place.touch ? nearKnot.touch : nearKnot.mouse;
      this.events.curveClicked(tool, target.position, this.viewer.reach(target.position, pixels));
    } else if (target.type === 'shorter') this.events.shorterClicked(target.index);
    else this.events.otherClicked(tool, target.id);
  }

  /**
   * A double click adds an anchor to the pen's curve, or removes the anchor under the pointer. With
   * the tool `select`, the user continues to draw the object under the pointer.
   */
  #doubleClick({ clientX: x, clientY: y, target: element }: MouseEvent): void {
    const { tool, figure } = this.editor.state;
    const anchor = underPointer(element);
    if (figure.kind === 'pen' && anchor?.type === 'anchor') {
      this.events.anchorRemoved(anchor.index);
      return;
    }
    const target = this.#target({ x, y, touch: false });
    if (figure.kind === 'pen' && tool === 'insert' && target?.type === 'curve') {
      this.events.curveClicked(tool, target.position, 0);
    }
    if (tool !== 'select') return;
    if (target?.type === 'other' && !this.editor.refuses()) this.editor.setTool('insert');
  }

  /** The place to which a click snaps; null if the click adds no point. */
  #snapAt(place: { x: number; y: number; touch: boolean }, target: Target | null): Snapped | null {
    const { control } = this.#keys;
    const places =
      target?.type === 'surface' || (target?.type === 'other' && this.snapping.placesOn(control));
    const draws = this.editor.state.tool === 'freehand';
    return places || draws ? this.snapping.pick({ ...place, control }) : null;
  }

  /**
   * Puts a point where the user clicked: the mirror's or the ruler's point, a control point, or the
   * center or the radius of a circle or an ellipse.
   */
  #put({ point }: Pick): void {
    const { figure, tool } = this.editor.state;
    if (tool === 'mirror') {
      this.events.mirrorClicked(point);
      return;
    }
    if (tool === 'measure') {
      this.events.rulerClicked(point);
      return;
    }
    if (!isRound(figure.kind)) {
      this.events.surfaceClicked(point);
      return;
    }
    if (!this.editor.isOpen && !this.editor.begin()) return;
    const from = this.editor.state.figure.circle;
    const { diagonal } = this.session.client!.info;
    const to = from
      ? withHandle(from, byRadii(from, this.session.view.circle), 'rim', point)
      : newCircle(point, diagonal, this.viewer.right);
    this.editor.run({ type: 'circle', from, to }, 'rim');
  }

  /** A drag draws a circle or an ellipse from its center. */
  #takeRound(press: Place): Hold | null {
    const { editor, session, viewer } = this;
    const { figure, tool } = editor.state;
    if (tool !== 'insert' || !isRound(figure.kind) || press.shift) return null;
    if (!editor.isOpen || figure.circle || !session.client) return null;
    const target = this.#target(press);
    const center = this.#snapAt(press, target)?.point;
    if (!center) return null;
    const begun = newCircle(center, session.client.info.diagonal, viewer.right);
    return {
      drag: ({ x, y }) => {
        const { touch } = press;
        const rim = this.snapping.pick({ x, y, touch, control: this.#keys.control })?.point;
        if (!rim) return;
        const to = withHandle(begun, begun, 'rim', rim);
        editor.preview({ type: 'circle', from: null, to });
      },
      release: (_, dragged) => {
        if (!dragged) {
          this.#click(press);
          return;
        }
        editor.commitDrag();
        if (editor.state.figure.circle) editor.select('rim');
      },
      cancel: () => editor.cancelDrag(),
    };
  }
}
