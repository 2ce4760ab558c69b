/** The worker that runs the engine: one surface, and the curve that is being edited on it. */

import type { BridgedInterval, Circle, CurveSamples } from 'karcher';
import {
  type Curve,
  type CurveOptions,
  type Karcher,
  KarcherError,
  load,
  type Mesh,
} from 'karcher';
import { lostIntervals } from '../model/lost';
import type { MeshSource } from '../model/meshes';
import type { TracedCurve } from '../model/traced';
import { type Change, changeBetween } from './change';
import type { Calls, Failure, Reply, Request } from './protocol';
import { reshaped } from './reshape';

let mesh: Mesh | null = null;
let curve: { options: CurveOptions; traced: Curve } | null = null;
const running = new Map<number, AbortController>();

type Work = { progress: (done: number, stage: string) => void; signal: AbortSignal };
type Answer<Result> = { result: Result; transfer?: Transferable[] };
type Handlers = {
  [Name in keyof Calls]: (
    work: Work,
    ...args: Parameters<Calls[Name]>
  ) => Answer<ReturnType<Calls[Name]>> | Promise<Answer<ReturnType<Calls[Name]>>>;
};

const handlers: Handlers = {
  async load({ progress }, source) {
    progress(0, 'Starting the engine');
    const karcher = await load();
    progress(0.2, 'Reading the surface');
    mesh = await meshOf(karcher, source, progress);
    const [positions, triangles] = [mesh.positions(), mesh.triangles()];
    const result = { info: mesh.info, positions, triangles };
    return { result, transfer: [positions.buffer, triangles.buffer] as ArrayBuffer[] };
  },

  async prepare(work, options) {
    await theMesh().prepare(options, work);
    return { result: undefined };
  },

  curve(_, options, { keep, marks = 0 } = { keep: true }) {
    const started = performance.now();
    const traced = keep ? retrace(options) : theMesh().curve(options);
    const result: TracedCurve = {
      polyline: traced.polyline(),
      polylineStatus: traced.unconverged(),
      ...drawnSamples(traced.samples(), traced.bridged()),
      knots: traced.knots(),
      marks: marks > 0 ? traced.equallySpaced(marks) : null,
      arcsNotShortest: 0,
      length: traced.length,
      milliseconds: performance.now() - started,
    };
    if (!keep) traced.dispose();
    return { result, transfer: buffersOf(result) };
  },

  knots(_, from, to) {
    const traced = retrace(from);
    const ruled = (options: CurveOptions) => ({ ...options, knots: undefined });
    const change = changeBetween(ruled(from), ruled(to));
    if (change.type === 'new') throw new Error('the knots of another curve do not go on');
    perform(traced, change, to);
    const knots = Array.from(traced.knots());
    curve = { options: { ...to, knots }, traced };
    return { result: knots };
  },

  measure(_, options, near) {
    const traced = retrace(options);
    const { parameter, position } = traced.nearest(near);
    const { inSpace: tangent } = traced.tangentAt(parameter);
    const [length, wholeLength] = [traced.lengthAt(parameter), traced.length];
    return { result: { parameter, position, length, wholeLength, tangent } };
  },

  reshape(_, options, edit) {
    return { result: reshaped(theMesh(), retrace(options), options, edit) };
  },

  circle(_, center, options) {
    return tracedArcs(() => theMesh().circle(center, options));
  },

  ellipse(_, center, options) {
    return tracedArcs(() => theMesh().ellipse(center, options));
  },

  isolines(_, center, options) {
    const started = performance.now();
    const lines = theMesh()
      .isolines(center, options)
      .map((line) => ({
        ...{ closed: line.closed, length: line.length },
        polyline: line.polyline(),
      }));
    const length = lines.reduce((sum, line) => sum + line.length, 0);
    const result = { lines, length, milliseconds: performance.now() - started };
    return { result, transfer: lines.map(({ polyline }) => polyline.buffer as ArrayBuffer) };
  },

  centerOfMass(_, points, weights, options) {
    return { result: theMesh().centerOfMass(points, weights, options) };
  },

  distance(_, point, options) {
    const result = theMesh().distance(point, options).slice();
    return { result, transfer: [result.buffer] };
  },

  shortestPath(_, from, to) {
    const path = theMesh().shortestPath(from, to);
    return { result: { length: path.length, polyline: path.polyline() } };
  },

  straightest(_, from, direction, length) {
    const { end, remaining, path } = theMesh().straightest(from, direction, length);
    return { result: { end, remaining, polyline: path.polyline() } };
  },
};

