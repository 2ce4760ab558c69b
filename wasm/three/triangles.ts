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
  readonly #places: Places;
  /**
   * The triangles at each place, one list after the other. `#starts` has the beginning of each
   * list, by the first vertex at the place.
   */
  readonly #starts: Int32Array;
  readonly #around: Int32Array;

  /** `named` are the corners as `Mesh.triangles` returns them: the first of welded vertices. */
  constructor(positions: Float64Array, corners: Int32Array, named: Int32Array) {
    const vertices = positions.length / 3;
    this.positions = positions;
    this.corners = corners;
    this.#places = new Places(positions);
    const { first } = this.#places;
    this.welded = first.slice();
    corners.forEach((v, i) => {
      this.welded[v] = named[i]!;
    });
    this.#starts = new Int32Array(vertices + 1);
    for (const v of corners) this.#starts[first[v]! + 1]!++;
    for (let v = 0; v < vertices; v++)
      this.#starts[v + 1] = this.#starts[v + 1]! + this.#starts[v]!;
    const next = this.#starts.slice();
    this.#around = new Int32Array(corners.length);
    corners.forEach((v, i) => {
      this.#around[next[first[v]!]!++] = Math.floor(i / 3);
    });
    this.diagonal = diagonalOf(positions, corners);
  }

  /** The first of the vertices that are welded to this one, unless welding has moved it. */
  drawn(vertex: number): number {
    const first = this.welded[vertex]!;
    return this.#places.first[first] === this.#places.first[vertex] ? first : vertex;
  }

  /**
   * The triangle whose corners lie at three places (nine numbers), or -1. Among several such
   * triangles, those with the same orientation come first, and of these the one with the number
   * `likely`.
   */
  find(places: ArrayLike<number>, likely: number): number {
    const [a, b, c] = [0, 3, 6].map((i) => this.#places.at(places, i));
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

  /** The rank of a face: 3 for corners in this order, 1 for the opposite order, 0 for others. */
  #order(face: number, a: number, b: number, c: number): number {
    const [u, v, w] = [0, 1, 2].map((k) => this.#places.first[this.corners[3 * face + k]!]!);
    const is = (x: number, y: number, z: number) => x === a && y === b && z === c;
    if (is(u!, v!, w!) || is(v!, w!, u!) || is(w!, u!, v!)) return 3;
    return is(u!, w!, v!) || is(w!, v!, u!) || is(v!, u!, w!) ? 1 : 0;
  }
}

/** Vertices by their places, in a hash table. */
class Places {
  /** The first vertex at the place of each vertex. */
  readonly first: Int32Array;
  readonly #positions: Float64Array;
  /** Vertices by a hash of their place; -1 for a free slot. The table is at most half full. */
  readonly #table: Int32Array;

  constructor(positions: Float64Array) {
    const vertices = positions.length / 3;
    this.#positions = positions;
    this.#table = new Int32Array(2 ** Math.ceil(Math.log2(2 * vertices + 2))).fill(-1);
    this.first = Int32Array.from({ length: vertices }, (_, vertex) => {
      const slot = this.#slot(positions, 3 * vertex);
      if (this.#table[slot]! < 0) this.#table[slot] = vertex;
      return this.#table[slot]!;
    });
  }

  /** The first vertex at the place whose coordinates begin at an index; -1 without one. */
  at(places: ArrayLike<number>, i: number): number {
    return this.#table[this.#slot(places, i)]!;
  }

  /** The slot of the vertex at a place, or a free one. */
  #slot(places: ArrayLike<number>, i: number): number {
    const [x, y, z] = [places[i]!, places[i + 1]!, places[i + 2]!];
    const mask = this.#table.length - 1;
    let slot = hash(x, y, z) & mask;
    for (;;) {
      const vertex = this.#table[slot]!;
      if (vertex < 0) return slot;
      const [px, py, pz] = [0, 1, 2].map((k) => this.#positions[3 * vertex + k]!);
      // A vertex with a NaN coordinate shares its place with no other vertex.
      if (px === x && py === y && pz === z) return slot;
      slot = (slot + 1) & mask;
    }
  }
}

const words = new Float32Array(3);
const bits = new Int32Array(words.buffer);

function hash(x: number, y: number, z: number): number {
  // 0 and -0 are one place.
  words[0] = x + 0;
  words[1] = y + 0;
  words[2] = z + 0;
  let mixed = Math.imul(bits[0]!, 0x9e3779b1) ^ Math.imul(bits[1]!, 0x85ebca77);
  mixed ^= Math.imul(bits[2]!, 0xc2b2ae3d);
  mixed = Math.imul(mixed ^ (mixed >>> 15), 0x2c1b3c6d);
  return mixed ^ (mixed >>> 13);
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
