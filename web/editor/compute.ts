import type { CenterOfMass, ErrorCode, FieldOptions } from 'karcher';
import { type CurveDocument, isRound, pointsNeeded } from '../model/document';
import { curveOptions, splineOf } from '../model/splines';
import type { TracedCurve } from '../model/traced';
import { type EngineClient, KarcherError } from '../worker/client';
import { drawCircle, resolveCircle, type ShownCircle, type ShownIsolines } from './circle_drawing';
import { type Shift, shiftBetween } from './shift';

/** What the engine makes of a document: a curve, isolines or a center, with a circle's handles. */
export interface Shown {
  curve: TracedCurve | null;
  isolines: ShownIsolines | null;
  circle: ShownCircle | null;
  center: ShownCenter | null;
  /** Why there is less than was asked for, as a sentence. */
  problem: string | null;
}

export interface ShownCenter extends CenterOfMass {
  milliseconds: number;
}

export const nothing: Shown = {
  curve: null,
  isolines: null,
  circle: null,
  center: null,
  problem: null,
};

/** The polylines of what is shown, but for those of curves beside it. */
export function polylinesOf({ curve, isolines }: Shown): Float32Array[] {
  if (curve) return [curve.polyline];
  return isolines?.lines.map(({ polyline }) => polyline) ?? [];
}

/** A draft has a better answer to follow, by other options; of a drag, the number of its point. */
export function compute(
  client: EngineClient,
  document: CurveDocument,
  options: FieldOptions,
  draft: boolean,
  dragged?: number,
): Promise<Shown> {
  if (isRound(document.kind)) return computeCircle(client, document, options, draft);
  if (document.points.length < pointsNeeded(document)) return Promise.resolve(nothing);
  const spline = splineOf(document);
  if (!spline) return computeCenter(client, document, options);
  const { marks } = spline.settings;
  return client
    .curve(curveOptions(spline, options), marks, dragged)
    .then((curve) => ({ ...nothing, curve }));
}

async function computeCenter(
  client: EngineClient,
  { points }: CurveDocument,
  options: FieldOptions,
): Promise<Shown> {
  const started = performance.now();
  const weights = points.map(({ weight = 1 }) => weight);
  const center = await client.mesh.centerOfMass([...points], weights, {
    ...options,
    normalize: true,
  });
  return { ...nothing, center: { ...center, milliseconds: performance.now() - started } };
}

async function computeCircle(
  client: EngineClient,
  { kind, circle: shape, circleForm }: CurveDocument,
  options: FieldOptions,
  draft: boolean,
): Promise<Shown> {
  if (!shape) return nothing;
  const circle = await resolveCircle(client, shape, kind === 'ellipse');
  try {
    const drawn = await drawCircle(client, shape, circle, circleForm, options, draft);
    return { ...nothing, circle, ...drawn };
  } catch (error) {
    // The handles stay, so that the radius can be taken back.
    return { ...nothing, circle, problem: messageOf(error) };
  }
}

/** How far what is shown moved from one quality to the other, in a unit of length. */
export function shiftOf(from: Shown, to: Shown, unit: number): Shift | null {
  if (from.center && to.center) {
    return shiftBetween(
      Float64Array.from(from.center.position),
      Float64Array.from(to.center.position),
      unit,
    );
  }
  if (!from.curve || !to.curve) return null;
  return shiftBetween(from.curve.samples.position, to.curve.samples.position, unit);
}

/** Failures that the engine tells by the numbers of points or arcs, which it counts from 0. */
const withoutNumbers: Partial<Record<ErrorCode, string>> = {
  unreachable: 'the points lie on different components of the surface; no path joins them all',
  boundary: 'a geodesic from the center to its arc meets the surface’s boundary',
};

export function messageOf(error: unknown): string {
  const told = error instanceof KarcherError && withoutNumbers[error.code];
  return told || (error instanceof Error ? error.message : `${error}`);
}
