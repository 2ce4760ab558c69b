/** Removal of pen anchors: one segment takes the place of two, as near to them as possible. */
import type { SurfacePoint } from 'karcher';
import type { Cubic, Planar } from '../../model/cubic_fit';
import {
  type ControlPoint,
  type Figure,
  plain,
  type Side,
  type Vector,
  withLeg,
} from '../../model/figure';
import { withHandleAt, withHandleLength } from '../../model/pen';
import type { DrawnTangents } from '../../model/pen_legs';
import { mergedCubic } from '../../model/pen_shape';
import { cross, dot, scaled } from '../../model/vectors';
import type { EngineClient } from '../../worker/client';
import { directionOf } from './circle_drawing';
import { drawnTangents } from './pen_drawing';

const minus = (a: Planar, b: Planar): Planar => [a[0] - b[0], a[1] - b[1]];

/** A point's tangent plane with its log and exponential maps, in coordinates of the plane. */
class LogPlane {
  readonly #x: Vector;
  readonly #y: Vector;

  private constructor(
    private readonly client: EngineClient,
    private readonly at: SurfacePoint,
    [p, q, r]: readonly [Vector, Vector, Vector],
  ) {
    const side = (to: Vector) => to.map((value, axis) => value - p[axis]!) as Vector;
    const normal = cross(side(q), side(r));
    this.#x = scaled(side(q), 1 / Math.hypot(...side(q)));
    const y = cross(normal, this.#x);
    this.#y = scaled(y, 1 / Math.hypot(...y));
  }

  static async of(client: EngineClient, at: SurfacePoint): Promise<LogPlane> {
    return new LogPlane(client, at, await client.corners(at.face));
  }

  async log(point: SurfacePoint): Promise<Planar> {
    const path = await this.client.mesh.shortestPath(plain(this.at), plain(point));
    if (!(path.length > 0)) return [0, 0];
    const direction = directionOf(path.polyline({ bits: 64 }));
    const [x, y] = [dot(direction, this.#x), dot(direction, this.#y)];
    const factor = path.length / (Math.hypot(x, y) || 1);
    return [factor * x, factor * y];
  }

  async exp([x, y]: Planar): Promise<SurfacePoint> {
    const direction = this.#x.map((value, axis) => x * value + y * this.#y[axis]!) as Vector;
    const length = Math.hypot(x, y);
    return (await this.client.mesh.straightest(plain(this.at), direction, length)).end;
  }
}

/**
 * The figure without an anchor. One segment replaces the two segments at the anchor, as near to
 * them as possible.
 */
export async function withoutAnchor(
  client: EngineClient,
  figure: Figure,
  index: number,
): Promise<Figure> {
  const { points, settings } = figure;
  const count = points.length;
  const [before, after] = [(index + count - 1) % count, (index + 1) % count];
  // The leg to the anchor disappears with it.
  const without = (changed: readonly ControlPoint[]): Figure => ({
    ...figure,
    points: changed.with(before, withLeg(changed[before]!, null)).toSpliced(index, 1),
  });
  const closed = settings.closed && count > 2;
  const isEnd = !closed && (index === 0 || index === count - 1);
  const drawn = await drawnTangents(client, figure);
  const handles = [
    drawn[before]?.after,
    drawn[index]?.before,
    drawn[index]?.after,
    drawn[after]?.before,
  ];
  // Straight sides stay straight.
  if (isEnd || !handles.some((handle) => handle)) return without(points);
  const plane = await LogPlane.of(client, points[index]!);
  const at = (handle: (typeof handles)[number], anchor: number) =>
    plane.log(handle?.point ?? points[anchor]!);
  const [start, first, second, third, fourth, end] = await Promise.all([
    plane.log(points[before]!),
    ...[at(handles[0], before), at(handles[1], index), at(handles[2], index)],
    ...[at(handles[3], after), plane.log(points[after]!)],
  ]);
  const middle: Planar = [0, 0];
  const merged = mergedCubic([start!, first!, second!, middle], [middle, third!, fourth!, end!], {
    start: handles[0] ? unit(minus(first!, start!)) : null,
    end: handles[3] ? unit(minus(fourth!, end!)) : null,
  });
  const changed = await Promise.all([
    withHandle(plane, points[before]!, drawn[before]!, 'after', merged),
    withHandle(plane, points[after]!, drawn[after]!, 'before', merged),
  ]);
  if (before !== after) return without(points.with(before, changed[0]).with(after, changed[1]));
  // A closed curve of two anchors keeps one, which then has both handles.
  return without(points.with(before, changed[0]));
}

const unit = ([x, y]: Planar): Planar => {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
};

/**
 * The anchor at one end of the merged segment, with its handle there: the old handle with another
 * length, or a new one.
 */
async function withHandle(
  plane: LogPlane,
  anchor: ControlPoint,
  drawn: DrawnTangents,
  side: Side,
  [start, first, second, end]: Cubic,
): Promise<ControlPoint> {
  const [from, to] = side === 'after' ? [start, first] : [end, second];
  const length = Math.hypot(...minus(to, from));
  if (drawn[side]) return withHandleLength(anchor, drawn, side, length);
  if (!(length > 0)) return anchor;
  const place = await plane.exp(to);
  const options = { broken: false };
  return { ...anchor, tangents: withHandleAt(anchor.tangents, drawn, side, place, options) };
}
