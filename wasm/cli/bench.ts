import type { Mesh } from '../mesh.js';
import { engineFieldOptions } from '../options.js';
import type { Peers } from '../peers/index.js';
import type { EngineBenchmark } from '../peers/karcher-peers.mjs';
import { nextCorner } from '../peers/next_corner.js';
import type { FieldOptions, PointLike, Solver, SurfacePoint } from '../types.js';
import type { Command } from './command.js';
import { UsageError } from './errors.js';
import { pointsOption } from './options.js';

const runs = 5;
/** The number of runs for steps of a few milliseconds at most. */
const quickRuns = 50;
/**
 * The runs before the measurement. The code that a JavaScript engine first generates from
 * WebAssembly is slow.
 */
const warmUp = { runs: 1000, ms: 500 };
const rings = 6;

export const bench: Command = {
  name: 'bench',
  call: 'mesh.prepare(options) and mesh.curve(options), timed',
  summary: "the times of a B-spline's steps, by the default method and the paper's",
  output:
    "{mesh: {vertices, triangles}, prepareMs, paper: {graphMs, fieldGraphMs, fieldExactMs, gradientMs, sampleUs, samples, lost, dragMs, bridgeMs, joinMs, weightMs}, karcher: {fieldMs, fieldVertices, fieldNsPerVertex, sampleNs, samples, lost, dragMs, bridgeMs, joinMs, weightMs}, steady: {levels, dragMs}, exact: {fieldMs, fieldVertices, fieldNsPerVertex}, calibrationNs, peakMemoryMB}; times are medians of several runs, except graphMs. The paper's fields and gradient cover all vertices, those of karcher and exact fieldVertices, within a tenth of the diagonal. dragMs is the time after a point moved, and weightMs after its weight changed, both without joinMs, the time of the paths between all samples. steady is the curve of levels 'auto', and its dragMs is a whole step of a drag",
  options: [
    pointsOption,
    { name: 'samples', value: 'N', help: 'the number of samples for each segment', default: '128' },
  ],
  async run(args) {
    const samples = args.integer('samples');
    const given = await args.points();
    const read = await args.meshFile();
    // The import is here so that the other commands do not wait for a second module.
    const { loadPeers } = await import('../peers/index.js');
    const peers = await loadPeers();
    const { mesh } = await read(peers.karcher);
    const { vertices, triangles } = mesh.info;
    const points = given.map((point) => pointOfFace(mesh, point));
    // The curve comes first, so that the command reports wrong points before the long work.
    const { sampleUs, ...karcherCurve } = timeCurve(mesh, points, samples, { method: 'karcher' });
    const steps = timeSteps(peers, mesh, points[0]!);
    const paperCurve = timeCurve(mesh, points, samples, {
      method: 'paper',
      solver: 'graph',
      rings,
    });
    return {
      json: {
        mesh: { vertices, triangles },
        prepareMs: steps.prepareMs,
        paper: {
          graphMs: steps.graphMs,
          fieldGraphMs: steps.fieldGraphMs,
          fieldExactMs: steps.fieldExactMs,
          gradientMs: steps.gradientMs,
          ...paperCurve,
        },
        karcher: { ...steps.fast, sampleNs: 1000 * sampleUs, ...karcherCurve },
        steady: timeSteadyDrag(mesh, points, samples),
        exact: steps.exact,
        calibrationNs: (1e6 * steps.calibrationMs) / vertices,
        peakMemoryMB: process.resourceUsage().maxRSS / 1024,
      },
    };
  },
};

/** A vertex as the corner of a face. */
function pointOfFace(mesh: Mesh, point: PointLike): SurfacePoint {
  if ('face' in point) return { face: point.face, bary: [...point.bary] };
  const corner = mesh.triangles().indexOf(point.vertex);
  if (corner < 0) throw new UsageError(`no face has the vertex ${point.vertex}`);
  const weight = (k: number) => (corner % 3 === k ? 1 : 0);
  return { face: Math.floor(corner / 3), bary: [weight(0), weight(1), weight(2)] };
}

