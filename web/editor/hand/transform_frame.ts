/**
 * The frame round selected objects: a rectangle in the tangent plane of the pivot, which the exp
 * map lays on the surface.
 */
import type { SurfacePoint } from 'karcher';
import { Vector3 } from 'three';
import type { DrawnObject } from '../../model/drawing';
import { isRound, plain, type Vector } from '../../model/figure';
import { type Carried, type CarriedTo, placesOf } from '../../model/moving';
import type { Surface } from '../../viewer/surface';
import type { EngineClient } from '../../worker/client';
import type { Box, Extent } from '../../worker/extent';
import type { ObjectLines } from '../engine/lines';
import { faceNormal } from '../engine/moving';

export interface TransformFrame {
  pivot: SurfacePoint;
  /** The frame's first axis, a unit vector in the plane of the pivot's face. */
  right: Vector;
  /**
   * The sides of the frame, as distances from the pivot along the first axis and along the second
   * axis to its left.
   */
  box: Box;
  /** The size of the contents, without the frame's margin. */
  size: Size;
}

/** The extents along the frame's first axis and across it, in the surface's unit. */
export interface Size {
  width: number;
  height: number;
}

export type FrameHandle = 'turn' | 'move' | 'pivot' | 'scale-1' | 'scale-2' | 'scale-3' | 'scale-4';

export interface ShownFrame {
  /** The lines, in the scene. */
  lines: Float32Array[];
  handles: { id: FrameHandle; position: Vector3 }[];
}

/**
 * Distances relative to the surface's diagonal: from the selection to the frame, and from the frame
 * to the turning handle.
 */
const margin = 0.02;
const stalk = 0.05;
/**
 * About `measured` points on all lines together determine a frame. If there are many lines, each
 * still contributes up to `fewestMeasured` points.
 */
const measured = 512;
const fewestMeasured = 16;
/** The number of pieces of each side. */
const piecesOfSide = 16;

/** The second axis, to the left of the first one. */
export async function acrossFrame(
  client: EngineClient,
  surface: Surface,
  { pivot, right }: Pick<TransformFrame, 'pivot' | 'right'>,
): Promise<Vector> {
  const normal = await faceNormal(client, surface, pivot);
  return normal.cross(new Vector3(...right)).toArray();
}

/** A unit direction in the plane of a point's face. */
async function inPlane(
  client: EngineClient,
  surface: Surface,
  at: SurfacePoint,
  along: Vector,
): Promise<Vector> {
  const normal = await faceNormal(client, surface, at);
  const projected = new Vector3(...along).projectOnPlane(normal);
  // If `along` is nearly normal to the plane, another direction replaces it.
  if (projected.length() < 1e-3) projected.set(normal.z, normal.x, normal.y).projectOnPlane(normal);
  return projected.normalize().toArray();
}

/**
 * The frame around places, with its first axis along `right`. Its pivot is the given one or,
 * without it, the middle of the places.
 */
export async function frameOf(
  client: EngineClient,
  surface: Surface,
  around: readonly Extent[],
  right: Vector,
  pivot: SurfacePoint | null,
): Promise<TransformFrame> {
  const boxAt = async (at: SurfacePoint) => {
    const axis = await inPlane(client, surface, at, right);
    const across = await acrossFrame(client, surface, { pivot: at, right: axis });
    const box = await client.boxAround(at, around, [axis, across]);
    return { axis, across, box };
  };
  let at = pivot;
  if (!at) {
    const from = plain(around[0]!.place);
    const { axis, across, box } = await boxAt(from);
    const x = (box.left + box.right) / 2;
    const y = (box.bottom + box.top) / 2;
    const { points } = await client.mesh.expMap(
      from,
      [0, 1, 2].map((k) => x * axis[k]! + y * across[k]!),
    );
    at = points[0]!;
  }
  const { axis, box } = await boxAt(at);
  const more = margin * client.info.diagonal;
  return {
    pivot: plain(at),
    right: axis,
    box: {
      left: box.left - more,
      right: box.right + more,
      bottom: box.bottom - more,
      top: box.top + more,
    },
    size: { width: box.right - box.left, height: box.top - box.bottom },
  };
}

