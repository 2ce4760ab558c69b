import { batchMask, type Slices } from '../slices.js';

/** The edges of one face only. */
export interface Boundary {
  /** The numbers of both ends, two an edge. */
  ends: Int32Array;
  /** Of each number, a vertex that has it. */
  vertexAt: Int32Array;
}

/** `numbers` has that of each corner's vertex: vertices that are one have the same. */
export async function boundaryEdges(
  triangles: Int32Array,
  numbers: Int32Array,
  slices: Slices,
): Promise<Boundary> {
  const count = numbers.reduce((most, number) => Math.max(most, number), 0) + 1;
  const vertexAt = new Int32Array(count);
  // The edges of each vertex to those of larger numbers, one list after the other.
  const starts = new Int32Array(count + 1);
  const others = new Int32Array(numbers.length);
  const forEachEdge = async (done: number, visit: (low: number, high: number) => void) => {
    for (let corner = 0; corner < numbers.length; corner++) {
      if ((corner & batchMask) === 0 && slices.over) {
        await slices.rest(done + (0.08 * corner) / numbers.length);
      }
      const [i, j] = [numbers[corner]!, numbers[corner % 3 === 2 ? corner - 2 : corner + 1]!];
      vertexAt[i] = triangles[corner]!;
      if (i !== j) visit(Math.min(i, j), Math.max(i, j));
    }
  };
  await forEachEdge(0.7, (low) => {
    starts[low]!++;
  });
  let sum = 0;
  for (let i = 0; i <= count; i++) {
    sum += starts[i]!;
    starts[i] = sum;
  }
  await forEachEdge(0.78, (low, high) => {
    others[--starts[low]!] = high;
  });
  const ends: number[] = [];
  for (let i = 0; i < count; i++) {
    if ((i & batchMask) === 0 && slices.over) await slices.rest(0.86 + (0.04 * i) / count);
    const [from, to] = [starts[i]!, starts[i + 1]!];
    if (to > from + 1) others.subarray(from, to).sort();
    for (let at = from; at < to; at++) {
      const other = others[at]!;
      const isAlone =
        (at === from || other !== others[at - 1]) && (at + 1 === to || other !== others[at + 1]);
      if (isAlone) ends.push(i, other);
    }
  }
  return { ends: Int32Array.from(ends), vertexAt };
}
