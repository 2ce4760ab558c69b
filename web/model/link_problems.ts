/** Reports of the parts of a link that this page cannot show, so that nothing changes silently. */
import { dashes, leastOpacity, surfaceWidths, widthRange } from './drawing';
import { offsetSides } from './derived';
import {
  defaultCircleForm,
  defaultSettings,
  fewestArcs,
  kinds,
  marksRange,
  mostArcs,
  mostLegPoints,
  mostLevels,
  samplesRange,
  toleranceRange,
} from './figure';
import { isMethod } from './methods';
import { isColor, mostObjects } from './saved_drawing';
import { parseView, viewRange } from './view_place';

/**
 * The largest number of points of a link. More would keep the page and its engine busy for minutes.
 */
export const mostLinkPoints = 1000;

/** The allowed values of a field, and the one that replaces others. */
interface Rule {
  allows(text: string): boolean;
  /** The allowed values in words: "from 2 to 5,000". */
  range: string;
  instead: string;
}

const number = (text: string) => (text.trim() === '' ? Number.NaN : Number(text));

const within = (least: number, most: number, whole: boolean, instead: string): Rule => ({
  allows: (text) => {
    const value = number(text);
    return value >= least && value <= most && (!whole || Number.isInteger(value));
  },
  range: `${whole ? 'a whole number ' : ''}from ${shown(least)} to ${shown(most)}`,
  instead,
});

const oneOf = (names: readonly string[], instead: string): Rule => ({
  allows: (text) => names.includes(text),
  range: `one of ${names.join(', ')}`,
  instead,
});

const areNumbers = (text: string, ...counts: number[]) => {
  const values = text.split(',').map(number);
  return values.every(Number.isFinite) && (counts.length === 0 || counts.includes(values.length));
};

/** Parts that begin with a point's index: `number:rest`, where `fits` checks the rest. */
const byPoint = (fits: (rest: string[]) => boolean) => (text: string) =>
  text.split(';').every((part) => {
    const [index = '', ...rest] = part.split(':');
    return /^\d+$/.test(index) && fits(rest);
  });

const isHandle = (text: string) => text === '' || text === 'same' || areNumbers(text, 1, 3, 4);

const shown = (value: number) => (value >= 1 ? value.toLocaleString('en') : `${value}`);

const flag = oneOf(['0', '1'], '0');

const rules: Readonly<Record<string, Rule>> = {
  kind: oneOf(kinds, 'bspline'),
  closed: flag,
  clamped: flag,
  degree: within(1, 5, true, `${defaultSettings.degree}`),
  parametrization: oneOf(['centripetal', 'uniform'], defaultSettings.parametrization),
  samples: within(samplesRange.least, samplesRange.most, true, `${defaultSettings.samples}`),
  tolerance: within(toleranceRange.least, toleranceRange.most, false, 'no tolerance'),
  marks: within(marksRange.least, marksRange.most, true, 'no marks'),
  levels: {
    allows: (text) =>
      ['auto', 'limit'].includes(text) || within(0, mostLevels, true, '').allows(text),
    range: `auto, limit or from 0 to ${mostLevels}`,
    instead: `${defaultSettings.levels}`,
  },
  circletype: oneOf(['arcs', 'linear', 'exact'], defaultCircleForm.type),
  arcs: within(fewestArcs, mostArcs, true, 'as many as keep to the radius'),
  width: within(widthRange.least, widthRange.most, false, 'the usual one'),
  band: within(surfaceWidths.least, surfaceWidths.most, false, 'a width in pixels'),
  opacity: within(leastOpacity, 1, false, 'an opaque line'),
  dash: oneOf(dashes, dashes[0]!),
  color: {
    allows: (text) => isColor(`#${text}`),
    range: 'six hexadecimal digits in lower case, as d9560b',
    instead: 'the default color',
  },
  fill: within(0, 1, false, 'no fill'),
  hatched: within(surfaceWidths.least, surfaceWidths.most, false, 'a solid fill'),
  striped: within(surfaceWidths.least, surfaceWidths.most, false, 'a solid fill'),
  inside: oneOf(['left', 'right'], 'the smaller side'),
  fillcolor: {
    allows: (text) => isColor(`#${text}`),
    range: 'six hexadecimal digits in lower case, as d9560b',
    instead: "the line's color",
  },
  knots: { allows: (text) => areNumbers(text), range: 'a list of numbers', instead: 'even ones' },
  legs: {
    allows: byPoint(
      (through) =>
        through.length > 0 &&
        through.length <= mostLegPoints &&
        through.every((point) => areNumbers(point, 3)),
    ),
    range: `numbers of points with up to ${mostLegPoints} places each`,
    instead: 'the shortest path',
  },
  distance: within(0, Infinity, false, 'no offset'),
  side: oneOf(offsetSides, offsetSides[0]),
  thickness: within(0, Infinity, false, 'no thickness'),
  view: {
    allows: (text) => parseView(text) !== null,
    range: viewRange,
    instead: 'the view there is',
  },
  tangents: {
    allows: byPoint((handles) => handles.length <= 2 && handles.every(isHandle)),
    range: 'numbers of anchors with one or two handles each',
    instead: 'no handle',
  },
};

const longestShown = 40;
const mostTold = 4;

/** Sentences about the faults of a link's fragment and the values that replace them. */
export function linkProblems(fragment: string): string[] {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const method = fields.get('method');
  const problems = new Set<string>();
  if (method && !isMethod(method)) {
    problems.add(`The link's method ${quoted(method)} is not known; using the one here.`);
  }
  const others = fields.getAll('other');
  if (others.length >= mostObjects) {
    problems.add(
      `The link has ${shown(others.length + 1)} objects; up to ${shown(mostObjects)} are read.`,
    );
  }
  for (const part of [fragment, ...others]) {
    for (const [name, text] of new URLSearchParams(part.replace(/^#/, ''))) {
      const rule = Object.hasOwn(rules, name) ? rules[name]! : null;
      if (!rule || rule.allows(text)) continue;
      const said = text === '' ? 'nothing' : quoted(text);
      problems.add(
        `The link's '${name}' must be ${rule.range}, not ${said}; using ${rule.instead}.`,
      );
    }
  }
  const told = [...problems];
  const more = told.length - mostTold;
  return more > 0 ? [...told.slice(0, mostTold), `And ${more} more.`] : told;
}

const quoted = (text: string) =>
  `'${text.length > longestShown ? `${text.slice(0, longestShown)}…` : text}'`;
