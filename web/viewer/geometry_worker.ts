/** The worker that prepares a surface for drawing and picking, so that the page never waits. */
import { MeshBVH } from 'three-mesh-bvh';
import { arraysOf } from '../model/mesh_blobs';
import { answering } from './answering';
import type { DrawnGeometry, GeometryRequest } from './drawn_geometry';
import { hollowsOf } from './hollows';
import { frameOf, geometryInScene, treeOf } from './scene_mesh';

type Corners = [number, number, number];

/**
 * The sides of triangles that face outwards, from the sign of the volume that a closed surface
 * encloses.
 */
function outsideOf(positions: Float32Array, triangles: Uint32Array): 'front' | 'back' {
  let volume = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => 3 * triangles[i + corner]!) as Corners;
    for (let axis = 0; axis < 3; axis++) {
      const [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
      const minor =
        positions[b + next]! * positions[c + last]! - positions[b + last]! * positions[c + next]!;
      volume += positions[a + axis]! * minor;
    }
  }
  return volume >= 0 ? 'front' : 'back';
}

async function drawn({ mesh, closed, up, colors = null }: GeometryRequest): Promise<DrawnGeometry> {
  const arrays = await arraysOf(mesh);
  const frame = frameOf(arrays, up);
  const { geometry, positions, triangles } = geometryInScene(arrays, frame);
  geometry.computeVertexNormals();
  const normals = geometry.getAttribute('normal').array as Float32Array;
  const outside = closed ? outsideOf(positions, triangles) : 'both';
  const hollows = hollowsOf(positions, normals, triangles);
  const tree = MeshBVH.serialize(treeOf(geometry), { cloneBuffers: false });
  return { mesh, frame, positions, normals, hollows, triangles, colors, tree, outside };
}

answering(drawn, ({ positions, normals, hollows, triangles, colors, tree }) => [
  ...[positions.buffer, normals.buffer, hollows.buffer, triangles.buffer, ...tree.roots],
  ...(colors ? [colors.buffer] : []),
  ...(tree.indirectBuffer ? [tree.indirectBuffer.buffer] : []),
]);
