import {
  type BatchedMesh,
  type BufferGeometry,
  type InstancedMesh,
  Matrix4,
  type Object3D,
  Vector3,
} from 'three';
import { KarcherError } from '../errors.js';
import type { Karcher } from '../karcher.js';
import type { EnginePlanes } from '../karcher-engine.mjs';
import type { Mesh } from '../mesh.js';
import { wirePoint } from '../points.js';
import type { MeshOptions, PointLike, SurfacePoint } from '../types.js';
import type { RemoteKarcher, RemoteMesh } from '../worker/index.js';
import { Triangles } from './triangles.js';

/** A mesh of the engine in the page or in a worker. */
export type AnyMesh = Mesh | RemoteMesh;

/**
 * The result of a raycast: an `Intersection` of three.js, or the result of `MeshBVH`. Without an
 * object the point is in the geometry's own coordinates, and the corners are numbers of the
 * surface's vertices.
 */
export interface SurfaceHit {
  /** The place of the hit. */
  point: { readonly x: number; readonly y: number; readonly z: number };
  /** The vertex numbers of the triangle's corners. */
  face?: { readonly a: number; readonly b: number; readonly c: number } | null | undefined;
  /** The number of that triangle. */
  faceIndex?: number | null | undefined;
  /** The object that was hit. The triangle is in its coordinates. */
  object?: Object3D | undefined;
  /** The instance of an `InstancedMesh`. */
  instanceId?: number | undefined;
  /** The instance of a `BatchedMesh`. */
  batchId?: number | undefined;
}

/** A point in a face, or a vertex with one of its faces. */
type InFace = { face: number; bary: [number, number, number] } | { face: number; vertex: number };

/** The largest distance between a hit's point and its surface point, relative to the diagonal. */
const farthest = 1e-6;

/**
 * A mesh of Karcher and its original geometry. All places are in the geometry's own coordinates,
 * which are those of the objects that draw it.
 */
export class Surface<OfMesh extends AnyMesh = AnyMesh> {
  /** The mesh, for all queries about the surface. */
  readonly mesh: OfMesh;
  /** @internal The original triangles of the mesh, in their original order. */
  readonly triangles: Triangles;
  readonly #planes: EnginePlanes;

  /** @internal `surfaceFromGeometry` and `surfaceFromMesh` create surfaces. */
  constructor(mesh: OfMesh, triangles: Triangles, planes: EnginePlanes) {
    this.mesh = mesh;
    this.triangles = triangles;
    this.#planes = planes;
  }

  /** The length of the bounding box's diagonal. */
  get diagonal(): number {
    return this.triangles.diagonal;
  }

