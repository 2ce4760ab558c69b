import type { CentersOfMass, CentersOptions, PointLike, StartOptions } from '../types.js';
import type { Arguments } from './arguments.js';
import type { Command, Result } from './command.js';
import { fieldOptions, pointsOption } from './options.js';
import { triple, triples } from './output.js';

const ofMeansAlone = [
  'rows',
  'uniqueness',
  'certificate',
  'paths',
  'method',
  'solver',
  'rings',
  'star',
];

const weightsFor = (points: readonly PointLike[], args: Arguments) =>
  args.given('weights') ? args.numbers('weights') : points.map(() => 1 / points.length);

/** The weights divided by their sum, if the arguments say so. */
function dividedWeights(weights: number[], args: Arguments): number[] {
  const sum = weights.reduce((total, weight) => total + weight, 0);
  // The call itself refuses weights whose sum is not positive.
  return args.given('normalize') && sum > 0 ? weights.map((weight) => weight / sum) : weights;
}

async function robustMean(args: Arguments, kind: string, start: StartOptions): Promise<Result> {
  if (args.given('median')) args.refuse(['huber-mean'], 'with --median');
  args.refuse(ofMeansAlone, `with --${kind}`);
  const { huberMean, median } = await import('../statistics/index.js');
  const threshold = kind === 'huber-mean' ? args.number('huber-mean') : 0;
  const points = await args.points();
  const weights = dividedWeights(weightsFor(points, args), args);
  const mesh = await args.mesh();
  return {
    json: await (kind === 'median'
      ? median(mesh, points, weights, start)
      : huberMean(mesh, points, weights, { threshold, ...start })),
  };
}

/** The centers, one for each row of weights. */
async function meansOfRows(args: Arguments, options: CentersOptions): Promise<Result> {
  args.refuse(['uniqueness', 'certificate', 'paths'], 'with --rows');
  const rows = await args.rows('rows');
  const points = await args.points();
  const mesh = await args.mesh();
  const means = mesh.centersOfMass(points, rows, { ...options, check: args.given('check') });
  return { json: { means: meanRecords(means) } };
}

/** Centers as objects, one after the other. */
function* meanRecords({ count, face, bary, position, status, energy }: CentersOfMass) {
  for (let i = 0; i < count; i++) {
    yield {
      point: { face: face[i]!, bary: triple(bary, i) },
      position: triple(position, i),
      status: status[i]!,
      energy: energy[i]!,
    };
  }
}

export const mean: Command = {
  name: 'mean',
  call: "mesh.centerOfMass(points, weights, options); with --rows mesh.centersOfMass; median and huberMean of 'karcher/statistics'",
  summary: 'the Riemannian center of mass of weighted points',
  output:
    '{point: {face, bary: [b0, b1, b2]}, position: [x, y, z], status, iterations, energy, uniqueness: certain|likely|notUnique|notLooked, otherMinima: notLooked|[{point, position, energy}, …], certificate: {energy, residual} with --certificate; with --median and --huber-mean {point, position, value, steps, converged}; with --rows {means: [{point, position, status, energy}, …]}; paths: [{length, polyline: [[x, y, z], …]}, …] with --paths}',
  options: [
    pointsOption,
    {
      name: 'weights',
      value: 'w1,w2,…',
      help: 'a weight for each point; they must sum to 1 within 1e-9',
      default: '1 / n each',
    },
    {
      name: 'rows',
      value: 'FILE',
      help: 'instead of --weights, a line of weights for each of many means of the same points, which together take much less time',
    },
    {
      name: 'check',
      help: 'with --rows: also check whether each center is a minimum of the exact energy',
    },
    {
      name: 'start',
      value: 'POINT',
      help: 'the point where the search starts',
      default: 'an average of averages, then points near which the energy may be lower',
    },
    { name: 'normalize', help: 'divide the weights by their sum' },
    { name: 'uniqueness', help: 'search other minima on the whole surface' },
    {
      name: 'certificate',
      help: 'also the exact energy and residual of the center, which take as long as one exact field',
    },
    { name: 'median', help: 'instead the geometric median, which minimizes the sum of distances' },
    {
      name: 'huber-mean',
      value: 'T',
      help: 'instead Huber’s mean, by squares of distances up to T and distances beyond',
    },
    { name: 'paths', help: 'also the shortest paths from the center to the points' },
    ...fieldOptions,
  ],
  async run(args) {
    if (args.given('weights')) args.refuse(['rows'], 'with --weights');
    if (!args.given('rows')) args.refuse(['check'], 'without --rows');
    const field = args.field();
    const start = args.whereGiven(['start'], (name) => args.point(name));
    const robust = ['median', 'huber-mean'].find((name) => args.given(name));
    if (robust) return robustMean(args, robust, start);
    const options = { ...field, ...start, normalize: args.given('normalize') };
    if (args.given('rows')) return meansOfRows(args, options);
    const uniqueness = args.given('uniqueness');
    const certificate = args.given('certificate');
    const points = await args.points();
    const weights = weightsFor(points, args);
    const mesh = await args.mesh();
    const center = mesh.centerOfMass(points, weights, { ...options, uniqueness, certificate });
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
