import { type Command, fieldOptions, pointsOption } from './command.js';
import { triples } from './output.js';

export const mean: Command = {
  name: 'mean',
  summary: 'the Riemannian center of mass of weighted points',
  output:
    '{point: {face, bary: [b0, b1, b2]}, position: [x, y, z], status, iterations, energy, uniqueness: certain|likely|notUnique|notLooked, otherMinima: notLooked|[{point, position, energy}, …], certificate: {energy, residual} with --certificate, paths: [{length, polyline: [[x, y, z], …]}, …] with --paths}',
  options: [
    pointsOption,
    {
      name: 'weights',
      value: 'w1,w2,…',
      help: 'a weight for each point; they must sum to 1 within 1e-9',
      required: true,
    },
    { name: 'normalize', help: 'divide the weights by their sum instead' },
    { name: 'uniqueness', help: 'look for other minima all over the surface' },
    {
      name: 'certificate',
      help: 'the exact energy and residual of the center, too: as long as one exact field',
    },
    { name: 'paths', help: 'the shortest paths from the center to the points, too' },
    ...fieldOptions,
  ],
  async run(args) {
    const weights = args.numbers('weights');
    const field = args.field();
    const points = await args.points();
    const mesh = await args.mesh();
    const center = mesh.centerOfMass(points, weights, {
      ...field,
      normalize: args.given('normalize'),
      uniqueness: args.given('uniqueness'),
      certificate: args.given('certificate'),
    });
    if (!args.given('paths')) return { json: center };
    const paths = points.map((point) => mesh.shortestPath(center.point, point));
    return {
      json: {
        ...center,
        paths: paths.map((one) => ({
          length: one.length,
          polyline: triples(one.polyline({ bits: 64 })),
        })),
      },
    };
  },
};
