import { namesOf } from '../check.js';
import type { Curve } from '../curve.js';
import type { CurveKind, CurveOptions, Parametrization } from '../types.js';
import type { Arguments } from './arguments.js';
import { curvesOfDrawing, figuresOf } from './drawing.js';
import { UsageError } from './errors.js';
import { type Option, pointsOption } from './options.js';
import { isJson, parseJson, parsePoints } from './syntax.js';

/**
 * Curves in the form of control points and other options: on the command line, in files and in
 * results.
 */

export type CurveRecord = Pick<
  CurveOptions,
  | 'kind'
  | 'closed'
  | 'degree'
  | 'knots'
  | 'weights'
  | 'betas'
  | 'parametrization'
  | 'points'
  | 'legs'
>;

const recordNames = namesOf<CurveRecord>({
  kind: true,
  closed: true,
  degree: true,
  knots: true,
  weights: true,
  betas: true,
  parametrization: true,
  points: true,
  legs: true,
});

export const kinds = 'bspline|bezier|rational|barycentric|catmullrom|polyline';

/** The options that describe a curve, unless a file describes it. */
const partOptions: readonly Option[] = [
  { ...pointsOption, required: false },
  { name: 'kind', value: kinds, help: 'the kind of curve', default: 'bspline' },
  { name: 'closed', help: 'a curve that ends where it starts' },
  { name: 'degree', value: 'P', help: 'the degree of a B-spline, 1 to 5', default: '3' },
  {
    name: 'knots',
    value: 'uniform|clamped|u0,u1,…',
    help: 'of a B-spline: with clamped knots the curve runs from the first to the last point; n points have n + P + 1 knots, on a closed curve n + 1',
    default: 'uniform',
  },
  { name: 'weights', value: 'w0,w1,…', help: 'a weight a point, of the kinds bspline, rational' },
  { name: 'betas', value: 'b0,b1,…', help: 'a beta a point, of the kind barycentric' },
  {
    name: 'parametrization',
    value: 'centripetal|uniform',
    help: 'the parametrization of the kind catmullrom',
    default: 'centripetal',
  },
];

export const curveOptions: readonly Option[] = [
  ...partOptions,
  {
    name: 'curve',
    value: 'FILE',
    help: "instead of these options, a curve as 'karcher edit' prints it, or a drawing of the page",
  },
  { name: 'number', value: 'I', help: 'the number of the curve in a file of several, from 0' },
];

/** The curve that the arguments describe, without checks against a mesh. */
export async function readCurve(args: Arguments): Promise<CurveRecord> {
  const [curve, ...more] = await readCurves(args);
  if (more.length === 0) return curve;
  throw new UsageError(
    `${args.text('curve')} holds ${more.length + 1} curves: --number chooses one, from 0`,
  );
}

/**
 * The curves of the arguments: the curve that they describe, the curve that they choose from a
 * file, or all curves of the file.
 */
export async function readCurves(args: Arguments): Promise<[CurveRecord, ...CurveRecord[]]> {
  if (args.given('curve')) {
    const names = partOptions.map(({ name }) => name);
    args.refuse(names, 'with --curve, which says it all');
    const path = args.text('curve');
    const curves = curvesOfFile(await args.file('curve'), path);
    if (args.given('number')) return [curveOf(curves, args.integer('number'), path)];
    const [, ...others] = curves.keys();
    return [curveOf(curves, 0, path), ...others.map((number) => curveOf(curves, number, path))];
  }
  args.refuse(['number'], 'without --curve');
  const shape = shapeOf(args);
  if (!args.given('points')) {
    throw new UsageError(`${args.command} needs --points FILE or --curve FILE`);
  }
  return [{ ...shape, points: await args.points() }];
}

function shapeOf(args: Arguments): Omit<CurveRecord, 'points'> {
  return {
    kind: args.choice<CurveKind>('kind'),
    closed: args.given('closed'),
    ...args.whereGiven(['degree'], (name) => args.integer(name)),
    ...args.whereGiven(['knots'], () => knotsOf(args)),
    ...args.whereGiven(['weights', 'betas'], (name) => args.numbers(name)),
    ...args.whereGiven(['parametrization'], (name) => args.choice<Parametrization>(name)),
  };
}

