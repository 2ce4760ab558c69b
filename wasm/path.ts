import { checkBoolean, checkNumber, toFloat64, toInt32 } from './check.js';
import type { EnginePath } from './karcher-engine.mjs';
import { inDouble } from './options.js';
import type { PathValue } from './path_values.js';
import type { PolylineOptions, SurfacePoint } from './types.js';

/** A record with lists in place of its typed arrays, for JSON. */
export const listed = <Listed>(data: object): Listed =>
  Object.fromEntries(
    Object.entries(data).map(([name, value]) => [
      name,
      ArrayBuffer.isView(value) ? [...(value as Float64Array)] : value,
    ]),
  ) as Listed;

/**
 * A path on the surface: its points from the start to the end. Two consecutive points share a face;
 * they may lie on its sides. Between them the path is straight, or an arc that is nearly straight.
 * A path keeps its points, needs no mesh and has no `dispose`.
 */
export class Path {
  readonly #data: EnginePath;

  /** @internal The mesh and its curves return paths. */
  constructor(data: EnginePath) {
    this.#data = data;
  }

  /**
   * The path of a value that `toJSON` returned. The value is copied.
   *
   * @throws {KarcherError} badArgument for anything else.
   * @example
   * ```ts
   * const again = Path.from(JSON.parse(JSON.stringify(path)));
   * ```
   */
  static from(value: PathValue): Path {
    const { closed, length, face, bary, position, lengths } = Object(value) as PathValue;
    return new Path({
      closed: checkBoolean(closed, 'closed'),
      length: checkNumber(length, 'length'),
      face: toInt32(face, 'face'),
      bary: toFloat64(bary, 'bary'),
      position: toFloat64(position, 'position'),
      lengths: toFloat64(lengths, 'lengths'),
    });
  }

  /** The length on the surface, in units of the mesh. */
  get length(): number {
    return this.#data.length;
  }

  /** Whether the path ends where it starts. */
  get closed(): boolean {
    return this.#data.closed;
  }

  /** The number of the path's points. */
  get count(): number {
    return this.#data.face.length;
  }

  /** The points of the path. Two consecutive points share a face. */
  points(): SurfacePoint[] {
    const { face, bary } = this.#data;
    return Array.from(face, (number, i) => ({
      face: number,
      bary: [bary[3 * i]!, bary[3 * i + 1]!, bary[3 * i + 2]!],
    }));
  }

  /** The length from the start to each point. */
  lengths(): Float64Array {
    return this.#data.lengths.slice();
  }

  /** x, y, z of each point. */
  polyline(options?: { bits?: 32 }): Float32Array;
  polyline(options: { bits: 64 }): Float64Array;
  polyline(options?: PolylineOptions): Float32Array | Float64Array;
  polyline(options: PolylineOptions = {}): Float32Array | Float64Array {
    const { position } = this.#data;
    return inDouble(options) ? position.slice() : new Float32Array(position);
  }

  /**
   * The path as a value for JSON. Methods that take paths also take this value, and `Path.from`
   * returns its path.
   *
   * @example
   * ```ts
   * mesh.offset([JSON.parse(JSON.stringify(path))], { distance: 0.02 });
   * ```
   */
  toJSON(): PathValue {
    return listed(this.#data);
  }

  /** @internal The path's data, which nobody may change. */
  data(): EnginePath {
    return this.#data;
  }
}
