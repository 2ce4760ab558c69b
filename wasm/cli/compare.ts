import type { MethodOptions } from '../peers/index.js';
import { type Command, pointsOption } from './command.js';
import { UsageError } from './errors.js';

export const compare: Command = {
  name: 'compare',
  summary: 'a curve by each method: times, and how far it is from exact log vectors or paths',
  output:
    '{mesh: {vertices, triangles, meanEdge}, methods: {vectorHeat|affineHeat|weightedAverages|descent|paper|karcher: {ok, reason, prepareMs, traceMs, dragMs, samples, lost, deviation: {median, max}, turningNoise}}}; two points give the shortest path between them, three a quadratic Bezier curve, more a B-spline; deviations, from the exact path or the curve of exact log vectors, are in mean edges, null is what was not measured',
  options: [
    pointsOption,
    { name: 'samples', value: 'N', help: 'samples a segment', default: '128' },
    {
      name: 'landmarks',
      value: 'N',
      help: 'landmarks of the embedding of weighted averages',
      default: '500',
    },
    { name: 'delaunay', help: 'the heat methods on the intrinsic Delaunay triangulation' },
    {
      name: 'budget',
      value: 'SECONDS',
      help: 'a method gives up after so long; 0 for never',
      default: '0',
    },
  ],
  async run(args) {
    const samples = args.integer('samples');
    const landmarks = args.integer('landmarks');
    const budgetMs = 1000 * args.number('budget') || Number.POSITIVE_INFINITY;
    if (budgetMs < 0) throw new UsageError('--budget must be at least 0 seconds');
    const delaunay = args.given('delaunay');
    const points = await args.points();
    const read = await args.meshFile();
    // Only here: the other commands need not wait for a second module.
    const { comparedMethods, loadPeers, runMethod, standardOptions, traceReference } = await import(
      '../peers/index.js'
    );
    const peers = await loadPeers();
    const { mesh } = await read(peers.karcher);
    const plan = peers.plan(points, samples);
    // First, so that wrong points are told before the long work.
    const reference = await traceReference(peers, mesh, plan);
    const methods: Record<string, object> = {};
    for (const name of comparedMethods) {
      const options: MethodOptions = { ...standardOptions(name, plan), landmarks, delaunay };
      const run = await runMethod(peers, mesh, plan, options, reference.samples, {
        budgetMs,
        progress: reporter(name),
      });
      const { curve: _, ...result } = run;
      methods[name] = result;
    }
    const { vertices, triangles, meanEdge } = mesh.info;
    return { json: { mesh: { vertices, triangles, meanEdge }, methods } };
  },
};

/** Tells on standard error how far a method is that takes long. */
function reporter(name: string): (done: number, stage: string) => void {
  const quietMs = 2000;
  let told = performance.now();
  return (done, stage) => {
    const now = performance.now();
    if (now - told < quietMs) return;
    told = now;
    process.stderr.write(`karcher: ${name}: ${stage}, ${Math.round(100 * done)} %\n`);
  };
}
