/** The worker that runs the engine: `karcher/worker-thread` that also makes the page's meshes. */
import { type Karcher, type LongWorkOptions, load, type Mesh } from 'karcher';
import { serve } from 'karcher/own-worker';
import type { MeshSource } from '../model/meshes';

/** What can be asked of the worker; the rest is asked of the mesh. */
const calls = {
  async load(source: MeshSource, { progress = () => {} }: LongWorkOptions) {
    progress(0, 'Starting the engine');
    const karcher = await load();
    progress(0.2, 'Reading the surface');
    const mesh = await meshOf(karcher, source, progress);
    return { mesh, positions: mesh.positions(), triangles: mesh.triangles() };
  },
};

export type Calls = typeof calls;

serve(calls);

async function meshOf(
  karcher: Karcher,
  source: MeshSource,
  progress: NonNullable<LongWorkOptions['progress']>,
): Promise<Mesh> {
  switch (source.kind) {
    case 'file':
      return karcher.meshFromObj(source.bytes);
    case 'arrays':
      return karcher.meshFromArrays(source.positions, source.triangles);
    case 'bunny':
    case 'shape': {
      const { makeSample } = await import('../model/sample_mesh');
      return makeSample(karcher, source, progress);
    }
    default: {
      const { makeMesh } = await import('../model/made_mesh');
      return makeMesh(karcher, source, progress);
    }
  }
}