function tracedArcs(trace: () => Circle): Answer<TracedCurve> {
  const started = performance.now();
  const { path, unconverged, samples, bridged, notShortest } = trace();
  const result: TracedCurve = {
    polyline: path.polyline(),
    polylineStatus: unconverged,
    ...drawnSamples(samples, bridged),
    knots: new Float64Array(),
    marks: null,
    arcsNotShortest: notShortest.length,
    length: path.length,
    milliseconds: performance.now() - started,
  };
  return { result, transfer: buffersOf(result) };
}

function buffersOf({ polyline, polylineStatus, samples }: TracedCurve): ArrayBuffer[] {
  const { segment, t, face, bary, position } = samples;
  const arrays = [polyline, polylineStatus, segment, t, face, bary, position];
  return [...new Set(arrays.map(({ buffer }) => buffer as ArrayBuffer))];
}

function theMesh(): Mesh {
  if (!mesh) throw new Error('no surface is loaded');
  return mesh;
}

async function meshOf(
  karcher: Karcher,
  source: MeshSource,
  progress: Work['progress'],
): Promise<Mesh> {
  switch (source.kind) {
    case 'file':
      return karcher.meshFromObj(source.bytes);
    case 'arrays':
      return karcher.meshFromArrays(source.positions, source.triangles);
    case 'bunny':
    case 'shape': {
      const { makeSample } = await import('../model/sample_mesh');
      return makeSample(karcher, source, progress);
    }
    default: {
      const { makeMesh } = await import('../model/made_mesh');
      return makeMesh(karcher, source, progress);
    }
  }
}

/** The curve for these options, made from the one before where an edit does. */
function retrace(options: CurveOptions): Curve {
  const change = curve ? changeBetween(curve.options, options) : { type: 'new' as const };
  if (!curve || change.type === 'new') {
    const traced = theMesh().curve(options);
    curve?.traced.dispose();
    curve = { options, traced };
    return traced;
  }
  // An edit that fails leaves the curve as it was.
  perform(curve.traced, change, options);
  curve = { options, traced: curve.traced };
  return curve.traced;
}

/** Carries out a change, other than to a new curve, to these options. */
function perform(traced: Curve, change: Change, options: CurveOptions): void {
  if (change.type === 'move') traced.movePoint(change.index, change.point);
  else if (change.type === 'insert') traced.insertPoint(change.index, change.point);
  else if (change.type === 'remove') traced.removePoint(change.index);
  else if (change.type === 'reorder') traced.movePointInOrder(change.from, change.to);
  else if (change.type === 'kind') traced.setKind(options.kind);
  else if (change.type === 'closed') traced.setClosed(options.closed ?? false);
  else if (change.type === 'weight') traced.setWeight(change.index, change.value);
  else if (change.type === 'beta') traced.setBeta(change.index, change.value);
}

function drawnSamples(
  all: CurveSamples,
  bridged: readonly BridgedInterval[],
): Pick<TracedCurve, 'samples' | 'lost'> {
  // Statuses by name would be copied one by one, with each step of a drag.
  const { status, ...samples } = all;
  return { samples, lost: lostIntervals(all, bridged) };
}

function failure(error: unknown): Failure {
  if (error instanceof KarcherError) return { message: error.message, code: error.code };
  const message = error instanceof Error ? error.message : `${error}`;
  return { message, fatal: error instanceof WebAssembly.RuntimeError };
}

const post = (reply: Reply, transfer: Transferable[] = []) => self.postMessage(reply, { transfer });

self.onmessage = async ({ data }: MessageEvent<Request>) => {
  const { id } = data;
  if (data.call === 'cancel') {
    running.get(id)?.abort();
    return;
  }
  const controller = new AbortController();
  running.set(id, controller);
  const progress = (done: number, stage: string) => post({ id, progress: done, stage });
  try {
    const handler = handlers[data.call] as (
      work: Work,
      ...args: unknown[]
    ) => Answer<unknown> | Promise<Answer<unknown>>;
    const answer = await handler({ progress, signal: controller.signal }, ...data.args);
    post({ id, result: answer.result }, answer.transfer);
  } catch (error) {
    post({ id, failure: failure(error) });
  } finally {
    running.delete(id);
  }
};
