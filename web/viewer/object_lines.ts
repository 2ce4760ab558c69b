import { Color, Group, type Vector3 } from 'three';
import { type Dash, defaultStyle, type LineStyle } from '../model/drawing';
import { FatLine, type LineStyle as FatLineStyle } from './fat_line';
import type { Surface } from './surface';

/** The drawn form of an object, in the scene: lines, and single points by `dotAt`. */
export interface ObjectDrawing {
  id: number;
  style: LineStyle;
  /** Whether the object is locked, so that a click cannot select it. */
  locked: boolean;
  lines: readonly Float32Array[];
  dots: readonly Float32Array[];
}

/** Dash and gap of a line of normal width, in units of the scene; a surface's diagonal is 2. */
const usualDashes: Record<Dash, readonly [number, number] | null> = {
  solid: null,
  dashed: [0.032, 0.02],
  dotted: [0.007, 0.013],
};

/** A normal line's width, in units of the scene, when a large screen shows the whole surface. */
const usualBand = 0.0125;

/** The least width of a line on the surface, in CSS pixels. */
const leastSeen = 0.5;

/** The style of the fat line for an object's line; `wider` adds CSS pixels to its width. */
export function fatStyle(style: LineStyle, surface: Surface | null, wider = 0) {
  const { width, onSurface, opacity } = style;
  const band = onSurface && surface ? width * surface.frame.scale : 0;
  // Dashes are in proportion to the line's width.
  const scale = onSurface ? band / usualBand : width / defaultStyle.width;
  const dash = usualDashes[style.dash];
  return {
    width: (onSurface ? leastSeen : width) + wider,
    band:
      band > 0
        ? { width: band, normals: (line: Float32Array) => surface!.normalsAlong(line) }
        : null,
    dash: dash && ([dash[0] * scale, dash[1] * scale] as const),
    opacity,
  };
}

/** The fraction of the color that remains where the surface hides a line. */
const usuallyHidden = 0.22;
/** The number of stencil marks that separate transparent lines; the edited object has one more. */
export const mostMarks = 253;
/** The width of a point, as a factor on the line's width. */
const dotWidth = 2.4;

/** The style of an object's single points, as lines so short that their round ends are dots. */
export const dotStyle = (style: LineStyle): LineStyle => ({
  ...style,
  width: dotWidth * style.width,
  dash: 'solid',
});

/** A line so short that its round ends are a dot. */
export const dotAt = ({ x, y, z }: Vector3) => Float32Array.of(x, y, z, x + 1e-4, y, z);

/**
 * The lines and dots of objects. Objects of one style share a fat line, so that many objects need
 * few draw calls.
 */
export class ObjectLines {
  readonly object = new Group();
  /** The surface that the lines lie on. */
  surface: Surface | null = null;
  readonly #lines = new Map<string, FatLine>();
  /** The stencil marks of the lines. */
  readonly #marks = new Map<string, number>();
  #objects: readonly ObjectDrawing[] = [];
  #color = new Color();
  #surface = new Color();

  #hiddenShown = true;

  constructor(
    private readonly order: number,
    /**
     * `hidden` is the fraction of the color that remains where the surface hides a line. `wider`
     * adds CSS pixels to the width of the line's style.
     */
    private readonly looks: Partial<Pick<FatLineStyle, 'hidden' | 'frames'>> & {
      wider?: number;
    } = {},
  ) {}

  get objects(): readonly ObjectDrawing[] {
    return this.#objects;
  }

  setColors(curve: Color, surface: Color): void {
    [this.#color, this.#surface] = [curve, surface];
    this.show(this.#objects);
  }

  show(objects: readonly ObjectDrawing[]): void {
    this.#objects = objects;
    const styles = new Map<string, { style: LineStyle; lines: Float32Array[] }>();
    const add = (style: LineStyle, lines: readonly Float32Array[]) => {
      const key = Object.values(style).join(' ');
      const entry = styles.get(key) ?? { style, lines: [] };
      entry.lines.push(...lines);
      styles.set(key, entry);
    };
    for (const { style, lines, dots } of objects) {
      if (lines.length > 0) add(style, lines);
      if (dots.length > 0) {
        add(dotStyle(style), dots);
      }
    }
    for (const [key, line] of this.#lines) {
      if (styles.has(key)) continue;
      this.object.remove(line.object);
      line.dispose();
      this.#lines.delete(key);
      this.#marks.delete(key);
    }
    for (const [key, { style, lines }] of styles) {
      const line = this.#lines.get(key) ?? this.#make(key, style);
      line.setColor(style.color ? new Color(style.color) : this.#color, this.#surface);
      line.set(lines);
    }
  }

  follow(camera: Vector3): void {
    for (const line of this.#lines.values()) line.follow(camera);
  }

  /** Sets whether parts behind the surface are visible. */
  showHidden(shown: boolean): void {
    this.#hiddenShown = shown;
    for (const line of this.#lines.values()) line.showHidden(shown);
  }

  #make(key: string, style: LineStyle): FatLine {
    const { hidden = usuallyHidden, wider = 0, frames = null } = this.looks;
    const mark = this.#freeMark();
    const drawn = { ...fatStyle(style, this.surface, wider), hidden, mark, frames };
    const line = new FatLine(drawn, this.order);
    line.showHidden(this.#hiddenShown);
    this.#lines.set(key, line);
    this.#marks.set(key, mark);
    this.object.add(line.object);
    return line;
  }

  /** The lowest mark without a line; if all have one, the lines share them in turn. */
  #freeMark(): number {
    const taken = new Set(this.#marks.values());
    let mark = 1;
    while (taken.has(mark)) mark++;
    return mark <= mostMarks ? mark : 1 + (this.#lines.size % mostMarks);
  }
}
