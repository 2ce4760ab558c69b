import { batchMask, type Slices } from '../slices.js';

/** Boundaries that nearly touch, and the `weld` that would join them. */
export interface NearBoundaries {
  /**
   * x, y, z of each boundary vertex near another boundary vertex, so that the import can weld the
   * two. Their distance is at most 1e-4 of the diagonal, and at most a third of the shortest edge
   * at either vertex.
   */
  places: Float64Array;
  /** The value of the option `weld` (`MeshOptions`) with which the import joins the boundaries. */
  weld: number;
}

/** The largest distance between boundaries that are near each other, relative to the diagonal. */
const nearness = 1e-4;
/**
 * The largest distance between vertices that the engine welds, relative to the shortest edge at
 * either vertex.
 */
const partOfEdge = 1 / 3;
/** The least tolerance that is advised, relative to the diagonal. */
const leastWeld = 1e-9;
/**
 * The largest number of halvings of the width of cells, such that doubles number all cells of the
 * surface exactly. Vertices whose edges would need still narrower cells lie in the narrowest ones.
 */
const mostLevels = 39;

/** The data of the search. */
interface Places {
  positions: Float64Array;
  /** The ends of the edges on the boundary. */
  boundary: Int32Array;
  /** The length of the shortest edge at each vertex. */
  shortest: Float64Array;
  diagonal: number;
  /** Whether the import welded, so that no weld joins what is apart at one place. */
  isWelded: boolean;
}

/**
 * Finds boundaries that nearly touch: a vertex of one boundary is near a vertex of the other. Their
 * distance is at most 1e-4 of the diagonal, and at most a third of the shortest edge at either
 * vertex. Neighbors along the boundaries must be near each other, too, since the import does not
 * weld vertices where parts only touch.
 */
export async function nearBoundaries(
  { positions, boundary, shortest, diagonal, isWelded }: Places,
  slices: Slices,
): Promise<NearBoundaries | null> {
  const reach = nearness * diagonal;
  const vertices = Int32Array.from(new Set(boundary));
  const at = (vertex: number, axis: number) => positions[3 * vertex + axis]!;
  const distance = (i: number, j: number) =>
    Math.sqrt((at(i, 0) - at(j, 0)) ** 2 + (at(i, 1) - at(j, 1)) ** 2 + (at(i, 2) - at(j, 2)) ** 2);
  const limitOf = (vertex: number) => Math.min(reach, partOfEdge * shortest[vertex]!);
  /** A coordinate relative to a vertex, so that cells far from the origin have exact numbers. */
  const fromFirst = (vertex: number, axis: number) => at(vertex, axis) - at(vertices[0]!, axis);
  // A cell is one to two times as wide as the limits of its vertices, so that few vertices share a
  // cell without being near each other.
  const levelOf = (limit: number) =>
    Math.min(mostLevels, Math.max(0, Math.floor(Math.log2(reach / limit))));
  const first = new Map<number, number>();
  const next = new Int32Array(vertices.length).fill(-1);
  const levels = new Set<number>();
  for (const [k, vertex] of vertices.entries()) {
    if ((k & batchMask) === 0 && slices.over) await slices.rest(0.9 + (0.03 * k) / vertices.length);
    const level = levelOf(limitOf(vertex));
    levels.add(level);
    const width = reach / 2 ** level;
    const cell = cellKey(
      level,
      ...([0, 1, 2].map((axis) => Math.floor(fromFirst(vertex, axis) / width)) as Cell),
    );
    next[k] = first.get(cell) ?? -1;
    first.set(cell, k);
  }
  const neighbours = await neighboursOf(boundary, slices);
  const areClose = (i: number, j: number) => distance(i, j) <= Math.min(limitOf(i), limitOf(j));
  const isNear = (i: number, j: number) =>
    areClose(i, j) &&
    !(isWelded && distance(i, j) === 0) &&
    neighbours.get(i)!.some((a) => neighbours.get(j)!.some((b) => areClose(a, b)));

  /** The first other vertex that is near this one, or -1. */
  const nearTo = (vertex: number): number => {
    const limit = limitOf(vertex);
    for (const level of levels) {
      const width = reach / 2 ** level;
      const most = Math.min(limit, width);
      const [low, high] = [-most, most].map((by) =>
        [0, 1, 2].map((axis) => Math.floor((fromFirst(vertex, axis) + by) / width)),
      ) as [Cell, Cell];
      for (let x = low[0]; x <= high[0]; x++) {
        for (let y = low[1]; y <= high[1]; y++) {
          for (let z = low[2]; z <= high[2]; z++) {
            for (let k = first.get(cellKey(level, x, y, z)) ?? -1; k >= 0; k = next[k]!) {
              const other = vertices[k]!;
              if (other !== vertex && isNear(vertex, other)) return other;
            }
          }
        }
      }
    }
    return -1;
  };

  const places: number[] = [];
  let farthest = 0;
  for (const [k, vertex] of vertices.entries()) {
    if ((k & 0xff) === 0 && slices.over) await slices.rest(0.95 + (0.05 * k) / vertices.length);
    const other = nearTo(vertex);
    if (other < 0) continue;
    places.push(at(vertex, 0), at(vertex, 1), at(vertex, 2));
    farthest = Math.max(farthest, distance(vertex, other));
  }
  if (places.length === 0) return null;
  const weld = roundedUp(Math.max(farthest, leastWeld * diagonal));
  return { places: Float64Array.from(places), weld };
}

type Cell = [number, number, number];

/**
 * The key of a cell. Several cells may share a key, so that the distances between their vertices
 * must be checked.
 */
function cellKey(level: number, x: number, y: number, z: number): number {
  let key = Math.imul(level + 1, 0x9e3779b1);
  for (const part of [x, y, z]) {
    key = Math.imul(key ^ (part | 0), 0x85ebca6b);
    key ^= key >>> 13;
  }
  return key;
}

/** The neighbors of each vertex along boundary edges. */
async function neighboursOf(ends: Int32Array, slices: Slices): Promise<Map<number, number[]>> {
  const neighbours = new Map<number, number[]>();
  for (let k = 0; k < ends.length; k += 2) {
    if ((k & batchMask) === 0 && slices.over) await slices.rest(0.93 + (0.02 * k) / ends.length);
    for (const [one, other] of [
      [ends[k]!, ends[k + 1]!] as const,
      [ends[k + 1]!, ends[k]!] as const,
    ]) {
      const known = neighbours.get(one);
      if (known) known.push(other);
      else neighbours.set(one, [other]);
    }
  }
  return neighbours;
}

/**
 * The length, increased by 1 % and rounded up to two significant digits, so that the result is
 * always larger.
 */
function roundedUp(length: number): number {
  const unit = 10 ** (Math.floor(Math.log10(length)) - 1);
  return Number((Math.ceil((1.01 * length) / unit) * unit).toPrecision(2));
}
