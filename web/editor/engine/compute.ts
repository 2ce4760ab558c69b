import type { CenterOfMass, CurveOptions, ErrorCode, FieldOptions, Path } from 'karcher';
import { isDerived } from '../../model/derived';
import { enclosingOf, type Figure, isRound, pointsNeeded } from '../../model/figure';
import { type DrawnBefore, withDrawnLegs } from '../../model/legs';
import { type MethodId, type Quality, qualityOf } from '../../model/methods';
import { controlPointsOf, penOptions } from '../../model/pen';
import type { DrawnTangents } from '../../model/pen_legs';
import { curveOptions, splineOf } from '../../model/splines';
import type { Fill, TracedCurve } from '../../model/traced';
import { type AskedFill, type EngineClient, KarcherError, Stopped } from '../../worker/client';
import { drawCircle, resolveCircle, type ShownCircle, type ShownIsolines } from './circle_drawing';
import { drawCut, type ShownCut } from './cut';
import { drawDerived, type OutlinesOf } from './derived';
import { drawnTangents, missingHandle } from './pen_drawing';

/** The engine's result for a figure: a curve, isolines or a center, with a circle's handles. */
export interface Shown {
  curve: TracedCurve | null;
  isolines: ShownIsolines | null;
  /** The parts of the surface, if the figure is a cut. */
  cut: ShownCut | null;
  circle: ShownCircle | null;
  center: ShownCenter | null;
  /** The handles of the anchors, if the figure is a curve of the pen. */
  tangents: readonly DrawnTangents[] | null;
  /** A sentence that says why parts of the result are missing. */
  problem: string | null;
  /** The region that the lines enclose; null if it was not requested. */
  fill: Fill | null;
}

export interface ShownCenter extends CenterOfMass {
  milliseconds: number;
}

export const nothing: Shown = {
  curve: null,
  isolines: null,
  cut: null,
  circle: null,
  center: null,
  tangents: null,
  problem: null,
  fill: null,
};

/** The polylines of a result. */
export function polylinesOf({ curve, isolines }: Shown): Float32Array[] {
  if (curve) return [curve.polyline];
  return isolines?.lines.map(({ polyline }) => polyline) ?? [];
}

/** The options for computing a figure. */
export interface Computation {
  /** The id of the object; the engine keeps its curve. */
  object: number;
  /** Whether a better answer will follow, with other options. */
  draft?: boolean;
  /**
   * The points or anchors that a drag moves, and the legs after the drag's last step. The engine
   * continues these legs.
   */
  drawnBefore?: DrawnBefore | undefined;
  /** Whether to look for other minima besides a center of mass, if the search is quick. */
  uniqueness?: boolean;
  /**
   * Whether to measure a center of mass by exact shortest paths, which takes about as long as one
   * exact field.
   */
  certificate?: boolean;
  /** Whether to compute the region that the lines enclose on the figure's side. */
  fill?: boolean;
  /** Whether to return the paths of the lines. */
  outlines?: boolean;
  /** The function that returns the lines of each figure that this figure combines. */
  outlinesOf?: OutlinesOf;
}

/**
 * The paths of the result: null if the computation did not request them, and empty if the result
 * has no lines.
 */
export const outlinesShown = ({ curve, isolines }: Shown): readonly Path[] | null =>
  curve || isolines ? (curve ?? isolines)!.outlines : [];

/** The fill of a figure that encloses no region, such as a center. */
export const noFill: Fill = { region: null, problem: null };

/**
 * A center looks for other minima only if its number of points times the number of vertices is at
 * most this. At the limit, the search takes some 60 ms.
 */
const mostLooked = { fast: 120_000, others: 20_000 };

export async function compute(
  client: EngineClient,
  figure: Figure,
  options: FieldOptions,
  computation: Computation,
): Promise<Shown> {
  const shown = await computeFigure(client, figure, options, computation);
  if (!computation.fill) return shown;
  return { ...shown, fill: shown.curve?.fill ?? shown.isolines?.fill ?? noFill };
}

function computeFigure(
  client: EngineClient,
  figure: Figure,
  options: FieldOptions,
  computation: Computation,
): Promise<Shown> {
  const { object, draft = false, drawnBefore } = computation;
  const fill = computation.fill ? enclosingOf(figure) : null;
  const { outlines = false, outlinesOf } = computation;
  if (figure.kind === 'cut') {
    return drawCut(client, figure, outlinesOf!).then((cut) => ({ ...nothing, cut }));
  }
  if (isDerived(figure.kind)) {
    return drawDerived(client, figure, outlinesOf!, fill !== null).then((isolines) => ({
      ...nothing,
      isolines,
    }));
  }
  if (isRound(figure.kind)) return computeCircle(client, figure, options, { draft, fill });
  if (figure.kind === 'pen') {
    return computePen(client, figure, options, { object, fill, outlines, drawnBefore });
  }
  const few = figure.points.length < pointsNeeded(figure);
  if (few || figure.kind === 'points') return Promise.resolve(nothing);
  const spline = splineOf(figure);
  if (!spline) return computeCenter(client, figure, options, computation);
  const { marks } = spline.settings;
  const value = curveOptions(spline, options);
  return client
    .curve(drawnBefore ? withDrawnLegs(value, drawnBefore) : value, {
      object,
      marks,
      fill,
      outlines,
    })
    .then((curve) => ({ ...nothing, curve }));
}

