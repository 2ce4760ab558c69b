import {
  badArgument,
  checkInteger,
  checkLength,
  checkOneOf,
  shown,
  toFloat64,
  toInt32,
} from './check.js';
import type { Engine } from './engine.js';
import type { EngineMesh, EngineModule } from './karcher-engine.mjs';
import { Mesh } from './mesh.js';
import { engineMeshOptions } from './options.js';
import { checkFits, checkMeshFits } from './room.js';
import type { MeshOptions, ObjOptions, Shape } from './types.js';

const shapes: readonly Shape[] = ['sphere', 'torus', 'knot', 'genus3', 'openSheet'];

function toCoordinates(positions: unknown): Float64Array {
  const coordinates = toFloat64(positions, 'the positions');
  checkLength(coordinates, 3, 'the positions');
  return coordinates;
}

/** A loaded engine, which creates meshes. Meshes live in the engine's memory until `dispose`. */
export class Karcher {
  readonly #engine: Engine;

  /** @internal `load` creates engines. */
  constructor(engine: Engine) {
    this.#engine = engine;
  }

  /**
   * Reads a mesh from an OBJ file, given as text or as bytes (UTF-8).
   *
   * It cuts polygons into triangles, drops vertices of no face, and repairs defects where that is
   * safe (`MeshOptions`, `RepairKind`). `info.repairs` lists the repairs. `fileMarks` returns the
   * file's parts, materials and colors. Vertices and faces keep the file's order; a polygon counts
   * as its triangles. A point keeps its place, even if its face changed.
   *
   * Throws `KarcherError`: badFile (no OBJ, or no faces), badIndex, notFinite, badArgument (a
   * coordinate beyond 1e30, a mesh smaller than 1e-30), degenerateFace, notOrientable, and with
   * `repair: 'none'` nonManifoldEdge and nonManifoldVertex, each naming the place. If the longest
   * edge of a mesh is more than 1e12 times its shortest, distances by windows throw badArgument
   * (`Mesh.distance`).
   *
   * @example
   * ```ts
   * const mesh = karcher.meshFromObj('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3');
   * ```
   */
  meshFromObj(textOrBytes: string | Uint8Array, options: ObjOptions = {}): Mesh {
    if (typeof textOrBytes !== 'string' && !(textOrBytes instanceof Uint8Array)) {
      throw badArgument(`an OBJ file must be a string or a Uint8Array, not ${shown(textOrBytes)}`);
    }
    const { parts, ...meshOptions } = options;
    const { repair, weld } = engineMeshOptions(meshOptions);
    const wanted = parts ? toInt32(parts, 'the parts') : null;
    const bytes =
      typeof textOrBytes === 'string' ? new TextEncoder().encode(textOrBytes) : textOrBytes;
    const megabytes = (bytes.length / 2 ** 20).toFixed(0);
    checkFits(bytes.length, `an OBJ file of ${megabytes} MB takes`, this.#engine.allocatedBytes);
    return this.#mesh((engine) => engine.meshFromObj(bytes, wanted, repair, weld));
  }

  /**
   * Creates a mesh from positions (x, y, z for each vertex) and triangles (three vertex numbers for
   * each face, counterclockwise seen from outside). It copies both. Repairs and errors are those of
   * `meshFromObj`.
   */
  meshFromArrays(
    positions: ArrayLike<number>,
    triangles: ArrayLike<number>,
    options: MeshOptions = {},
  ): Mesh {
    const coordinates = toCoordinates(positions);
    const corners = toInt32(triangles, 'the triangles');
    checkLength(corners, 3, 'the triangles');
    const { repair, weld } = engineMeshOptions(options);
    checkMeshFits(
      coordinates.length / 3,
      corners.length / 3,
      'a mesh of',
      this.#engine.allocatedBytes,
    );
    return this.#mesh((engine) => engine.meshFromArrays(coordinates, corners, repair, weld));
  }

  /**
   * Creates a mesh from polygons. `corners` has the vertices of one polygon after the other, and
   * `sizes` has the number of corners of each polygon, at least 3. The polygons are cut into
   * triangles, like the polygons of an OBJ file, and each triangle is a face.
   */
  meshFromPolygons(
    positions: ArrayLike<number>,
    corners: ArrayLike<number>,
    sizes: ArrayLike<number>,
    options: MeshOptions = {},
  ): Mesh {
    const coordinates = toCoordinates(positions);
    const vertices = toInt32(corners, 'the corners');
    const counts = toInt32(sizes, 'the sizes');
    const { repair, weld } = engineMeshOptions(options);
    checkMeshFits(
      coordinates.length / 3,
      vertices.length - 2 * counts.length,
      'a mesh of',
      this.#engine.allocatedBytes,
    );
    return this.#mesh((engine) =>
      engine.meshFromPolygons(coordinates, vertices, counts, repair, weld),
    );
  }

  /**
   * A built-in shape of about this number of triangles. Throws `KarcherError` badArgument for an
   * unknown name or a number out of range.
   *
   * @example
   * ```ts
   * const mesh = karcher.shape('torus', 20_000);
   * ```
   */
  shape(name: Shape, triangles = 20_000): Mesh {
    checkOneOf(name, shapes, 'a shape');
    checkInteger(triangles, 'the number of triangles');
    return this.#mesh((engine) => engine.builtInShape(name, triangles));
  }

  /**
   * The number of used bytes in the engine's memory. Tests use it to check that memory is freed.
   */
  allocatedBytes(): number {
    return this.#engine.allocatedBytes();
  }

  #mesh(make: (engine: EngineModule) => EngineMesh): Mesh {
    return new Mesh(this.#engine, this.#engine.call(make));
  }
}
