import { batchMask, type Slices } from '../slices.js';

/**
 * The edges of one face only: x, y, z of both ends. `numbers` has the place of each corner, so that
 * vertices at one place are one.
 */
export async function boundaryEdges(
  positions: Float64Array,
  triangles: Int32Array,
  numbers: Int32Array,
  slices: Slices,
): Promise<Float64Array> {
  // An edge as one number: those of two faces come twice.
  const count = numbers.reduce((most, number) => Math.max(most, number), 0) + 1;
  const keys = new Float64Array(numbers.length);
  const vertexAt = new Int32Array(count);
  for (let corner = 0; corner < numbers.length; corner++) {
    if ((corner & batchMask) === 0 && slices.over) {
      await slices.rest(0.7 + (0.1 * corner) / numbers.length);
    }
    const [i, j] = [numbers[corner]!, numbers[corner % 3 === 2 ? corner - 2 : corner + 1]!];
    vertexAt[i] = triangles[corner]!;
    keys[corner] = i === j ? -1 : Math.min(i, j) * count + Math.max(i, j);
  }
  keys.sort();
  const ends: number[] = [];
  for (let at = 0; at < keys.length; at++) {
    if ((at & batchMask) === 0 && slices.over) await slices.rest(0.9 + (0.1 * at) / keys.length);
    const key = keys[at]!;
    if (key < 0 || key === keys[at - 1] || key === keys[at + 1]) continue;
    for (const number of [Math.floor(key / count), key % count]) {
      const vertex = 3 * vertexAt[number]!;
      ends.push(positions[vertex]!, positions[vertex + 1]!, positions[vertex + 2]!);
    }
  }
  return Float64Array.from(ends);
}
