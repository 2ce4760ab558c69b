/** The worker that draws the surface's outline, so that the page never waits. */
import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { seenOutline } from './hidden_lines';
import type { OutlineRequest } from './outline_request';

self.onmessage = ({ data }: MessageEvent<OutlineRequest>) => {
  const { mesh, tree, sight } = data;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  geometry.setIndex(new BufferAttribute(mesh.triangles, 1));
  const lines = seenOutline(mesh, MeshBVH.deserialize(tree, geometry, { setIndex: false }), sight);
  self.postMessage(lines, { transfer: lines.map(({ buffer }) => buffer) });
};
