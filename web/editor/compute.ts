import type { CenterOfMass, CurveOptions, FieldOptions, SurfacePoint } from 'karcher';
import type { EngineClient } from '../worker/client';
import type { TracedCurve } from '../worker/protocol';
import {
  type CircleShape,
  type CurveDocument,
  parameterOf,
  pointsNeeded,
  type Spline,
  type Vector,
} from './document';
import { type Shift, shiftBetween } from './shift';
import { splineOf } from './splines';

/** What the engine makes of a document: one of the three at most. */
export interface Shown {
  curve: TracedCurve | null;
  circle: ShownCircle | null;
  center: ShownCenter | null;
  /** Why there is less than was asked for, as a sentence. */
  problem: string | null;
}

export interface ShownCircle {
  radius: number;
  direction: Vector;
  rim: SurfacePoint;
  /** The geodesic from the center to the rim. */
  path: Float32Array;
}

export interface ShownCenter extends CenterOfMass {
  milliseconds: number;
}

export const nothing: Shown = { curve: null, circle: null, center: null, problem: null };

const samplesPerSegment = 128;

export function compute(
  client: EngineClient,
  document: CurveDocument,
  options: FieldOptions,
): Promise<Shown> {
  if (document.kind === 'circle') return computeCircle(client, document.circle, options);
  if (document.points.length < pointsNeeded(document)) return Promise.resolve(nothing);
  const spline = splineOf(document);
  if (!spline) return computeCenter(client, document, options);
  return client.curve(curveOptions(spline, options)).then((curve) => ({ ...nothing, curve }));
}

/** A spline as the engine takes it: with what its kind has a use for. */
export function curveOptions(
  { kind, points, settings }: Spline,
  options: FieldOptions,
): CurveOptions {
  const { closed, degree, clamped, knots, parametrization } = settings;
  const rule = clamped && !closed ? 'clamped' : 'uniform';
  const parameter = parameterOf(kind);
  const numbers = points.map((point) => (parameter && point[parameter]) ?? 1);
  const plain = numbers.every((number) => number === 1);
  return {
    ...options,
    kind,
    points: points.map(({ face, bary }) => ({ face, bary })),
    samples: samplesPerSegment,
    closed,
    ...(kind === 'bspline' && { degree, knots: knots ? [...knots] : rule }),
    ...(kind === 'catmullrom' && { parametrization }),
    ...(parameter === 'weight' && !plain && { weights: numbers }),
    ...(parameter === 'beta' && !plain && { betas: numbers }),
  };
}

async function computeCenter(
  client: EngineClient,
  { points }: CurveDocument,
  options: FieldOptions,
): Promise<Shown> {
  const started = performance.now();
  const weights = points.map(({ weight = 1 }) => weight);
  const center = await client.centerOfMass([...points], weights, { ...options, normalize: true });
  return { ...nothing, center: { ...center, milliseconds: performance.now() - started } };
}

async function computeCircle(
  client: EngineClient,
  shape: CircleShape | null,
  options: FieldOptions,
): Promise<Shown> {
  if (!shape) return nothing;
  const circle = await resolveCircle(client, shape);
  const { radius } = circle;
  try {
    const curve = await client.circle({ ...options, center: shape.center, radius });
    return { ...nothing, curve, circle };
  } catch (error) {
    // The handles stay, so that the radius can be taken back.
    return { ...nothing, circle, problem: messageOf(error) };
  }
}

async function resolveCircle(
  client: EngineClient,
  { center, rim }: CircleShape,
): Promise<ShownCircle> {
  if ('face' in rim) {
    const { length, polyline } = await client.shortestPath(center, rim);
    return { radius: length, direction: directionOf(polyline), rim, path: polyline };
  }
  const { radius, direction } = rim;
  const { end, polyline } = await client.straightest(center, direction, radius);
  return { radius, direction, rim: end, path: polyline };
}

/** The first step of a polyline that is no repeated point; any direction when all are. */
function directionOf(polyline: Float32Array): Vector {
  for (let i = 3; i < polyline.length; i += 3) {
    const step = [0, 1, 2].map((axis) => polyline[i + axis]! - polyline[axis]!) as Vector;
    const length = Math.hypot(...step);
    if (length > 0) return step.map((value) => value / length) as Vector;
  }
  return [1, 0, 0];
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

export const messageOf = (error: unknown) => (error instanceof Error ? error.message : `${error}`);
