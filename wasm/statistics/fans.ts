import type { PointLike, SurfacePoint } from '../types.js';
import { at } from '../vectors.js';
import type { AnyMesh } from './energy.js';

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
  /** The connected part of each number; null if no vertex has several fans. */
  parts: Int32Array | null;
}

/** The fans of a mesh. */
export async function fansOf(mesh: AnyMesh): Promise<Fans> {
  const given = await mesh.positions();
  const { corners, copies, parts } = await mesh.fans();
  const { turnedOver } = await mesh.planes();
  leaveOutFins(corners, (await mesh.kept()).areFaces);
  const count = given.length / 3;
  const vertices = new Int32Array(count + copies.length).map((_, number) => number);
  vertices.set(copies, count);
  const positions = new Float64Array(3 * vertices.length);
  positions.set(given);
  copies.forEach((vertex, i) => {
    positions.set(at(given, vertex), 3 * (count + i));
  });
  return { corners, vertices, positions, turnedOver, parts: copies.length > 0 ? parts : null };
}

/**
 * Leaves out triangles without area that join no others, since no other triangle has two of their
 * sides. The rest join a triangle at their longest side to several at their shorter ones.
 */
function leaveOutFins(corners: Int32Array, areFaces: Uint8Array): void {
  const flat: number[] = [];
  areFaces.forEach((isFace, face) => {
    if (!isFace && corners[3 * face]! >= 0) flat.push(face);
  });
  if (flat.length === 0) return;
  const sidesOf = (face: number) =>
    [0, 1, 2].map((k) => {
      const [from, to] = [corners[3 * face + k]!, corners[3 * face + ((k + 1) % 3)]!];
      return Math.min(from, to) * 2 ** 26 + Math.max(from, to);
    });
  const uses = new Map(flat.flatMap(sidesOf).map((side) => [side, 0]));
  for (const face of areFaces.keys()) {
    for (const side of sidesOf(face)) if (uses.has(side)) uses.set(side, uses.get(side)! + 1);
  }
  for (let left = flat, before = 0; left.length !== before; ) {
    before = left.length;
    left = left.filter((face) => {
      const sides = sidesOf(face);
      const isFin =
        new Set(sides).size < 3 || sides.filter((side) => uses.get(side) === 1).length > 1;
      if (!isFin) return true;
      for (const side of sides) uses.set(side, uses.get(side)! - 1);
      corners.fill(-1, 3 * face, 3 * face + 3);
      return false;
    });
  }
}

/** A point of a face of the surface; other parts may have a face at its place. */
export async function inFace(mesh: AnyMesh, point: PointLike): Promise<SurfacePoint> {
  const [{ face, bary }] = (await mesh.expMap(point, [0, 0, 0])).points as [SurfacePoint];
  return { face, bary: [...bary] };
}
