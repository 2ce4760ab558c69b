import { Places } from '../places.js';
import { batchMask, type Slices } from '../slices.js';
import type { MeshInfo } from '../types.js';

/** The engine contracts edges of at most this part of the diagonal. */
const shortOfDiagonal = 1e-14;
/** The engine contracts edges of at most this part of the longest edge of their face. */
const shortOfFace = 1e-12;

/**
 * A number for each corner of the triangles. Vertices that are one in the engine have the same
 * number: vertices at one place if the import welded any, and the ends of edges that it contracted.
 */
export async function numbersOf(
  positions: Float64Array,
  triangles: Int32Array,
  { repairs, diagonal }: Readonly<MeshInfo>,
  slices: Slices,
): Promise<Int32Array> {
  const isRepaired = (wanted: string) => repairs.some(({ kind }) => kind === wanted);
  // If the import welded no vertices, vertices at one place are separate in the engine.
  const numbers = isRepaired('welded') ? await byPlace(positions, triangles, slices) : triangles;
  if (!isRepaired('contracted')) return numbers;
  const sets = Int32Array.from({ length: positions.length / 3 }, (_, number) => number);
  const find = (number: number) => {
    let v = number;
    while (sets[v] !== v) {
      sets[v] = sets[sets[v]!]!;
      v = sets[v]!;
    }
    return v;
  };
  const place = (corner: number) =>
    positions.subarray(3 * triangles[corner]!, 3 * triangles[corner]! + 3);
  for (let at = 0; at < triangles.length; at += 3) {
    if (((at / 3) & batchMask) === 0 && slices.over) {
      await slices.rest(0.3 + (0.1 * at) / triangles.length);
    }
    const [p, q, r] = [place(at), place(at + 1), place(at + 2)] as const;
    const lengths = [lengthOf(p, q), lengthOf(q, r), lengthOf(r, p)];
    const limit = Math.max(shortOfDiagonal * diagonal, shortOfFace * Math.max(...lengths));
    for (const [k, length] of lengths.entries()) {
      if (length > limit) continue;
      const [i, j] = [find(numbers[at + k]!), find(numbers[at + ((k + 1) % 3)]!)];
      sets[Math.max(i, j)] = Math.min(i, j);
    }
  }
  return numbers.map(find);
}

const lengthOf = (p: Float64Array, q: Float64Array) =>
  Math.hypot(q[0]! - p[0]!, q[1]! - p[1]!, q[2]! - p[2]!);

async function byPlace(positions: Float64Array, triangles: Int32Array, slices: Slices) {
  const places = new Places();
  const numbers = new Int32Array(triangles.length);
  for (const [i, vertex] of triangles.entries()) {
    if ((i & batchMask) === 0 && slices.over) await slices.rest((0.3 * i) / triangles.length);
    const at = 3 * vertex;
    numbers[i] = places.number(positions[at]!, positions[at + 1]!, positions[at + 2]!);
  }
  return numbers;
}
