import type { EnginePath } from './karcher-engine.mjs';
import { inDouble } from './options.js';
import type { PolylineOptions, SurfacePoint } from './types.js';

/**
 * A path on the surface: its points from the start to the end. Two neighbours share a face,
 * possibly on its sides. Between them the path is straight, or an arc that is nearly straight. A
 * path keeps its points, needs no mesh and has no `dispose`.
 */
export class Path {
  readonly #data: EnginePath;

  /** @internal The mesh and its curves return paths. */
  constructor(data: EnginePath) {
    this.#data = data;
  }

  /** The length on the surface, in units of the mesh. */
  get length(): number {
    return this.#data.length;
  }

  /** Whether it ends where it starts. */
  get closed(): boolean {
    return this.#data.closed;
  }

  /** The number of its points. */
  get count(): number {
    return this.#data.face.length;
  }

  /** The points of the path. Between two of them it is straight, in a face that both share. */
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

  /** @internal The path's data, which nobody may change. */
  data(): EnginePath {
    return this.#data;
  }
}
