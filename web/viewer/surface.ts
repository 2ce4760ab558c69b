import type { SurfacePoint } from 'karcher';
import {
  type Box3,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  type Mesh,
  Quaternion,
  type Ray,
  Sphere,
  Vector3,
} from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { surfacePoint, type Vector } from '../model/figure';
import { blobsOf, type MeshBlobs } from '../model/mesh_blobs';
import type { SurfacePart } from '../model/parts';
import type { Pattern, Region } from '../model/traced';
import { clayMesh, edgeMesh, paint, showClay, showTint, showValues } from './clay';
import type { DrawnGeometry } from './drawn_geometry';
import {
  directionFromScene,
  directionInScene,
  type Frame,
  placeFromScene,
  placeInScene,
  placesInScene,
} from './frame';
import { hollowWidths } from './hollows';
import { SurfaceParts } from './surface_parts';

export { colorSurface, fitSurface } from './clay';

/** A weight of a picked point with few decimals, so that links are short. */
const shortened = (weight: number) => Math.floor(weight * 1e9) / 1e9;

/** A point under the pointer, and its place in the scene. */
export interface Pick {
  point: SurfacePoint;
  position: Vector3;
}

const unitWeights = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;

/** Whole faces, and triangles within faces. */
type Triangulated = Omit<Region, 'area' | 'side' | 'boundary' | 'corners'> & {
  corners: Float32Array | Float64Array;
};

/** A surface in the scene: its triangles for drawing, and for rays. */
export class Surface {
  readonly object = new Group();
  readonly frame: Frame;
  /** Whether the surface's file has colors. */
  readonly hasColors: boolean;
  /** The whole mesh in the surface's own coordinates. */
  readonly #mesh: MeshBlobs;
  /** The visible parts of a cut surface; null if the whole is visible. */
  #shown: readonly SurfacePart[] | null = null;
  readonly #geometry = new BufferGeometry();
  readonly #tree: MeshBVH;
  readonly #positions: Float32Array;
  readonly #triangles: Uint32Array;
  readonly #normals: Float32Array;
  readonly #hollows: Int8Array;
  readonly #outside: DrawnGeometry['outside'];
  /** A flag for each face, 1 if the face is visible; null if all faces are visible. */
  #seen: Uint8Array | null = null;
  readonly #edges: Mesh;
  #edgesShown = false;
  readonly #whole: Mesh;
  /** The visible parts in place of a cut surface. */
  readonly #parts = new SurfaceParts(clayMesh, edgeMesh, paint);
  readonly #along = new WeakMap<Float32Array, Float32Array>();