  /**
   * The surface point at which a raycast hit an object that draws this surface. The triangle is
   * identified by the places of its corners, so that vertex numbers and the order of triangles do
   * not matter. A `MeshBVH` may change this order at any time. Throws `KarcherError` badPoint if
   * the hit is on another surface, or on this one in another shape (skinned, morphed, or edited
   * since). The place of the point and that of the hit may differ by at most 1e-6 of the diagonal.
   */
  pointAt(hit: SurfaceHit): SurfacePoint {
    const place = placeOf(hit);
    const face = this.triangles.find(this.#cornersOf(hit), hit.faceIndex ?? -1);
    if (face < 0) {
      throw new KarcherError('badPoint', 'the triangle that was hit is none of this surface');
    }
    const point = { face, bary: this.#weightsAt(face, place) };
    const away = this.position(point).distanceTo(place);
    if (away <= farthest * this.diagonal) return point;
    throw new KarcherError(
      'badPoint',
      `the hit lies ${away.toPrecision(3)} from the triangle that it names: the object is drawn in another shape than the surface's`,
    );
  }

  /** The place of a point, as a new vector or in `target`. */
  position(point: PointLike, target = new Vector3()): Vector3 {
    const own = this.#checked(point);
    // The face of a cut triangle may have no corner at the vertex.
    if ('vertex' in own) return target.fromArray(this.triangles.positions, 3 * own.vertex);
    target.set(0, 0, 0);
    for (const [k, weight] of own.bary.entries()) {
      target.addScaledVector(this.#corner(own.face, k), weight);
    }
    return target;
  }

  /**
   * The unit normal of the point's face, as `Mesh.normal` returns it. It is zero for a face without
   * area, where `Mesh.normal` takes the face beside it. It points up. All of a connected surface has
   * one upper side, from which the corners of most faces appear counterclockwise. The corners of a
   * face that the import turned over appear clockwise.
   */
  normal(point: PointLike, target = new Vector3()): Vector3 {
    const { face } = this.#checked(point);
    const from = this.#corner(face, 0);
    const along = this.#corner(face, 1).sub(from);
    target.copy(along.cross(this.#corner(face, 2).sub(from))).normalize();
    return this.#planes.turnedOver[face] ? target.negate() : target;
  }

  /**
   * The frame of a point. Its origin is the place of the point; its axes are two unit vectors in
   * the face, and the normal. An object with this matrix stands on the surface, its z axis upright.
   * At a vertex the face is the one in whose plane log vectors lie.
   */
  frame(point: PointLike, target = new Matrix4()): Matrix4 {
    const { face } = this.#checked(point);
    const normal = this.normal(point);
    const along = this.#corner(face, 1).sub(this.#corner(face, 0)).normalize();
    const across = new Vector3().crossVectors(normal, along);
    return target.makeBasis(along, across, normal).setPosition(this.position(point));
  }

  /** @internal The corners of each face, which appear counterclockwise from above. */
  cornersFromAbove(): Int32Array {
    const corners = this.triangles.corners.slice();
    this.#planes.turnedOver.forEach((isTurned, face) => {
      if (isTurned) corners.subarray(3 * face + 1, 3 * face + 3).reverse();
    });
    return corners;
  }

  /** A point with its face. For a vertex, the face is the engine's. */
  #checked(point: PointLike): InFace {
    const given = Array.from(wirePoint(point)) as [number, number, number, number];
    if (Number.isNaN(given[0])) {
      const [, vertex] = given;
      const face = this.#planes.faceOf[vertex] ?? -1;
      if (face >= 0) return { face, vertex };
      throw new KarcherError('badIndex', `there is no vertex ${vertex} of a face`);
    }
    const [face, ...bary] = given;
    if (face >= 0 && face < this.triangles.corners.length / 3) return { face, bary };
    throw new KarcherError('badIndex', `there is no face ${face}`);
  }

  #corner(face: number, k: number): Vector3 {
    const { positions, corners } = this.triangles;
    return new Vector3().fromArray(positions, 3 * corners[3 * face + k]!);
  }

  /** The places of the triangle's corners, as nine numbers. */
  #cornersOf({ face, faceIndex, object }: SurfaceHit): Float64Array {
    const geometry = (object as { geometry?: BufferGeometry } | undefined)?.geometry;
    const numbers = face
      ? [face.a, face.b, face.c]
      : [0, 1, 2].map((k) => {
          const corner = 3 * (faceIndex ?? Number.NaN) + k;
          return geometry?.index ? geometry.index.getX(corner) : corner;
        });
    const { positions } = this.triangles;
    const position = geometry?.attributes.position;
    const places = numbers.flatMap((v) =>
      position
        ? [position.getX(v), position.getY(v), position.getZ(v)]
        : [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]],
    );
    return Float64Array.from(places, (x) => x ?? Number.NaN);
  }

  /**
   * The barycentric weights of a place in a face. For a place slightly outside, negative weights
   * become 0.
   */
  #weightsAt(face: number, place: Vector3): [number, number, number] {
    const sides = [0, 1, 2].map((k) => this.#corner(face, k).sub(place));
    const from = this.#corner(face, 0);
    const normal = this.#corner(face, 1).sub(from).cross(this.#corner(face, 2).sub(from));
    const weights = [0, 1, 2].map((k) =>
      Math.max(
        0,
        sides[(k + 1) % 3]!.clone()
          .cross(sides[(k + 2) % 3]!)
          .dot(normal),
      ),
    );
    const sum = weights[0]! + weights[1]! + weights[2]!;
    return [weights[0]! / sum, weights[1]! / sum, weights[2]! / sum];
  }
}