/** Times the preparation of a mesh and the fields of a point, in milliseconds. */
function timeSteps(peers: Peers, mesh: Mesh, { face, bary }: SurfacePoint) {
  const benchmark = peers.benchmark(mesh);
  const time = (work: (steps: EngineBenchmark) => void, times = runs) =>
    median(Array.from({ length: times }, () => elapsed(() => benchmark.call(work))));
  const source = Float64Array.of(face, ...bary);
  const field = (solver: Solver) => engineFieldOptions({ method: 'paper', solver });
  const radius = 0.1 * mesh.info.diagonal;
  const logField = (solver: Solver) => {
    const options = engineFieldOptions({ method: 'karcher', solver });
    const fieldVertices = benchmark.call((steps) => steps.chooseField(source, options, radius));
    time((steps) => steps.readField(), quickRuns);
    const fieldMs = time((steps) => steps.readField(), quickRuns);
    return { fieldMs, fieldVertices, fieldNsPerVertex: (1e6 * fieldMs) / fieldVertices };
  };
  // The order matters, since the fields need the graph and the operator.
  const prepareMs = time((steps) => steps.prepare());
  const calibrationMs = time((steps) => steps.edgeDijkstra());
  const graphMs = time((steps) => steps.ringGraph(rings), 1);
  benchmark.call((steps) => steps.gradientOperator());
  const result = {
    prepareMs,
    calibrationMs,
    graphMs,
    fieldGraphMs: time((steps) => steps.field(source, field('graph'))),
    fieldExactMs: time((steps) => steps.field(source, field('exact'))),
    gradientMs: time((steps) => steps.gradient()),
    fast: logField('fast'),
    exact: logField('exact'),
  };
  benchmark.dispose();
  return result;
}

/** Times a B-spline. Its middle point moves to a neighbouring place and back. */
function timeCurve(
  mesh: Mesh,
  points: readonly SurfacePoint[],
  samples: number,
  field: FieldOptions,
) {
  const curve = mesh.curve({ kind: 'bspline', points: [...points], samples, levels: 0, ...field });
  const { count, status } = curve.samples();
  const lost = status.filter((name) => name !== 'converged').length;
  const start = performance.now();
  /**
   * Traces the curve again while all fields are known. All weights are equal, so that the curve
   * stays the same.
   */
  const retrace = (i: number) => curve.setWeights(points.map(() => 1 + (i % 2)));
  for (let i = 1; i <= warmUp.runs && performance.now() - start < warmUp.ms; i++) retrace(i);
  const index = Math.floor(points.length / 2);
  const here = curve.points()[index]!;
  const places = [nextCorner(here), here];
  const drags: number[] = [];
  const traces: number[] = [];
  const bridges: number[] = [];
  const joins: number[] = [];
  for (let i = 0; i < (field.method === 'paper' ? runs : quickRuns); i++) {
    curve.movePoint(index, places[i % 2]!);
    const { fields, trace, bridge } = curve.times();
    drags.push(fields + trace + bridge);
    // This trace times the searches alone, since all fields are known.
    retrace(i);
    const times = curve.times();
    traces.push(times.trace);
    bridges.push(times.bridge);
    joins.push(times.join);
  }
  // An edit traces the curve at once. The measured time leaves out the paths that join the samples.
  const weights = Array.from({ length: field.method === 'paper' ? runs : quickRuns }, (_, i) => {
    const whole = elapsed(() => curve.setWeight(index, i % 2 === 0 ? 2 : 1));
    return whole - curve.times().join;
  });
  curve.dispose();
  return {
    sampleUs: (1000 * median(traces)) / count,
    samples: count,
    lost,
    dragMs: median(drags),
    bridgeMs: median(bridges),
    joinMs: median(joins),
    weightMs: median(weights),
  };
}

/**
 * Times the default curve with its number of levels fixed. Its middle point moves to a neighbouring
 * place and back.
 */
function timeSteadyDrag(mesh: Mesh, points: readonly SurfacePoint[], samples: number) {
  const curve = mesh.curve({ kind: 'bspline', points: [...points], samples });
  const { levels } = curve;
  curve.set({ ...curve.value(), levels });
  const index = Math.floor(points.length / 2);
  const here = curve.points()[index]!;
  const places = [nextCorner(here), here];
  const step = (i: number) => elapsed(() => curve.dragPoint(index, places[i % 2]!));
  const start = performance.now();
  for (let i = 0; i < warmUp.runs && performance.now() - start < warmUp.ms; i++) step(i);
  const steps = Array.from({ length: quickRuns }, (_, i) => step(i));
  curve.dispose();
  return { levels, dragMs: median(steps) };
}

function elapsed(work: () => void): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}

function median(values: number[]): number {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)]!;
}