  constructor(drawn: DrawnGeometry) {
    this.frame = drawn.frame;
    this.#mesh = drawn.mesh;
    this.#positions = drawn.positions;
    this.#triangles = drawn.triangles;
    this.#normals = drawn.normals;
    this.#outside = drawn.outside;
    this.#geometry.setAttribute('position', new BufferAttribute(drawn.positions, 3));
    this.#geometry.setAttribute('normal', new BufferAttribute(drawn.normals, 3));
    this.#hollows = drawn.hollows;
    this.#geometry.setAttribute('hollow', new BufferAttribute(drawn.hollows, hollowWidths, true));
    this.hasColors = drawn.colors !== null;
    if (drawn.colors) {
      this.#geometry.setAttribute('tint', new BufferAttribute(drawn.colors, 3, true));
    }
    this.#geometry.setIndex(new BufferAttribute(drawn.triangles, 1));
    // The sphere around the frame's box suffices; three.js would look at all vertices.
    this.#geometry.boundingSphere = new Sphere(new Vector3(), 1);
    showClay(drawn.outside);
    this.#tree = MeshBVH.deserialize(drawn.tree, this.#geometry, { setIndex: false });
    this.#edges = edgeMesh(this.#geometry);
    this.#edges.visible = false;
    this.#whole = clayMesh(this.#geometry);
    this.object.add(this.#whole, this.#edges, this.#parts.object);
  }

  /** The surface's vertices and triangles, in the scene. */
  get arrays(): { positions: Float32Array; triangles: Uint32Array } {
    return { positions: this.#positions, triangles: this.#triangles };
  }

  /** What is visible, in the surface's own coordinates: the whole mesh, or each visible part. */
  get shownMeshes(): readonly MeshBlobs[] {
    return this.#shown?.map(blobsOf) ?? [this.#mesh];
  }

  /** The number of triangles. */
  get triangles(): number {
    return this.#triangles.length / 3;
  }

  set edges(visible: boolean) {
    this.#edgesShown = visible;
    this.#edges.visible = visible && this.#whole.visible;
    this.#parts.edgesShown = visible;
  }

  /** Whether the surface shows its own colors, if it has any. */
  set colored(shown: boolean) {
    showTint(shown && this.hasColors);
  }

  /**
   * Colors the surface by values at its vertices, from 0 to `most`, which is positive. Vertices
   * with value -`most` keep the surface's color. With null, the whole surface keeps it.
   */
  colorBy(colored: { values: Float32Array; most: number } | null): void {
    showValues(colored?.most ?? 0);
    if (colored) this.#geometry.setAttribute('value', new BufferAttribute(colored.values, 1));
    else this.#geometry.deleteAttribute('value');
  }

  /**
   * Shows parts instead of the whole surface, each with or without a color over it; null shows the
   * whole.
   */
  showParts(parts: readonly { part: SurfacePart; color: string | null }[] | null): void {
    this.#whole.visible = parts === null;
    this.#edges.visible = this.#edgesShown && parts === null;
    this.#parts.show(parts ?? [], (part) => this.#partGeometry(part));
    this.#shown = parts?.map(({ part }) => part) ?? null;
    this.#seen = this.#shown && seenFaces(this.#shown, this.triangles);
  }

  #partGeometry({ faces, weights }: SurfacePart): BufferGeometry {
    const none = new Int32Array();
    return this.regionGeometry({ whole: none, parts: faces, corners: weights });
  }

  /** The triangles of a region. */
  regionGeometry({ whole, parts, corners }: Triangulated): BufferGeometry {
    const count = 3 * (whole.length + parts.length);
    const [positions, normals] = [new Float32Array(3 * count), new Float32Array(3 * count)];
    const bent = new Float32Array(hollowWidths * count);
    let to = 0;
    const add = (
      face: number,
      weights: readonly [number, number, number],
      order: readonly number[] = [0, 1, 2],
    ) => {
      let [x, y, z] = [0, 0, 0];
      for (const corner of order) {
        const from = 3 * this.#triangles[3 * face + corner]!;
        const weight = weights[corner]!;
        for (let width = 0; width < hollowWidths; width++) {
          const sunken = this.#hollows[(from / 3) * hollowWidths + width]!;
          bent[(to / 3) * hollowWidths + width]! += weight * sunken;
        }
        x += weight * this.#positions[from]!;
        y += weight * this.#positions[from + 1]!;
        z += weight * this.#positions[from + 2]!;
        for (let axis = 0; axis < 3; axis++) {
          normals[to + axis]! += weight * this.#normals[from + axis]!;
        }
      }
      positions[to] = x;
      positions[to + 1] = y;
      positions[to + 2] = z;
      to += 3;
    };
    for (const face of whole) for (const corner of unitWeights) add(face, corner);
    for (const [i, face] of parts.entries()) {
      // The sum over the corners is in the order of the vertex indices, so that a point of an edge
      // is at the same place in both faces, to the last bit.
      const vertexOf = (corner: number) => this.#triangles[3 * face + corner]!;
      const order = [0, 1, 2].sort((a, b) => vertexOf(a) - vertexOf(b));
      for (let at = 6 * i; at < 6 * i + 6; at += 2) {
        const [b, c] = [corners[at]!, corners[at + 1]!];
        add(face, [1 - b - c, b, c], order);
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setAttribute(
      'hollow',
      new BufferAttribute(Int8Array.from(bent, Math.round), hollowWidths, true),
    );
    geometry.boundingSphere = new Sphere(new Vector3(), 1);
    return geometry;
  }

  /** The triangles of a pattern, with its distances. */
  patternGeometry({ faces, corners, values }: Pattern): BufferGeometry {
    const geometry = this.regionGeometry({ whole: new Int32Array(), parts: faces, corners });
    geometry.setAttribute('value', new BufferAttribute(values, 1));
    return geometry;
  }

  /** The first point where a ray of the scene meets a visible face of the surface. */
  pick(ray: Ray): Pick | null {
    const hit = this.#hit(ray);
    return hit ? this.#pickAt(hit.faceIndex!, hit.point) : null;
  }

  /**
   * The distance along the ray to a visible face of the surface; infinite if the ray meets none.
   */
  depth(ray: Ray): number {
    return this.#hit(ray)?.distance ?? Infinity;
  }

  #hit(ray: Ray) {
    const first = this.#tree.raycastFirst(ray, DoubleSide);
    const seen = this.#seen;
    if (!seen || !first || seen[first.faceIndex!] === 1) return first;
    const hits = this.#tree.raycast(ray, DoubleSide).filter((hit) => seen[hit.faceIndex!] === 1);
    return hits.toSorted((a, b) => a.distance - b.distance)[0] ?? null;
  }

  /** The surface's point nearest to a point of the scene. */
  nearest(position: Vector3): SurfacePoint {
    const hit = this.#tree.closestPointToPoint(position)!;
    return this.#pickAt(hit.faceIndex, hit.point).point;
  }

  /** The distance of a place of the scene from the surface; null if it exceeds `most`. */
  distanceWithin(position: Vector3, most: number): number | null {
    return this.#tree.closestPointToPoint(position, undefined, 0, most)?.distance ?? null;
  }

  /** The place of a surface point in the scene. */
  position({ face, bary }: SurfacePoint, target = new Vector3()): Vector3 {
    target.set(0, 0, 0);
    for (let corner = 0; corner < 3; corner++) {
      target.addScaledVector(this.#corner(face, corner), bary[corner]!);
    }
    return target;
  }

  /** The places of a face's corners in the scene. */
  corners(face: number): [Vector3, Vector3, Vector3] {
    return [this.#corner(face, 0), this.#corner(face, 1), this.#corner(face, 2)];
  }

  /** The unit normal at a surface point. It points outwards if the surface has an outside. */
  normal({ face, bary }: SurfacePoint): Vector3 {
    const normal = new Vector3();
    for (let corner = 0; corner < 3; corner++) {
      const vertex = this.#triangles[3 * face + corner]!;
      normal.addScaledVector(new Vector3().fromArray(this.#normals, 3 * vertex), bary[corner]!);
    }
    return normal.normalize().multiplyScalar(this.#outside === 'back' ? -1 : 1);
  }

  /** The unit normals at the points of a polyline on the surface, in the scene. */
  normalsAlong(line: Float32Array): Float32Array {
    const known = this.#along.get(line);
    if (known) return known;
    const normals = new Float32Array(line.length);
    const place = new Vector3();
    for (let i = 0; i < line.length; i += 3) {
      this.normal(this.nearest(place.fromArray(line, i))).toArray(normals, i);
    }
    this.#along.set(line, normals);
    return normals;
  }

  /** Converts a polyline (x, y, z for each point) from the surface's coordinates to the scene's. */
  toScene(polyline: Float32Array): Float32Array {
    return placesInScene(this.frame, polyline);
  }

  /** Converts a place from the surface's coordinates to the scene's. */
  inScene(place: Vector): Vector3 {
    return new Vector3(...placeInScene(this.frame, place));
  }

  /** Converts a place from the scene's coordinates to the surface's. */
  fromScene(position: Vector3): Vector {
    return placeFromScene(this.frame, position.toArray());
  }

  /** Converts a direction from the surface's coordinates to the scene's. */
  directionInScene(direction: Vector): Vector3 {
    return new Vector3(...directionInScene(this.frame.up, direction));
  }

  /** Converts a direction from the scene's coordinates to the surface's. */
  directionFromScene(direction: Vector3): Vector {
    return directionFromScene(this.frame.up, direction.toArray());
  }

  /**
   * Maps directions at one point to directions at another, by the rotation of the first normal into
   * the second.
   */
  carry(from: SurfacePoint, to: SurfacePoint): (direction: Vector) => Vector {
    const turning = new Quaternion().setFromUnitVectors(this.normal(from), this.normal(to));
    return (direction) =>
      this.directionFromScene(this.directionInScene(direction).applyQuaternion(turning));
  }

  /**
   * The point to which `other` moves while `from` moves to `to`. Both move by the same distance and
   * in the same direction along the surface.
   */
  along(from: SurfacePoint, to: SurfacePoint, other: SurfacePoint): SurfacePoint {
    const turning = new Quaternion().setFromUnitVectors(this.normal(from), this.normal(other));
    const step = this.position(to).sub(this.position(from)).applyQuaternion(turning);
    return this.nearest(this.position(other).add(step));
  }

  /**
   * The distance, in a direction from the scene's middle, at which an upright camera sees the
   * surface's whole width. `slope` is the tangent of half the camera's horizontal field of view.
   */
  widthDistance(direction: Vector3, slope: number): number {
    const aside = new Vector3(0, 1, 0).cross(direction).normalize().divideScalar(slope);
    const sides = [direction.clone().add(aside), direction.clone().sub(aside)];
    return Math.max(0, ...sides.map((side) => this.#reach(side)));
  }

  /** The height of the surface's lowest place in the scene. */
  get lowest(): number {
    return -this.#reach(new Vector3(0, -1, 0));
  }

  /**
   * The surface's farthest reach from the scene's middle in a direction, times the direction's
   * length.
   */
  #reach(direction: Vector3): number {
    let farthest = -Infinity;
    // The search skips boxes that would increase the extent by less than this. On a plane, it would
    // otherwise enter all boxes, since they have the same extent.
    const grain = 1e-6 * direction.length();
    const corner = new Vector3();
    const reachOf = (box: Box3) =>
      corner
        .set(
          direction.x > 0 ? box.max.x : box.min.x,
          direction.y > 0 ? box.max.y : box.min.y,
          direction.z > 0 ? box.max.z : box.min.z,
        )
        .dot(direction);
    this.#tree.shapecast({
      boundsTraverseOrder: (box) => -reachOf(box),
      intersectsBounds: (box) => reachOf(box) > farthest + grain,
      intersectsTriangle: ({ a, b, c }) => {
        farthest = Math.max(farthest, a.dot(direction), b.dot(direction), c.dot(direction));
        return false;
      },
    });
    return farthest;
  }

  dispose(): void {
    this.#geometry.dispose();
    this.#parts.dispose();
  }

  #corner(face: number, corner: number): Vector3 {
    return new Vector3().fromArray(this.#positions, 3 * this.#triangles[3 * face + corner]!);
  }

  #pickAt(face: number, hit: Vector3): Pick {
    const origin = this.#corner(face, 0);
    const a = this.#corner(face, 1).sub(origin);
    const b = this.#corner(face, 2).sub(origin);
    const d = hit.clone().sub(origin);
    const [aa, ab, bb, da, db] = [a.dot(a), a.dot(b), b.dot(b), d.dot(a), d.dot(b)];
    const area = aa * bb - ab * ab;
    const u = area > 0 ? Math.max(0, (bb * da - ab * db) / area) : 0;
    const v = area > 0 ? Math.max(0, (aa * db - ab * da) / area) : 0;
    const sum = Math.max(1, u + v);
    const point = surfacePoint(face, shortened(u / sum), shortened(v / sum));
    return { point, position: this.position(point) };
  }
}

function seenFaces(parts: readonly SurfacePart[], count: number): Uint8Array {
  const seen = new Uint8Array(count);
  for (const { faces } of parts) for (const face of faces) seen[face] = 1;
  return seen;
}
