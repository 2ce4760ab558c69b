import type { Curve } from '../curve.js';
import type { Mesh } from '../mesh.js';
import type { CurveKind, FieldOptions } from '../types.js';
import type { Arguments } from './arguments.js';
import type { Command } from './command.js';
import { curveOptions, kinds, readCurve, readOther, recordOf } from './curve_arguments.js';
import { UsageError } from './errors.js';
import { fieldOptions, type Option } from './options.js';
import { parseNumber, parsePoint } from './syntax.js';

/** The result of an edit: new curves, the number of a new control point, or nothing new. */
interface Outcome {
  curves?: Curve[];
  point?: number;
}

interface Edit extends Option {
  apply(curve: Curve, args: Arguments, mesh: Mesh, field: FieldOptions): Outcome | Promise<Outcome>;
}

/** An edit that changes the curve itself. */
const inPlace = (option: Option, change: (curve: Curve, args: Arguments) => void): Edit => ({
  ...option,
  apply(curve, args) {
    change(curve, args);
    return {};
  },
});

const numberOf = (text: string, what: string) => {
  const number = parseNumber(text, what);
  if (Number.isInteger(number)) return number;
  throw new UsageError(`${what} must be a whole number, not '${text}'`);
};

/** `I=VALUE`: the number of a control point, and a value for it. */
function entry(args: Arguments, name: string): [number, string] {
  const [number, value, ...more] = args.text(name).split('=');
  if (value === undefined || more.length > 0) {
    throw new UsageError(`--${name} must be a point's number and a value, 'I=…'`);
  }
  return [numberOf(number!, `the number in --${name}`), value];
}

const edits: readonly Edit[] = [
  {
    name: 'insert-on-curve',
    value: 'T',
    help: 'inserts a control point on the curve, at a parameter',
    apply: (curve, args) => ({ point: curve.insertOnCurve(args.number('insert-on-curve')) }),
  },
  {
    name: 'split',
    value: 'T',
    help: 'splits the curve at a parameter; a closed curve is opened there',
    apply: (curve, args) => ({ curves: curve.split(args.number('split')) }),
  },
  {
    name: 'join',
    value: 'FILE',
    help: 'joins the curve and another, from a file as for --curve, or of points',
    async apply(curve, args, mesh, field) {
      const other = mesh.curve({ ...(await readOther(args, 'join', curve)), ...field });
      return { curves: [curve.join(other)] };
    },
  },
  inPlace(
    { name: 'move-point', value: 'I=POINT', help: 'moves control point I' },
    (curve, args) => {
      const [i, point] = entry(args, 'move-point');
      curve.movePoint(i, parsePoint(point, 'the point of --move-point'));
    },
  ),
  inPlace(
    {
      name: 'insert-point',
      value: 'I=POINT',
      help: 'inserts a control point, which gets the number I',
    },
    (curve, args) => {
      const [i, point] = entry(args, 'insert-point');
      curve.insertPoint(i, parsePoint(point, 'the point of --insert-point'));
    },
  ),
  inPlace({ name: 'remove-point', value: 'I', help: 'removes control point I' }, (curve, args) =>
    curve.removePoint(args.integer('remove-point')),
  ),
  inPlace(
    {
      name: 'move-point-in-order',
      value: 'I=J',
      help: 'moves control point I to the number J',
    },
    (curve, args) => {
      const [from, to] = entry(args, 'move-point-in-order');
      curve.movePointInOrder(from, numberOf(to, 'the new number in --move-point-in-order'));
    },
  ),
  inPlace(
    { name: 'set-weight', value: 'I=W', help: 'sets the weight of point I' },
    (curve, args) => {
      const [i, weight] = entry(args, 'set-weight');
      curve.setWeight(i, parseNumber(weight, 'the weight in --set-weight'));
    },
  ),
  inPlace({ name: 'set-beta', value: 'I=B', help: 'sets the beta of point I' }, (curve, args) => {
    const [i, beta] = entry(args, 'set-beta');
    curve.setBeta(i, parseNumber(beta, 'the beta in --set-beta'));
  }),
  inPlace({ name: 'reverse', help: 'reverses the curve' }, (curve) => curve.reverse()),
  inPlace(
    { name: 'set-closed', value: 'true|false', help: 'closes the curve, or opens it' },
    (curve, args) => curve.setClosed(args.choice('set-closed') === 'true'),
  ),
  inPlace({ name: 'set-kind', value: kinds, help: 'changes the kind' }, (curve, args) =>
    curve.setKind(args.choice<CurveKind>('set-kind')),
  ),
];

export const edit: Command = {
  name: 'edit',
  call: 'mesh.curve(options), and the method of the same name, such as insertOnCurve for --insert-on-curve',
  summary: 'the curve after an edit of its control points',
  output:
    "{curves: [{kind, closed, degree, knots, weights, betas, parametrization, points: [{face, bary: [b0, b1, b2]}, …], legs: [[{face, bary}, …], null, …]}, …], point: the new point's number with --insert-on-curve}; a curve has the values that its kind uses, weights and betas unless all are 1, and legs unless all are shortest paths; other legs have points on their way. --curve reads such a file, here and in trace",
  options: [...edits.map(({ apply: _, ...option }) => option), ...curveOptions, ...fieldOptions],
  async run(args) {
    const [chosen, second] = edits.filter(({ name }) => args.given(name));
    if (chosen === undefined || second !== undefined) {
      const names = edits.map(({ name }) => `--${name}`).join(', ');
      throw new UsageError(`edit takes one of ${names}${second ? ', not two' : ''}`);
    }
    const field = args.field();
    const record = await readCurve(args);
    const mesh = await args.mesh();
    const curve = mesh.curve({ ...record, ...field });
    const { curves = [curve], point } = await chosen.apply(curve, args, mesh, field);
    return { json: { curves: curves.map(recordOf), point } };
  },
};
