import { type Command, fieldOptions, formatOption } from './command.js';
import { sampleRecords, triples } from './output.js';

export const circle: Command = {
  name: 'circle',
  summary: 'a geodesic circle of rational quadratic arcs',
  output:
    '{polyline: [[x, y, z], …], samples: [{segment, t, face, bary, position, converged, status}, …], bridged: [{segment, t0, t1, reason}, …], length, notShortest: [arc, …]}',
  options: [
    { name: 'center', value: 'POINT', help: 'the center', required: true },
    { name: 'radius', value: 'R', help: 'the radius, in units of the mesh', required: true },
    { name: 'arcs', value: 'N', help: 'the number of arcs, 3 to 64', default: '7' },
    { name: 'samples', value: 'N', help: 'samples an arc, both ends included', default: '32' },
    ...fieldOptions,
    formatOption,
  ],
  async run(args) {
    const center = args.point('center');
    const radius = args.number('radius');
    const arcs = args.integer('arcs');
    const samples = args.integer('samples');
    const field = args.field();
    const mesh = await args.mesh();
    const result = mesh.circle({ center, radius, arcs, samples, ...field });
    const { length, polyline } = result.path;
    return {
      json: {
        polyline: triples(polyline),
        samples: sampleRecords(result.samples),
        bridged: result.bridged,
        length,
        notShortest: result.notShortest,
      },
      polylines: [polyline],
    };
  },
};
