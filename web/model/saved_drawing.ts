/**
 * A drawing as JSON, and its check. The check throws a sentence unless a value is a correct drawing
 * in every part and of bounded size.
 */
import type { SurfacePoint } from 'karcher';
import {
  cornerShapes,
  type Derived,
  isDerived,
  mostParts,
  offsetSides,
  type PartChoice,
  plainOffset,
} from './derived';
import {
  type Dash,
  type Drawing,
  type DrawnObject,
  dashes,
  type FillPattern,
  type FillStyle,
  fillPatterns,
  type LineStyle,
  leastOpacity,
  surfaceWidths,
  widthRange,
} from './drawing';
import type { Tangent, Tangents } from './figure';
import {
  type Across,
  type CircleForm,
  type CircleShape,
  type ControlPoint,
  type CurveSettings,
  type Figure,
  fewestArcs,
  isEmpty,
  type Kind,
  kinds,
  knotsFit,
  marksRange,
  mostArcs,
  mostLegPoints,
  mostLevels,
  type Origin,
  type Rim,
  samplesRange,
  toleranceRange,
  type Vector,
} from './figure';
import { longestName } from './names';

const drawingFormat = 'karcher-drawing';
export const drawingVersion = 1;

/** The limits of a drawing. */
export const mostObjects = 2000;
export const mostPoints = 10_000;

export const savedDrawing = ({ active, objects }: Drawing) => ({
  format: drawingFormat,
  version: drawingVersion,
  active,
  objects,
});

/** The sentence about the first limit that a drawing exceeds; null if it exceeds none. */
export function excessOf({ objects }: Drawing): string | null {
  if (objects.length > mostObjects) return `A drawing may have up to ${mostObjects} objects.`;
  const over = objects.some(({ figure }) => figure.points.length > mostPoints);
  return over ? `A curve may have up to ${mostPoints} points.` : null;
}

/** The drawing in a value of JSON. Throws a sentence about the first fault. */
export function readDrawing(value: unknown): Drawing {
  const { format, version, active, objects } = record(value, 'the drawing');
  if (format !== drawingFormat) throw new Error(`the format is not '${drawingFormat}'`);
  if (version !== drawingVersion) {
    throw new Error(
      `the drawing has version ${shown(version)}; this page reads version ${drawingVersion}`,
    );
  }
  const read = list(objects, 'the objects', mostObjects).map((object, i) =>
    readObject(object, `object ${i + 1}`),
  );
  const ids = new Set(read.map(({ id }) => id));
  if (ids.size < read.length) throw new Error('two objects have the same id');
  if (typeof active !== 'number' || !ids.has(active))
    throw new Error('no object is the active one');
  if (read.some(({ id, figure }) => id !== active && isEmpty(figure))) {
    throw new Error('an object that is not the active one is empty');
  }
  return { objects: read, active };
}

/** Reads objects that were copied here or in another tab. */
export function readObjects(value: unknown): DrawnObject[] {
  return list(value, 'the objects', mostObjects).map((object, i) =>
    readObject(object, `object ${i + 1}`),
  );
}

function readObject(value: unknown, what: string): DrawnObject {
  const { id, name, visible, locked, group, figure, ...style } = record(value, what);
  return {
    id: whole(id, 1, Number.MAX_SAFE_INTEGER, `the id of ${what}`),
    name: text(name, `the name of ${what}`),
    visible: flag(visible, `'visible' of ${what}`),
    locked: flag(locked, `'locked' of ${what}`),
    ...readStyle(style, what),
    group: group === null ? null : text(group, `the group of ${what}`),
    figure: readFigure(figure, what),
  };
}

function readStyle(
  {
    color,
    width,
    onSurface = false,
    dash,
    opacity = 1,
    fill = 0,
    fillColor = null,
    pattern = 'solid',
    spacing = null,
  }: Partial<Record<keyof (LineStyle & FillStyle), unknown>>,
  what: string,
) {
  if (color !== null && !isColor(color))
    throw new Error(`the color of ${what} is ${shown(color)}, which is not a color`);
  if (fillColor !== null && !isColor(fillColor))
    throw new Error(`the fill of ${what} is ${shown(fillColor)}, which is not a color`);
  const ownPattern = oneOf<FillPattern>(pattern, fillPatterns, `the pattern of ${what}`);
  const ownSpacing =
    ownPattern === 'solid' && spacing === null
      ? null
      : number(spacing, surfaceWidths.least, surfaceWidths.most, `the spacing of ${what}`);
  const isOn = flag(onSurface, `'onSurface' of ${what}`);
  const { least, most } = isOn ? surfaceWidths : widthRange;
  return {
    color,
    width: number(width, least, most, `the width of ${what}`),
    onSurface: isOn,
    dash: oneOf<Dash>(dash, dashes, `the dash of ${what}`),
    opacity: number(opacity, leastOpacity, 1, `the opacity of ${what}`),
    fill: number(fill, 0, 1, `the fill of ${what}`),
    fillColor,
    pattern: ownPattern,
    // A solid fill has no spacing, so that equal drawings have equal texts.
    spacing: ownPattern === 'solid' ? null : ownSpacing,
  };
}

