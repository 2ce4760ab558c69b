/** A mesh in the scene, and the tree with which rays find its triangles. */
import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { MeshArrays } from '../model/mesh_blobs';
import type { UpAxis } from '../model/meshes';
import { type Frame, placesInScene } from './frame';

/** The frame of the vertices that belong to triangles. */
export function frameOf({ positions, triangles }: MeshArrays, up: UpAxis): Frame {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const vertex of triangles) {
    for (let axis = 0; axis < 3; axis++) {
      const value = positions[3 * vertex + axis]!;
      low[axis] = Math.min(low[axis]!, value);
      high[axis] = Math.max(high[axis]!, value);
    }
  }
  const center = low.map((value, axis) => (value + high[axis]!) / 2) as Frame['center'];
  const diagonal = Math.hypot(...low.map((value, axis) => high[axis]! - value));
  return { center, scale: 2 / diagonal, up };
}

/**
 * Converts a mesh to the scene's coordinates by a frame. Vertices without a triangle, which may lie
 * anywhere, move to the middle of the scene.
 */
export function geometryInScene({ positions, triangles }: MeshArrays, frame: Frame) {
  const places = placesInScene(frame, positions);
  const isUsed = new Uint8Array(places.length / 3);
  for (const vertex of triangles) isUsed[vertex] = 1;
  for (let vertex = 0; vertex < isUsed.length; vertex++) {
    if (!isUsed[vertex]) places.fill(0, 3 * vertex, 3 * vertex + 3);
  }
  const corners = Uint32Array.from(triangles);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setIndex(new BufferAttribute(corners, 1));
  return { geometry, positions: places, triangles: corners };
}

/**
 * The tree of a geometry. Without `indirect` it would reorder the triangles, and lose the engine's
 * numbering.
 */
export const treeOf = (geometry: BufferGeometry) => new MeshBVH(geometry, { indirect: true });
