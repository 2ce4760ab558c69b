/** The engine's results for a circle or an ellipse: its lines, and the places of its handles. */
import type { FieldOptions, SurfacePoint } from 'karcher';
import { acrossDirection, defaultAcross, reachAlong } from '../../model/circle';
import type { Across, CircleForm, CircleShape, Vector } from '../../model/figure';
import type { SourceLine } from '../../model/origins';
import type { TracedCurve, TracedIsolines } from '../../model/traced';
import type { AskedFill, EngineClient } from '../../worker/client';

/** A radius with a handle. */
export interface ShownRadius {
  radius: number;
  direction: Vector;
  rim: SurfacePoint;
  /** The geodesic from the center to the rim. */
  path: Float32Array;
}

export interface ShownCircle extends ShownRadius {
  /** An ellipse's other radius. */
  across: ShownRadius | null;
}

/**
 * The smallest value that a handle can give the ellipse's other radius, relative to the surface's
 * diagonal.
 */
const leastAcross = 1e-3;

export interface ShownIsolines extends TracedIsolines {
  /** Whether the lines are exact, whatever the quality of the method. */
  exact: boolean;
  /** The lines of a boolean's operands. */
  from?: readonly SourceLine[];
}

/** The places of the handles of a circle or an ellipse, and the radii that follow from them. */
export async function resolveCircle(
  client: EngineClient,
  { center, rim, across }: CircleShape,
  isEllipse: boolean,
): Promise<ShownCircle> {
  const along =
    'face' in rim
      ? await radiusTo(client, center, rim)
      : await radiusOf(client, center, rim.direction, rim.radius);
  if (!isEllipse) return { ...along, across: null };
  const direction = acrossDirection(along.direction, await client.corners(center.face));
  const radius = await acrossRadius(client, center, across, along.radius, direction);
  return { ...along, across: await radiusOf(client, center, direction, radius) };
}

async function radiusTo(
  client: EngineClient,
  center: SurfacePoint,
  rim: SurfacePoint,
): Promise<ShownRadius> {
  const path = await client.mesh.shortestPath(center, rim);
  const direction = directionOf(path.polyline({ bits: 64 }));
  return { radius: path.length, direction, rim, path: path.polyline() };
}

async function radiusOf(
  client: EngineClient,
  center: SurfacePoint,
  direction: Vector,
  radius: number,
): Promise<ShownRadius> {
  const { end, path } = await client.mesh.straightest(center, direction, radius);
  return { radius, direction, rim: end, path: path.polyline() };
}

async function acrossRadius(
  client: EngineClient,
  center: SurfacePoint,
  across: Across | undefined,
  along: number,
  direction: Vector,
): Promise<number> {
  if (!across) return defaultAcross * along;
  if ('radius' in across) return across.radius;
  const to = await radiusTo(client, center, across);
  const least = leastAcross * client.info.diagonal;
  // In a mirror image the point lies on the other side, where its reach is negative.
  return Math.max(least, Math.abs(reachAlong(to.radius, to.direction, direction)));
}

/**
 * The lines of a circle or an ellipse. Rejects if there are none with these radii. In a draft, a
 * linear isoline replaces an exact one, since a linear one takes the same time for every radius.
 */
export async function drawCircle(
  client: EngineClient,
  { center }: CircleShape,
  { radius, direction, across }: ShownCircle,
  { type, arcs }: CircleForm,
  options: FieldOptions,
  {
    draft,
    leastLevels = 0,
    fill = null,
  }: { draft: boolean; leastLevels?: number | undefined; fill?: AskedFill },
): Promise<{ curve: TracedCurve } | { isolines: ShownIsolines }> {
  const counted = arcs === 'auto' ? {} : { arcs };
  if (across) {
    const radii = [radius, across.radius] as const;
    const ellipse = { ...options, radii, direction, ...counted };
    return {
      curve: await atLeast(leastLevels, (part) =>
        client.ellipse(center, { ...ellipse, ...part }, fill),
      ),
    };
  }
  if (type === 'arcs') {
    const circle = { ...options, radius, ...counted };
    return {
      curve: await atLeast(leastLevels, (part) =>
        client.circle(center, { ...circle, ...part }, fill),
      ),
    };
  }
  const { solver, rings } = options;
  const exact = type === 'exact' && !draft;
  const isolines = await client.isolines(
    center,
    exact ? { radius, type: 'exact' } : { radius, type: 'linear', solver, rings },
    fill,
  );
  if (isolines.lines.length === 0) {
    throw new Error(`no point of the surface lies ${radius.toPrecision(4)} from the center`);
  }
  return { isolines: { ...isolines, exact } };
}

/**
 * Traces with the number of levels that the engine chooses; if this number is less than `levels`,
 * traces again with `levels`.
 */
async function atLeast(
  levels: number,
  trace: (part: { levels?: number }) => Promise<TracedCurve>,
): Promise<TracedCurve> {
  const traced = await trace({});
  return traced.levels < levels ? trace({ levels }) : traced;
}

/**
 * The direction of the first nonzero step of a polyline; an arbitrary one if all of its points
 * coincide.
 */
export function directionOf(polyline: Float32Array | Float64Array): Vector {
  for (let i = 3; i < polyline.length; i += 3) {
    const step = [0, 1, 2].map((axis) => polyline[i + axis]! - polyline[axis]!) as Vector;
    const length = Math.hypot(...step);
    if (length > 0) return step.map((value) => value / length) as Vector;
  }
  return [1, 0, 0];
}
