import { Color, type Vector3 } from 'three';
import { defaultStyle } from '../model/drawing';
import { isAmongShades, litSurface, rimColor, type ViewerColors } from './colors';
import { dotStyle, type ObjectDrawing, ObjectLines } from './object_lines';
import type { Surface } from './surface';

type Drawn = Omit<ObjectDrawing, 'id' | 'locked'>;

/**
 * The CSS pixels that halo and seam add to the width of a line. The halo surrounds the line of a
 * selected object, and the seam separates line and halo. The halo of an object under the pointer is
 * as wide as the seam.
 */
const [haloWider, seamWider] = [8, 3];
/** The CSS pixels that a rim adds to the width of a line. Lines that are hard to see have a rim. */
const rimWider = 2.5;

const plain = { id: 0, locked: true };

/** The lines of objects with their widths, but solid, opaque and without a color of their own. */
const around = (objects: readonly Drawn[]): ObjectDrawing[] =>
  objects.map(({ style: { width, onSurface }, lines, dots }) => ({
    ...plain,
    style: { ...defaultStyle, width, onSurface },
    lines,
    dots,
  }));

/** Halos around lines that are selected, that a click would take, or that are hard to see. */
export class Halos {
  /**
   * Invisible copies of the lines, which cut the lines out of their halos. The surface is thus
   * visible between dashes and through transparent lines.
   */
  readonly #inside = new ObjectLines(0.1, { hidden: 0, frames: 'inside' });
  readonly #halo = new ObjectLines(0.2, { hidden: 0, wider: haloWider, frames: 'around' });
  /** A seam between halo and line, so that the halo is visible beside a line of any color. */
  readonly #seam = new ObjectLines(0.5, { hidden: 0, wider: seamWider, frames: 'around' });
  readonly #hover = new ObjectLines(0.8, { hidden: 0, wider: seamWider, frames: 'around' });
  readonly #rim = new ObjectLines(1, { hidden: 0, wider: rimWider });
  readonly #all = [this.#inside, this.#halo, this.#seam, this.#hover, this.#rim];
  readonly objects = this.#all.map(({ object }) => object);
  #colors: ViewerColors | null = null;
  /** Half the width of the widest line or dot with its halo, in CSS pixels. */
  reach = 0;

  set surface(surface: Surface) {
    for (const lines of this.#all) lines.surface = surface;
  }

  setColors(colors: ViewerColors): void {
    this.#colors = colors;
    const surface = litSurface(colors);
    this.#halo.setColors(new Color(colors.chosen), surface);
    this.#seam.setColors(new Color('#fff'), surface);
    this.#hover.setColors(new Color(colors.frame), surface);
  }

  /** Shows halos around chosen and hovered objects, and rims around the objects that need one. */
  show(all: readonly Drawn[], chosen: readonly Drawn[], hovered: readonly Drawn[]): void {
    this.#inside.show(around([...chosen, ...hovered]));
    this.#halo.show(around(chosen));
    this.#seam.show(around(chosen));
    this.#hover.show(around(hovered));
    this.#rim.show(all.flatMap((one) => this.#rimOf(one)));
    const widths = all
      .filter(({ style }) => !style.onSurface)
      .map(({ style, dots }) => (dots.length > 0 ? dotStyle(style) : style).width);
    const widest = Math.max(0, ...widths);
    this.reach = (widest + (chosen.length > 0 ? haloWider : rimWider)) / 2;
  }

  follow(camera: Vector3): void {
    for (const lines of this.#all) lines.follow(camera);
  }

  /**
   * The rim of an object that is hard to see, with the dashes of its line. A transparent line has
   * no rim, since the rim would show through.
   */
  #rimOf({ style, lines, dots }: Drawn): ObjectDrawing[] {
    if (
      style.opacity < 1 ||
      !style.color ||
      !this.#colors ||
      !isAmongShades(style.color, this.#colors)
    )
      return [];
    return [{ ...plain, style: { ...style, color: rimColor(style.color) }, lines, dots }];
  }
}
