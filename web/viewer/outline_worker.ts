/** The worker that draws the surface's outline, so that the page never waits. */
import { arraysOf } from '../model/mesh_blobs';
import { answering } from './answering';
import { seenOutline } from './hidden_lines';
import type { OutlineRequest } from './outline_request';
import { geometryInScene, treeOf } from './scene_mesh';

async function outline({ mesh, frame, sight }: OutlineRequest): Promise<Float32Array[]> {
  const { geometry, ...inScene } = geometryInScene(await arraysOf(mesh), frame);
  return seenOutline(inScene, treeOf(geometry), sight);
}

answering(outline, (lines) => lines.map(({ buffer }) => buffer));
