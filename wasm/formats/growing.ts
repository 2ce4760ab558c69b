import { counted } from './failures.js';

/** Arrays for files whose counts are unknown until their end. The arrays grow by doubling. */

export class GrowingInts {
  #array = new Int32Array(1 << 10);
  length = 0;

  push(value: number): void {
    if (this.length === this.#array.length) {
      const longer = new Int32Array(2 * this.length);
      longer.set(this.#array);
      this.#array = longer;
    }
    this.#array[this.length++] = value;
  }

  /** The pushed numbers, without a copy if possible. */
  get values(): Int32Array {
    return this.#array.subarray(0, this.length);
  }
}

/**
 * The corners of polygons. The list of the polygons' sizes exists only after the first polygon that
 * is not a triangle.
 */
export class GrowingPolygons {
  readonly #corners = new GrowingInts();
  #sizes: GrowingInts | null = null;
  count = 0;
  #leftOut = 0;

  corner(vertex: number): void {
    this.#corners.push(vertex);
  }

  /**
   * Ends a polygon that has `size` corners. A polygon with fewer than three corners counts as left
   * out; the caller must not add its corners.
   */
  end(size: number): void {
    if (size < 3) {
      this.#leftOut++;
      return;
    }
    if (size !== 3 && !this.#sizes) {
      this.#sizes = new GrowingInts();
      for (let i = 0; i < this.count; i++) this.#sizes.push(3);
    }
    this.#sizes?.push(size);
    this.count++;
  }

  get corners(): Int32Array {
    return this.#corners.values;
  }

  get sizes(): Int32Array | null {
    return this.#sizes?.values ?? null;
  }

  /** A sentence about faces that are points or lines, if there are any. */
  get notRead(): string[] {
    if (this.#leftOut === 0) return [];
    return [`${counted(this.#leftOut)} points and lines were left out.`];
  }

  /** The number of the polygons' triangles. */
  get triangles(): number {
    return this.#corners.length - 2 * this.count;
  }
}
