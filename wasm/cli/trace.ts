import { load } from '../load.js';
import type { CurveKind } from '../types.js';
import { type Command, fieldOptions, formatOption, pointsOption } from './command.js';
import { sampleRecords, triples } from './output.js';

export const trace: Command = {
  name: 'trace',
  summary: 'a spline with control points',
  output:
    '{samples: [{segment, t, face, bary, position, converged, status}, …], bridged: [{segment, t0, t1, reason}, …], polyline: [[x, y, z], …], length, ms: {prepare, fields, trace, join}}',
  options: [
    pointsOption,
    { name: 'kind', value: 'bspline|bezier', help: 'the kind of curve', default: 'bspline' },
    {
      name: 'samples',
      value: 'N',
      help: 'samples a segment, at t = i / (N - 1)',
      default: '128',
    },
    ...fieldOptions,
    formatOption,
  ],
  async run(args) {
    const kind = args.choice<CurveKind>('kind');
    const samples = args.integer('samples');
    const field = args.field();
    const points = await args.points();
    const bytes = await args.meshBytes();
    const karcher = await load();

    const start = performance.now();
    const mesh = karcher.meshFromObj(bytes);
    await mesh.prepare(field);
    const prepare = performance.now() - start;
    const curve = mesh.curve({ kind, points, samples, ...field });
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
