import type { Arguments } from './arguments.js';
import type { Command, Result } from './command.js';
import { fieldOptions, pointsOption } from './options.js';
import { triples } from './output.js';

const ofMeansAlone = ['uniqueness', 'certificate', 'paths', 'method', 'solver', 'rings', 'star'];

async function robustMean(args: Arguments, kind: string, weights: number[]): Promise<Result> {
  if (args.given('median')) args.refuse(['huber'], 'with --median');
  args.refuse(ofMeansAlone, `with --${kind}`);
  const { huberMean, median } = await import('../statistics/index.js');
  const threshold = kind === 'huber' ? args.number('huber') : 0;
  const points = await args.points();
  const mesh = await args.mesh();
  return {
    json: await (kind === 'median'
      ? median(mesh, points, weights)
      : huberMean(mesh, points, weights, { threshold })),
  };
}

export const mean: Command = {
  name: 'mean',
  summary: 'the Riemannian center of mass of weighted points',
  output:
    '{point: {face, bary: [b0, b1, b2]}, position: [x, y, z], status, iterations, energy, uniqueness: certain|likely|notUnique|notLooked, otherMinima: notLooked|[{point, position, energy}, …], certificate: {energy, residual} with --certificate; with --median and --huber {point, position, value, steps, converged}; paths: [{length, polyline: [[x, y, z], …]}, …] with --paths}',
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
    { name: 'median', help: 'the geometric median instead: it minimizes the sum of distances' },
    {
      name: 'huber',
      value: 'T',
      help: 'Huber’s mean instead, by squares of distances up to T and distances beyond',
    },
    { name: 'paths', help: 'the shortest paths from the center to the points, too' },
    ...fieldOptions,
  ],
  async run(args) {
    const weights = args.numbers('weights');
    const field = args.field();
    const robust = ['median', 'huber'].find((name) => args.given(name));
    if (robust) return robustMean(args, robust, weights);
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
