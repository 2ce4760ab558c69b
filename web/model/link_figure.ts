/** Figures in links: points, legs and handles, settings, circles. */
import type { SurfacePoint } from 'karcher';
import { isDerived } from './derived';
import {
  type Across,
  type CircleShape,
  type ControlPoint,
  type Figure,
  mostLegPoints,
  type Origin,
  type Rim,
  type Tangent,
  type Tangents,
  type Vector,
  withFittingKnots,
  withLeg,
  withParameter,
} from './figure';
import { derivedFields, parseDerived } from './link_derived';
import { circleFields, kindFields, readFields, settingFields, writtenFields } from './link_fields';
import { formatPoint, parseNumbers, parsePoint } from './link_numbers';
import { longestName, shortened } from './names';
import { withOrigin } from './origins';
import { withTangents } from './pen';

/**
 * The fields of a figure. `numberOf` returns the position of a source among all objects, counted
 * from 1, or 0 if the source is gone.
 */
export function figureFields(
  { kind, points, settings, circle, circleForm, inside, rule, derived }: Figure,
  numberOf: (id: number) => number,
): string[] {
  const parts = [`kind=${kind}`, `points=${points.map(formatControlPoint).join(';')}`];
  parts.push(
    ...legsFields(points),
    ...tangentsFields(points),
    ...originsFields(points),
    ...writtenFields(settingFields, settings),
  );
  if (circle) parts.push(`circle=${formatCircle(circle)}`);
  const { type: circletype, arcs } = circleForm;
  parts.push(...writtenFields(circleFields, { circletype, arcs }));
  if (inside) parts.push(`inside=${inside}`);
  if (rule) parts.push(`rule=${rule}`);
  if (isDerived(kind) && derived) parts.push(...derivedFields(derived, numberOf));
  return parts;
}

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

function legsFields(points: readonly ControlPoint[]): string[] {
  const legs = points.map(({ leg }, i) => leg && [i, ...leg.map(formatPoint)].join(':'));
  const told = legs.filter((leg) => leg !== undefined);
  return told.length > 0 ? [`legs=${told.join(';')}`] : [];
}

/**
 * For each anchor with handles: its index and the handles before and after it, each handle in its
 * own form.
 */
function tangentsFields(points: readonly ControlPoint[]): string[] {
  const told = points.flatMap(({ tangents }, i) =>
    tangents ? [`${i}:${formatTangent(tangents.before)}:${formatTangent(tangents.after)}`] : [],
  );
  return told.length > 0 ? [`tangents=${told.join(';')}`] : [];
}

/**
 * The origins of pieces: the names of the objects, encoded once more, and for each piece the index
 * of its point, the index of its object's name, and its ends.
 */
function originsFields(points: readonly ControlPoint[]): string[] {
  const names = [...new Set(points.flatMap(({ origin }) => (origin ? [origin.of] : [])))];
  const told = points.flatMap(({ origin }, i) =>
    origin ? [[i, names.indexOf(origin.of), origin.from, origin.to].join(',')] : [],
  );
  const encoded = names.map((name) => encodeURIComponent(encodeURIComponent(name)));
  return told.length > 0 ? [`origins=${[encoded.join(','), ...told].join(';')}`] : [];
}

/** Origins by the indices of their points. */
function parseOrigins(text: string): Map<number, Origin> {
  const [names = '', ...told] = text.split(';');
  const all = names.split(',').map((name) => shortened(decoded(name), longestName));
  return new Map(
    told.flatMap((one): [number, Origin][] => {
      const [i, name, from, to] = parseNumbers(one, 4) ?? [];
      const isPart = (value: number | undefined) => value !== undefined && value >= 0 && value <= 1;
      const of = all[name ?? -1];
      return of !== undefined && isPart(from) && isPart(to)
        ? [[i!, { of, from: from!, to: to! }]]
        : [];
    }),
  );
}

/** A decoded text; the text itself if it cannot be decoded. */
function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
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

/** Handles by the indices of their anchors. */
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

/** The texts of the points in a figure's fragment. */
export function pointTexts(fragment: string): string[] {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  return (fields.get('points') ?? '').split(';').filter((text) => text !== '');
}

/** The figure in a fragment. */
export function parseFigure(fragment: string): Figure {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const legs = parseLegs(fields.get('legs') ?? '');
  const tangents = parseTangents(fields.get('tangents') ?? '');
  const origins = parseOrigins(fields.get('origins') ?? '');
  const read = pointTexts(fragment).map(parseControlPoint);
  const points = read.map((point, i) => {
    const next = i + 1 < read.length ? read[i + 1] : read[0];
    const leg = next ? legs.get(i) : null;
    const own = point && withTangents(withLeg(point, leg), tangents.get(`${i}`));
    return own && withOrigin(own, origins.get(i));
  });
  const { kind, inside, rule } = readFields(kindFields, fields);
  const { circletype: type, arcs } = readFields(circleFields, fields);
  return withFittingKnots({
    kind,
    settings: readFields(settingFields, fields),
    points: points.filter((point) => point !== null),
    circle: parseCircle(fields.get('circle') ?? ''),
    circleForm: { type, arcs },
    ...(inside && { inside }),
    ...(rule && { rule }),
    ...(isDerived(kind) && { derived: parseDerived(kind, fields) }),
  });
}

/** Legs by the indices of their points. Faulty legs are left out. */
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

function parseControlPoint(text: string): ControlPoint | null {
  const [face, u, v, weight = '1', beta = '1'] = text.split(',');
  const point = parsePoint([face, u, v].join(','));
  const weighted = point && withParameter(point, 'weight', parseParameter(weight));
  return weighted && withParameter(weighted, 'beta', parseParameter(beta));
}

/**
 * A point's weight or beta. For the parts of a cut curve it may exceed the range of the sliders.
 */
function parseParameter(text: string): number {
  const [value] = parseNumbers(text, 1) ?? [1];
  return Math.min(1e12, Math.max(1e-12, value!));
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
