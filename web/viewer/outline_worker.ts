/** The worker that draws the surface's outline, so that the page never waits. */
import { arraysOf, joined } from '../model/mesh_blobs';
import { answering } from './answering';
import { seenOutline } from './hidden_lines';
import type { OutlineRequest } from './outline_request';
import { geometryInScene, treeOf } from './scene_mesh';

async function outline({ meshes, frame, sight }: OutlineRequest): Promise<Float32Array[]> {
  const mesh = joined(await Promise.all(meshes.map(arraysOf)));
  if (mesh.triangles.length === 0) return [];
  const { geometry, ...inScene } = geometryInScene(mesh, frame);
  return seenOutline(inScene, treeOf(geometry), sight);
}

answering(outline, (lines) => lines.map(({ buffer }) => buffer));
