import { shown } from '../check.js';
import { KarcherError } from '../errors.js';
import type { Mesh } from '../mesh.js';
import type { CurveSamples, SurfacePoint } from '../types.js';

/** The properties of a path that files need; a `Path` has them. */
export interface FilePath {
  /** Whether the path ends where it starts. */
  readonly closed: boolean;
  /** The number of points. */
  readonly count: number;
  /** The path's points. */
  points(): readonly SurfacePoint[];
  /** x, y, z of each point. */
  polyline(options: { bits: 64 }): Float64Array;
  /** The length from the start to each point. */
  lengths(): Float64Array;
}

/** A curve to write to a file. */
export interface FileCurve {
  /** The curve's name. */
  name?: string | undefined;
  /** The curve as a path on the surface, such as the result of `Curve.path`. */
  path: FilePath;
  /**
   * The parameter of each point of the path, for CSV; `pathParameters` returns them for a curve.
   */
  parameters?: ArrayLike<number> | null | undefined;
  /** Red, green and blue, 0 to 255. */
  color?: readonly [number, number, number] | undefined;
  /** The radius of a tube along the curve; without a radius the curve is a line. */
  radius?: number | undefined;
  /** The number of sides of the tube's cross section, 3 to 64; 8 by default. */
  sides?: number | undefined;
}

/**
 * Curves as text of comma-separated values. The first row has the names of the columns; each other
 * row has a point of a path: its place, the normal of its face, the face, the barycentric weights
 * in it, and the length from the start. Numbers are written to the last bit. If a curve has
 * parameters, there is a column for parameters. If there are several curves, there is a column for
 * their names. `surface` is the curves' mesh, or its positions and triangles. The latter do not say
 * which triangles the import has turned over, so that the normals of these are the opposite ones.
 *
 * Throws `KarcherError` badArgument and badIndex.
 *
 * @example
 * ```ts
 * const text = curvesCsv([{ path: curve.path() }], mesh);
 * console.log(text.split('\n')[0]); // x,y,z,normal_x,normal_y,normal_z,face,…
 * ```
 */
export function curvesCsv(
  curves: readonly FileCurve[],
  surface: Pick<Mesh, 'normal'> | { positions: ArrayLike<number>; triangles: ArrayLike<number> },
): string {
  const several = curves.length > 1;
  const hasParameters = curves.some(({ parameters }) => parameters);
  const columns = [
    ...(several ? ['curve'] : []),
    ...['x', 'y', 'z', 'normal_x', 'normal_y', 'normal_z', 'face', 'bary_1', 'bary_2', 'bary_3'],
    'length',
    ...(hasParameters ? ['parameter'] : []),
  ];
  const rows = [columns.join(',')];
  curves.forEach(({ name, path, parameters }, number) => {
    const points = path.points();
    if (parameters && parameters.length !== points.length) {
      const what = `a curve of ${points.length} points needs as many parameters, not ${parameters.length}`;
      throw new KarcherError('badArgument', what);
    }
    const polyline = path.polyline({ bits: 64 });
    const lengths = path.lengths();
    const label = cell(name ?? `curve ${number + 1}`);
    points.forEach((point, i) => {
      const { face, bary } = point;
      rows.push(
        [
          ...(several ? [label] : []),
          ...polyline.subarray(3 * i, 3 * i + 3),
          ...('normal' in surface ? surface.normal(point) : normalOfFace(surface, face)),
          face,
          ...bary,
          lengths[i]!,
          ...(hasParameters ? [parameters ? parameters[i]! : ''] : []),
        ].join(','),
      );
    });
  });
  return `${rows.join('\n')}\n`;
}

/** A text as one cell, in quotation marks if it needs them. */
const cell = (text: string) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

function normalOfFace(
  { positions, triangles }: { positions: ArrayLike<number>; triangles: ArrayLike<number> },
  face: number,
): number[] {
  if (!(Number.isInteger(face) && face >= 0 && 3 * face + 2 < triangles.length)) {
    const what = `there is no face ${shown(face)}: there are ${triangles.length / 3}`;
    throw new KarcherError('badIndex', what);
  }
  const corner = (k: number) =>
    [0, 1, 2].map((axis) => positions[3 * triangles[3 * face + k]! + axis]!);
  return normalOf([corner(0), corner(1), corner(2)]);
}

/** The unit normal of a triangle; zero if it has no area. */
export function normalOf(corners: readonly ArrayLike<number>[]): number[] {
  const [a, b, c] = corners as [ArrayLike<number>, ArrayLike<number>, ArrayLike<number>];
  const [ux, uy, uz] = [b[0]! - a[0]!, b[1]! - a[1]!, b[2]! - a[2]!];
  const [vx, vy, vz] = [c[0]! - a[0]!, c[1]! - a[1]!, c[2]! - a[2]!];
  const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(...normal);
  return normal.map((value) => (length > 0 ? value / length : 0));
}

/**
 * The parameter of each point of a curve's path. A sample has its own parameter; between two
 * samples the parameter grows in proportion to the length. The samples are those of the same curve
 * or circle.
 *
 * @example
 * ```ts
 * const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
 * const path = curve.path();
 * curvesCsv([{ path, parameters: pathParameters(path, curve.samples()) }], surface);
 * ```
 */
export function pathParameters(
  path: FilePath,
  samples: Omit<CurveSamples, 'status'>,
): Float64Array {
  const polyline = path.polyline({ bits: 64 });
  const lengths = path.lengths();
  const { count } = path;
  const isAt = (vertex: number, sample: number) =>
    [0, 1, 2].every((k) => polyline[3 * vertex + k] === samples.position[3 * sample + k]);
  const parameterOf = (sample: number) => samples.segment[sample]! + samples.t[sample]!;
  const known: { vertex: number; parameter: number }[] = [];
  const last = samples.count - 1;
  for (let sample = 0, vertex = 0; sample < last; sample++) {
    let found = vertex;
    while (found < count && !isAt(found, sample)) found++;
    if (found === count) continue;
    known.push({ vertex: found, parameter: parameterOf(sample) });
    vertex = found;
  }
  // A bridge may miss the last sample, which is the path's end, by a rounding error.
  known.push({ vertex: count - 1, parameter: parameterOf(last) });
  const parameters = new Float64Array(count);
  known.forEach(({ vertex, parameter }, i) => {
    const next = known[i + 1] ?? { vertex, parameter };
    const length = lengths[next.vertex]! - lengths[vertex]!;
    for (let v = vertex; v <= next.vertex; v++) {
      const part = length > 0 ? (lengths[v]! - lengths[vertex]!) / length : 0;
      parameters[v] = parameter + part * (next.parameter - parameter);
    }
  });
  return parameters;
}