/**
 * The extents of objects. An object is measured by points of its lines, or by its places if it has
 * no line; a circle with a stored radius is measured by its center and radius.
 */
export function extentsOf(
  objects: readonly DrawnObject[],
  lines: readonly ObjectLines[],
): Extent[] {
  const paths = new Map(lines.map(({ id, paths }) => [id, paths]));
  const count = lines.reduce((sum, line) => sum + line.paths.length, 0);
  const most = Math.max(fewestMeasured, Math.floor(measured / Math.max(1, count)));
  return objects.flatMap(({ id, figure }) => {
    const { circle, kind } = figure;
    if (kind === 'circle' && circle && 'radius' in circle.rim) {
      return [{ place: circle.center, radius: circle.rim.radius }];
    }
    const along = (paths.get(id) ?? []).flatMap((path) => {
      const points = path.points();
      const every = Math.ceil(points.length / most);
      return points.filter((_, i) => i % every === 0 || i === points.length - 1);
    });
    const own = placesOf(isRound(kind) ? { ...figure, points: [] } : { ...figure, circle: null });
    return (along.length > 0 ? along : own).map((place) => ({ place, radius: 0 }));
  });
}

/** The points of a frame that a move carries along. */
export const carriedFrame = ({ pivot, right }: TransformFrame): Carried[] => [
  { place: pivot, direction: null },
  { place: pivot, direction: right },
];

/** The frame at its new place, scaled with its contents. */
export function frameAt(
  { box, size }: TransformFrame,
  { points, directions }: CarriedTo,
  scale: number,
): TransformFrame {
  const right = new Vector3().fromArray(directions, 3).normalize().toArray();
  return {
    pivot: plain(points[0]!),
    right,
    box: {
      left: scale * box.left,
      right: scale * box.right,
      bottom: scale * box.bottom,
      top: scale * box.top,
    },
    size: { width: scale * size.width, height: scale * size.height },
  };
}

/** The frame as it lies on the surface. */
export async function shownFrame(
  client: EngineClient,
  surface: Surface,
  frame: TransformFrame,
): Promise<ShownFrame> {
  const { pivot, right, box } = frame;
  const across = await acrossFrame(client, surface, frame);
  const corners: [number, number][] = [
    [box.left, box.bottom],
    [box.right, box.bottom],
    [box.right, box.top],
    [box.left, box.top],
  ];
  const middle = (box.left + box.right) / 2;
  const tip = box.top + stalk * client.info.diagonal;
  const between = ([x0, y0]: [number, number], [x1, y1]: [number, number]) =>
    Array.from({ length: piecesOfSide + 1 }, (_, i): [number, number] => {
      const part = i / piecesOfSide;
      return [x0 + part * (x1 - x0), y0 + part * (y1 - y0)];
    });
  const sides = [
    ...corners.map((corner, i) => between(corner, corners[(i + 1) % 4]!)),
    between([middle, box.top], [middle, tip]),
  ];
  const places = [...sides.flat(), [middle, box.bottom] as const];
  const vectors = places.flatMap(([x, y]) => [0, 1, 2].map((k) => x * right[k]! + y * across[k]!));
  const { points } = await client.mesh.expMap(pivot, vectors);
  const positions = points.map((point) => surface.position(point));
  const count = piecesOfSide + 1;
  const lines = sides.map((_, side) =>
    Float32Array.from(
      positions.slice(side * count, (side + 1) * count).flatMap((position) => position.toArray()),
    ),
  );
  const handles: ShownFrame['handles'] = [
    ...[0, 1, 2, 3].map((i) => ({
      id: `scale-${i + 1}` as FrameHandle,
      position: positions[i * count]!,
    })),
    { id: 'turn', position: positions[5 * count - 1]! },
    { id: 'move', position: positions[5 * count]! },
    { id: 'pivot', position: surface.position(pivot) },
  ];
  return { lines, handles };
}