/** The value of a figure's curve; null for figures without one. */
export async function curveValueOf(
  client: EngineClient,
  figure: Figure,
  options: FieldOptions,
): Promise<CurveOptions | null> {
  if (figure.points.length < pointsNeeded(figure)) return null;
  if (figure.kind === 'pen') {
    const tangents = await drawnTangents(client, figure);
    return missingHandle(figure, tangents) ? null : penOptions(figure, tangents, options);
  }
  const spline = splineOf(figure);
  return spline && curveOptions(spline, options);
}

async function computePen(
  client: EngineClient,
  figure: Figure,
  options: FieldOptions,
  {
    drawnBefore,
    ...request
  }: Pick<Computation, 'object' | 'outlines' | 'drawnBefore'> & {
    fill: AskedFill;
  },
): Promise<Shown> {
  const tangents = await drawnTangents(client, figure);
  const problem = missingHandle(figure, tangents);
  const few = figure.points.length < pointsNeeded(figure);
  // The handles stay, so that the user can drag them back.
  if (few || problem) return { ...nothing, tangents, problem };
  try {
    const { marks } = figure.settings;
    const value = penOptions(figure, tangents, options);
    const points = drawnBefore?.points.flatMap((i) => controlPointsOf(figure, i)) ?? [];
    const drawn = drawnBefore ? withDrawnLegs(value, { ...drawnBefore, points }) : value;
    const curve = await client.curve(drawn, { ...request, marks });
    return { ...nothing, tangents, curve };
  } catch (error) {
    if (client.closed || error instanceof Stopped) throw error;
    return { ...nothing, tangents, problem: messageOf(error) };
  }
}

async function computeCenter(
  client: EngineClient,
  { points }: Figure,
  options: FieldOptions,
  looks: Pick<Computation, 'uniqueness' | 'certificate'>,
): Promise<Shown> {
  const started = performance.now();
  const weights = points.map(({ weight = 1 }) => weight);
  const { vertices } = client.info;
  const isFast = options.solver === 'fast';
  const uniqueness =
    looks.uniqueness === true &&
    points.length * vertices <= (isFast ? mostLooked.fast : mostLooked.others);
  const center = await client.mesh.centerOfMass([...points], weights, {
    ...options,
    normalize: true,
    uniqueness,
    certificate: looks.certificate,
  });
  return { ...nothing, center: { ...center, milliseconds: performance.now() - started } };
}

/**
 * The exact center, with the other minima that the draft found. The engine of exact answers does
 * not search for them, since its copy of the surface does not count as a built-in shape.
 */
export function withUniqueness(
  exact: ShownCenter | null,
  draft: ShownCenter | null,
): ShownCenter | null {
  if (exact?.status !== 'converged' || draft?.status !== 'converged') return exact;
  const { uniqueness, otherMinima } = draft;
  return { ...exact, uniqueness, otherMinima };
}

async function computeCircle(
  client: EngineClient,
  { kind, circle: shape, circleForm, settings }: Figure,
  options: FieldOptions,
  { draft, fill }: { draft: boolean; fill: AskedFill },
): Promise<Shown> {
  if (!shape) return nothing;
  const circle = await resolveCircle(client, shape, kind === 'ellipse');
  try {
    const { leastLevels } = settings;
    const detail = { draft, fill, ...(options.method !== 'paper' && { leastLevels }) };
    const drawn = await drawCircle(client, shape, circle, circleForm, options, detail);
    return { ...nothing, circle, ...drawn };
  } catch (error) {
    if (error instanceof Stopped) throw error;
    // The handles stay, so that the user can drag the radius back.
    return { ...nothing, circle, problem: messageOf(error) };
  }
}

/** The quality of the first answer. An exact isoline is exact with every method. */
export function qualityShown({ curve, isolines, center }: Shown, method: MethodId): Quality | null {
  if (isolines?.exact) return 'exact';
  return curve || isolines || center ? qualityOf(method) : null;
}

/**
 * The median and the largest of the distances by which a curve's samples move, in a unit of length.
 */
export interface Shift {
  median: number;
  largest: number;
}

/** The largest median shift, in mean edges, that users do not see as a jump. */
export const unseenShift = 0.2;

/**
 * The distances between the samples of two curves at the same parameters, in a unit of length. The
 * arrays have x, y, z of each sample. Null if the numbers of samples differ or are 0.
 */
export function shiftBetween(from: Float64Array, to: Float64Array, unit: number): Shift | null {
  if (from.length !== to.length || from.length === 0) return null;
  const distances = new Float64Array(from.length / 3).map((_, i) =>
    Math.hypot(...[0, 1, 2].map((axis) => to[3 * i + axis]! - from[3 * i + axis]!)),
  );
  distances.sort();
  const middle = (distances.length - 1) / 2;
  const median = (distances[Math.floor(middle)]! + distances[Math.ceil(middle)]!) / 2;
  return { median: median / unit, largest: distances.at(-1)! / unit };
}

/** The shift from the draft to the exact form, as multiples of `unit`; null if there is none. */
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

/** Sentences that replace the engine's messages about points or arcs, which count from 0. */
const withoutNumbers: Partial<Record<ErrorCode, string>> = {
  unreachable: 'the points lie on different components of the surface; no path joins them all',
  boundary: 'a geodesic from the center to its arc meets the surface’s boundary',
};

export function messageOf(error: unknown): string {
  const told = error instanceof KarcherError && withoutNumbers[error.code];
  return told || (error instanceof Error ? error.message : `${error}`);
}
