/** Reports of the parts of a link that this page cannot show, so that nothing changes silently. */
import { offsetSides } from './derived';
import { mostLegPoints } from './figure';
import {
  circleFields,
  type Field,
  kindFields,
  lookFields,
  oneOf,
  settingFields,
  shown,
  within,
} from './link_fields';
import { isMethod } from './methods';
import { mostObjects } from './saved_drawing';
import { parseView, viewRange } from './view_place';

/**
 * The largest number of points of a link. More would keep the page and its engine busy for minutes.
 */
export const mostLinkPoints = 1000;

/** A field with the properties that its check needs. */
type Rule = Pick<Field<unknown>, 'read' | 'range' | 'instead'>;

const number = (text: string) => (text.trim() === '' ? Number.NaN : Number(text));

/** A rule that checks a text as a whole. */
const all = (allows: (text: string) => boolean, range: string, instead: string): Rule => ({
  read: (text) => allows(text) || null,
  range,
  instead,
});

const areNumbers = (text: string, ...counts: number[]) => {
  const values = text.split(',').map(number);
  return values.every(Number.isFinite) && (counts.length === 0 || counts.includes(values.length));
};

/** A check of parts that begin with a point's index, as `number:rest`; `fits` checks the rest. */
const byPoint = (fits: (rest: string[]) => boolean) => (text: string) =>
  text.split(';').every((part) => {
    const [index = '', ...rest] = part.split(':');
    return /^\d+$/.test(index) && fits(rest);
  });

const isHandle = (text: string) => text === '' || text === 'same' || areNumbers(text, 1, 3, 4);

const notNegative = { least: 0, most: Infinity };

const rules: Readonly<Record<string, Rule>> = {
  ...{ ...settingFields, ...circleFields, ...lookFields, ...kindFields },
  legs: all(
    byPoint(
      (through) =>
        through.length > 0 &&
        through.length <= mostLegPoints &&
        through.every((point) => areNumbers(point, 3)),
    ),
    `numbers of points with up to ${mostLegPoints} places each`,
    'the shortest path',
  ),
  distance: within(notNegative, null, 'no offset'),
  end: within(notNegative, null, 'the same distance'),
  side: oneOf(offsetSides, offsetSides[0]!),
  thickness: within(notNegative, null, 'no thickness'),
  view: all((text) => parseView(text) !== null, viewRange, 'the view there is'),
  tangents: all(
    byPoint((handles) => handles.length <= 2 && handles.every(isHandle)),
    'numbers of anchors with one or two handles each',
    'no handle',
  ),
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
      if (!rule || rule.read(text) !== null) continue;
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
