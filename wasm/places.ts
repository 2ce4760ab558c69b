/**
 * Vertices by their place, for files that repeat a vertex in each of its faces: those of exactly the
 * same coordinates are one, numbered in the order in which they come.
 */
export class Places {
  #positions = new Float64Array(3 << 10);
  #words = new Int32Array(this.#positions.buffer);
  /** Vertices plus 1 by hash, open addressing; 0 is free. */
  #table = new Int32Array(1 << 12);
  count = 0;

  /** The number of the vertex there. */
  number(x: number, y: number, z: number): number {
    if (3 * this.count === this.#positions.length) this.#grow();
    const positions = this.#positions;
    const at = 3 * this.count;
    // -0 is 0.
    positions[at] = x + 0;
    positions[at + 1] = y + 0;
    positions[at + 2] = z + 0;
    const mask = this.#table.length - 1;
    let slot = this.#hash(this.count) & mask;
    for (let entry = this.#table[slot]!; entry !== 0; entry = this.#table[slot]!) {
      const other = 3 * (entry - 1);
      if (
        positions[other] === positions[at] &&
        positions[other + 1] === positions[at + 1] &&
        positions[other + 2] === positions[at + 2]
      ) {
        return entry - 1;
      }
      slot = (slot + 1) & mask;
    }
    this.#table[slot] = ++this.count;
    return this.count - 1;
  }

  get positions(): Float64Array {
    return this.#positions.slice(0, 3 * this.count);
  }

  #hash(vertex: number): number {
    let hash = 0;
    for (let word = 6 * vertex; word < 6 * vertex + 6; word++) {
      hash = Math.imul(hash ^ this.#words[word]!, 0x9e3779b1);
      hash ^= hash >>> 15;
    }
    return hash;
  }

  #grow(): void {
    const positions = new Float64Array(2 * this.#positions.length);
    positions.set(this.#positions);
    this.#positions = positions;
    this.#words = new Int32Array(positions.buffer);
    this.#table = new Int32Array(2 * this.#table.length);
    const mask = this.#table.length - 1;
    for (let vertex = 0; vertex < this.count; vertex++) {
      let slot = this.#hash(vertex) & mask;
      while (this.#table[slot] !== 0) slot = (slot + 1) & mask;
      this.#table[slot] = vertex + 1;
    }
  }
}
