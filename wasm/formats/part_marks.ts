import { KarcherError } from '../errors.js';
import type { CutPart } from '../types.js';
import type { FileMarks, Triangles } from './types.js';

/**
 * The marks of one part of a cut surface. A vertex gets the file's color at its place, interpolated
 * in the original triangle. A triangle gets the part of the file to which the original triangle
 * belongs. Spread the result into the argument of `meshFile`. `surface` has the positions and
 * triangles of the mesh that was cut; the third argument has the marks of its file.
 *
 * For a shell of the part, pass `sheets: 2`. The colors are then repeated for the second sheet, and
 * the result has no parts of the file, since the walls belong to none.
 *
 * Throws `KarcherError` badArgument if the file has another number of colors than the surface has
 * vertices.
 *
 * @example
 * ```ts
 * const { mesh, file } = await meshFromFile(karcher, bytes);
 * const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
 * for (const part of mesh.cut(paths)) {
 *   const written = meshFile({ ...part, ...marksOfPart(part, surface, file) }, 'ply');
 * }
 * ```
 */
export function marksOfPart(
  part: Pick<CutPart, 'positions' | 'triangles' | 'faces'>,
  surface: { positions: ArrayLike<number>; triangles: ArrayLike<number> },
  { colors, parts, partOf }: Pick<FileMarks, 'colors' | 'partOf'> & Pick<Triangles, 'parts'>,
  { sheets = 1 }: { sheets?: 1 | 2 } = {},
): Pick<Triangles, 'colors' | 'parts' | 'partOf'> {
  if (colors && colors.length !== surface.positions.length) {
    const sentence = `the file has ${colors.length / 3} colors, and the surface ${surface.positions.length / 3} vertices`;
    throw new KarcherError('badArgument', sentence);
  }
  return {
    ...(colors && { colors: repeated(colorsOfPart(part, surface, colors), sheets) }),
    ...(partOf &&
      sheets === 1 && { parts, partOf: Int32Array.from(part.faces, (f) => partOf[f]!) }),
  };
}

const repeated = (values: Uint8Array, times: number): Uint8Array => {
  const all = new Uint8Array(times * values.length);
  for (let i = 0; i < times; i++) all.set(values, i * values.length);
  return all;
};

function colorsOfPart(
  { positions, triangles, faces }: Pick<CutPart, 'positions' | 'triangles' | 'faces'>,
  surface: { positions: ArrayLike<number>; triangles: ArrayLike<number> },
  colors: Uint8Array,
): Uint8Array {
  const result = new Uint8Array(positions.length);
  const at = (of: ArrayLike<number>, vertex: number) =>
    [of[3 * vertex]!, of[3 * vertex + 1]!, of[3 * vertex + 2]!] as const;
  triangles.forEach((vertex, i) => {
    const face = faces[Math.floor(i / 3)]!;
    const corners = [0, 1, 2].map((k) => surface.triangles[3 * face + k]!);
    const weights = weightsIn(
      corners.map((corner) => at(surface.positions, corner)),
      at(positions, vertex),
    );
    for (let k = 0; k < 3; k++) {
      const mixed = corners.reduce((sum, c, j) => sum + weights[j]! * colors[3 * c + k]!, 0);
      result[3 * vertex + k] = Math.round(Math.min(255, Math.max(0, mixed)));
    }
  });
  return result;
}

/** The coordinates of a place. */
export type Place = readonly [number, number, number];

/**
 * The barycentric weights of a place in a triangle; those of the first corner if the triangle has
 * no area.
 */
export function weightsIn(corners: readonly Place[], place: Place): [number, number, number] {
  const [a, b, c] = corners as [Place, Place, Place];
  const [u, v, d] = [b, c, place].map((to) => to.map((x, k) => x - a[k]!));
  const dot = (p: number[], q: number[]) => p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
  const [uu, uv, vv, du, dv] = [dot(u!, u!), dot(u!, v!), dot(v!, v!), dot(d!, u!), dot(d!, v!)];
  const area = uu * vv - uv * uv;
  if (!(area > 0)) return [1, 0, 0];
  const [x, y] = [(vv * du - uv * dv) / area, (uu * dv - uv * du) / area];
  return [1 - x - y, x, y];
}
