/**
 * Turns a stroke by hand into a few smooth anchors of the pen. The surface along the stroke unrolls
 * onto a plane, where the stroke has the same lengths and turns as on the surface. Cubic curves are
 * fitted there: near an anchor, the plane's coordinates are the anchor's log coordinates.
 */
import type { SurfacePoint } from 'karcher';
import { cornersOf, fittedCubics, type Planar } from './cubic_fit';
import type { ControlPoint, Tangent, Tangents, Vector } from './figure';
import { type LinePieces, withOrigin } from './origins';
import { withTangents } from './pen';
import { cross, dot, minus } from './vectors';

/** A sample of the stroke. Lengths are in the surface's unit. */
export interface StrokeSample {
  point: SurfacePoint;
  place: Vector;
  /** The unit normal. */
  normal: Vector;
  /** The tolerance of the fit at the sample. */
  tolerance: number;
  /** The length of a pixel at the sample. */
  pixel: number;
}

/**
 * The distance over which the direction of a stroke is measured, in pixels, and the least turn of a
 * corner, in radians.
 */
const reachPixels = 10;
const cornerAngle = 1;

const along = (a: Vector, b: Vector, factor: number): Vector => [
  a[0] + factor * b[0],
  a[1] + factor * b[1],
  a[2] + factor * b[2],
];

/** The direction of a step in a tangent plane; null if it has no length there. */
function directionIn(normal: Vector, step: Vector): Vector | null {
  const flat = along(step, normal, -dot(step, normal));
  const length = Math.hypot(...flat);
  return length > 0 ? (flat.map((value) => value / length) as Vector) : null;
}

/** The angle from one direction of a tangent plane to another, counterclockwise. */
const angleFrom = (a: Vector, b: Vector, normal: Vector) =>
  Math.atan2(dot(cross(a, b), normal), dot(a, b));

/**
 * A stroke in the plane. At each sample, `direction` on the surface corresponds to `angle` in the
 * plane.
 */
interface RolledOut {
  places: Planar[];
  frames: { direction: Vector; angle: number }[];
}

export function rolledOut(samples: readonly Pick<StrokeSample, 'place' | 'normal'>[]): RolledOut {
  const places: Planar[] = [[0, 0]];
  const frames: RolledOut['frames'] = [];
  let angle = 0;
  for (const [i, { place, normal }] of samples.entries()) {
    const [before, next] = [samples[i - 1], samples[i + 1]];
    const come = before ? directionIn(normal, minus(place, before.place)) : null;
    const go = next ? directionIn(normal, minus(next.place, place)) : null;
    if (come && go) angle += angleFrom(come, go, normal);
    frames.push({ direction: go ?? come ?? [1, 0, 0], angle });
    if (!next) continue;
    const length = Math.hypot(...minus(next.place, place));
    const [x, y] = places[i]!;
    places.push([x + length * Math.cos(angle), y + length * Math.sin(angle)]);
  }
  return { places, frames };
}

/** A vector of the plane as a handle at a sample. */
function handleAt(
  { normal }: StrokeSample,
  { direction, angle }: RolledOut['frames'][number],
  [x, y]: Planar,
): { direction: Vector; length: number } | null {
  const length = Math.hypot(x, y);
  if (!(length > 0)) return null;
  const turn = Math.atan2(y, x) - angle;
  const aside = cross(normal, direction);
  const turned = along([0, 0, 0], direction, Math.cos(turn));
  return { direction: along(turned, aside, Math.sin(turn)), length };
}

/**
 * The anchors of a curve near a stroke of at least two samples, with corners at the stroke's sharp
 * turns and at `breaks`. For a closed curve, the last sample is the first one again. The piece
 * after an anchor has the origin of its samples, if `originOf` gives one.
 */
export function anchorsOf(
  samples: readonly StrokeSample[],
  closed: boolean,
  { breaks, originOf }: LinePieces = { breaks: [], originOf: () => undefined },
): ControlPoint[] {
  const { places, frames } = rolledOut(samples);
  const last = samples.length - 1;
  const pixel = samples.reduce((sum, one) => sum + one.pixel, 0) / samples.length;
  const reach = reachPixels * pixel;
  const turns = cornersOf(places, { reach, angle: cornerAngle });
  const corners = [...new Set([...turns, ...breaks])].sort((a, b) => a - b);
  const tolerances = samples.map(({ tolerance }) => tolerance);
  const [first, end] = [frames[0]!, frames[last]!];
  // In the plane, the same direction at the seam has different angles at the start and the end of
  // the stroke.
  const turn = end.angle + angleFrom(end.direction, first.direction, samples[last]!.normal);
  const options = { tolerances, corners, reach, ...(closed && { loop: { turn, cornerAngle } }) };
  const { pieces, isSmoothSeam } = fittedCubics(places, options);
  const count = pieces.length + (closed ? 0 : 1);
  return Array.from({ length: count }, (_, i) => {
    const [before, after] = [pieces[i - 1] ?? (closed ? pieces.at(-1) : undefined), pieces[i]];
    const at = after?.from ?? last;
    const told = (which: number, [from, to]: readonly [Planar, Planar]) =>
      handleAt(samples[which]!, frames[which]!, [to[0] - from[0], to[1] - from[1]]);
    const ahead = after && told(after.from, [after.cubic[0], after.cubic[1]]);
    const back = before && told(before.to, [before.cubic[3], before.cubic[2]]);
    const isSmooth = i === 0 ? isSmoothSeam : !corners.includes(at);
    const opposite: Tangent | null | undefined =
      isSmooth && ahead && back ? { length: back.length } : back;
    const tangents: Tangents = {
      ...(ahead && { after: ahead }),
      ...(opposite && { before: opposite }),
    };
    const anchor = withTangents(samples[at]!.point, tangents);
    return after ? withOrigin(anchor, originOf(after.from, after.to)) : anchor;
  });
}
