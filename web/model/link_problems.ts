/** What a link says that this page cannot show as it is said: told, and not silently changed. */
import { dashes, widthRange } from './drawing';
import {
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
import { isMethod } from './methods';

/** A link of more points would keep the page and its engine busy for minutes. */
export const mostLinkPoints = 1000;

/** What a field may say, and what is taken in its place. */
interface Rule {
  allows(text: string): boolean;
  /** What it may be: "from 2 to 5,000". */
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

const shown = (value: number) => (value >= 1 ? value.toLocaleString('en') : `${value}`);

const flag = oneOf(['0', '1'], '0');

const rules: Readonly<Record<string, Rule>> = {
  kind: oneOf(kinds, 'bspline'),
  closed: flag,
  clamped: flag,
  degree: within(1, 5, true, `${defaultSettings.degree}`),
  parametrization: oneOf(['centripetal', 'uniform'], defaultSettings.parametrization),
  samples: within(samplesRange.least, samplesRange.most, true, `${defaultSettings.samples}`),
  tolerance: within(toleranceRange.least, toleranceRange.most, false, 'none'),
  marks: within(marksRange.least, marksRange.most, true, 'none'),
  levels: {
    allows: (text) =>
      ['auto', 'limit'].includes(text) || within(0, mostLevels, true, '').allows(text),
    range: `auto, limit or from 0 to ${mostLevels}`,
    instead: `${defaultSettings.levels}`,
  },
  circletype: oneOf(['arcs', 'linear', 'exact'], defaultCircleForm.type),
  arcs: within(fewestArcs, mostArcs, true, `${defaultCircleForm.arcs}`),
  width: within(widthRange.least, widthRange.most, false, 'the usual one'),
  dash: oneOf(dashes, dashes[0]!),
};

const longestShown = 40;
const mostTold = 4;

/** Sentences about what a link's fragment says wrongly, with what is taken in its place. */
export function linkProblems(fragment: string): string[] {
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const method = fields.get('method');
  const problems = new Set<string>();
  if (method && !isMethod(method)) {
    problems.add(`The link's method ${quoted(method)} is not known: the one here is taken.`);
  }
  for (const part of [fragment, ...fields.getAll('other')]) {
    for (const [name, text] of new URLSearchParams(part.replace(/^#/, ''))) {
      const rule = Object.hasOwn(rules, name) ? rules[name]! : null;
      if (!rule || rule.allows(text)) continue;
      const said = text === '' ? 'nothing' : quoted(text);
      problems.add(`The link's ${name} is ${said}, not ${rule.range}: ${rule.instead} is taken.`);
    }
  }
  const told = [...problems];
  const more = told.length - mostTold;
  return more > 0 ? [...told.slice(0, mostTold), `And ${more} more.`] : told;
}

const quoted = (text: string) =>
  `'${text.length > longestShown ? `${text.slice(0, longestShown)}…` : text}'`;
