import { checkArray, checkNumber, toFloat64 } from '../check.js';
import { KarcherError } from '../errors.js';
import { Path } from '../path.js';
import type { AnyMesh } from './energy.js';
import { fansOf } from './fans.js';
import { type LevelCrossing, levelLines } from './level_lines.js';

/**
 * The lines on which a function has given levels: a list of paths for each level. The function has
 * one value for each vertex and is linear in triangles. Of welded vertices, the value of the first
 * counts. Lines that are not closed end on the boundary, or at triangles with a value that is not
 * finite. A level without points has no line.
 *
 * Lines of distances are those of `mesh.isolines` with the type `linear`, except at vertices where
 * the surface only touches another part or itself: a vertex has one value in all its faces.
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
  const count = (await mesh.positions()).length / 3;
  if (given.length !== count) {
    const sentence = `there are ${count} vertices but ${given.length} values`;
    throw new KarcherError('badArgument', sentence);
  }
  const { corners, vertices, positions } = await fansOf(mesh);
  const valueAt = (corner: number) => given[vertices[corners[corner]!]!]!;
  const ascending = [...new Set(wanted)].sort((a, b) => a - b);
  const lines = levelLines(corners, valueAt, ascending).map((each) =>
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
