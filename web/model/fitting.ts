/**
 * Fits drawings to a surface that has fewer triangles than their own surface: leaves out what lies
 * on the missing triangles.
 */
import type { SurfacePoint } from 'karcher';
import type { Drawing, DrawnObject } from './drawing';
import { type ControlPoint, type Figure, isEmpty, withFittingKnots, withLeg } from './figure';
import { withTangents } from './pen';

/**
 * The points that lie on a surface with this many triangles. A point keeps its leg if the leg also
 * lies there and joins the same neighbours as before. A point loses both handles if one lies
 * outside.
 */
function fittingPoints(points: readonly ControlPoint[], triangles: number): ControlPoint[] {
  const fits = ({ face }: SurfacePoint) => face < triangles;
  const fitting = ({ tangents }: ControlPoint) => {
    const all = [tangents?.before, tangents?.after];
    return all.every((tangent) => !tangent || !('face' in tangent) || fits(tangent));
  };
  // A point of the pen that loses its handles also loses the ends of its legs.
  const stays = (point: ControlPoint) => fits(point) && fitting(point);
  const holds = (i: number) =>
    points[i]!.leg?.every(fits) && stays(points[i]!) && stays(points[i + 1] ?? points[0]!)
      ? points[i]!.leg
      : null;
  return points
    .map((point, i) => withLeg(point, holds(i)))
    .map((point) => (fitting(point) ? point : withTangents(point, undefined)))
    .filter(fits);
}

/** The figure without what lies outside a surface with this many triangles. */
function fittingFigure(figure: Figure, triangles: number): Figure {
  const fits = (place: object) => !('face' in place) || (place as SurfacePoint).face < triangles;
  const { circle, derived } = figure;
  const circleFits = circle && [circle.center, circle.rim, circle.across ?? {}].every(fits);
  return withFittingKnots({
    ...figure,
    points: fittingPoints(figure.points, triangles),
    circle: circleFits ? circle : null,
    ...(derived?.parts && {
      derived: { ...derived, parts: derived.parts.filter(({ point }) => fits(point)) },
    }),
  });
}

/**
 * The objects without what lies outside a surface with this many triangles. Objects of which
 * nothing is left disappear.
 */
export const fittingObjects = (objects: readonly DrawnObject[], triangles: number) =>
  objects
    .map((object) => ({ ...object, figure: fittingFigure(object.figure, triangles) }))
    .filter(({ figure }) => !isEmpty(figure));

/**
 * The drawing without what lies outside a surface with this many triangles. Objects of which
 * nothing is left disappear, except the edited one.
 */
export function fitting(drawing: Drawing, triangles: number): Drawing {
  const { active } = drawing;
  const objects = drawing.objects.map((object) => ({
    ...object,
    figure: fittingFigure(object.figure, triangles),
  }));
  return { objects: objects.filter(({ id, figure }) => id === active || !isEmpty(figure)), active };
}
