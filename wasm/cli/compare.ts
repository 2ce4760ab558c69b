import type { MethodOptions } from '../peers/index.js';
import type { Command } from './command.js';
import { UsageError } from './errors.js';
import { pointsOption } from './options.js';

export const compare: Command = {
  name: 'compare',
  call: "runMethod of 'karcher/peers'",
  summary:
    'a curve by each method, with times and distances from the curve of exact log vectors or paths',
  output:
    '{mesh: {vertices, triangles, meanEdge}, reference, methods: {vectorHeat|affineHeat|weightedAverages|descent|bSurf|paper|karcher|leveled: {solver, ok, reason, prepareMs, traceMs, fieldsMs, dragMs, dragFieldMs, memory, samples, lost, lostByOwnRule, logMaps: {made, asked, ms}, deviation: {median, max, samples}, turningNoise, breaks, sharpestTurn: {degrees, t}, ruler: {residual: {median, max}, energy: {median, excess}, measured, of}, drag: {steps, leaps, most}}}}; two points give the shortest path between them, three a quadratic Bezier curve, more a B-spline. solver is the method’s solver of distances or log maps: paper has exact distances for two points and the graph of k = 6 for more, unless --solver or --rings sets another, and karcher has fast ones. karcher is level 0, the center of all points, leveled the default, which refines the control polygon first. Deviations from the reference (the exact path, or our curve of exact log vectors) are in mean edges h, over all samples that are not lost. lost counts samples for which the search did not converge to 1e-6 h, and which no bridge and no subdivided piece replaces; lostByOwnRule those that the method’s authors would not have accepted either (vector heat’s library stops at a step of a third of the root of a face’s area, and halves steps that do not lower the energy up to seven times). logMaps counts those that the heat methods made, in ms milliseconds, and those that they requested, each of which their library computes anew. ruler is the same for all: at up to 33 samples, by exact shortest paths, the residual |sum w log p| in h and the energy sum w d^2 in h^2, excess over the reference’s. breaks counts leaps between neighbouring samples, sharpestTurn is the largest angle at one. drag moves the middle control point towards the next one in even steps, over two edges at most: leaps counts the steps in which a sample moved more than five times as far as the hand, most is the farthest, in steps of the hand. fieldsMs and dragFieldMs are the part of traceMs and dragMs that fields take, memory the bytes that the method holds with its curve. null stands for values that were not measured',
  options: [
    pointsOption,
    { name: 'samples', value: 'N', help: 'the number of samples for each segment', default: '128' },
    {
      name: 'landmarks',
      value: 'N',
      help: 'landmarks of the embedding of weighted averages',
      default: '500',
    },
    { name: 'delaunay', help: 'the heat methods on the intrinsic Delaunay triangulation' },
    {
      name: 'solver',
      value: 'exact|graph',
      help: 'the distances of the paper’s method; exact for two points, graph for more',
      default: 'graph',
    },
    { name: 'rings', value: 'K', help: 'rings of its graph, 1 to 10', default: '6' },
    {
      name: 'star',
      value: 'wide|ring',
      help: 'the faces of its Eq. 3: also those beyond, as in its authors’ program, or those around a vertex, as printed',
      default: 'wide',
    },
    {
      name: 'seeds',
      value: 'authors|heaviest',
      help: 'the starts of its searches: those of its authors’ program, or of the engine',
      default: 'authors',
    },
    {
      name: 'drag',
      value: 'STEPS',
      help: 'the number of steps of the drag that counts leaps; 0 for none',
      default: '20',
    },
    {
      name: 'budget',
      value: 'SECONDS',
      help: 'the time after which a method gives up; 0 for never',
      default: '0',
    },
  ],
  async run(args, tell) {
    const samples = args.integer('samples');
    const landmarks = args.integer('landmarks');
    const budgetMs = 1000 * args.number('budget') || Number.POSITIVE_INFINITY;
    const dragSteps = args.integer('drag');
    if (dragSteps < 0) throw new UsageError('--drag must be at least 0 steps');
    if (budgetMs < 0) throw new UsageError('--budget must be at least 0 seconds');
    const delaunay = args.given('delaunay');
    const solver = args.choice<'exact' | 'graph'>('solver');
    if (args.given('rings') && args.given('solver') && solver === 'exact') {
      args.refuse(['rings'], 'with --solver exact');
    }
    const ofPaper: Partial<MethodOptions> = {
      star: args.choice<'wide' | 'ring'>('star'),
      seeds: args.choice<'authors' | 'heaviest'>('seeds'),
      ...(args.given('solver') && { solver }),
    };
    const rings = args.integer('rings');
    const points = await args.points();
    const read = await args.meshFile();
    // The import is here so that the other commands do not wait for a second module.
    const {
      comparedMethods,
      loadPeers,
      Ruler,
      referenceOptions,
      runMethod,
      solverWords,
      standardOptions,
      traceReference,
    } = await import('../peers/index.js');
    const peers = await loadPeers();
    const { mesh } = await read(peers.karcher);
    const plan = peers.plan(points, samples);
    // The reference comes first, so that the command reports wrong points before the long work.
    const reference = await traceReference(peers, mesh, plan);
    const ruler = new Ruler(mesh, plan);
    await ruler.compareWith(reference.samples);
    const methods: Record<string, object> = {};
    for (const name of comparedMethods) {
      const options: MethodOptions = { ...standardOptions(name, plan), landmarks, delaunay };
      if (name === 'paper') {
        Object.assign(options, ofPaper);
        if (options.solver === 'graph') options.rings = rings;
        else delete options.rings;
      }
      const run = await runMethod(peers, mesh, plan, options, reference.samples, {
        budgetMs,
        ruler,
        dragSteps,
        progress: reporter(name, tell),
      });
      const { curve: _, ...result } = run;
      methods[name] = { solver: solverWords(options), ...result };
    }
    const { vertices, triangles, meanEdge } = mesh.info;
    const words =
      points.length === 2
        ? 'the exact shortest path'
        : `our method, ${solverWords(referenceOptions)}`;
    return { json: { mesh: { vertices, triangles, meanEdge }, reference: words, methods } };
  },
};

/** A function that reports the progress of a slow method. */
function reporter(
  name: string,
  tell: (sentence: string) => void,
): (done: number, stage: string) => void {
  const quietMs = 2000;
  let told = performance.now();
  return (done, stage) => {
    const now = performance.now();
    if (now - told < quietMs) return;
    told = now;
    tell(`${name}: ${stage}, ${Math.round(100 * done)} %`);
  };
}
