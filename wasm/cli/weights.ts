import type { Command } from './command.js';
import { fieldOptions, pointsOption } from './options.js';

export const weights: Command = {
  name: 'weights',
  call: 'mesh.weightsOf(point, points, options)',
  summary: 'weights of points for which a given point is their center of mass',
  output: '{weights: [w1, w2, …], isMinimum}',
  options: [
    { name: 'point', value: 'POINT', help: 'the desired center', required: true },
    pointsOption,
    {
      name: 'weights',
      value: 'w1,w2,…',
      help: 'the weights that are changed as little as possible; by default equal ones',
    },
    { name: 'non-negative', help: 'allow no weight below 0' },
    ...fieldOptions,
  ],
  async run(args) {
    const point = args.point('point');
    const given = args.whereGiven(['weights'], (name) => args.numbers(name));
    const field = args.field();
    const points = await args.points();
    const mesh = await args.mesh();
    const nonNegative = args.given('non-negative');
    const found = mesh.weightsOf(point, points, { ...field, ...given, nonNegative });
    return { json: { weights: Array.from(found.weights), isMinimum: found.isMinimum } };
  },
};
