import type { Curve } from '../curve.js';
import { pathParameters } from '../formats/index.js';
import { load } from '../load.js';
import type { Mesh } from '../mesh.js';
import type { Arguments } from './arguments.js';
import type { Command } from './command.js';
import { curveOptions, readCurve } from './curve_arguments.js';
import { drawnOptions, fieldOptions } from './options.js';
import { pointRecords, sampleRecords, triples } from './output.js';
import { samplingOf, samplingOptions } from './sampling.js';

export const trace: Command = {
  name: 'trace',
  call: 'mesh.curve(options), and calls of that curve',
  summary: 'a spline with control points',
  output:
    '{levels, samples: [{segment, t, face, bary, position, converged, status}, …], bridged: [{segment, t0, t1, reason}, …], polyline: [[x, y, z], …], length, ms: {prepare, polygon, fields, trace, bridge, join}, at: [{parameter, point: {face, bary}, position, status, tangent: {inFace: changes of bary, inSpace}, length: from the start}, …] with --at, nearest: {parameter, point, position, status, distance} with --nearest, equallySpaced: [{parameter, point, position}, …] with --equally-spaced}',
  options: [
    ...curveOptions,
    ...samplingOptions,
    {
      name: 'at',
      value: 't1,t2,…',
      help: 'points of the curve at these parameters, which run from 0 to the number of segments',
    },
    {
      name: 'nearest',
      value: 'PLACE',
      help: "the curve's nearest point in space to a point, or to a place 'x,y,z'",
    },
    {
      name: 'equally-spaced',
      value: 'N',
      help: 'N points with the same length of curve between them',
    },
    ...fieldOptions,
    ...drawnOptions,
  ],
  async run(args) {
    const sampling = samplingOf(args);
    const field = args.field();
    const format = args.choice('format');
    if (format !== 'json') {
      args.refuse(['at', 'nearest', 'equally-spaced'], `with --format ${format}`);
    }
    const measures = measuresOf(args);
    const record = await readCurve(args);
    const read = await args.meshFile();
    const karcher = await load();

    const start = performance.now();
    const { mesh } = await read(karcher);
    await mesh.prepare(field);
    const prepare = performance.now() - start;
    const curve = mesh.curve({ ...record, ...sampling, ...field });
    const polyline = curve.polyline({ bits: 64 });
    return {
      json: {
        levels: curve.levels,
        samples: sampleRecords(curve.samples()),
        bridged: curve.bridged(),
        polyline: triples(polyline),
        length: curve.length,
        ms: { prepare, ...curve.times() },
        ...measures(mesh, curve),
      },
      mesh,
      curves: () => {
        const path = curve.path();
        return [{ path, parameters: pathParameters(path, curve.samples()) }];
      },
    };
  },
};

/**
 * Checks the options of the measures before the curve is traced. The returned function computes the
 * measures of the traced curve.
 */
function measuresOf(args: Arguments): (mesh: Mesh, curve: Curve) => object {
  const { at } = args.whereGiven(['at'], (name) => args.numbers(name));
  const { nearest } = args.whereGiven(['nearest'], (name) => args.place(name));
  const spaced = args.given('equally-spaced') ? args.integer('equally-spaced') : undefined;
  return (mesh, curve) => ({
    at: at?.map((parameter) => {
      const { inFace, inSpace, ...point } = curve.tangentAt(parameter);
      return { ...point, tangent: { inFace, inSpace }, length: curve.lengthAt(parameter) };
    }),
    nearest: nearest && curve.nearest(Array.isArray(nearest) ? nearest : mesh.position(nearest)),
    equallySpaced: spaced === undefined ? undefined : pointRecords(curve.equallySpaced(spaced)),
  });
}
