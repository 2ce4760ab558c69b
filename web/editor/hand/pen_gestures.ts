import type { SurfacePoint } from 'karcher';
import { Vector3 } from 'three';
import type { ControlPoint, Side, Tangent, Vector } from '../../model/figure';
import { methodOptions } from '../../model/methods';
import {
  asJoint,
  byVectors,
  type Joint,
  segmentAt,
  withHandleAt,
  withTangents,
} from '../../model/pen';
import { bends, goesOn, type PenState } from '../../model/pen_hints';
import type { DrawnTangents } from '../../model/pen_legs';
import type { Viewer } from '../../viewer/viewer';
import { Bend } from '../engine/bend';
import { Newest } from '../engine/newest';
import type { Session } from '../engine/session';
import type { Editor } from '../state/editor';
import type { Snapping } from './snapping';
import type { Hold, Place } from './stage_pointer';
import { targetAt } from './targets';

/** The number of corrections of a bend at each step of a drag, and at its end. */
const whileDragged = 1;
const atLast = 8;
/** The step of a handle's angle while Shift is down. */
const angleStep = Math.PI / 4;

/** The pressed keys during a drag. */
export interface HeldKeys {
  alt: boolean;
  shift: boolean;
  /** Whether Ctrl or Cmd is down. */
  control: boolean;
}

/**
 * The pen: a click on the surface places a corner. A drag places a smooth anchor at its start, with
 * one handle under the pointer and the other opposite to it. Each click or drag is one step of the
 * history.
 */
