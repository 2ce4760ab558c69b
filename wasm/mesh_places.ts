import { frozenInfo, toVector } from './check.js';
import { type Engine, Handle, type MeshHandle } from './engine.js';
import type { EngineFans, EngineKept, EngineMesh, EnginePlanes } from './karcher-engine.mjs';
import * as maps from './maps.js';
import type { Outline, PathPoints } from './path_types.js';
import { toSurfacePoint, wirePoint, wirePointsOrArrays } from './points.js';
import type {
  FileMarks,
  Frame,
  MeshInfo,
  NearestPoint,
  PointArrays,
  PointLike,
  SurfacePoint,
  VectorLike,
} from './types.js';

/** The methods of `Mesh` for its vertices and faces, and for places on the mesh and on paths. */
export class MeshPlaces {
  readonly #handle: MeshHandle;

  /** The counts of the mesh's elements, its sizes, and its repairs. */
  readonly info: Readonly<MeshInfo>;

  /** @internal `Karcher` creates meshes. */
  constructor(engine: Engine, target: EngineMesh) {
    this.#handle = new Handle(engine, 'the mesh', target);
    this.info = frozenInfo(this.#handle.call((mesh) => mesh.info()));
  }

  /** @internal The mesh in the engine's memory. */
  get handle(): MeshHandle {
    return this.#handle;
  }

  /**
   * x, y, z of each vertex, in the caller's order, as a new array. Welded vertices have the same
   * place; dropped vertices keep their places.
   *
   * @example
   * ```ts
   * const place = mesh.positions().subarray(3 * 12, 3 * 12 + 3); // of vertex 12
   * ```
   */
  positions(): Float64Array {
    return this.#handle.call((mesh) => mesh.positions());
  }

  /**
   * The three vertices of each triangle, as a new array. Triangles are in the caller's order, and
   * vertices have the caller's numbers. Of welded vertices, triangles name the first.
   *
   * @example
   * ```ts
   * const corners = mesh.triangles().subarray(3 * 7, 3 * 7 + 3); // of face 7
   * ```
   */
  triangles(): Int32Array {
    return this.#handle.call((mesh) => mesh.triangles());
  }

  /**
   * The marks of the mesh's OBJ file, beside its surface. They are empty for other meshes;
   * `meshFromFile` of `karcher/formats` returns the marks of other files.
   */
  fileMarks(): FileMarks {
    return this.#handle.call((mesh) => mesh.marks());
  }

  /**
   * The point of a face with the given weights of its corners, checked and cleaned. If rounding has
   * led the weights at most 1e-6 out of the face, the point moves onto the face. A raycast of
   * three.js returns face and weights as `faceIndex` and `barycoord`.
   *
   * @example
   * ```ts
   * const middle = mesh.surfacePoint(17, [1 / 3, 1 / 3, 1 / 3]);
   * ```
   */
  surfacePoint(face: number, bary: VectorLike): SurfacePoint {
    const wire = wirePoint({ face, bary } as PointLike);
    return toSurfacePoint(this.#handle.call((mesh) => mesh.checkedPoint(wire)));
  }

  /**
   * The place of a point in space.
   *
   * @example
   * ```ts
   * const [x, y, z] = mesh.position({ vertex: 12 });
   * ```
   */
  position(point: PointLike): [number, number, number] {
    const wire = wirePoint(point);
    return this.#handle.call((mesh) => mesh.position(wire));
  }

  /**
   * The places of points, x, y, z for each. The points are a list, or flat arrays such as those of
   * `CentersOfMass`.
   */
  positionsOf(points: readonly PointLike[] | PointArrays): Float64Array {
    const wire = wirePointsOrArrays(points);
    return this.#handle.call((mesh) => mesh.positionsOf(wire));
  }

  /**
   * The unit normal of a point's face. All normals of a connected surface point to the same side:
   * the corners of a face appear counterclockwise from there, unless the import turned it over.
   *
   * @example
   * ```ts
   * const [x, y, z] = mesh.normal({ vertex: 12 });
   * ```
   */
  normal(point: PointLike): [number, number, number] {
    const wire = wirePoint(point);
    return this.#handle.call((mesh) => mesh.normal(wire));
  }

  /**
   * Three unit vectors at a point: along the first edge of its face, at right angles to this edge
   * in the face, and the normal.
   *
   * @example
   * ```ts
   * const [along, across, normal] = mesh.frame({ vertex: 12 });
   * ```
   */
  frame(point: PointLike): Frame {
    const wire = wirePoint(point);
    return this.#handle.call((mesh) => mesh.frame(wire));
  }

  /** @internal What remains after the import, for `karcher/checkup` and `karcher/statistics`. */
  kept(): EngineKept {
    return this.#handle.call((mesh) => mesh.kept());
  }

  /** @internal The vertices of triangles on the surface, for `karcher/statistics`. */
  fans(): EngineFans {
    return this.#handle.call((mesh) => mesh.fans());
  }

  /** @internal The planes of vectors, for `karcher/three`. */
  planes(): EnginePlanes {
    return this.#handle.call((mesh) => mesh.planes());
  }

  /**
   * The point of the surface that is nearest to a place in space; if several points are equally
   * near, one of them.
   *
   * @example
   * ```ts
   * const { point, distance } = mesh.nearestPoint([0.1, 0.2, 0.3]);
   * ```
   */
  nearestPoint(place: VectorLike): NearestPoint {
    const vector = toVector(place, 'the place');
    const { point, distance } = this.#handle.call((mesh) => mesh.nearestPoint(vector));
    const position = this.#handle.call((mesh) => mesh.position(point));
    return { point: toSurfacePoint(point), position, distance };
  }

  /**
   * `count` points of a path, with equal lengths between neighbors, as `Curve.equallySpaced`
   * returns them for a curve. They include both ends of an open path, and begin at the start of a
   * closed one.
   *
   * @throws {KarcherError} as `transportAlong` does, and badArgument for a count below 1.
   * @example
   * ```ts
   * const { face, bary } = mesh.equallySpaced(mesh.shortestPath(a, b), 10);
   * ```
   */
  equallySpaced(path: Outline, count: number): PathPoints {
    return maps.equallySpaced(this.#handle, path, count);
  }

  /**
   * The points at lengths from the start of a path. For a length beyond the path, the point is its
   * end.
   *
   * @throws {KarcherError} as `transportAlong` does.
   * @example
   * ```ts
   * const { position } = mesh.pointsAtLengths(path, [path.length / 2]);
   * ```
   */
  pointsAtLengths(path: Outline, lengths: ArrayLike<number>): PathPoints {
    return maps.pointsAlong(this.#handle, path, lengths);
  }
}