export const isColor = (value: unknown): value is string =>
  typeof value === 'string' && /^#[0-9a-f]{6}$/.test(value);

function readFigure(value: unknown, what: string): Figure {
  const { kind, settings, points, circle, circleForm, inside, rule, derived } = record(
    value,
    `the figure of ${what}`,
  );
  const own = oneOf(kind, kinds, `the kind of ${what}`);
  const figure: Figure = {
    kind: own,
    settings: readSettings(settings, what),
    points: list(points, `the points of ${what}`, mostPoints).map((point, i) =>
      readControlPoint(point, `point ${i + 1} of ${what}`),
    ),
    circle: circle === null ? null : readCircle(circle, what),
    circleForm: readCircleForm(circleForm, what),
    ...(inside !== undefined && {
      inside: oneOf(inside, ['left', 'right'], `what is inside ${what}`),
    }),
    ...(rule !== undefined && {
      rule: oneOf(rule, ['nonZero'], `the rule by which ${what} encloses`),
    }),
    ...(isDerived(own) && { derived: readDerived(derived, own, what) }),
  };
  if (!knotsFit(figure)) throw new Error(`the knots of ${what} are not as many as its points take`);
  return figure;
}

function readDerived(value: unknown, kind: Kind, of: string): Derived {
  const { sources, offset, parts = [], thickness = 0 } = record(value, `what ${of} is made of`);
  const told = {
    sources: list(sources, `the objects that ${of} is made of`, mostObjects).map((id) =>
      whole(id, 1, Number.MAX_SAFE_INTEGER, `an object that ${of} is made of`),
    ),
  };
  if (kind === 'offset') {
    const { distance, end, side, corners = 'round' } = record(offset, `the offset of ${of}`);
    return {
      ...told,
      offset: plainOffset({
        distance: number(distance, Number.MIN_VALUE, Infinity, `the distance of ${of}`),
        ...(end !== undefined && {
          end: number(end, 0, Infinity, `the distance at the end of ${of}`),
        }),
        side: oneOf(side, offsetSides, `the side of ${of}`),
        corners: oneOf(corners, cornerShapes, `the corners of ${of}`),
      }),
    };
  }
  if (kind !== 'cut') return told;
  return {
    ...told,
    parts: list(parts, `the parts of ${of}`, mostParts).map((part): PartChoice => {
      const { point, state } = record(part, `a part of ${of}`);
      return {
        point: readPoint(point, `the point of a part of ${of}`),
        state: oneOf(state, ['hidden', 'deleted'], `the state of a part of ${of}`),
      };
    }),
    thickness: number(thickness, 0, Infinity, `the thickness of ${of}`),
  };
}

function readSettings(value: unknown, of: string): CurveSettings {
  const what = `the settings of ${of}`;
  const { closed, degree, clamped, knots, parametrization, samples, tolerance, marks, levels } =
    record(value, what);
  const within = (one: unknown, { least, most }: { least: number; most: number }, name: string) =>
    number(one, least, most, `${name} in ${what}`);
  return {
    closed: flag(closed, `'closed' in ${what}`),
    degree: whole(degree, 1, 5, `the degree in ${what}`),
    clamped: flag(clamped, `'clamped' in ${what}`),
    knots:
      knots === null
        ? null
        : list(knots, `the knots in ${what}`, mostPoints + 6).map((knot) =>
            number(knot, -Infinity, Infinity, `a knot in ${what}`),
          ),
    parametrization: oneOf(parametrization, ['centripetal', 'uniform'], `the spacing in ${what}`),
    samples: whole(samples, samplesRange.least, samplesRange.most, `the samples in ${what}`),
    tolerance: tolerance === null ? null : within(tolerance, toleranceRange, 'the tolerance'),
    marks:
      marks === 0 ? 0 : whole(marks, marksRange.least, marksRange.most, `the marks in ${what}`),
    levels:
      levels === 'auto' || levels === 'limit'
        ? levels
        : whole(levels, 0, mostLevels, `the levels in ${what}`),
  };
}

function readControlPoint(value: unknown, what: string): ControlPoint {
  const { weight, beta, leg, tangents, origin } = record(value, what);
  const positive = (one: unknown, name: string) => number(one, 1e-12, 1e12, `${name} of ${what}`);
  const through = (leg === undefined ? [] : list(leg, `the leg of ${what}`, mostLegPoints)).map(
    (point) => readPoint(point, `a point of the leg of ${what}`),
  );
  return {
    ...readPoint(value, what),
    ...(weight !== undefined && { weight: positive(weight, 'the weight') }),
    ...(beta !== undefined && { beta: positive(beta, 'the beta') }),
    // A leg without points is the shortest one.
    ...(through.length > 0 && { leg: through }),
    ...(tangents !== undefined && { tangents: readTangents(tangents, what) }),
    ...(origin !== undefined && { origin: readOrigin(origin, what) }),
  };
}

