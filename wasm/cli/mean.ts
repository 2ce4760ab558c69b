import { type Command, fieldOptions, pointsOption } from './command.js';

export const mean: Command = {
  name: 'mean',
  summary: 'the Riemannian center of mass of weighted points',
  output: '{point: {face, bary: [b0, b1, b2]}, position: [x, y, z], status, iterations, energy}',
  options: [
    pointsOption,
    {
      name: 'weights',
      value: 'w1,w2,…',
      help: 'a weight for each point; they must sum to 1 within 1e-9',
      required: true,
    },
    { name: 'normalize', help: 'divide the weights by their sum instead' },
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
    });
    return { json: center };
  },
};
