import type { SurfacePoint } from 'karcher';
import { Quaternion, Vector3 } from 'three';
import type { ControlPoint, Vector } from '../model/figure';
import {
  asJoint,
  byVectors,
  type DrawnTangents,
  type Joint,
  type Side,
  type Tangent,
  withHandleAt,
  withTangents,
} from '../model/pen';
import type { Viewer } from '../viewer/viewer';
import type { Editor } from './editor';
import type { Session } from './session';
import { targetAt } from './targets';
import type { Held } from './two_fingers';

/** A press that moves less, in CSS pixels, places a corner. */
const slop = { mouse: 4, touch: 10 };
/** With Shift held handles keep to multiples of this angle. */
const angleStep = Math.PI / 4;

/** Keys that are held while something is dragged. */
export interface HeldKeys {
  alt: boolean;
  shift: boolean;
}

/**
 * The pen: a click on the surface places a corner, a drag from there a smooth anchor with its handles
 * under the pointer. Each is one step of the history.
 */
export class PenGestures implements Held {
  #stroke: {
    pointer: number;
    x: number;
    y: number;
    slop: number;
    index: number;
    anchor: SurfacePoint;
    drawn: boolean;
  } | null = null;
  #newest: { x: number; y: number; shift: boolean } | null = null;
  #frame = 0;

  /** `severalFingers` tells whether the view has the pointer. */
  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    private readonly stage: HTMLElement,
    private readonly severalFingers: () => boolean,
  ) {
    // Before the view's controls, which listen on the stage too.
    stage.addEventListener('pointerdown', (event) => this.#down(event), { capture: true });
    stage.addEventListener('pointermove', (event) => this.#move(event));
    stage.addEventListener('pointerup', (event) => this.#up(event));
    stage.addEventListener('pointercancel', () => this.letGo());
  }

  /** The pointer that draws; null without one. */
  get heldBy(): number | null {
    return this.#stroke?.pointer ?? null;
  }

  /** Takes back the anchor that is being placed. */
  letGo(): void {
    if (!this.#stroke) return;
    this.#stroke = null;
    this.#newest = null;
    this.editor.cancelDrag();
  }

  #down(event: PointerEvent): void {
    const { editor, stage, viewer } = this;
    const { figure, tool, selection } = editor.state;
    const free = event.target === stage || event.target instanceof HTMLCanvasElement;
    const plain = event.button === 0 && !event.shiftKey && !event.ctrlKey && !event.metaKey;
    if (figure.kind !== 'pen' || tool !== 'insert' || !free || !plain) return;
    if (this.#stroke || this.severalFingers()) return;
    const touch = event.pointerType === 'touch';
    const place = { x: event.clientX, y: event.clientY, touch };
    const target = targetAt(viewer, editor.state, place);
    if (target?.type !== 'surface') return;
    event.stopPropagation();
    stage.focus({ preventScroll: true });
    stage.classList.add('pointed');
    stage.setPointerCapture(event.pointerId);
    // Where nothing is selected the curve has ended.
    const goesOn = editor.isOpen && !figure.settings.closed && selection !== null;
    if (figure.points.length > 0 && !goesOn) editor.begin('pen');
    const index = editor.state.figure.points.length;
    const { point: anchor } = target.pick;
    this.#stroke = {
      ...{ pointer: event.pointerId, x: event.clientX, y: event.clientY, index, anchor },
      slop: touch ? slop.touch : slop.mouse,
      drawn: false,
    };
    editor.preview({ type: 'insert', index, point: anchor });
    editor.select(index);
  }

  #move(event: PointerEvent): void {
    if (this.#stroke?.pointer !== event.pointerId) return;
    this.#newest = { x: event.clientX, y: event.clientY, shift: event.shiftKey };
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#drawHandle();
    });
  }

  #drawHandle(): void {
    const [stroke, newest] = [this.#stroke, this.#newest];
    this.#newest = null;
    if (!stroke || !newest) return;
    stroke.drawn ||= Math.hypot(newest.x - stroke.x, newest.y - stroke.y) > stroke.slop;
    const after = stroke.drawn && this.tangentAt(stroke.anchor, newest, newest.shift);
    if (!after) return;
    const point = withTangents(stroke.anchor, { after, before: { length: null } });
    this.editor.preview({ type: 'insert', index: stroke.index, point });
    this.editor.select(stroke.index);
  }

  #up(event: PointerEvent): void {
    if (this.#stroke?.pointer !== event.pointerId) return;
    this.#drawHandle();
    const { index } = this.#stroke;
    this.#stroke = null;
    this.editor.commitDrag();
    this.editor.select(index);
  }

  /** The handle of an anchor at a place of the window; null past the silhouette. */
  tangentAt(anchor: SurfacePoint, place: { x: number; y: number }, kept: boolean): Tangent | null {
    const { surface } = this.viewer;
    const point = this.viewer.pick(place.x, place.y)?.point;
    if (!surface || !point) return null;
    if (!kept) return point;
    const normal = surface.normal(anchor);
    const along = surface.position(point).sub(surface.position(anchor)).projectOnPlane(normal);
    const right = surface.directionInScene(this.viewer.right).projectOnPlane(normal).normalize();
    const up = normal.clone().cross(right);
    const angle = Math.round(Math.atan2(along.dot(up), along.dot(right)) / angleStep) * angleStep;
    const length = along.length() / surface.frame.scale;
    const direction = right.multiplyScalar(Math.cos(angle)).addScaledVector(up, Math.sin(angle));
    return { direction: surface.directionFromScene(direction), length };
  }

  /** An anchor with one of its handles dragged to a place of the window. */
  withHandle(
    anchor: ControlPoint,
    drawn: DrawnTangents,
    side: Side,
    place: { x: number; y: number },
    { alt, shift }: HeldKeys,
  ): ControlPoint | null {
    const to = this.tangentAt(anchor, place, shift);
    const options = { broken: alt };
    return to && withTangents(anchor, withHandleAt(anchor.tangents, drawn, side, to, options));
  }

  /** An anchor at another point, to which its handles go along; with Alt new ones are drawn out. */
  moved(
    anchor: ControlPoint,
    drawn: DrawnTangents,
    point: SurfacePoint,
    { alt }: HeldKeys,
  ): ControlPoint {
    if (alt) return withTangents(anchor, { after: point, before: { length: null } });
    const surface = this.viewer.surface!;
    const turn = new Quaternion().setFromUnitVectors(surface.normal(anchor), surface.normal(point));
    const turned = (direction: Vector) =>
      surface.directionFromScene(surface.directionInScene(direction).applyQuaternion(turn));
    return withTangents(
      { ...anchor, ...point },
      byVectors(anchor.tangents, drawn, (direction) => turned(direction)),
    );
  }

  /** Makes the selected anchor, or else all of them, corners or smooth. */
  setJoint(joint: Joint): void {
    const { figure, selection } = this.editor.state;
    const { tangents } = this.session.view;
    if (figure.kind !== 'pen' || !tangents) return;
    const points = figure.points.map((point, i) => {
      if (selection !== null && selection !== i) return point;
      const drawn = tangents[i] ?? {};
      const has = drawn.before || drawn.after;
      if (joint === 'corner' || has)
        return withTangents(point, asJoint(point.tangents, drawn, joint));
      return withTangents(point, this.#alongChord(i));
    });
    this.editor.replace({ ...figure, points }, selection);
  }

  /** Handles for an anchor without any: parallel to the chord between its neighbors. */
  #alongChord(index: number): { after: Tangent; before: Tangent } | undefined {
    const { points, settings } = this.editor.state.figure;
    const surface = this.viewer.surface!;
    const count = points.length;
    const at = (i: number) => points[settings.closed ? (i + count) % count : i] ?? points[index]!;
    const place = (i: number) => surface.position(at(i), new Vector3());
    const chord = place(index + 1).sub(place(index - 1));
    const length = chord.length() / 6 / surface.frame.scale;
    if (!(length > 0)) return undefined;
    const direction = surface.directionFromScene(chord.normalize());
    return { after: { direction, length }, before: { length: null } };
  }
}
