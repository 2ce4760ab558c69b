import type { PointLike, SurfacePoint } from '../types.js';
import { at, cross, distance, dot, subtract, type Vector } from '../vectors.js';
import type { AnyMesh } from './energy.js';
import { facesOf } from './surface.js';

/**
 * The caller's triangles as faces of the surface. Where several fans of faces meet at a vertex,
 * faces have numbers for it that are apart: the number of the vertex in one fan, and numbers after
 * those of all vertices in the others.
 */
export interface Fans {
  /** Three numbers of vertices for each triangle. */
  corners: Int32Array;
  /** The caller's vertex of each number. */
  vertices: Int32Array;
  /** The position of each number: x, y, z. */
  positions: Float64Array;
  /** 1 for each triangle that was turned over. */
  turnedOver: Uint8Array;
  /** The connected part of each triangle and of each number; null if no vertex has several fans. */
  parts: { ofFaces: Int32Array; ofNumbers: Int32Array } | null;
}

/** The fans of a mesh. */
export async function fansOf(mesh: AnyMesh): Promise<Fans> {
  const given = await mesh.positions();
  const corners = await facesOf(mesh, given);
  const turnedOver = new Uint8Array(corners.length / 3);
  const vertices = Array.from({ length: given.length / 3 }, (_, vertex) => vertex);
  const isDivided = mesh.info.repairs.some(({ kind }) =>
    ['turnedOver', 'branching', 'bowTie'].includes(kind),
  );
  if (!isDivided) {
    return {
      corners,
      vertices: Int32Array.from(vertices),
      positions: given,
      turnedOver,
      parts: null,
    };
  }
  const ofFaces = new Int32Array(corners.length / 3).fill(-1);
  const ofNumbers = vertices.map(() => -1);
  const agreement = new Float64Array(corners.length / 3);
  // Without paths, `cut` divides a mesh into its components, whose vertices and orientation are
  // those of the surface.
  for (const [number, part] of (await mesh.cut([])).entries()) {
    const known = new Map<number, number>();
    part.faces.forEach((face, i) => {
      ofFaces[face] = number;
      const own = [...part.triangles.subarray(3 * i, 3 * i + 3)];
      const places = own.map((vertex) => at(part.positions, vertex));
      const before = [...corners.subarray(3 * face, 3 * face + 3)].map((v) => vertices[v]!);
      const there = before.map((vertex) => at(given, vertex));
      agreement[face]! += dot(normalOf(places), normalOf(there));
      own.forEach((vertex, j) => {
        // A repair may have put a vertex on a side of a face.
        const k = there.findIndex((place) => distance(place, places[j]!) === 0);
        if (k < 0) return;
        if (!known.has(vertex)) {
          const isFree = ofNumbers[before[k]!] === -1;
          known.set(vertex, isFree ? before[k]! : vertices.push(before[k]!) - 1);
          ofNumbers[known.get(vertex)!] = number;
        }
        corners[3 * face + k] = known.get(vertex)!;
      });
    });
  }
  return {
    corners,
    vertices: Int32Array.from(vertices),
    positions: Float64Array.from(vertices.flatMap((vertex) => at(given, vertex))),
    turnedOver: turnedOver.map((_, face) => +(agreement[face]! < 0)),
    parts: { ofFaces, ofNumbers: Int32Array.from(ofNumbers) },
  };
}

/** A point of a face of the surface; other parts may have a face at its place. */
export async function inFace(mesh: AnyMesh, point: PointLike): Promise<SurfacePoint> {
  const [{ face, bary }] = (await mesh.expMap(point, [0, 0, 0])).points as [SurfacePoint];
  return { face, bary: [...bary] };
}

/** A vector along the normal of a triangle. */
const normalOf = ([a, b, c]: readonly Vector[]) => cross(subtract(b!, a!), subtract(c!, a!));
