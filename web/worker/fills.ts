/** The regions that lines enclose, as the triangles that the page paints. */
import {
  type Curve,
  KarcherError,
  type Mesh,
  type Path,
  type Region,
  type SurfacePoint,
} from 'karcher';
import type { Enclosing } from '../model/figure';
import type { Fill } from '../model/traced';
import { filledSides } from './filled_sides';
import { withTouched } from './touched_faces';

/** The region that a curve, or several paths together, enclose. */
export function fillOf(
  mesh: Mesh,
  lines: Curve | readonly SurfacePoint[][],
  enclosing: Enclosing,
): Fill {
  const outlines = Array.isArray(lines) ? lines : [(lines as Curve).path()];
  return painted(mesh, () => regionOf(mesh, { outlines, ...enclosing }));
}

/** A shape's region. */
export const regionOf = (
  mesh: Mesh,
  { rule, ...shape }: Enclosing & { outlines: readonly (Path | SurfacePoint[])[] },
): Region => mesh.regions([shape], rule ? { rule } : {})[0]!;

/** The centroid of the region with a boundary and a point inside. */
export async function centroidOf(
  mesh: Mesh,
  outlines: readonly SurfacePoint[][],
  inside: SurfacePoint,
): Promise<SurfacePoint> {
  const { centroid } = await import('karcher/statistics');
  const [region] = mesh.regions([{ outlines, inside }]);
  return (await centroid(mesh, region!)).point;
}

/** A region in its painted form, or the reason why it does not exist. */
export function painted(mesh: Mesh, regionOf: () => Region): Fill {
  try {
    const region = regionOf();
    const { share, triangles, sides, isLeft } = region.data();
    const side = isLeft === undefined ? null : isLeft ? 'left' : 'right';
    const whole = share.reduce((sum, part) => sum + (part === 1 ? 1 : 0), 0);
    const faces = new Int32Array(whole);
    let next = 0;
    for (let face = 0; face < share.length; face++) if (share[face] === 1) faces[next++] = face;
    const { whole: left, ...open } = withTouched(
      faces,
      { faces: triangles, sides },
      mesh.triangles(),
    );
    const filled = filledSides(open.faces, open.sides);
    return {
      region: { whole: left, ...filled, area: region.area, boundary: region.boundary(), side },
      problem: null,
    };
  } catch (error) {
    if (error instanceof KarcherError) return { region: null, problem: error.message };
    throw error;
  }
}
