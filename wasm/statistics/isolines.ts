import { checkArray, checkNumber, toFloat64 } from '../check.js';
import { KarcherError } from '../errors.js';
import { Path } from '../path.js';
import type { AnyMesh } from './energy.js';
import { type LevelCrossing, levelLines } from './level_lines.js';
import { facesOf, firstOfWelded } from './surface.js';

/**
 * The lines on which a function has given levels: a list of paths for each level. The function has
 * one value for each vertex and is linear in triangles. Of welded vertices, the value of the first
 * counts. Lines that are not closed end on the boundary, or at triangles with a value that is not
 * finite. A level without points has no line.
 *
 * Lines of distances are those of `mesh.isolines` with the type `linear`.
 *
 * @throws {KarcherError} badArgument unless there is one value for each vertex, and notFinite for a
 *   level that is not finite. The promise rejects with it.
 * @example
 * ```ts
 * const height = Array.from({ length: mesh.info.vertices }, (_, v) => mesh.position({ vertex: v })[2]);
 * const [low, high] = await isolines(mesh, height, [-0.1, 0.1]);
 * ```
 */
export async function isolines(
  mesh: AnyMesh,
  values: ArrayLike<number>,
  levels: readonly number[],
): Promise<Path[][]> {
  const given = toFloat64(values, 'the values');
  const wanted = checkArray(levels, 'the levels').map((level, i) =>
    checkNumber(level, `level ${i}`),
  );
  const positions = await mesh.positions();
  if (given.length !== positions.length / 3) {
    const sentence = `there are ${positions.length / 3} vertices but ${given.length} values`;
    throw new KarcherError('badArgument', sentence);
  }
  const faces = await facesOf(mesh, positions);
  const welded = await firstOfWelded(mesh, positions, faces);
  // Of welded vertices with equal values, only the first counts, so that no line ends at a seam.
  const known = new Map<string, number>();
  const first = Array.from(given, (value, v) => {
    const name = `${welded[v]},${value}`;
    if (!known.has(name)) known.set(name, v);
    return known.get(name)!;
  });
  const corners = faces.map((vertex) => first[vertex]!);
  const ascending = [...new Set(wanted)].sort((a, b) => a - b);
  const lines = levelLines(corners, (corner) => given[corners[corner]!]!, ascending).map((each) =>
    each.flatMap((line) => pathOf(line, positions, corners) ?? []),
  );
  return wanted.map((level) => lines[ascending.indexOf(level)]!);
}

/** A line as a path, without repeated points; undefined for a line of length 0. */
function pathOf(
  line: readonly LevelCrossing[],
  positions: Float64Array,
  corners: Int32Array,
): Path | undefined {
  const face: number[] = [];
  const bary: number[] = [];
  const position: number[] = [];
  const lengths: number[] = [];
  let length = 0;
  for (const crossing of line) {
    const place = [0, 1, 2].map((axis) =>
      crossing.bary.reduce(
        (sum, weight, k) =>
          weight === 0
            ? sum
            : sum + weight * positions[3 * corners[3 * crossing.face + k]! + axis]!,
        0,
      ),
    );
    if (face.length > 0) {
      const step = Math.hypot(...place.map((value, k) => value - position.at(k - 3)!));
      if (step === 0) continue;
      length += step;
    }
    face.push(crossing.face);
    bary.push(...crossing.bary);
    position.push(...place);
    lengths.push(length);
  }
  if (face.length < 2) return undefined;
  const closed = line.length > 2 && line[0]!.edge === line.at(-1)!.edge;
  return new Path({
    closed,
    length,
    face: Int32Array.from(face),
    bary: Float64Array.from(bary),
    position: Float64Array.from(position),
    lengths: Float64Array.from(lengths),
  });
}
