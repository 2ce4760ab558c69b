import type { EnginePath } from './karcher-engine.mjs';
import { asPolyline } from './polyline.js';
import type { PolylineOptions, SurfacePoint } from './types.js';

/**
 * A path on the surface: points of it, from the start to the end, two neighbours of which lie in one
 * face, be it on its sides. Between them the path is straight, or an arc that is as good as straight.
 * It keeps its points, needs no mesh and is not disposed of.
 */
export class Path {
  readonly #data: EnginePath;

  /** @internal The mesh and its curves give paths. */
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

  /** How many points it has. */
  get count(): number {
    return this.#data.face.length;
  }

  /** The points of the path; between two of them it is straight, in a face that both have in common. */
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
    return asPolyline(this.#data.position, options);
  }

  /** @internal What it is made of, which is not to be changed. */
  data(): EnginePath {
    return this.#data;
  }
}
