import type { ComparedMethod, MethodResult } from 'karcher/peers';
import { pathFigure } from '../figures/means';
import { smallerMesh } from '../figures/small';
import { galleryFigure, resolutionFigure } from '../figures/splines';
import type { MeshSpec, Vector } from '../figures/types';

/**
 * A row of Table 1: a curve on a mesh. As in the paper, the control points are at vertices, for all
 * methods.
 */
export interface TableRow {
  id: string;
  name: string;
  mesh: MeshSpec;
  /** The control points: two for a shortest path with exact distances, more for a B-spline. */
  points: readonly Vector[];
}

/** The methods of the paper's table, the affine heat method, our level 0 and our default. */
export const tableMethods = [
  'vectorHeat',
  'affineHeat',
  'weightedAverages',
  'paper',
  'karcher',
  'leveled',
] as const satisfies ComparedMethod[];

export type TableMethod = (typeof tableMethods)[number];

export const tableMethodNames: Record<TableMethod, string> = {
  vectorHeat: 'Vector heat',
  affineHeat: 'Affine heat',
  weightedAverages: 'Weighted averages',
  paper: 'Paper',
  karcher: 'Karcher, level 0',
  leveled: 'Karcher, default',
};

const pair = pathFigure.points.pair!;
const { bunny, knot, torus } = galleryFigure.points as Record<string, Vector[]>;
const genus3 = resolutionFigure.points.spline!;

const shape = (name: 'torus' | 'knot' | 'genus3', triangles: number): MeshSpec => ({
  kind: 'shape',
  name,
  triangles,
});
const simplified = (of: MeshSpec, triangles: number): MeshSpec => ({
  kind: 'simplified',
  of,
  triangles,
});

export const tableRows: readonly TableRow[] = [
  {
    id: 'path-coarse',
    name: 'Path, simplified torus',
    mesh: simplified(shape('torus', 50_000), 500),
    points: pair,
  },
  { id: 'path-fine', name: 'Path, regular torus', mesh: shape('torus', 50_000), points: pair },
  {
    id: 'genus3-1k',
    name: 'Genus 3, simplified',
    mesh: simplified(shape('genus3', 50_000), 1_000),
    points: genus3,
  },
  { id: 'bunny-4k', name: 'Bunny', mesh: { kind: 'bunny', levels: 0 }, points: bunny! },
  { id: 'knot-10k', name: 'Knotted tube', mesh: shape('knot', 10_000), points: knot! },
  { id: 'torus-20k', name: 'Torus', mesh: shape('torus', 20_000), points: torus! },
  { id: 'bunny-59k', name: 'Bunny', mesh: { kind: 'bunny', levels: 2 }, points: bunny! },
  { id: 'torus-100k', name: 'Torus', mesh: shape('torus', 100_000), points: torus! },
  { id: 'genus3-250k', name: 'Genus 3', mesh: shape('genus3', 250_000), points: genus3 },
  { id: 'knot-500k', name: 'Knotted tube', mesh: shape('knot', 500_000), points: knot! },
];

/** The rows on meshes with a fraction of the triangles, for quick tests. */
export const smallRows = (part: number): TableRow[] =>
  tableRows.map((row) => ({ ...row, mesh: smallerMesh(row.mesh, part) }));

/** The approximate number of a row's triangles, before its mesh exists. */
export function expectedTriangles(mesh: MeshSpec): number {
  return mesh.kind === 'bunny' ? 3_674 * 4 ** mesh.levels : mesh.triangles;
}

/** The number of segments: one between two points, else three fewer than the points. */
export const segmentsOf = ({ points }: TableRow): number =>
  points.length === 2 ? 1 : points.length - 3;

/** A cell: the result of a method in a row. */
export interface TableCell {
  row: string;
  method: TableMethod;
  triangles: number;
  segments: number;
  result: MethodResult;
}

/**
 * The paper's own times, from its authors' machine, for an update of a curve with 256 samples a
 * segment. The curve is on the lion, a mesh that we do not have. The times of the paper's Table 1
 * are not known here.
 */
export const published = { samples: 256, updateMs: 197, fieldMs: 161, segmentMs: 10 };

/** A note on the paper's times beside ours. */
export const publishedNote = `The paper’s own times are of its authors’ machine and of meshes that are not at hand, and those of its Table 1 are not kept here, so none stand beside ours. Of its text: on the lion, with ${published.samples} samples a segment, an update took ${published.updateMs} ms, ${published.fieldMs} of them the field and about ${published.segmentMs} each segment.`;

/**
 * An estimate of a heat method's tracing time if it computed a log map at each evaluation, like its
 * authors' library. It follows from the time of the computed maps and from the number of requested
 * ones. Null for methods without log maps, and for log maps without a time, as in older reports.
 */
export function asUsedMs({ traceMs, logMaps }: MethodResult): number | null {
  if (traceMs === null || !logMaps?.ms) return null;
  const { made, asked, ms } = logMaps;
  return traceMs + (ms * (asked - made)) / made;
}
