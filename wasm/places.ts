/**
 * The number of bits of a hash that choose a part of the table. Each part grows by itself, so that
 * no growth takes long.
 */
const tableBits = 8;
/**
 * The number of bits of a vertex's index in its chunk. These are the low bits of the vertex's
 * number.
 */
const chunkBits = 14;
const chunkMask = (1 << chunkBits) - 1;

/** A part of the table, with open addressing. A slot holds a vertex plus 1, or 0 if it is free. */
interface Part {
  slots: Int32Array;
  count: number;
}

/** Positions, and the same memory as 32-bit integers. */
interface Chunk {
  positions: Float64Array;
  words: Int32Array;
}

/**
 * Vertices by their place: those of files that repeat a vertex in each of its faces, and those of
 * triangles that are found by their corners. Places with equal coordinates are one vertex; NaN is
 * equal to itself. Vertices have numbers in the order of their first occurrence.
 */
export class Places {
  readonly #chunks: Chunk[] = [];
  readonly #parts: Part[] = Array.from({ length: 1 << tableBits }, () => ({
    slots: new Int32Array(16),
    count: 0,
  }));
  count = 0;
  /** The part in which the last search ended, and the slot. */
  #last = this.#parts[0]!;
  #slot = 0;

  /** The number of the vertex at a place; a new place gets the next number. */
  number(x: number, y: number, z: number): number {
    const known = this.find(x, y, z);
    if (known >= 0) return known;
    const part = this.#last;
    part.slots[this.#slot] = ++this.count;
    if (2 * ++part.count > part.slots.length) this.#grow(part);
    return this.count - 1;
  }

  /** The number of the vertex at a place, or -1. */
  find(x: number, y: number, z: number): number {
    const { positions, words } = this.#chunkOf(this.count);
    const at = 3 * (this.count & chunkMask);
    // The sums turn -0 into 0.
    positions[at] = x + 0;
    positions[at + 1] = y + 0;
    positions[at + 2] = z + 0;
    const word = 2 * at;
    const hash = hashOf(words, word);
    this.#last = this.#parts[hash & ((1 << tableBits) - 1)]!;
    const { slots } = this.#last;
    const mask = slots.length - 1;
    let slot = (hash >>> tableBits) & mask;
    for (let entry = slots[slot]!; entry !== 0; entry = slots[slot]!) {
      if (this.#isAt(entry - 1, words, word)) return entry - 1;
      slot = (slot + 1) & mask;
    }
    this.#slot = slot;
    return -1;
  }

  get positions(): Float64Array {
    const positions = new Float64Array(3 * this.count);
    for (const [i, chunk] of this.#chunks.entries()) {
      const at = (3 * i) << chunkBits;
      positions.set(chunk.positions.subarray(0, Math.max(0, positions.length - at)), at);
    }
    return positions;
  }

  #chunkOf(vertex: number): Chunk {
    const number = vertex >>> chunkBits;
    if (number === this.#chunks.length) {
      const positions = new Float64Array(3 << chunkBits);
      this.#chunks.push({ positions, words: new Int32Array(positions.buffer) });
    }
    return this.#chunks[number]!;
  }

  /** Whether a vertex has this place, bit by bit, so that NaN equals itself. */
  #isAt(vertex: number, words: Int32Array, at: number): boolean {
    const others = this.#chunks[vertex >>> chunkBits]!.words;
    const other = 6 * (vertex & chunkMask);
    for (let i = 0; i < 6; i++) if (others[other + i] !== words[at + i]) return false;
    return true;
  }

  #grow(part: Part): void {
    const slots = new Int32Array(2 * part.slots.length);
    const mask = slots.length - 1;
    for (const entry of part.slots) {
      if (entry === 0) continue;
      const vertex = entry - 1;
      const hash = hashOf(this.#chunks[vertex >>> chunkBits]!.words, 6 * (vertex & chunkMask));
      let slot = (hash >>> tableBits) & mask;
      while (slots[slot] !== 0) slot = (slot + 1) & mask;
      slots[slot] = entry;
    }
    part.slots = slots;
  }
}

function hashOf(words: Int32Array, at: number): number {
  let hash = 0;
  for (let word = at; word < at + 6; word++) {
    hash = Math.imul(hash ^ words[word]!, 0x9e3779b1);
    hash ^= hash >>> 15;
  }
  return hash;
}
