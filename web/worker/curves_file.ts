/** Curves as files, with the surface that they lie on. */
import type { Mesh, SurfacePoint } from 'karcher';
import type { FileMarks, FilePath } from 'karcher/formats';
import type { CurvesFormat, DrawnCurve } from '../model/drawn_curves';

/** A curve in a message to the worker: with the arrays of its path, whose methods do not pass. */
export interface SentCurve extends Omit<DrawnCurve, 'path'> {
  closed: boolean;
  points: readonly SurfacePoint[];
  polyline: Float64Array;
  lengths: Float64Array;
}

export const sentCurve = ({ path, ...rest }: DrawnCurve): SentCurve => ({
  ...rest,
  closed: path.closed,
  points: path.points(),
  polyline: path.polyline({ bits: 64 }),
  lengths: path.lengths(),
});

const pathOf = ({ closed, points, polyline, lengths }: SentCurve): FilePath => ({
  closed,
  count: points.length,
  points: () => points,
  polyline: () => polyline,
  lengths: () => lengths,
});

/**
 * Rows of the curves' points as CSV, or the surface with its own colors and parts, and the curves
 * as lines of an OBJ file or tubes of a GLB file.
 */
export async function curvesFile(
  mesh: Mesh,
  curves: readonly SentCurve[],
  format: CurvesFormat,
  marks: FileMarks | null,
): Promise<Uint8Array> {
  const { curvesCsv, meshFile, pathParameters } = await import('karcher/formats');
  const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
  if (format === 'csv') {
    const rows = curves.map((curve) => {
      const path = pathOf(curve);
      const parameters = curve.samples && pathParameters(path, curve.samples);
      return { name: curve.name, path, parameters };
    });
    return new TextEncoder().encode(curvesCsv(rows, surface));
  }
  const { colors = null, parts, partOf = null } = marks ?? {};
  const written = curves.map((curve) => ({
    name: curve.name,
    path: pathOf(curve),
    ...(format === 'glb' && { radius: curve.radius }),
    // In OBJ a colored curve would make the whole surface white.
    ...((format === 'glb' || colors) && { color: curve.color }),
  }));
  return meshFile({ ...surface, colors, parts, partOf, curves: written }, format);
}
