/** The worker that prepares a surface for drawing and picking, so that the page never waits. */
import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { DrawnGeometry, GeometryRequest } from './drawn_geometry';
import { type Frame, placesInScene } from './frame';

type Corners = [number, number, number];

/** The frame of the vertices that triangles use. */
function frameOf({ positions, triangles, up }: GeometryRequest): Frame {
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

/** The sign of the volume that a closed surface encloses tells which way its triangles face. */
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

self.onmessage = ({ data }: MessageEvent<GeometryRequest>) => {
  const frame = frameOf(data);
  // Vertices that no triangle uses may be anything; three.js asks for bounds of all.
  const positions = placesInScene(frame, data.positions);
  for (let i = 0; i < positions.length; i++) if (!Number.isFinite(positions[i])) positions[i] = 0;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(Uint32Array.from(data.triangles), 1));
  geometry.computeVertexNormals();
  // Without `indirect` the tree would reorder the triangles, and lose the engine's numbering.
  const tree = MeshBVH.serialize(new MeshBVH(geometry, { indirect: true }), {
    cloneBuffers: false,
  });
  const normals = geometry.getAttribute('normal').array as Float32Array;
  const triangles = geometry.getIndex()!.array as Uint32Array;
  const outside = data.closed ? outsideOf(positions, triangles) : 'both';
  const answer: DrawnGeometry = { frame, positions, normals, triangles, tree, outside };
  const buffers = new Set<Transferable>([positions.buffer, normals.buffer, triangles.buffer]);
  for (const root of tree.roots) buffers.add(root);
  self.postMessage(answer, { transfer: [...buffers] });
};
