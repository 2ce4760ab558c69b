/**
 * Recognizes moves and mirrors that would tear a figure: neighbouring points would end far apart.
 */
import { Vector3 } from 'three';
import type { DrawnObject } from '../../model/drawing';
import { type ControlPoint, type Figure, isCurve } from '../../model/figure';
import type { Surface } from '../../viewer/surface';
import type { EngineClient } from '../../worker/client';

/**
 * A figure counts as torn if a leg becomes longer by more than this factor. A move to a place of
 * another curvature also stretches figures, but less; points on both sides of a cut locus separate
 * at once.
 */
const mostStretch = 4;

/**
 * Whether objects would be torn if these figures replaced the objects' own figures. They are
 * `scale` times as large.
 */
export async function isTorn(
  client: EngineClient,
  surface: Surface,
  objects: readonly DrawnObject[],
  figures: readonly Figure[],
  scale = 1,
): Promise<boolean> {
  const [from, to] = [new Vector3(), new Vector3()];
  const apart = (a: ControlPoint, b: ControlPoint) =>
    surface.position(a, from).distanceTo(surface.position(b, to));
  for (const [i, { figure }] of objects.entries()) {
    if (!isCurve(figure.kind)) continue;
    const { points } = figure;
    const moved = figures[i]!.points;
    const legs = figure.settings.closed ? points.length : points.length - 1;
    for (let leg = 0; leg < legs; leg++) {
      const next = (leg + 1) % points.length;
      const is = apart(moved[leg]!, moved[next]!) / (mostStretch * scale);
      if (is <= apart(points[leg]!, points[next]!)) continue;
      // The distance in space may mislead: the two sides of an ear are near each other in space,
      // but not along the surface.
      const [begin, end] = [points[leg]!, points[next]!];
      const way = await client.mesh.shortestPath(
        { face: begin.face, bary: begin.bary },
        { face: end.face, bary: end.bary },
      );
      if (is > way.length * surface.frame.scale) return true;
    }
  }
  return false;
}
