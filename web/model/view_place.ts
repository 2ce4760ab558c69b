/** The camera's place as links write it: `view=top`, or six numbers. */
import type { Vector } from './figure';

/** The named views of the whole surface. */
export const viewNames = ['front', 'back', 'left', 'right', 'top', 'bottom'] as const;
export type ViewName = (typeof viewNames)[number];

const isViewName = (name: string | null): name is ViewName =>
  (viewNames as readonly (string | null)[]).includes(name);

/** A view after a turn, a zoom or a move, in the scene, where a surface's diagonal is 2. */
export interface OrbitPlace {
  /**
   * The direction from the target to the camera, in degrees: the azimuth around the axis that
   * points up, counted from the front, and the elevation.
   */
  azimuth: number;
  elevation: number;
  /**
   * The radius of the ball around the target that fits into the window. It does not depend on the
   * window's shape.
   */
  reach: number;
  target: Vector;
}

export type ViewPlace = ViewName | OrbitPlace;

/** The ranges of the view's numbers. */
const ranges = [
  { least: -180, most: 180 },
  { least: -90, most: 90 },
  { least: 1e-4, most: 10 },
  ...Array.from({ length: 3 }, () => ({ least: -20, most: 20 })),
];

export const viewRange =
  'a side, as front, or six numbers: degrees around from -180 to 180, above from -90 to 90, reach from 0.0001 to 10, and what is looked at from -20 to 20';

/** Formats a view; null if it is outside the range of links. */
export function formatView(view: ViewPlace): string | null {
  if (typeof view === 'string') return view;
  const { azimuth, elevation, reach, target } = view;
  const numbers = [azimuth, elevation].map((angle) => rounded(angle, 2));
  // The target of a near view needs more digits.
  const digits = Math.max(5, 3 - Math.floor(Math.log10(reach)));
  const near = Number(reach.toPrecision(5));
  const text = [...numbers, near, ...target.map((at) => rounded(at, digits))];
  return parseView(text.join(',')) ? text.join(',') : null;
}

/** Parses a view; null if it is none, or a number is out of range. */
export function parseView(text: string): ViewPlace | null {
  if (isViewName(text)) return text;
  const fields = text.split(',');
  const numbers = fields.map((field) => (field.trim() === '' ? Number.NaN : Number(field)));
  const good = ranges.every(({ least, most }, i) => numbers[i]! >= least && numbers[i]! <= most);
  if (!good || numbers.length !== ranges.length) return null;
  const [azimuth, elevation, reach, ...target] = numbers as [number, number, number, ...Vector];
  return { azimuth, elevation, reach, target };
}

/** The rounded number; -0 becomes 0. */
const rounded = (value: number, digits: number) => Number(value.toFixed(digits)) + 0;
