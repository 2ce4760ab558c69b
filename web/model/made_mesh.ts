import type { Karcher, Mesh } from 'karcher';
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import type { MadeSource } from './meshes';
import { planeArrays } from './planes';
import { makeSample, type Tell } from './sample_mesh';

/** Generates the mesh of a source, always the same for the same source; the caller owns it. */
export async function makeMesh(
  karcher: Karcher,
  source: MadeSource,
  tell: Tell = () => {},
): Promise<Mesh> {
  switch (source.kind) {
    case 'shape':
    case 'bunny':
      return makeSample(karcher, source, tell);
    case 'plane': {
      const { positions, triangles } = planeArrays(source);
      return karcher.meshFromArrays(positions, triangles);
    }
    case 'simplified': {
      const fine = await makeMesh(karcher, source.of, tell);
      try {
        tell(0.7, 'Simplifying');
        return await simplified(karcher, fine, source.triangles);
      } finally {
        fine.dispose();
      }
    }
  }
}

/**
 * The mesh with a smaller number of triangles: meshoptimizer collapses the edges that change the
 * surface least.
 */
async function simplified(karcher: Karcher, fine: Mesh, triangles: number): Promise<Mesh> {
  await MeshoptSimplifier.ready;
  const positions = fine.positions();
  const [kept] = MeshoptSimplifier.simplify(
    Uint32Array.from(fine.triangles()),
    Float32Array.from(positions),
    3,
    3 * triangles,
    1,
  );
  const [remap, count] = MeshoptSimplifier.compactMesh(kept);
  const compact = new Float64Array(3 * count);
  remap.forEach((to, from) => {
    if (to !== 0xffffffff) compact.set(positions.subarray(3 * from, 3 * from + 3), 3 * to);
  });
  // compactMesh has renumbered `kept` in place.
  return karcher.meshFromArrays(compact, kept);
}
