/**
 * Fields of links with a single value: their readers, their writers, and the values that a link may
 * have.
 */
import type { CurveLevels } from 'karcher';
import { dashes, defaultStyle, leastOpacity, surfaceWidths, widthRange } from './drawing';
import {
  type CircleType,
  type CurveSettings,
  defaultCircleForm,
  defaultSettings,
  fewestArcs,
  kinds,
  marksRange,
  mostArcs,
  mostLevels,
  samplesRange,
  toleranceRange,
} from './figure';
import { parseNumbers } from './link_numbers';
import { isColor } from './saved_drawing';

export interface Field<Value> {
  /** Reads a text; null if it is no value of the field. */
  read(text: string): Value | null;
  write(value: Value): string;
  /** The value if the link lacks the field. */
  unsaid: Value;
  /** The allowed values (`range`), and the value that replaces any other one, in words. */
  range: string;
  instead: string;
}

/** Fields by their names in a link, in the order of the link. */
type Fields<Values> = { readonly [Name in keyof Values]: Field<Values[Name]> };

/** The values of fields in a link. Defaults replace faulty and missing values. */
export function readFields<Values>(fields: Fields<Values>, link: URLSearchParams): Values {
  const all = Object.entries<Field<unknown>>(fields as Record<string, Field<unknown>>);
  const said = all.map(([name, { read, unsaid }]) => [name, read(link.get(name) ?? '') ?? unsaid]);
  return Object.fromEntries(said) as Values;
}

/** The fields whose values differ from the defaults of a link. */
export function writtenFields<Values>(fields: Fields<Values>, values: Values): string[] {
  const names = Object.keys(fields) as (keyof Values & string)[];
  const said = names.filter((name) => values[name] !== fields[name].unsaid);
  return said.map((name) => `${name}=${fields[name].write(values[name])}`);
}

export const shown = (value: number) => (value >= 1 ? value.toLocaleString('en') : `${value}`);

/** A number within a range; with `whole`, an integer. */
export const within = <Unsaid>(
  { least, most }: { least: number; most: number },
  unsaid: Unsaid,
  instead: string,
  whole = false,
): Field<number | Unsaid> => ({
  read(text) {
    const value = text.trim() === '' ? Number.NaN : Number(text);
    return value >= least && value <= most && (!whole || Number.isInteger(value)) ? value : null;
  },
  range: `${whole ? 'a whole number ' : ''}from ${shown(least)} to ${shown(most)}`,
  ...{ write: String, unsaid, instead },
});

export const oneOf = <Name extends string, Unsaid = Name>(
  names: readonly Name[],
  unsaid: Unsaid,
  instead = `${unsaid}`,
): Field<Name | Unsaid> => ({
  read: (text) => names.find((name) => name === text) ?? null,
  range: `one of ${names.join(', ')}`,
  ...{ write: String, unsaid, instead },
});

const flag: Field<boolean> = {
  read: (text) => (text === '1' ? true : text === '0' ? false : null),
  write: (value) => (value ? '1' : '0'),
  ...{ unsaid: false, range: 'one of 0, 1', instead: '0' },
};

const color = (instead: string): Field<string | null> => ({
  read: (text) => (isColor(`#${text}`) ? `#${text}` : null),
  write: (value) => value!.slice(1),
  ...{ unsaid: null, range: 'six hexadecimal digits in lower case, as d9560b', instead },
});

const knots: Field<readonly number[] | null> = {
  read: (text) => parseNumbers(text, text.split(',').length),
  ...{ write: String, unsaid: null, range: 'a list of numbers', instead: 'even ones' },
};

const { degree, parametrization, samples, marks, levels: unsaidLevels } = defaultSettings;
const wholeLevels = within({ least: 0, most: mostLevels }, unsaidLevels, '', true);
const levels: Field<CurveLevels> = {
  ...wholeLevels,
  read: (text) => (text === 'auto' || text === 'limit' ? text : wholeLevels.read(text)),
  ...{ range: `auto, limit or from 0 to ${mostLevels}`, instead: `${unsaidLevels}` },
};

export const settingFields: Fields<Omit<CurveSettings, 'leastLevels' | 'draft'>> = {
  closed: flag,
  degree: within({ least: 1, most: 5 }, degree, `${degree}`, true),
  ...{ clamped: flag, knots },
  parametrization: oneOf(['centripetal', 'uniform'], parametrization),
  samples: within(samplesRange, samples, `${samples}`, true),
  tolerance: within(toleranceRange, null, 'no tolerance'),
  marks: within(marksRange, marks, 'no marks', true),
  levels,
};

const { type, arcs } = defaultCircleForm;
const arcsRange = { least: fewestArcs, most: mostArcs };
export const circleFields = {
  circletype: oneOf<CircleType>(['arcs', 'linear', 'exact'], type),
  // Older links omitted the number of arcs if it was seven, the default of that time. Their circles
  // now keep nearer to their radius.
  arcs: within(arcsRange, arcs, 'as many as keep to the radius', true),
};

export const kindFields = {
  kind: oneOf(kinds, 'bspline' as const),
  inside: oneOf(['left', 'right'], null, 'the smaller side'),
  rule: oneOf(['nonZero'], null, 'the even-odd rule'),
};

/**
 * The look of an object. The value of `band` is a width in the surface's unit, and the value of a
 * pattern is its spacing.
 */
export const lookFields = {
  color: color('the default color'),
  band: within(surfaceWidths, null, 'a width in pixels'),
  width: within(widthRange, defaultStyle.width, 'the usual one'),
  dash: oneOf(dashes, defaultStyle.dash),
  opacity: within({ least: leastOpacity, most: 1 }, 1, 'an opaque line'),
  fill: within({ least: 0, most: 1 }, 0, 'no fill'),
  fillcolor: color("the line's color"),
  hatched: within(surfaceWidths, null, 'a solid fill'),
  striped: within(surfaceWidths, null, 'a solid fill'),
};
