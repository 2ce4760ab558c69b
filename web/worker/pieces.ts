/** The pieces of a file without parts of its own: connected components of triangles. */
import type { Karcher, Mesh } from 'karcher';
import type { FileInfo } from 'karcher/formats';

export interface Opened {
  mesh: Mesh;
  file: FileInfo;
}

/**
 * The largest number of parts. If a file has more pieces, the smallest ones, such as crumbs of a
 * scan, form the last part together.
 */
const mostParts = 1000;

/**
 * The index of each triangle's piece, and the number of triangles of each piece. The largest piece
 * comes first; of equally large ones, the one with the first triangle.
 */
export function piecesOf(
  triangles: Int32Array,
  vertices: number,
): { of: Int32Array; sizes: number[] } {
  const parents = Int32Array.from({ length: vertices }, (_, i) => i);
  const rootOf = (vertex: number) => {
    let root = vertex;
    while (parents[root] !== root) {
      // Each step halves the path to the root, so that paths stay short.
      parents[root] = parents[parents[root]!]!;
      root = parents[root]!;
    }
    return root;
  };
  for (let i = 0; i < triangles.length; i += 3) {
    const root = rootOf(triangles[i]!);
    parents[rootOf(triangles[i + 1]!)] = root;
    parents[rootOf(triangles[i + 2]!)] = rootOf(root);
  }
  const counts = new Map<number, number>();
  for (let i = 0; i < triangles.length; i += 3) {
    const root = rootOf(triangles[i]!);
    counts.set(root, (counts.get(root) ?? 0) + 1);
  }
  const sorted = [...counts].sort(([, a], [, b]) => b - a);
  const numbers = new Map(sorted.map(([root], number) => [root, number]));
  const of = new Int32Array(triangles.length / 3);
  for (let face = 0; face < of.length; face++)
    of[face] = numbers.get(rootOf(triangles[3 * face]!))!;
  return { of, sizes: sorted.map(([, count]) => count) };
}

/** The pieces as parts, from the largest. */
function partsOf(sizes: readonly number[]): FileInfo['parts'] {
  const parts = sizes.map((triangles, i) => ({ name: `Piece ${i + 1}`, triangles }));
  if (parts.length <= mostParts) return parts;
  const crumbs = parts.splice(mostParts - 1);
  const triangles = crumbs.reduce((sum, crumb) => sum + crumb.triangles, 0);
  return [...parts, { name: `${crumbs.length} small pieces`, triangles }];
}

/**
 * A completely read file, with its pieces as parts if it has no parts, and the mesh of the wanted
 * pieces. If this mesh is a new one, the given mesh is disposed of.
 */
export async function inPieces(
  karcher: Karcher,
  { mesh, file }: Opened,
  wanted: readonly number[] | null,
): Promise<Opened> {
  const { components } = mesh.info;
  if (file.parts.length > 1 || components < 2) return { mesh, file };
  const triangles = mesh.triangles();
  const positions = mesh.positions();
  const { of, sizes } = piecesOf(triangles, positions.length / 3);
  const parts = partsOf(sizes);
  for (const [face, piece] of of.entries()) of[face] = Math.min(piece, parts.length - 1);
  const marked = { ...file, parts, partOf: of };
  if (!wanted?.some((piece) => piece < parts.length)) return { mesh, file: marked };
  const kept: number[] = [];
  const numbers = new Int32Array(positions.length / 3).fill(-1);
  const corners: number[] = [];
  for (const [face, piece] of of.entries()) {
    if (!wanted.includes(piece)) continue;
    for (let corner = 0; corner < 3; corner++) {
      const vertex = triangles[3 * face + corner]!;
      if (numbers[vertex] === -1) numbers[vertex] = kept.push(vertex) - 1;
      corners.push(numbers[vertex]!);
    }
  }
  const places = new Float64Array(3 * kept.length);
  const colors = file.colors && new Uint8Array(3 * kept.length);
  for (const [to, from] of kept.entries()) {
    places.set(positions.subarray(3 * from, 3 * from + 3), 3 * to);
    colors?.set(file.colors!.subarray(3 * from, 3 * from + 3), 3 * to);
  }
  const piece = await karcher.meshFromArrays(places, corners);
  mesh.dispose();
  return { mesh: piece, file: { ...marked, colors, partOf: null, materialOf: null } };
}
