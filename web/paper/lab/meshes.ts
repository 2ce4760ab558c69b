import bunny from 'bunny';
import type { Karcher, Mesh } from 'karcher';
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import type { MeshSpec } from '../figures/types';
import { planeArrays } from './planes';

/** The mesh of a spec; its owner is the caller. */
export async function makeMesh(karcher: Karcher, spec: MeshSpec): Promise<Mesh> {
  switch (spec.kind) {
    case 'shape':
      return karcher.shape(spec.name, spec.triangles);
    case 'bunny':
      return makeBunny(karcher, spec.levels);
    case 'plane': {
      const { positions, triangles } = planeArrays(spec.tessellation, spec.triangles);
      return karcher.meshFromArrays(positions, triangles);
    }
    case 'simplified': {
      const fine = await makeMesh(karcher, spec.of);
      try {
        return await simplified(karcher, fine, spec.triangles);
      } finally {
        fine.dispose();
      }
    }
  }
}

function makeBunny(karcher: Karcher, levels: number): Mesh {
  const coarse = karcher.meshFromArrays(bunny.positions.flat(), bunny.cells.flat());
  if (levels === 0) return coarse;
  const fine = coarse.subdivide(levels);
  coarse.dispose();
  return fine;
}

/** Edges collapsed where the surface changes least (meshoptimizer), down to so many triangles. */
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

/** A name for a mesh, the same for the same spec. */
export const meshKey = (spec: MeshSpec): string => JSON.stringify(spec);

const shapeNames = {
  sphere: 'Sphere',
  torus: 'Torus',
  knot: 'Knotted tube',
  genus3: 'Genus 3',
  openSheet: 'Open sheet',
};

/** What a person calls it. */
export function meshName(spec: MeshSpec): string {
  switch (spec.kind) {
    case 'shape':
      return shapeNames[spec.name];
    case 'bunny':
      return 'Bunny';
    case 'plane':
      return `Plane, ${spec.tessellation}`;
    case 'simplified':
      return `${meshName(spec.of)}, simplified`;
  }
}

/** The key under which the editor opens the mesh; null where it can't. */
export function editorKey(spec: MeshSpec): string | null {
  if (spec.kind === 'shape') return `${spec.name}:${spec.triangles}`;
  return spec.kind === 'bunny' ? `bunny:${spec.levels}` : null;
}