/** The name of a rule for knots, or the knots themselves. */
function knotsOf(args: Arguments): 'uniform' | 'clamped' | number[] {
  const text = args.text('knots');
  if (text === 'uniform' || text === 'clamped') return text;
  if (/^[a-z]+$/i.test(text)) {
    throw new UsageError(`--knots must be uniform, clamped or numbers, not '${text}'`);
  }
  return args.numbers('knots');
}

/** The other curve of a join: a file with a curve, or with points for a curve of the same kind. */
export async function readOther(args: Arguments, name: string, like: Curve): Promise<CurveRecord> {
  const text = await args.file(name);
  const path = args.text(name);
  if (isJson(text) && hasCurve(parseJson(text, path))) {
    const curves = curvesOfFile(text, path);
    if (curves.length < 2) return curveOf(curves, 0, path);
    throw new UsageError(`${path} holds ${curves.length} curves: --${name} takes a file of one`);
  }
  const { kind } = like;
  return {
    kind,
    ...(kind === 'bspline' && { degree: like.degree }),
    ...(args.text('knots') === 'clamped' && { knots: 'clamped' as const }),
    ...(kind === 'catmullrom' && { parametrization: like.parametrization }),
    points: parsePoints(text, path),
  };
}

/** Whether a value of JSON is a drawing, a list of curves, or a curve, which has not only points. */
function hasCurve(value: unknown): boolean {
  const names = Object.keys(Object(value));
  return (
    figuresOf(value) !== null ||
    names.includes('curves') ||
    names.some((name) => name !== 'points' && recordNames.includes(name))
  );
}

/**
 * The curves of a file: the output of `karcher edit`, one curve of it, or a drawing of the page.
 */
function curvesOfFile(text: string, path: string): unknown[] {
  const drawn = isJson(text) ? curvesOfDrawing(parseJson(text, path), path) : null;
  if (drawn) return drawn;
  try {
    const content: unknown = JSON.parse(text);
    const { curves = [content] } = content as { curves?: unknown };
    if (Array.isArray(curves)) return curves;
  } catch {
    // A text that is no JSON gets the same error as JSON without a list of curves.
  }
  throw new UsageError(
    `${path} must hold a curve as JSON, as 'karcher edit' prints it, or a drawing`,
  );
}

/** A curve of a file, after a check of its names. The engine checks the values. */
function curveOf(curves: readonly unknown[], number: number, path: string): CurveRecord {
  const curve = curves[number];
  if (typeof curve !== 'object' || curve === null) {
    throw new UsageError(`${path} holds no curve ${number}: it holds ${curves.length}, from 0`);
  }
  const unknown = Object.keys(curve).find((name) => !recordNames.includes(name));
  if (unknown !== undefined) {
    throw new UsageError(
      `'${unknown}' in ${path} is no part of a curve: ${recordNames.join(', ')}`,
    );
  }
  return curve as CurveRecord;
}

/**
 * Data from which a curve can be created again. It omits weights and betas if all are 1, and legs
 * if all are shortest paths.
 */
export function recordOf(curve: Curve): CurveRecord {
  const { kind, closed } = curve;
  const { legs } = curve.value();
  const numbers = (name: 'weights' | 'betas') => {
    const values = curve[name]();
    return values.some((value) => value !== 1) && { [name]: Array.from(values) };
  };
  return {
    kind,
    closed,
    ...(kind === 'bspline' && { degree: curve.degree, knots: Array.from(curve.knots()) }),
    ...((kind === 'bspline' || kind === 'rational') && numbers('weights')),
    ...(kind === 'barycentric' && numbers('betas')),
    ...(kind === 'catmullrom' && { parametrization: curve.parametrization }),
    points: curve.points(),
    ...(legs && { legs }),
  };
}
