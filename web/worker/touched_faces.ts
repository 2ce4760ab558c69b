/**
 * Faces that lie in a region as a whole, but have a corner of the region's border on an edge: a
 * line may run along a part of the edge. These faces need a filling of triangles, like faces that
 * are partly in the region, so that neighbors have whole edges in common.
 */

export interface Sides {
  /** The face of each side, in order. */
  faces: Int32Array;
  /** The second and third weights of the two ends of each side. */
  sides: Float64Array;
}

/**
 * The corners of the border on an edge. Each corner is given by its weight at one vertex of the
 * edge, the vertex with the higher index.
 */
interface Touched {
  face: number;
  weights: Set<number>;
  isShared: boolean;
}

const bothOf = [
  [1, 2],
  [2, 0],
  [0, 1],
] as const;

/**
 * Takes the touched faces out of the whole faces, and adds their sides to the given ones.
 * `triangles` has the vertices of all faces.
 */
export function withTouched(
  whole: Int32Array,
  given: Sides,
  triangles: Int32Array,
): Sides & { whole: Int32Array } {
  const keyOf = (face: number, corner: number) => {
    const [i, j] = bothOf[corner]!;
    const [a, b] = [triangles[3 * face + i]!, triangles[3 * face + j]!];
    return a < b ? b * 2 ** 26 + a : a * 2 ** 26 + b;
  };
  const edges = new Map<number, Touched>();
  for (const [i, face] of given.faces.entries()) {
    // Sides form loops, so each corner is the first end of a side.
    const [x, y] = [given.sides[4 * i]!, given.sides[4 * i + 1]!];
    const weights = [1 - x - y, x, y];
    const corner = weights.indexOf(0);
    if (corner < 0 || weights.includes(1)) continue;
    const [j, k] = bothOf[corner]!;
    const key = keyOf(face, corner);
    const higher = triangles[3 * face + j]! > triangles[3 * face + k]! ? j : k;
    const edge = edges.get(key) ?? { face, weights: new Set(), isShared: false };
    edges.set(key, edge);
    if (edge.face !== face) edge.isShared = true;
    edge.weights.add(weights[higher]!);
  }
  const vertices = new Set<number>();
  for (const [key, { isShared }] of edges) {
    if (isShared) edges.delete(key);
    else vertices.add(key % 2 ** 26);
  }
  if (edges.size === 0) return { whole, ...given };
  const isTouched = (face: number) =>
    [0, 1, 2].some((k) => vertices.has(triangles[3 * face + k]!)) &&
    [0, 1, 2].some((corner) => edges.has(keyOf(face, corner)));
  const touched = whole.filter(isTouched);
  const added = [...touched].map((face) => {
    const ends: [number, number][] = [];
    for (const corner of [2, 0, 1]) {
      const [i, j] = bothOf[corner]!;
      const rises = triangles[3 * face + j]! > triangles[3 * face + i]!;
      const parts = [...(edges.get(keyOf(face, corner))?.weights ?? [])];
      const along = parts.map((weight) => (rises ? weight : 1 - weight)).sort((a, b) => a - b);
      for (const part of [0, ...along]) {
        const weights = [0, 0, 0];
        weights[i] = 1 - part;
        weights[j] = part;
        ends.push([weights[1]!, weights[2]!]);
      }
    }
    const sides = ends.flatMap((end, i) => [...end, ...ends[(i + 1) % ends.length]!]);
    return { face, sides: Float64Array.from(sides) };
  });
  return { whole: whole.filter((face) => !isTouched(face)), ...merged(given, added) };
}

/** The sides together with the sides of other faces, in the order of the faces. */
function merged(
  { faces, sides }: Sides,
  added: readonly { face: number; sides: Float64Array }[],
): Sides {
  const count = added.reduce((sum, one) => sum + one.sides.length / 4, faces.length);
  const all = { faces: new Int32Array(count), sides: new Float64Array(4 * count) };
  let [from, to] = [0, 0];
  const take = (until: number) => {
    all.faces.set(faces.subarray(from, until), to);
    all.sides.set(sides.subarray(4 * from, 4 * until), 4 * to);
    to += until - from;
    from = until;
  };
  for (const { face, sides: own } of added) {
    const before = faces.findIndex((other, i) => i >= from && other > face);
    take(before < 0 ? faces.length : before);
    all.faces.fill(face, to, to + own.length / 4);
    all.sides.set(own, 4 * to);
    to += own.length / 4;
  }
  take(faces.length);
  return all;
}
