/**
 * A drawing as a link's fragment. The fields of the edited object:
 * `mesh=bunny:1&kind=bspline&method=…&points=face,b1,b2,weight,beta;…&closed=1&degree=2&clamped=1`
 * `&legs=0:face,b1,b2:face,b1,b2;3:…&tangents=0:before:after;…&samples=64&tolerance=0.001&marks=9&levels=2`
 * `&of=2,3&distance=2&side=outwards&parts=face,b1,b2,hidden;…&thickness=1`
 * `&circle=face,b1,b2;radius,x,y,z;across&circletype=exact&arcs=5`
 * `&fill=0.5&fillcolor=0b8457&hatched=2` (or `striped=2`: the spacing)
 * `&name=…&hidden=1&locked=1&color=d9560b&width=6&dash=dotted&opacity=0.5&group=…&place=2`. `band`
 * is a width in the surface's unit. A leg has the index of its point and the points that it passes
 * through on its way to the next one (for the pen: from handle to handle). `place` is the number of
 * objects below this one. `view=azimuth,elevation,reach,x,y,z` or `view=top` is the place of the
 * camera (view_place.ts); the front is the default. The other objects follow from the lowest to the
 * topmost, each with the same fields in a field `other`. A link omits weights and betas of 1,
 * shortest legs and other defaults. It has no ids: objects have new numbers in their order.
 */
import {
  activeObject,
  type Drawing,
  type DrawnObject,
  defaultStyle,
  type FillStyle,
  indexOf,
  type LineStyle,
  newObject,
  othersOf,
  type Properties,
} from './drawing';
import { type Figure, isEmpty, isRound, type Kind, withFittingKnots } from './figure';
import { lookFields, readFields, writtenFields } from './link_fields';
import { figureFields, parseFigure, pointTexts } from './link_figure';
import { linkProblems } from './link_problems';
import { isMethod, type MethodId } from './methods';
import { longestName, shortened } from './names';
import { mostObjects } from './saved_drawing';
import { withSourceIds } from './sources';
import { formatView, parseView, type ViewPlace } from './view_place';

export interface Link {
  mesh: string;
  method: MethodId | null;
  drawing: Drawing;
  /** The place of the camera; null if the link has none. */
  view: ViewPlace | null;
  /** The numbers of faulty points and circles, which the drawing omits. */
  unread: Lost;
  /** Sentences about other faulty parts, which also name the values that replace them. */
  problems: readonly string[];
}

/** The numbers of points and circles that a drawing lacks. */
export interface Lost {
  points: number;
  circles: number;
}

export function formatLink(
  mesh: string,
  method: MethodId,
  drawing: Drawing,
  view: ViewPlace | null = null,
): string {
  const active = activeObject(drawing);
  const others = othersOf(drawing);
  const place = indexOf(drawing, active.id);
  const numberOf = (id: number) => 1 + indexOf(drawing, id);
  const [kind, ...rest] = objectFields(active, numberOf);
  return [
    `mesh=${encodeURIComponent(mesh).replaceAll('%3A', ':')}`,
    kind,
    `method=${method}`,
    ...rest,
    ...(place > 0 ? [`place=${place}`] : []),
    ...viewFields(view),
    ...others.map(
      (other) => `other=${encodeURIComponent(objectFields(other, numberOf).join('&'))}`,
    ),
  ].join('&');
}

/** The field of a view in a fragment. */
export function viewFields(view: ViewPlace | null): string[] {
  const text = view && formatView(view);
  return text ? [`view=${text}`] : [];
}

/**
 * The fields of an object. `numberOf` returns the position of a source among all objects, counted
 * from 1, or 0 if the source is gone.
 */
function objectFields(
  { figure, ...properties }: DrawnObject,
  numberOf: (id: number) => number,
): string[] {
  const parts = figureFields(figure, numberOf);
  const { name, visible, locked, group } = properties;
  if (name) parts.push(`name=${encodeName(name)}`);
  if (!visible) parts.push('hidden=1');
  if (locked) parts.push('locked=1');
  parts.push(...writtenFields(lookFields, linkLook(properties)));
  if (group !== null) parts.push(`group=${encodeName(group)}`);
  return parts;
}

const encodeName = (name: string) => encodeURIComponent(shortened(name, longestName));