export class PenGestures {
  /** Drops the last step of a bend that the user has let go. */
  #dropLast = () => {};

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
    private readonly snapping: Snapping,
  ) {}

  /** Places an anchor under a press on the surface, or bends the curve. */
  take(press: Place): Hold | null {
    const { editor, viewer } = this;
    const { figure, tool } = editor.state;
    const { snapping } = this;
    // Ctrl turns the view, unless it keeps a point from snapping.
    if (press.shift || (press.control && !snapping.on)) return null;
    if (figure.kind !== 'pen' || tool !== 'insert') return null;
    const target = targetAt(viewer, editor.state, press);
    const places = target?.type === 'other' && snapping.placesOn(press.control);
    const picked = places || target?.type === 'surface' ? snapping.pick(press) : null;
    if (picked) return this.#place(picked.point);
    const isBent = target?.type === 'curve' && bends(this.state(press.alt));
    return isBent ? this.#bend(target.position) : null;
  }

  /** Ends a released bend as it is shown. */
  letGo(): void {
    this.#dropLast();
  }

  /** The state on which a click or a drag of the pen depends. */
  state(alt: boolean): PenState {
    const { figure, selection, chosen, drawing } = this.editor.state;
    return {
      anchors: figure.points.length,
      closed: figure.settings.closed,
      selected: typeof selection === 'number' ? selection : null,
      chosen: chosen.includes(drawing.active),
      alt,
    };
  }

  #place(anchor: SurfacePoint): Hold {
    const { editor } = this;
    const { selection, chosen, none, figure } = editor.state;
    const count = figure.points.length;
    const begins = !editor.isOpen || (count > 0 && !goesOn(this.state(false)));
    const index = begins ? 0 : count;
    const place = (point: ControlPoint) => {
      if (begins) editor.previewBegun('pen', { type: 'insert', index, point });
      else editor.preview({ type: 'insert', index, point });
      editor.setSelection({ selection: index, chosen: begins ? [] : chosen });
    };
    place(anchor);
    const restore = () => editor.setSelection({ selection, chosen, none });
    return {
      drag: (to) => {
        const after = this.tangentAt(anchor, to, to.shift);
        if (after) place(withTangents(anchor, { after, before: { length: null } }));
      },
      release: () => {
        if (editor.commitDrag()) editor.select(index);
        else restore();
      },
      cancel: () => {
        editor.cancelDrag();
        restore();
      },
    };
  }

  /**
   * Bends the segment at a place of the scene by a drag; a click selects the segment's nearer
   * anchor.
   */
  #bend(position: Vector3): Hold {
    const { editor } = this;
    const near = this.viewer.surface!.fromScene(position);
    const { figure } = editor.state;
    let [held, released] = [true, false];
    let bend: Promise<Bend | null> | null = null;
    const go = async ({ x, y }: Place, corrections: number) => {
      bend ??= this.#bendOf(near);
      const point = this.viewer.pick(x, y)?.point;
      const segment = await bend;
      const command = point && (await segment?.through(point, corrections).catch(() => null));
      // The curve may have disappeared after the release.
      if (held && segment && command && editor.state.base === figure) {
        editor.preview(command, segment.anchors);
        if (released) editor.releaseDrag();
      }
    };
    const newest = new Newest<Place>((place) => go(place, whileDragged));
    return {
      drag: (place) => newest.push(place),
      release: async (place, dragged) => {
        if (!dragged) return this.selectNear(position);
        released = true;
        editor.releaseDrag();
        this.#dropLast = () => {
          held = false;
        };
        try {
          await newest.end();
          await go(place, atLast);
          if (held && editor.state.base === figure) editor.commitDrag();
        } finally {
          (await bend)?.end();
        }
      },
      cancel: () => {
        held = false;
        newest.drop();
        editor.cancelDrag();
        void bend?.then((segment) => segment?.end());
      },
    };
  }

  async #bendOf(near: Vector): Promise<Bend | null> {
    const { figure, method } = this.editor.state;
    const { client, view } = this.session;
    const { surface } = this.viewer;
    const { tangents } = view;
    const measured = await this.session.measured(near);
    if (!measured || !client || !surface || !tangents) return null;
    const at = segmentAt(figure, measured.parameter);
    return Bend.of(client, surface, figure, tangents, methodOptions(method), at).catch(() => null);
  }

  /** Selects the nearer anchor of the segment at a place of the scene. */
  async selectNear(position: Vector3): Promise<void> {
    const near = this.viewer.surface!.fromScene(position);
    const { figure, selection } = this.editor.state;
    const measured = await this.session.measured(near);
    // The user may have selected something else meanwhile.
    const { state } = this.editor;
    if (!measured || state.figure !== figure || state.selection !== selection) return;
    const { from, to, t } = segmentAt(figure, measured.parameter);
    this.editor.select(t < 0.5 ? from : to);
  }

  /**
   * Turns an anchor with handles into a corner, and an anchor without handles into a smooth one. The
   * legs on both sides keep their ways.
   */
  convert(index: number): void {
    const { figure } = this.editor.state;
    const from = figure.points[index];
    if (!from) return;
    const tangents = from.tangents ? undefined : this.#alongChord(index);
    const points = figure.points.with(index, withTangents(from, tangents));
    this.editor.replace({ ...figure, points }, index);
  }

  /**
   * The handle of an anchor, with its end at a place of the window; null outside the silhouette. If
   * `kept`, the handle's angle is a multiple of `angleStep`.
   */
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

  /** An anchor after the drag of one of its handles to a place of the window. */
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

  /**
   * An anchor after a drag to another point. Its handles move along; with Alt, the drag draws out
   * new handles instead.
   */
  moved(
    anchor: ControlPoint,
    drawn: DrawnTangents,
    point: SurfacePoint,
    { alt }: HeldKeys,
  ): ControlPoint {
    if (alt) return withTangents(anchor, { after: point, before: { length: null } });
    const carried = this.viewer.surface!.carry(anchor, point);
    return withTangents({ ...anchor, ...point }, byVectors(anchor.tangents, drawn, carried));
  }

  /**
   * Turns the selected anchors, or all anchors if none is selected, into corners or smooth anchors.
   */
  setJoint(joint: Joint): void {
    const { figure, selection, more } = this.editor.state;
    const { tangents } = this.session.view;
    if (figure.kind !== 'pen' || !tangents) return;
    const points = figure.points.map((point, i) => {
      if (selection !== null && selection !== i && !more.includes(i)) return point;
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
