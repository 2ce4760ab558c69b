/** Curves as files, with the surface that they lie on. */
import type { CutPart, Mesh, SurfacePoint } from 'karcher';
import type { FileCurve, FileMarks, FilePath, Triangles, WrittenFormat } from 'karcher/formats';
import type { CurvesFormat, DrawnCurve } from '../model/drawn_curves';

/**
 * A curve in a message to the worker. It has the arrays of the path, since methods cannot be sent.
 */
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
 * A file of curves. A CSV file has rows of the curves' points. Other files have the surface with
 * its own colors and parts, and the curves as lines (OBJ) or as tubes (GLB).
 */
export async function curvesFile(
  mesh: Mesh,
  curves: readonly SentCurve[],
  format: CurvesFormat,
  marks: FileMarks | null,
): Promise<Uint8Array> {
  const { curvesCsv, meshFile, pathParameters } = await import('karcher/formats');
  if (format === 'csv') {
    const rows = curves.map((curve) => {
      const path = pathOf(curve);
      const parameters = curve.samples && pathParameters(path, curve.samples);
      return { name: curve.name, path, parameters };
    });
    return new TextEncoder().encode(curvesCsv(rows, mesh));
  }
  const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
  const { colors = null, parts, partOf = null } = marks ?? {};
  const written = writtenCurves(curves, format, colors !== null);
  return meshFile({ ...surface, colors, parts, partOf, curves: written }, format);
}

/** A part of the cut surface, with its file's properties and the pieces of curves that lie on it. */
export async function partFile(
  mesh: Mesh,
  part: CutPart,
  thick: Triangles | null,
  format: WrittenFormat,
  {
    marks,
    sheets,
    curves,
  }: { marks: FileMarks | null; sheets: 1 | 2; curves: readonly SentCurve[] },
): Promise<Uint8Array> {
  const { curvesOnPart, marksOfPart, meshFile } = await import('karcher/formats');
  const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
  const said = marks && marksOfPart(part, surface, marks, { sheets });
  const written = writtenCurves(curves, format, Boolean(said?.colors));
  return meshFile(
    { ...(thick ?? part), ...said, curves: curvesOnPart(part, surface, written) },
    format,
  );
}

/** Curves in the form of a file: tubes in GLB, and lines in the other formats. */
const writtenCurves = (
  curves: readonly SentCurve[],
  format: WrittenFormat,
  isColored: boolean,
): FileCurve[] =>
  curves.map((curve) => ({
    name: curve.name,
    path: pathOf(curve),
    ...(format === 'glb' && { radius: curve.radius }),
    // In OBJ and PLY a colored curve would make the whole surface white.
    ...((format === 'glb' || isColored) && { color: curve.color }),
  }));
