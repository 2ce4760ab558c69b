/** Figures that are moved as a whole: which of their places and directions go along, and how. */
import type { SurfacePoint } from 'karcher';
import { type Figure, type Vector, withPlaces } from './figure';
import { type Tangent, type Tangents, withTangents } from './pen';

/** Every place of a figure on the surface, each once. */
export function placesOf(figure: Figure): SurfacePoint[] {
  const places = new Set<SurfacePoint>();
  withPlaces(figure, (place) => {
    places.add(place);
    return place;
  });
  return [...places];
}

/** The figure with its places moved and its directions turned. */
export function movedFigure(
  figure: Figure,
  move: (place: SurfacePoint) => SurfacePoint,
  turn: (direction: Vector) => Vector,
): Figure {
  const moved = withPlaces(figure, move);
  const turned = (tangent: Tangent): Tangent =>
    'direction' in tangent ? { ...tangent, direction: turn(tangent.direction) } : tangent;
  const withTurned = ({ before, after }: Tangents): Tangents => ({
    ...(before && { before: turned(before) }),
    ...(after && { after: turned(after) }),
  });
  const { circle } = moved;
  const rim = circle && 'direction' in circle.rim ? circle.rim : null;
  return {
    ...moved,
    points: moved.points.map((point) =>
      point.tangents ? withTangents(point, withTurned(point.tangents)) : point,
    ),
    circle: circle && rim ? { ...circle, rim: { ...rim, direction: turn(rim.direction) } } : circle,
  };
}
