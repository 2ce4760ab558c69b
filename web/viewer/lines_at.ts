import { Vector3 } from 'three';
import type { LineStyle } from '../model/drawing';
import { dotStyle, type ObjectDrawing } from './object_lines';
import type { Vantage } from './vantage';

/** The lines that a pointer may pick, in the scene. */
export interface PickableLines {
  /** The edited curve; empty if the edited object is no curve. */
  curve: Float32Array;
  /** All lines of the edited object, and their style. */
  own: readonly Float32Array[];
  style: LineStyle;
  /** The other objects, the topmost last. */
  objects: readonly ObjectDrawing[];
  /** Paths that are shorter than the curve's legs. */
  shorter: readonly Float32Array[];
}

/**
 * Finds the visible lines at a place of the stage. Lines count in their whole width. Distances are
 * in CSS pixels.
 */
export class LinesAt {
  constructor(
    private readonly vantage: Vantage,
    private readonly lines: PickableLines,
    private readonly place: { x: number; y: number },
  ) {}

  /** The curve's visible point at the place, in the scene; null without one. */
  curve(within: number): Vector3 | null {
    return this.#pointOf(this.lines.curve, within, this.lines.style);
  }

  /** Whether the edited object is visible at the place. */
  own(within: number): boolean {
    const { own, style } = this.lines;
    return own.some((line) => this.#pointOf(line, within, style));
  }

  /**
   * The id of the topmost object visible at the place, except for locked objects and the edited
   * one; null if there is none.
   */
  object(within: number): number | null {
    const found = this.lines.objects.findLast(({ locked, style, lines, dots }) => {
      const isSeen = (look: LineStyle) => (line: Float32Array) => this.#pointOf(line, within, look);
      return !locked && (lines.some(isSeen(style)) || dots.some(isSeen(dotStyle(style))));
    });
    return found?.id ?? null;
  }

  /** The index of the first shorter path visible at the place; -1 without one. */
  shorter(within: number): number {
    return this.lines.shorter.findIndex((line) => this.#pointOf(line, within));
  }

  /** The nearest visible point on a line of another object, in the scene; null without one. */
  nearestOnObjects(within: number): Vector3 | null {
    const found = this.lines.objects
      .flatMap(({ lines }) =>
        lines.map((line) => this.vantage.nearest(line, this.place, () => within)),
      )
      .filter((one) => one !== null)
      .sort((a, b) => a.distance - b.distance);
    return found[0]?.position ?? null;
  }

  #pointOf(line: Float32Array, within: number, style: LineStyle | null = null): Vector3 | null {
    const half = (position: Vector3) => (style ? this.vantage.seenWidth(style, position) / 2 : 0);
    const reach = (position: Vector3) => Math.max(within, half(position));
    return this.vantage.nearest(line, this.place, reach)?.position ?? null;
  }
}

/** The ids of the other objects in a box, and whether the edited object is in the box. */
export interface ObjectsIn {
  others: number[];
  edited: boolean;
}

/** A box of the stage, in CSS pixels. */
interface StageBox {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** The unlocked objects that are at least partly visible in a box of the stage. */
export function objectsIn(
  vantage: Vantage,
  { objects, own }: PickableLines,
  box: StageBox,
): ObjectsIn {
  const isSeen = (place: Vector3) => !vantage.project(place).hidden;
  const [from, to, position] = [new Vector3(), new Vector3(), new Vector3()];
  const isWithin = (line: Float32Array) => {
    for (let i = 0; i < line.length; i += 3) {
      vantage.onStage(to.fromArray(line, i));
      if (middleIn(box, to, to) !== null && isSeen(position.fromArray(line, i))) return true;
      // A box may hold a visible part of a segment without its ends.
      const middle = i > 0 && from.z <= 1 && to.z <= 1 ? middleIn(box, from, to) : null;
      if (middle !== null && isSeen(vantage.fromStage(from.lerp(to, middle)))) return true;
      from.copy(to);
    }
    return false;
  };
  const others = objects.filter(
    ({ locked, lines, dots }) => !locked && [...lines, ...dots].some(isWithin),
  );
  return { others: others.map(({ id }) => id), edited: own.some(isWithin) };
}

/**
 * The middle of the part of a segment that lies in a box, from 0 at the start of the segment to 1
 * at its end; null if no part lies there.
 */
function middleIn({ left, top, width, height }: StageBox, from: Vector3, to: Vector3) {
  let [enters, leaves] = [0, 1];
  for (const [start, end, low, high] of [
    [from.x, to.x, left, left + width],
    [from.y, to.y, top, top + height],
  ] as const) {
    if (Math.max(start, end) < low || Math.min(start, end) > high) return null;
    if (start === end) continue;
    const [atLow, atHigh] = [(low - start) / (end - start), (high - start) / (end - start)];
    enters = Math.max(enters, Math.min(atLow, atHigh));
    leaves = Math.min(leaves, Math.max(atLow, atHigh));
  }
  return enters <= leaves ? (enters + leaves) / 2 : null;
}
