/** The worker that runs the engine: one surface, and the curve that is being edited on it. */
import {
  type BridgedInterval,
  type CenterOptions,
  type Circle,
  type CircleOptions,
  type Curve,
  type CurveOptions,
  type CurveSamples,
  type DistanceOptions,
  type EllipseOptions,
  type FieldOptions,
  type IsolineOptions,
  type Karcher,
  type LongWorkOptions,
  load,
  type Mesh,
  type PointLike,
} from 'karcher';
import { serve } from 'karcher/own-worker';
import { lostIntervals } from '../model/lost';
import type { MeshSource } from '../model/meshes';
import type { Measured, TracedCurve, TracedIsolines } from '../model/traced';
import { type Change, changeBetween } from './change';
import { type Reshape, reshaped } from './reshape';

type Tell = NonNullable<LongWorkOptions['progress']>;

let mesh: Mesh | null = null;
let curve: { options: CurveOptions; traced: Curve } | null = null;

export interface CurveWork {
  keep: boolean;
  /** How many points to mark along it. */
  marks?: number;
}

/** What can be asked of the worker. */
const calls = {
  async load(source: MeshSource, { progress = () => {} }: LongWorkOptions) {
    progress(0, 'Starting the engine');
    const karcher = await load();
    progress(0.2, 'Reading the surface');
    mesh = await meshOf(karcher, source, progress);
    return { info: mesh.info, positions: mesh.positions(), triangles: mesh.triangles() };
  },

  prepare(options: FieldOptions, work: LongWorkOptions) {
    return theMesh().prepare(options, work);
  },

  /** The curve that is edited, by its smallest change; or one that is traced and not kept. */
  curve(options: CurveOptions, { keep, marks = 0 }: CurveWork): TracedCurve {
    const started = performance.now();
    const traced = keep ? retrace(options) : theMesh().curve(options);
    const result: TracedCurve = {
      polyline: traced.polyline(),
      polylineStatus: traced.unconverged(),
      ...drawnSamples(traced.samples(), traced.bridged()),
      knots: traced.knots(),
      levels: traced.levels,
      marks: marks > 0 ? traced.equallySpaced(marks) : null,
      arcsNotShortest: 0,
      length: traced.length,
      milliseconds: performance.now() - started,
    };
    if (!keep) traced.dispose();
    return result;
  },

  /**
   * A B-spline's knots after an edit, which makes it one of other points, or closes or opens it; it
   * is then the curve that is edited.
   */
  knots(from: CurveOptions, to: CurveOptions): number[] {
    const traced = retrace(from);
    const ruled = (options: CurveOptions) => ({ ...options, knots: undefined });
    const change = changeBetween(ruled(from), ruled(to));
    if (change.type === 'new') throw new Error('the knots of another curve do not go on');
    perform(traced, change, to);
    const knots = Array.from(traced.knots());
    curve = { options: { ...to, knots }, traced };
    return knots;
  },

  /** The curve with these options, which is the one that is edited, where it is nearest to a place. */
  measure(options: CurveOptions, near: [number, number, number]): Measured {
    const traced = retrace(options);
    const { parameter, position } = traced.nearest(near);
    const { inSpace: tangent } = traced.tangentAt(parameter);
    const [length, wholeLength] = [traced.lengthAt(parameter), traced.length];
    return { parameter, position, length, wholeLength, tangent };
  },

  /** The curves that an edit makes of the one with these options. */
  reshape(options: CurveOptions, edit: Reshape) {
    return reshaped(theMesh(), retrace(options), options, edit);
  },

  circle(center: PointLike, options: CircleOptions): TracedCurve {
    return tracedArcs(() => theMesh().circle(center, options));
  },

  ellipse(center: PointLike, options: EllipseOptions): TracedCurve {
    return tracedArcs(() => theMesh().ellipse(center, options));
  },

  isolines(center: PointLike, options: IsolineOptions): TracedIsolines {
    const started = performance.now();
    const lines = theMesh()
      .isolines(center, options)
      .map((line) => ({
        ...{ closed: line.closed, length: line.length },
        polyline: line.polyline(),
      }));
    const length = lines.reduce((sum, line) => sum + line.length, 0);
    return { lines, length, milliseconds: performance.now() - started };
  },

  centerOfMass(points: PointLike[], weights: number[], options?: CenterOptions) {
    return theMesh().centerOfMass(points, weights, options);
  },

  distance(point: PointLike, options?: DistanceOptions) {
    return theMesh().distance(point, options);
  },

  shortestPath(from: PointLike, to: PointLike) {
    return theMesh().shortestPath(from, to);
  },

  straightest(from: PointLike, direction: [number, number, number], length: number) {
    return theMesh().straightest(from, direction, length);
  },
};

export type Calls = typeof calls;

serve(calls);

function tracedArcs(trace: () => Circle): TracedCurve {
  const started = performance.now();
  const { path, unconverged, samples, bridged, notShortest } = trace();
  return {
    polyline: path.polyline(),
    polylineStatus: unconverged,
    ...drawnSamples(samples, bridged),
    knots: new Float64Array(),
    levels: 0,
    marks: null,
    arcsNotShortest: notShortest.length,
    length: path.length,
    milliseconds: performance.now() - started,
  };
}

function theMesh(): Mesh {
  if (!mesh) throw new Error('no surface is loaded');
  return mesh;
}

async function meshOf(karcher: Karcher, source: MeshSource, progress: Tell): Promise<Mesh> {
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
