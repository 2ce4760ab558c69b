/**
 * A drawing as a link's fragment. The object that is edited:
 * `mesh=bunny:1&kind=bspline&method=…&points=face,b1,b2,weight,beta;…&closed=1&degree=2&clamped=1`
 * `&legs=0:face,b1,b2:face,b1,b2;3:…&tangents=0:before:after;…&samples=64&tolerance=0.001&marks=9&levels=2`
 * `&of=2,3&distance=2&side=outwards&parts=face,b1,b2,hidden;…&thickness=1`
 * `&circle=face,b1,b2;radius,x,y,z;across&circletype=exact&arcs=5`
 * `&name=…&hidden=1&locked=1&color=d9560b&width=6&dash=dotted&opacity=0.5&group=…&place=2`. A width in
 * the surface's unit is `band`. Legs are told by a
 * point's number and the points that its way to the next one goes through (of the pen's anchors: from
 * handle to handle), its place by how many objects lie below it. `view=azimuth,elevation,reach,x,y,z` or
 * `view=top` is from where the surface is looked at (view_place.ts), by default the front. Then the others
 * from the lowest to the topmost, each with the same fields in a field `other`. Weights and betas of 1,
 * shortest legs and other defaults go without saying. Ids are not told: objects are numbered anew in their
 * order.
 */
import type { CurveLevels, SurfacePoint } from 'karcher';
import {
  activeObject,
  type Drawing,
  type DrawnObject,
  dashes,
  defaultStyle,
  indexOf,
  leastOpacity,
  newObject,
  othersOf,
  type Properties,
  surfaceWidths,
  widthRange,
} from './drawing';
import type { Tangent, Tangents } from './figure';
import { isDerived } from './derived';
import {
  type Across,
  type CircleForm,
  type CircleShape,
  type ControlPoint,
  type CurveSettings,
  defaultCircleForm,
  defaultSettings,
  type Figure,
  fewestArcs,
  isEmpty,
  isRound,
  type Kind,
  kinds,
  marksRange,
  mostArcs,
  mostLegPoints,
  mostLevels,
  type Rim,
  samplesRange,
  surfacePoint,
  toleranceRange,
  type Vector,
  withFittingKnots,
  withLeg,
  withParameter,
} from './figure';
import { derivedFields, parseDerived } from './link_derived';
import { linkProblems } from './link_problems';
import { isMethod, type MethodId } from './methods';
import { longestName, shortened } from './names';
import { withTangents } from './pen';
import { isColor, mostObjects } from './saved_drawing';
import { formatView, parseView, type ViewPlace } from './view_place';

export interface Link {
  mesh: string;
  method: MethodId | null;
  drawing: Drawing;
  /** From where the surface is looked at; null where it does not say. */
  view: ViewPlace | null;
  /** What it says so wrongly that the drawing is without it. */
  unread: Lost;
  /** Sentences about what else it says wrongly, and what is taken in its place. */
  problems: readonly string[];
}

/** Places that a drawing is without. */
export interface Lost {
  points: number;
  circles: number;
}

const formatPoint = ({ face, bary }: SurfacePoint) => `${face},${bary[1]},${bary[2]}`;

function formatControlPoint(point: ControlPoint): string {
  const { weight = 1, beta = 1 } = point;
  const numbers = beta !== 1 ? [weight, beta] : weight !== 1 ? [weight] : [];
  return [formatPoint(point), ...numbers].join(',');
}

function formatRim(rim: Rim): string {
  if ('face' in rim) return formatPoint(rim);
  return [rim.radius, ...rim.direction].join(',');
}

function formatAcross(across: Across): string {
  return 'face' in across ? formatPoint(across) : `${across.radius}`;
}