function readOrigin(value: unknown, what: string): Origin {
  const { of, from, to } = record(value, `the origin of ${what}`);
  return {
    of: text(of, `the name of the origin of ${what}`),
    from: number(from, 0, 1, `the start of the origin of ${what}`),
    to: number(to, 0, 1, `the end of the origin of ${what}`),
  };
}

function readTangents(value: unknown, what: string): Tangents {
  const { before, after } = record(value, `the handles of ${what}`);
  return {
    ...(before !== undefined && { before: readTangent(before, what) }),
    ...(after !== undefined && { after: readTangent(after, what) }),
  };
}

function readTangent(value: unknown, of: string): Tangent {
  const what = `a handle of ${of}`;
  if (isPoint(value)) return readPoint(value, what);
  const { direction, length: own } = record(value, what);
  if (direction === undefined) return { length: own === null ? null : number(own, 0, 1e300, what) };
  return { direction: readDirection(direction, what), length: number(own, 0, 1e300, what) };
}

function readPoint(value: unknown, what: string): SurfacePoint {
  const { face, bary } = record(value, what);
  const weights = list(bary, `the place of ${what}`, 3).map((weight) =>
    number(weight, 0, 1, `a weight of ${what}`),
  );
  const sum = weights.reduce((total, weight) => total + weight, 0);
  if (weights.length !== 3 || Math.abs(sum - 1) > 1e-6) {
    throw new Error(`the place of ${what} is not three weights of sum 1`);
  }
  return { face: whole(face, 0, 2 ** 31 - 1, `the face of ${what}`), bary: weights as Vector };
}

function readCircle(value: unknown, of: string): CircleShape {
  const what = `the circle of ${of}`;
  const { center, rim, across } = record(value, what);
  return {
    center: readPoint(center, `the center of ${what}`),
    rim: readRim(rim, what),
    ...(across !== undefined && { across: readAcross(across, what) }),
  };
}

const isPoint = (value: unknown) => value !== null && typeof value === 'object' && 'face' in value;

function readRim(value: unknown, what: string): Rim {
  if (isPoint(value)) return readPoint(value, `the rim of ${what}`);
  const { radius, direction } = record(value, `the rim of ${what}`);
  return { radius: length(radius, what), direction: readDirection(direction, what) };
}

function readDirection(value: unknown, what: string): Vector {
  const along = list(value, `the direction of ${what}`, 3).map((one) =>
    number(one, -Infinity, Infinity, `the direction of ${what}`),
  );
  if (along.length !== 3) throw new Error(`the direction of ${what} is not three numbers`);
  return along as Vector;
}

function readAcross(value: unknown, what: string): Across {
  if (isPoint(value)) return readPoint(value, `the radius across of ${what}`);
  return { radius: length(record(value, what).radius, what) };
}

const length = (value: unknown, what: string) =>
  number(value, Number.MIN_VALUE, Infinity, `the radius of ${what}`);

function readCircleForm(value: unknown, of: string): CircleForm {
  const { type, arcs } = record(value, `the circle's form of ${of}`);
  return {
    type: oneOf(type, ['arcs', 'linear', 'exact'], `the circle's type of ${of}`),
    arcs: arcs === 'auto' ? arcs : whole(arcs, fewestArcs, mostArcs, `the arcs of ${of}`),
  };
}

function record(value: unknown, what: string): Record<string, unknown> {
  if (value === null || typeof value !== 'object' || Array.isArray(value)) {
    throw new Error(`${what} is not an object`);
  }
  return value as Record<string, unknown>;
}

function list(value: unknown, what: string, most: number): unknown[] {
  if (!Array.isArray(value)) throw new Error(`${what} must be a list`);
  if (value.length > most) throw new Error(`${what} are more than ${most}`);
  return value;
}

/** A finite number within a range. */
function number(value: unknown, least: number, most: number, what: string): number {
  if (typeof value !== 'number' || !Number.isFinite(value) || value < least || value > most) {
    throw new Error(`${what} is ${shown(value)}`);
  }
  return value;
}

function whole(value: unknown, least: number, most: number, what: string): number {
  if (!Number.isInteger(value)) throw new Error(`${what} is ${shown(value)}`);
  return number(value, least, most, what);
}

function flag(value: unknown, what: string): boolean {
  if (typeof value !== 'boolean') throw new Error(`${what} is neither true nor false`);
  return value;
}

function text(value: unknown, what: string): string {
  // The schema counts characters, of which some are two units of the text.
  if (typeof value !== 'string' || [...value].length > longestName) {
    throw new Error(`${what} must be a text of up to ${longestName} letters`);
  }
  return value;
}

function oneOf<Value>(value: unknown, all: readonly Value[], what: string): Value {
  const found = all.find((one) => one === value);
  if (found === undefined) throw new Error(`${what} is ${shown(value)}`);
  return found;
}

/** A value in a sentence, cut to a readable length. */
function shown(value: unknown): string {
  const text = JSON.stringify(value) ?? 'nothing';
  return text.length > 60 ? `${text.slice(0, 59)}…` : text;
}
