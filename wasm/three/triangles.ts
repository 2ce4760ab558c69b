import { Places } from '../places.js';
import { at } from '../vectors.js';

/**
 * Finds the triangles of a mesh by the places of their corners, whatever the vertex numbers are.
 */
export class Triangles {
  /** x, y, z of each vertex. */
  readonly positions: Float64Array;
  /** The vertices of each triangle. */
  readonly corners: Int32Array;
  /** The length of the bounding box's diagonal. */
  readonly diagonal: number;
  /** The first of the vertices that are welded to each vertex. */
  readonly welded: Int32Array;
  readonly #places = new Places();
  /** The number of the place of each vertex. */
  readonly #placeOf: Int32Array;
  /**
   * The triangles at each place, one list after the other. `#starts` has the beginning of each
   * list.
   */
  readonly #starts: Int32Array;
  readonly #around: Int32Array;

  /**
   * `named` are the corners as `Mesh.triangles` returns them: the first of welded vertices.
   * `faceOf` is a face at each vertex, or -1, as in `EnginePlanes`.
   */
  constructor(positions: Float64Array, corners: Int32Array, named: Int32Array, faceOf: Int32Array) {
    this.positions = positions;
    this.corners = corners;
    this.welded = new Int32Array(positions.length / 3).fill(-1);
    corners.forEach((v, i) => {
      this.welded[v] = named[i]!;
    });
    // A vertex that no corner names may be welded to a corner of its face.
    faceOf.forEach((face, v) => {
      if (this.welded[v]! < 0) this.welded[v] = face < 0 ? v : named[this.#nearestCorner(face, v)]!;
    });
    const places = this.welded.map((_, v) => this.#places.number(...at(positions, v)));
    this.#placeOf = places;
    this.#starts = new Int32Array(this.#places.count + 1);
    for (const v of corners) this.#starts[places[v]! + 1]!++;
    for (let i = 0; i < this.#places.count; i++)
      this.#starts[i + 1] = this.#starts[i + 1]! + this.#starts[i]!;
    const next = this.#starts.slice();
    this.#around = new Int32Array(corners.length);
    corners.forEach((v, i) => {
      this.#around[next[places[v]!]!++] = Math.floor(i / 3);
    });
    this.diagonal = diagonalOf(positions, corners);
  }

  /** The first of the vertices that are welded to this one, unless welding has moved it. */
  drawn(vertex: number): number {
    const first = this.welded[vertex]!;
    return this.#placeOf[first] === this.#placeOf[vertex] ? first : vertex;
  }

  /**
   * The triangle whose corners lie at three places (nine numbers), or -1. Among several such
   * triangles, those with the same orientation come first, and of these the one with the number
   * `likely`.
   */
  find(places: ArrayLike<number>, likely: number): number {
    const [a, b, c] = [0, 1, 2].map((i) => this.#places.find(...at(places, i)));
    if (a! < 0 || b! < 0 || c! < 0) return -1;
    let found = -1;
    let best = 0;
    for (let i = this.#starts[a!]!; i < this.#starts[a! + 1]!; i++) {
      const face = this.#around[i]!;
      const order = this.#order(face, a!, b!, c!);
      const rank = order && order + (face === likely ? 1 : 0);
      if (rank <= best) continue;
      best = rank;
      found = face;
    }
    return found;
  }

  /** The place in `corners` of a face's corner that is nearest to a vertex. */
  #nearestCorner(face: number, vertex: number): number {
    const place = at(this.positions, vertex);
    const distanceTo = (corner: number) => {
      const other = at(this.positions, this.corners[corner]!);
      return Math.hypot(...place.map((x, k) => x - other[k]!));
    };
    return [3 * face, 3 * face + 1, 3 * face + 2].reduce((best, corner) =>
      distanceTo(corner) < distanceTo(best) ? corner : best,
    );
  }

  /** The rank of a face: 3 for corners in this order, 1 for the opposite order, 0 for others. */
  #order(face: number, a: number, b: number, c: number): number {
    const [u, v, w] = [0, 1, 2].map((k) => this.#placeOf[this.corners[3 * face + k]!]!);
    const is = (x: number, y: number, z: number) => x === a && y === b && z === c;
    if (is(u!, v!, w!) || is(v!, w!, u!) || is(w!, u!, v!)) return 3;
    return is(u!, w!, v!) || is(w!, v!, u!) || is(v!, u!, w!) ? 1 : 0;
  }
}

function diagonalOf(positions: Float64Array, corners: Int32Array): number {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (const v of corners) {
    for (let k = 0; k < 3; k++) {
      const x = positions[3 * v + k]!;
      if (x < least[k]!) least[k] = x;
      if (x > most[k]!) most[k] = x;
    }
  }
  return Math.hypot(...most.map((x, k) => x - least[k]!));
}
