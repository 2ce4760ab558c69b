import { type Command, pointsOption } from './command.js';

export const compare: Command = {
  name: 'compare',
  summary: 'a curve by each method: times, and how far it is from exact log vectors',
  output:
    '{mesh: {vertices, triangles, meanEdge}, methods: {vectorHeat|affineHeat|weightedAverages|descent|paper|karcher: {ok, reason, prepareMs, traceMs, dragMs, samples, lost, deviation: {median, max}, turningNoise}}}; two points give the shortest path between them, three a quadratic Bezier curve, more a B-spline; deviations are in mean edges, null is what was not measured',
  options: [
    pointsOption,
    { name: 'samples', value: 'N', help: 'samples a segment', default: '128' },
    {
      name: 'landmarks',
      value: 'N',
      help: 'landmarks of the embedding of weighted averages',
      default: '500',
    },
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
    const points = await args.points();
    const bytes = await args.meshBytes();
    // Only here: the other commands need not wait for a second module.
    const { comparedMethods, loadPeers, runMethod, standardOptions, traceReference } = await import(
      '../peers/index.js'
    );
    const peers = await loadPeers();
    const mesh = peers.karcher.meshFromObj(bytes);
    const plan = peers.plan(points, samples);
    // First, so that wrong points are told before the long work.
    const reference = await traceReference(peers, mesh, plan);
    const methods: Record<string, object> = {};
    for (const name of comparedMethods) {
      const options = { ...standardOptions(name, plan), landmarks };
      const run = await runMethod(peers, mesh, plan, options, reference.samples, { budgetMs });
      const { curve: _, ...result } = run;
      methods[name] = result;
    }
    const { vertices, triangles, meanEdge } = mesh.info;
    return { json: { mesh: { vertices, triangles, meanEdge }, methods } };
  },
};
