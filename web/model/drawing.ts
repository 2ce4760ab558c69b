/** A drawing on one surface: objects in an order, one of which is edited. It is immutable. */
import type { SurfacePoint } from 'karcher';
import { emptyFigure, type Figure, isEmpty, withPlaces } from './figure';

export type Dash = 'solid' | 'dashed' | 'dotted';

export const dashes: readonly Dash[] = ['solid', 'dashed', 'dotted'];

/** The style of a line. */
export interface LineStyle {
  /** The color `#rrggbb`, or null for the theme's color of curves. */
  readonly color: string | null;
  /** The width in CSS pixels, or in the surface's unit. */
  readonly width: number;
  /**
   * Whether the width is in the surface's unit: the line then lies on the surface, and looks wider
   * from near.
   */
  readonly onSurface: boolean;
  readonly dash: Dash;
  /** The opacity, up to 1. */
  readonly opacity: number;
}

/** A hatched fill has equidistant lines, a striped one has bands along the border. */
export type FillPattern = 'solid' | 'hatched' | 'striped';

export const fillPatterns: readonly FillPattern[] = ['solid', 'hatched', 'striped'];

/** The paint of the inside of a closed line. */
export interface FillStyle {
  /** The opacity, from 0 (no fill) to 1. */
  readonly fill: number;
  /** The color `#rrggbb`, or null for the line's color. */
  readonly fillColor: string | null;
  readonly pattern: FillPattern;
  /**
   * The distance from one line to the next, or the width of a band, in the surface's unit; null for
   * a solid fill.
   */
  readonly spacing: number | null;
}

/** The properties of an object besides its figure. */
export interface Properties extends LineStyle, FillStyle {
  /** The name; empty for an unnamed object. */
  readonly name: string;
  readonly visible: boolean;
  /** Whether the object is locked, so that nobody can pick or edit it. */
  readonly locked: boolean;
  /** The name of its group, or null. */
  readonly group: string | null;
}

export interface DrawnObject extends Properties {
  /** A whole number, at least 1, that no other object of the drawing has. It never changes. */
  readonly id: number;
  readonly figure: Figure;
}

export interface Drawing {
  /**
   * The objects, at least one, from the lowest to the topmost. Only the active one may be empty.
   */
  readonly objects: readonly DrawnObject[];
  /** The id of the edited object. */
  readonly active: number;
}

/** The ranges of widths in CSS pixels, and in the surface's unit. */
export const widthRange = { least: 0.5, most: 20 };
export const surfaceWidths = { least: 1e-12, most: 1e12 };
export const leastOpacity = 0.05;
export const defaultStyle: LineStyle = {
  color: null,
  width: 4,
  onSurface: false,
  dash: 'solid',
  opacity: 1,
};
const defaultFill: FillStyle = {
  fill: 0,
  fillColor: null,
  pattern: 'solid',
  spacing: null,
};

const defaultProperties: Properties = {
  name: '',
  visible: true,
  locked: false,
  ...defaultStyle,
  ...defaultFill,
  group: null,
};

/** An object with a figure, and with defaults for its other properties. */
export function newObject(
  id: number,
  figure: Figure,
  properties: Partial<Properties> = {},
): DrawnObject {
  return { id, ...defaultProperties, ...properties, figure };
}

/** A drawing of one figure. */
export const drawingOf = (figure: Figure): Drawing => ({
  objects: [newObject(1, figure)],
  active: 1,
});

export const emptyDrawing: Drawing = drawingOf(emptyFigure);

export const indexOf = ({ objects }: Drawing, id: number) =>
  objects.findIndex((object) => object.id === id);

/** The object with an id; undefined if it does not exist. */
export const objectOf = ({ objects }: Drawing, id: number) =>
  objects.find((object) => object.id === id);

/** The edited object. */
export function activeObject(drawing: Drawing): DrawnObject {
  return objectOf(drawing, drawing.active)!;
}

/** The objects other than the edited one. */
export const othersOf = ({ objects, active }: Drawing) => objects.filter(({ id }) => id !== active);

/** An id that no object has. */
export const freeId = ({ objects }: Drawing) =>
  1 + objects.reduce((most, { id }) => Math.max(most, id), 0);

/** Whether all objects of the drawing are empty. */
export const isBlank = ({ objects }: Drawing) => objects.every(({ figure }) => isEmpty(figure));

/** A new object with a figure, and with the look of the edited object. */
export function successorOf(drawing: Drawing, figure: Figure): DrawnObject {
  return newObject(freeId(drawing), figure, lookOf(activeObject(drawing)));
}

/** The style and paint of an object. */
export function lookOf(object: LineStyle & FillStyle): LineStyle & FillStyle {
  const { fill, fillColor, pattern, spacing } = object;
  return { ...styleOf(object), fill, fillColor, pattern, spacing };
}

export function styleOf({ color, width, onSurface, dash, opacity }: LineStyle): LineStyle {
  return { color, width, onSurface, dash, opacity };
}

/**
 * The object with `move` applied to each of its places on the surface. It loses the choices for
 * parts of a cut whose points have no new place.
 */
export function withObjectPlaces(
  object: DrawnObject,
  move: (point: SurfacePoint) => SurfacePoint | null | undefined,
): DrawnObject {
  const figure = withPlaces(object.figure, (place) => move(place)!);
  const { derived } = figure;
  const parts = derived?.parts?.flatMap((part) => {
    const point = move(part.point);
    return point ? [{ ...part, point }] : [];
  });
  return { ...object, figure: parts ? { ...figure, derived: { ...derived!, parts } } : figure };
}
