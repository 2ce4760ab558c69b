/** Moves whole figures: their places, and their directions there. */
import type { SurfacePoint } from 'karcher';
import type { Tangent, Tangents } from './figure';
import { type CircleShape, type Figure, type Vector, withPlaces } from './figure';
import { withTangents } from './pen';

/** A place of a figure on the surface, or a direction that the figure has there. */
export interface Carried {
  place: SurfacePoint;
  direction: Vector | null;
}

/** The new places of carried points, and x, y, z of their carried directions. */
export interface CarriedTo {
  points: readonly SurfacePoint[];
  directions: Float64Array;
}

type Turn = (direction: Vector, at: SurfacePoint) => Vector;

/** Every place of a figure on the surface, each once. */
export function placesOf(figure: Figure): SurfacePoint[] {
  const places = new Set<SurfacePoint>();
  withPlaces(figure, (place) => {
    places.add(place);
    return place;
  });
  return [...places];
}

/** All places and directions that move with figures. */
export function carriedOf(figures: readonly Figure[]): Carried[] {
  const found = new Map<SurfacePoint, Set<Vector>>();
  for (const figure of figures) {
    for (const place of placesOf(figure)) if (!found.has(place)) found.set(place, new Set());
    withDirections(figure, figure, 1, (direction, at) => {
      found.get(at)!.add(direction);
      return direction;
    });
  }
  return [...found].flatMap(([place, directions]): Carried[] => [
    { place, direction: null },
    ...[...directions].map((direction) => ({ place, direction })),
  ]);
}

/**
 * The figures with the moved places and directions, and with their lengths multiplied by `scale`.
 */
export function movedFigures(
  figures: readonly Figure[],
  carried: readonly Carried[],
  { points, directions }: CarriedTo,
  scale: number,
): Figure[] {
  const places = new Map<SurfacePoint, SurfacePoint>();
  const turned = new Map<SurfacePoint, Map<Vector, Vector>>();
  for (const [i, { place, direction }] of carried.entries()) {
    const { face, bary } = points[i]!;
    if (!direction) places.set(place, { face, bary });
    else {
      const here = turned.get(place) ?? new Map<Vector, Vector>();
      turned.set(place, here.set(direction, [...directions.subarray(3 * i, 3 * i + 3)] as Vector));
    }
  }
  const turn: Turn = (direction, at) => turned.get(at)!.get(direction)!;
  return figures.map((figure) => {
    const moved = withPlaces(figure, (place) => places.get(place)!);
    return withDirections(moved, figure, scale, turn);
  });
}

/**
 * The figure with turned directions and scaled lengths. `turn` receives each direction with its
 * place in the original figure, `from`.
 */
function withDirections(figure: Figure, from: Figure, scale: number, turn: Turn): Figure {
  const tangentAt = (at: SurfacePoint, tangent: Tangent): Tangent => {
    if ('face' in tangent) return tangent;
    if (tangent.length === null) return tangent;
    const length = scale * tangent.length;
    return 'direction' in tangent
      ? { direction: turn(tangent.direction, at), length }
      : { ...tangent, length };
  };
  const tangentsAt = (at: SurfacePoint, { before, after }: Tangents): Tangents => ({
    ...(before && { before: tangentAt(at, before) }),
    ...(after && { after: tangentAt(at, after) }),
  });
  return {
    ...figure,
    points: figure.points.map((point, i) =>
      point.tangents ? withTangents(point, tangentsAt(from.points[i]!, point.tangents)) : point,
    ),
    circle: figure.circle && withRadii(figure.circle, from.circle!.center, scale, turn),
  };
}

function withRadii(
  { center, rim, across }: CircleShape,
  at: SurfacePoint,
  scale: number,
  turn: Turn,
): CircleShape {
  return {
    center,
    rim: 'face' in rim ? rim : { radius: scale * rim.radius, direction: turn(rim.direction, at) },
    ...(across && { across: 'face' in across ? across : { radius: scale * across.radius } }),
  };
}