function formatCircle({ center, rim, across }: CircleShape): string {
  const parts = [formatPoint(center), formatRim(rim)];
  return [...parts, ...(across ? [formatAcross(across)] : [])].join(';');
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

/** The field of a view, for a fragment. */
export function viewFields(view: ViewPlace | null): string[] {
  const text = view && formatView(view);
  return text ? [`view=${text}`] : [];
}

/** `numberOf` tells an object of an id by its place among all, from 1; 0 where it is gone. */
function objectFields(
  { figure, ...properties }: DrawnObject,
  numberOf: (id: number) => number,
): string[] {
  const { kind, points, settings, circle, circleForm, derived } = figure;
  const parts = [`kind=${kind}`, `points=${points.map(formatControlPoint).join(';')}`];
  parts.push(...legsFields(points), ...tangentsFields(points), ...settingsFields(settings));
  if (circle) parts.push(`circle=${formatCircle(circle)}`);
  if (circleForm.type !== defaultCircleForm.type) parts.push(`circletype=${circleForm.type}`);
  if (circleForm.arcs !== defaultCircleForm.arcs) parts.push(`arcs=${circleForm.arcs}`);
  if (isDerived(kind) && derived) parts.push(...derivedFields(derived, numberOf, formatPoint));
  const { name, visible, locked, color, width, onSurface, dash, opacity, group } = properties;
  const { fill, fillColor } = properties;
  if (name) parts.push(`name=${encodeName(name)}`);
  if (!visible) parts.push('hidden=1');
  if (locked) parts.push('locked=1');
  if (color) parts.push(`color=${color.slice(1)}`);
  if (onSurface) parts.push(`band=${width}`);
  else if (width !== defaultStyle.width) parts.push(`width=${width}`);
  if (dash !== defaultStyle.dash) parts.push(`dash=${dash}`);
  if (opacity !== defaultStyle.opacity) parts.push(`opacity=${opacity}`);
  if (fill > 0) parts.push(`fill=${fill}`);
  if (fillColor) parts.push(`fillcolor=${fillColor.slice(1)}`);
  if (group !== null) parts.push(`group=${encodeName(group)}`);
  return parts;
}

const encodeName = (name: string) => encodeURIComponent(shortened(name, longestName));

function legsFields(points: readonly ControlPoint[]): string[] {
  const legs = points.map(({ leg }, i) => leg && [i, ...leg.map(formatPoint)].join(':'));
  const told = legs.filter((leg) => leg !== undefined);
  return told.length > 0 ? [`legs=${told.join(';')}`] : [];
}

/** The handles of anchors: by a point's number those before and after it, each told as it is. */
function tangentsFields(points: readonly ControlPoint[]): string[] {
  const told = points.flatMap(({ tangents }, i) =>
    tangents ? [`${i}:${formatTangent(tangents.before)}:${formatTangent(tangents.after)}`] : [],
  );
  return told.length > 0 ? [`tangents=${told.join(';')}`] : [];
}

function formatTangent(tangent: Tangent | undefined): string {
  if (!tangent) return '';
  if ('face' in tangent) return formatPoint(tangent);
  if ('direction' in tangent) return [tangent.length, ...tangent.direction].join(',');
  return tangent.length === null ? 'same' : `${tangent.length}`;
}

function parseTangent(text: string): Tangent | undefined {
  if (text === 'same') return { length: null };
  const point = parsePoint(text);
  if (point) return point;
  const [length = -1, ...direction] = parseNumbers(text, 4) ?? parseNumbers(text, 1) ?? [];
  if (length < 0) return undefined;
  return direction.length > 0 ? { direction: direction as Vector, length } : { length };
}

/** Handles by the numbers of their anchors. */
function parseTangents(text: string): Map<string, Tangents> {
  const parts = text.split(';').map((part) => part.split(':'));
  return new Map(
    parts.map(([number = '', before = '', after = '']) => {
      const read = { before: parseTangent(before), after: parseTangent(after) };
      const told = {
        ...(read.before && { before: read.before }),
        ...(read.after && { after: read.after }),
      };
      return [number, told];
    }),
  );
}

function settingsFields(settings: CurveSettings): string[] {
  const parts: string[] = [];
  if (settings.closed) parts.push('closed=1');
  if (settings.degree !== defaultSettings.degree) parts.push(`degree=${settings.degree}`);
  if (settings.clamped) parts.push('clamped=1');
  if (settings.knots) parts.push(`knots=${settings.knots}`);
  if (settings.parametrization !== defaultSettings.parametrization) {
    parts.push(`parametrization=${settings.parametrization}`);
  }
  if (settings.samples !== defaultSettings.samples) parts.push(`samples=${settings.samples}`);
  if (settings.tolerance !== null) parts.push(`tolerance=${settings.tolerance}`);
  if (settings.marks > 0) parts.push(`marks=${settings.marks}`);
  if (settings.levels !== defaultSettings.levels) parts.push(`levels=${settings.levels}`);
  return parts;
}

/** Null unless the fragment names a surface; what else it says wrongly is left out. */
export function parseLink(fragment: string): Link | null {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const mesh = fields.get('mesh');
  if (!mesh) return null;
  const method = fields.get('method');
  const others = fields.getAll('other').slice(0, mostObjects - 1);
  const objects = others.flatMap(parseObjects).filter(({ figure }) => !isEmpty(figure));
  const place = Math.min(objects.length, parseWhole(fields.get('place')) ?? 0);
  const [active, ...hidden] = parseObjects(fragment);
  objects.splice(place, 0, active!);
  objects.push(...hidden);
  const all = [fragment, ...others];
  const said = all.reduce((sum, text) => sum + pointTexts(text).length, 0);
  const circles = all.filter((text) => new URLSearchParams(text).get('circle')).length;
  const drawing = {
    objects: objects.map((object, i) => ({ ...object, id: i + 1 })),
    active: place + 1,
  };
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

/** The points of a figure's fragment, as they are said. */
function pointTexts(fragment: string): string[] {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  return (fields.get('points') ?? '').split(';').filter((text) => text !== '');
}

/** How many points a drawing's objects have. */
export const pointsOf = (drawing: Drawing) => countPlaces(drawing).points;

const countPlaces = ({ objects }: Drawing): Lost => ({
  points: objects.reduce((sum, { figure }) => sum + figure.points.length, 0),
  circles: objects.filter(({ figure }) => figure.circle).length,
});

/** What a link says and a drawing that was made of it is without. */
export function lostOf({ drawing: said, unread }: Link, drawing: Drawing): Lost {
  const [all, left] = [countPlaces(said), countPlaces(drawing)];
  return {
    points: unread.points + all.points - left.points,
    circles: unread.circles + all.circles - left.circles,
  };
}

/**
 * The object that a fragment says. Links once kept the circle behind a curve's points, or the points
 * behind a circle: these are another object, which is not shown.
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

/** The figure that a fragment says. */
function parseFigure(fragment: string): Figure {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const legs = parseLegs(fields.get('legs') ?? '');
  const tangents = parseTangents(fields.get('tangents') ?? '');
  const read = pointTexts(fragment).map(parseControlPoint);
  const points = read.map((point, i) => {
    const next = i + 1 < read.length ? read[i + 1] : read[0];
    const leg = next ? legs.get(i) : null;
    return point && withTangents(withLeg(point, leg), tangents.get(`${i}`));
  });
  const kind = kinds.find((one) => one === fields.get('kind')) ?? 'bspline';
  return withFittingKnots({
    kind,
    settings: parseSettings(fields),
    points: points.filter((point) => point !== null),
    circle: parseCircle(fields.get('circle') ?? ''),
    circleForm: parseCircleForm(fields),
    ...(isDerived(kind) && { derived: parseDerived(kind, fields, parsePoint) }),
  });
}

function parseProperties(fragment: string): Partial<Properties> {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const color = `#${fields.get('color')}`;
  const band = Number(fields.get('band') ?? Number.NaN);
  const onSurface = isWithin(band, surfaceWidths);
  const width = Number(fields.get('width') ?? defaultStyle.width);
  const opacity = Number(fields.get('opacity') ?? defaultStyle.opacity);
  const fill = Number(fields.get('fill') ?? 0);
  const fillColor = `#${fields.get('fillcolor')}`;
  return {
    name: shortened(fields.get('name') ?? '', longestName),
    visible: fields.get('hidden') !== '1',
    locked: fields.get('locked') === '1',
    color: isColor(color) ? color : null,
    width: onSurface ? band : isWithin(width, widthRange) ? width : defaultStyle.width,
    onSurface,
    dash: dashes.find((one) => one === fields.get('dash')) ?? defaultStyle.dash,
    opacity: isWithin(opacity, { least: leastOpacity, most: 1 }) ? opacity : defaultStyle.opacity,
    fill: fill >= 0 && fill <= 1 ? fill : 0,
    fillColor: isColor(fillColor) ? fillColor : null,
    group: shortened(fields.get('group') ?? '', longestName) || null,
  };
}

const isWithin = (value: number, { least, most }: { least: number; most: number }) =>
  value >= least && value <= most;

const parseWhole = (text: string | null) => (text && /^\d{1,9}$/.test(text) ? Number(text) : null);

/** Legs by the numbers of their points; those that are said wrongly are left out. */
function parseLegs(text: string): Map<number, SurfacePoint[]> {
  const legs = new Map<number, SurfacePoint[]>();
  for (const part of text.split(';')) {
    const [number = '', ...through] = part.split(':');
    const leg = through.map(parsePoint).filter((point) => point !== null);
    const whole = leg.length === through.length && leg.length > 0 && leg.length <= mostLegPoints;
    if (whole && /^\d+$/.test(number)) legs.set(Number(number), leg);
  }
  return legs;
}

function parseNumbers(text: string, count: number): number[] | null {
  const fields = text.split(',');
  // -0 is 0.
  const values = fields.map((field) => Number(field) + 0);
  const good = fields.length === count && fields.every((field) => field.trim() !== '');
  return good && values.every(Number.isFinite) ? values : null;
}

function parsePoint(text: string): SurfacePoint | null {
  const values = parseNumbers(text, 3);
  if (!values) return null;
  const [face, u, v] = values as Vector;
  const good = Number.isInteger(face) && face >= 0 && u >= 0 && v >= 0 && u + v <= 1;
  return good ? surfacePoint(face, u, v) : null;
}

function parseControlPoint(text: string): ControlPoint | null {
  const [face, u, v, weight = '1', beta = '1'] = text.split(',');
  const point = parsePoint([face, u, v].join(','));
  const weighted = point && withParameter(point, 'weight', parseParameter(weight));
  return weighted && withParameter(weighted, 'beta', parseParameter(beta));
}

/** The parts of a curve that was cut may have any numbers, beyond those of the sliders too. */
function parseParameter(text: string): number {
  const [value] = parseNumbers(text, 1) ?? [1];
  return Math.min(1e12, Math.max(1e-12, value!));
}

function parseSettings(fields: URLSearchParams): CurveSettings {
  const degree = Number(fields.get('degree'));
  const knots = fields.get('knots') ?? '';
  const within = (name: string, { least, most }: { least: number; most: number }) => {
    const [value] = parseNumbers(fields.get(name) ?? '', 1) ?? [0];
    return value! >= least && value! <= most ? value! : null;
  };
  const whole = (value: number | null) => (Number.isInteger(value) ? value : null);
  return {
    closed: fields.get('closed') === '1',
    degree: [1, 2, 3, 4, 5].includes(degree) ? degree : defaultSettings.degree,
    clamped: fields.get('clamped') === '1',
    knots: parseNumbers(knots, knots.split(',').length),
    parametrization:
      fields.get('parametrization') === 'uniform' ? 'uniform' : defaultSettings.parametrization,
    samples: whole(within('samples', samplesRange)) ?? defaultSettings.samples,
    tolerance: within('tolerance', toleranceRange),
    marks: whole(within('marks', marksRange)) ?? 0,
    levels: levelsOf(fields.get('levels')) ?? defaultSettings.levels,
  };
}

/** What a text says of levels; null where it says none. */
export function levelsOf(text: string | null): CurveLevels | null {
  if (text === 'auto' || text === 'limit') return text;
  const number = Number(text || NaN);
  return Number.isInteger(number) && number >= 0 && number <= mostLevels ? number : null;
}

function parseCircle(text: string): CircleShape | null {
  const [centerText = '', rimText = '', acrossText = ''] = text.split(';');
  const center = parsePoint(centerText);
  const rim = parseRim(rimText);
  if (!center || !rim) return null;
  const across = parseAcross(acrossText);
  return { center, rim, ...(across && { across }) };
}

function parseRim(text: string): Rim | null {
  const point = parsePoint(text);
  if (point) return point;
  const values = parseNumbers(text, 4);
  if (!values || values[0]! <= 0) return null;
  const [radius, ...direction] = values as [number, number, number, number];
  return { radius, direction };
}

function parseAcross(text: string): Across | null {
  const point = parsePoint(text);
  if (point) return point;
  const [radius] = parseNumbers(text, 1) ?? [0];
  return radius! > 0 ? { radius: radius! } : null;
}

function parseCircleForm(fields: URLSearchParams): CircleForm {
  const type = fields.get('circletype');
  // Links once named no arcs where there were seven: these circles keep nearer to their radius now.
  const arcs = Number(fields.get('arcs'));
  const good = Number.isInteger(arcs) && arcs >= fewestArcs && arcs <= mostArcs;
  return {
    type: type === 'linear' || type === 'exact' ? type : defaultCircleForm.type,
    arcs: good ? arcs : defaultCircleForm.arcs,
  };
}

/** Points of such a surface, with the legs of such points between points that stay neighbours. */
function fittingPoints(points: readonly ControlPoint[], triangles: number): ControlPoint[] {
  const fits = ({ face }: SurfacePoint) => face < triangles;
  const fitting = ({ tangents }: ControlPoint) => {
    const all = [tangents?.before, tangents?.after];
    return all.every((tangent) => !tangent || !('face' in tangent) || fits(tangent));
  };
  // With its handles a point of the pen loses the ends of its legs.
  const stays = (point: ControlPoint) => fits(point) && fitting(point);
  const holds = (i: number) =>
    points[i]!.leg?.every(fits) && stays(points[i]!) && stays(points[i + 1] ?? points[0]!)
      ? points[i]!.leg
      : null;
  return points
    .map((point, i) => withLeg(point, holds(i)))
    .map((point) => (fitting(point) ? point : withTangents(point, undefined)))
    .filter(fits);
}

/** A figure of which every place is on a surface of that many triangles. */
function fittingFigure(figure: Figure, triangles: number): Figure {
  const fits = (place: object) => !('face' in place) || (place as SurfacePoint).face < triangles;
  const { circle, derived } = figure;
  const circleFits = circle && [circle.center, circle.rim, circle.across ?? {}].every(fits);
  return withFittingKnots({
    ...figure,
    points: fittingPoints(figure.points, triangles),
    circle: circleFits ? circle : null,
    ...(derived?.parts && {
      derived: { ...derived, parts: derived.parts.filter(({ point }) => fits(point)) },
    }),
  });
}

/** Objects with what lies on a surface of that many triangles; without those that have nothing there. */
export const fittingObjects = (objects: readonly DrawnObject[], triangles: number) =>
  objects
    .map((object) => ({ ...object, figure: fittingFigure(object.figure, triangles) }))
    .filter(({ figure }) => !isEmpty(figure));

/** A drawing of which every place is on a surface of that many triangles. */
export function fitting(drawing: Drawing, triangles: number): Drawing {
  const { active } = drawing;
  const objects = drawing.objects.map((object) => ({
    ...object,
    figure: fittingFigure(object.figure, triangles),
  }));
  return { objects: objects.filter(({ id, figure }) => id === active || !isEmpty(figure)), active };
}