/** The place of a hit in the coordinates of the geometry. */
function placeOf({ point, object, instanceId, batchId }: SurfaceHit): Vector3 {
  const place = new Vector3(point.x, point.y, point.z);
  if (!object) return place;
  const matrix = object.matrixWorld.clone();
  const own = new Matrix4();
  if (instanceId !== undefined) {
    (object as InstancedMesh).getMatrixAt(instanceId, own);
    matrix.multiply(own);
  } else if (batchId !== undefined) {
    (object as BatchedMesh).getMatrixAt(batchId, own);
    matrix.multiply(own);
  }
  if (matrix.determinant() === 0) {
    throw new KarcherError('badPoint', 'the object that was hit is scaled to nothing');
  }
  return place.applyMatrix4(matrix.invert());
}

/**
 * Creates the surface of a geometry. The surface has copies of the positions and triangles, so that
 * a `MeshBVH` may later change their order in the geometry. The engine welds vertices at one place
 * where their faces meet, such as along seams of texture coordinates. The geometry itself, with its
 * groups, does not change. Vertex i of the mesh is vertex i of the geometry.
 *
 * With the engine of `loadInWorker`, the result is a promise. Throws what `Karcher.meshFromArrays`
 * throws, and `KarcherError` badArgument for a geometry without positions.
 */
export function surfaceFromGeometry(
  karcher: Karcher,
  geometry: BufferGeometry,
  options?: MeshOptions,
): Surface<Mesh>;
export function surfaceFromGeometry(
  karcher: RemoteKarcher,
  geometry: BufferGeometry,
  options?: MeshOptions,
): Promise<Surface<RemoteMesh>>;
export function surfaceFromGeometry(
  karcher: Karcher | RemoteKarcher,
  { index, attributes }: BufferGeometry,
  options: MeshOptions = {},
): Surface<Mesh> | Promise<Surface<RemoteMesh>> {
  const { position } = attributes;
  if (!position) throw new KarcherError('badArgument', 'the geometry has no positions');
  const positions = new Float64Array(3 * position.count);
  for (let v = 0; v < position.count; v++) {
    positions.set([position.getX(v), position.getY(v), position.getZ(v)], 3 * v);
  }
  const corners = Int32Array.from({ length: index?.count ?? position.count }, (_, i) =>
    index ? index.getX(i) : i,
  );
  const mesh = karcher.meshFromArrays(positions, corners, options);
  return mesh instanceof Promise
    ? mesh.then(async (made) => {
        const [named, planes] = await Promise.all([made.triangles(), made.planes()]);
        return surfaceOf(made, { positions, corners, named, planes });
      })
    : surfaceOf(mesh, { positions, corners, named: mesh.triangles(), planes: mesh.planes() });
}

/** The surface of a mesh from another source. `geometryOf` returns a geometry that draws it. */
export function surfaceFromMesh(mesh: Mesh): Surface<Mesh>;
export function surfaceFromMesh(mesh: RemoteMesh): Promise<Surface<RemoteMesh>>;
export function surfaceFromMesh(mesh: AnyMesh): Surface<Mesh> | Promise<Surface<RemoteMesh>> {
  const parts = [mesh.positions(), mesh.triangles(), mesh.planes()] as const;
  const made = ([places, corners, planes]: readonly [Float64Array, Int32Array, EnginePlanes]) => {
    // The graphics card has places of 32 bits, and hits refer to them.
    const positions = Float64Array.from(places, Math.fround);
    return { positions, corners, named: corners, planes };
  };
  return parts[0] instanceof Promise
    ? Promise.all(parts).then((data) => surfaceOf(mesh as RemoteMesh, made(data)))
    : surfaceOf(mesh as Mesh, made(parts as [Float64Array, Int32Array, EnginePlanes]));
}

interface SurfaceParts {
  positions: Float64Array;
  corners: Int32Array;
  named: Int32Array;
  planes: EnginePlanes;
}

const surfaceOf = <OfMesh extends AnyMesh>(
  mesh: OfMesh,
  { positions, corners, named, planes }: SurfaceParts,
) => new Surface(mesh, new Triangles(positions, corners, named, planes.faceOf), planes);
