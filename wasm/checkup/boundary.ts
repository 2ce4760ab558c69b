import { batchMask, type Slices } from '../slices.js';
import { facesOnOthers } from './doubled.js';

/**
 * Finds the boundary: the vertices at the two ends of each edge that belongs to only one face.
 * `triangles` are those of `Mesh.triangles`, which name one of several welded vertices. More than
 * two faces at an edge stay together in pairs. An odd number of faces leaves one face over, and the
 * edge is then on the boundary. With `doubled`, the search omits faces that lie on others, as the
 * engine does.
 */
export async function boundaryEdges(
  triangles: Int32Array,
  doubled: boolean,
  slices: Slices,
): Promise<Int32Array> {
  const count = triangles.reduce((most, vertex) => Math.max(most, vertex), 0) + 1;
  const onOthers = doubled ? await facesOnOthers(triangles, count, slices) : null;
  // Each vertex has a list of its neighbours with larger numbers. In `others`, these lists follow
  // one another.
  const starts = new Int32Array(count + 1);
  const others = new Int32Array(triangles.length);
  const forEachEdge = async (done: number, visit: (low: number, high: number) => void) => {
    for (let corner = 0; corner < triangles.length; corner++) {
      if ((corner & batchMask) === 0 && slices.over) {
        await slices.rest(done + (0.08 * corner) / triangles.length);
      }
      const [i, j] = edgeOf(triangles, corner);
      if (i === j || onOthers?.same[Math.floor(corner / 3)]) continue;
      visit(Math.min(i, j), Math.max(i, j));
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
  for (let i = 0; i < count; i++) {
    if ((i & batchMask) === 0 && slices.over) await slices.rest(0.86 + (0.02 * i) / count);
    if (starts[i + 1]! > starts[i]! + 1) others.subarray(starts[i], starts[i + 1]).sort();
  }
  const facesAt = (low: number, high: number) => {
    let faces = 0;
    for (let at = starts[low]!; at < starts[low + 1]!; at++) faces += others[at] === high ? 1 : 0;
    return faces;
  };
  /** The edges at which an odd number of the omitted faces meet. */
  const changed = new Set<string>();
  for (const face of onOthers?.turned ?? []) {
    const edges = [0, 1, 2].map((k) => edgeOf(triangles, 3 * face + k).sort((i, j) => i - j));
    // Two faces that lie on each other are a closed surface, unless a further face has one of their
    // edges.
    if (!edges.some(([low, high]) => facesAt(low!, high!) > 2)) continue;
    for (const edge of edges) if (!changed.delete(`${edge}`)) changed.add(`${edge}`);
  }
  const ends: number[] = [];
  for (let i = 0; i < count; i++) {
    if ((i & batchMask) === 0 && slices.over) await slices.rest(0.88 + (0.02 * i) / count);
    const to = starts[i + 1]!;
    for (let from = starts[i]!, at = from; from < to; from = at) {
      const other = others[from]!;
      while (at < to && others[at] === other) at++;
      const isOdd = (at - from) % 2 === 1;
      if (isOdd !== (changed.size > 0 && changed.has(`${[i, other]}`))) ends.push(i, other);
    }
  }
  return Int32Array.from(ends);
}

/** The vertices at the ends of the edge that starts at a corner. */
function edgeOf(triangles: Int32Array, corner: number): [number, number] {
  return [triangles[corner]!, triangles[corner % 3 === 2 ? corner - 2 : corner + 1]!];
}