/** Reads a link and omits faulty fields; null unless the fragment names a surface. */
export function parseLink(fragment: string): Link | null {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const mesh = fields.get('mesh');
  if (!mesh) return null;
  const method = fields.get('method');
  const others = fields.getAll('other').slice(0, mostObjects - 1);
  const place = Math.min(others.length, parseWhole(fields.get('place')) ?? 0);
  const texts = others.toSpliced(place, 0, fragment);
  const drawing = numbered(texts.map(parseObjects), place);
  const all = [fragment, ...others];
  const said = all.reduce((sum, text) => sum + pointTexts(text).length, 0);
  const circles = all.filter((text) => new URLSearchParams(text).get('circle')).length;
  const read = countPlaces(drawing);
  return {
    mesh,
    method: isMethod(method) ? method : null,
    drawing,
    view: parseView(fields.get('view') ?? ''),
    unread: { points: said - read.points, circles: circles - read.circles },
    problems: linkProblems(fragment),
  };
}

/**
 * The drawing of the objects in a link's texts, in their order. A source is the number of its text,
 * even if the drawing lacks the objects of other texts, since all of their points are faulty. The
 * hidden objects of the edited text lie on top.
 */
function numbered(texts: readonly (readonly DrawnObject[])[], place: number): Drawing {
  const count = texts.length;
  const objects = texts.flatMap(([object, ...hidden], i) => [
    { ...object!, id: i + 1 },
    ...(i === place ? [] : hidden),
  ]);
  const all = [...objects, ...texts[place]!.slice(1)].map((object, i) => ({
    ...object,
    id: object.id || count + i + 1,
  }));
  const active = place + 1;
  const stays = ({ id, figure }: DrawnObject) => id === active || !isEmpty(figure);
  let left: readonly DrawnObject[] = all;
  do {
    const there = left.filter(stays);
    const ids = new Set(there.map(({ id }) => id));
    left = there.map((one) => withSourceIds(one, (id) => (ids.has(id) ? id : undefined)));
    // An object that has lost its last source is empty, too.
  } while (!left.every(stays));
  const numbers = new Map(left.map(({ id }, i) => [id, i + 1]));
  return {
    objects: left.map((one) => ({
      ...withSourceIds(one, (id) => numbers.get(id)),
      id: numbers.get(one.id)!,
    })),
    active: numbers.get(active)!,
  };
}

/** The number of points of a drawing's objects. */
export const pointsOf = (drawing: Drawing) => countPlaces(drawing).points;

const countPlaces = ({ objects }: Drawing): Lost => ({
  points: objects.reduce((sum, { figure }) => sum + figure.points.length, 0),
  circles: objects.filter(({ figure }) => figure.circle).length,
});

/** The numbers of a link's points and circles that a drawing lacks. */
export function lostOf({ drawing: said, unread }: Link, drawing: Drawing): Lost {
  const [all, left] = [countPlaces(said), countPlaces(drawing)];
  return {
    points: unread.points + all.points - left.points,
    circles: unread.circles + all.circles - left.circles,
  };
}

/**
 * The objects in a fragment. In older links a curve could also have a circle, and a circle also
 * points. This second figure becomes another object, which is hidden.
 */
function parseObjects(fragment: string): DrawnObject[] {
  const figure = parseFigure(fragment);
  const object = newObject(0, figure, parseProperties(fragment));
  const curve = { ...figure, circle: null };
  const round = withFittingKnots({ ...figure, points: [] });
  const behind = (other: Figure, kind: Kind) =>
    [newObject(0, { ...other, kind }, { visible: false })].filter((one) => !isEmpty(one.figure));
  return isRound(figure.kind)
    ? [{ ...object, figure: round }, ...behind(curve, 'bspline')]
    : [{ ...object, figure: curve }, ...behind(round, 'circle')];
}

function linkLook(properties: LineStyle & FillStyle) {
  const { color, width, onSurface, dash, opacity, fill, fillColor, pattern, spacing } = properties;
  return {
    ...{ color, dash, opacity, fill, fillcolor: fillColor },
    ...{ band: onSurface ? width : null, width: onSurface ? defaultStyle.width : width },
    hatched: pattern === 'hatched' ? spacing : null,
    striped: pattern === 'striped' ? spacing : null,
  };
}

function parseProperties(fragment: string): Partial<Properties> {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const look = readFields(lookFields, fields);
  const { color, band, dash, opacity, fill, fillcolor: fillColor, hatched, striped } = look;
  return {
    name: shortened(fields.get('name') ?? '', longestName),
    visible: fields.get('hidden') !== '1',
    locked: fields.get('locked') === '1',
    ...{ color, dash, opacity, fill, fillColor },
    ...{ width: band ?? look.width, onSurface: band !== null },
    pattern: hatched !== null ? 'hatched' : striped !== null ? 'striped' : 'solid',
    spacing: hatched ?? striped,
    group: shortened(fields.get('group') ?? '', longestName) || null,
  };
}

const parseWhole = (text: string | null) => (text && /^\d{1,9}$/.test(text) ? Number(text) : null);
