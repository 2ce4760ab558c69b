import { load } from '../load.js';
import type { CurveGeometry, CurveKind, CurveOptions, Parametrization } from '../types.js';
import type { Arguments } from './arguments.js';
import { type Command, fieldOptions, formatOption, pointsOption } from './command.js';
import { UsageError } from './errors.js';
import { sampleRecords, triples } from './output.js';

export const trace: Command = {
  name: 'trace',
  summary: 'a spline with control points',
  output:
    '{samples: [{segment, t, face, bary, position, converged, status}, …], bridged: [{segment, t0, t1, reason}, …], polyline: [[x, y, z], …], length, ms: {prepare, fields, trace, bridge, join}}',
  options: [
    pointsOption,
    {
      name: 'kind',
      value: 'bspline|bezier|rational|barycentric|catmullrom|polyline',
      help: 'the kind of curve',
      default: 'bspline',
    },
    { name: 'closed', help: 'a curve that ends where it starts' },
    { name: 'degree', value: 'P', help: 'of a B-spline, 1 to 5', default: '3' },
    { name: 'clamped', help: 'a B-spline from its first to its last point' },
    {
      name: 'knots',
      value: 'u0,u1,…',
      help: 'of a B-spline of n points: n + P + 1 knots, of a closed one n + 1',
    },
    { name: 'weights', value: 'w0,w1,…', help: 'a weight a point, of the kinds bspline, rational' },
    { name: 'betas', value: 'b0,b1,…', help: 'a beta a point, of the kind barycentric' },
    {
      name: 'parametrization',
      value: 'centripetal|uniform',
      help: 'of the kind catmullrom',
      default: 'centripetal',
    },
    {
      name: 'samples',
      value: 'N|adaptive',
      help: 'samples a segment, at t = i / (N - 1), or as many as the tolerance needs',
      default: '128',
    },
    {
      name: 'tolerance',
      value: 'T',
      help: "of adaptive samples: the curve's distance from the geodesics between them, as a part of the diagonal",
      default: '1e-4',
    },
    {
      name: 'geometry',
      value: 'geodesic|exact',
      help: "what lies between the samples: geodesics, or the curve's own crossings of edges",
      default: 'geodesic',
    },
    ...fieldOptions,
    formatOption,
  ],
  async run(args) {
    const options = curveOptions(args);
    const field = args.field();
    const points = await args.points();
    const bytes = await args.meshBytes();
    const karcher = await load();

    const start = performance.now();
    const mesh = karcher.meshFromObj(bytes);
    await mesh.prepare(field);
    const prepare = performance.now() - start;
    const curve = mesh.curve({ ...options, points, ...field });
    const { length, polyline } = curve.path;
    return {
      json: {
        samples: sampleRecords(curve.samples),
        bridged: curve.bridged,
        polyline: triples(polyline),
        length,
        ms: { prepare, ...curve.times },
      },
      polylines: [polyline],
    };
  },
};

function curveOptions(args: Arguments): Omit<CurveOptions, 'points'> {
  const adaptive = args.given('tolerance') || args.text('samples') === 'adaptive';
  if (args.given('tolerance') && args.given('samples') && args.text('samples') !== 'adaptive') {
    throw new UsageError('trace takes --samples or --tolerance, not both');
  }
  if (args.given('knots') && args.given('clamped')) {
    throw new UsageError('trace takes --knots or --clamped, not both');
  }
  return {
    kind: args.choice<CurveKind>('kind'),
    closed: args.given('closed'),
    ...args.whereGiven(['degree'], (name) => args.integer(name)),
    ...(args.given('clamped') && { knots: 'clamped' as const }),
    ...args.whereGiven(['knots', 'weights', 'betas'], (name) => args.numbers(name)),
    ...args.whereGiven(['parametrization'], (name) => args.choice<Parametrization>(name)),
    geometry: args.choice<CurveGeometry>('geometry'),
    ...(adaptive
      ? { samples: 'adaptive' as const, tolerance: args.number('tolerance') }
      : { samples: args.integer('samples') }),
  };
}
