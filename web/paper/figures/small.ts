import type { MeshSpec } from './types';

const fewest = 500;

/** The same mesh with a fraction of the triangles, for quick tests. */
export function smallerMesh(spec: MeshSpec, part: number): MeshSpec {
  if (spec.kind === 'bunny') return { ...spec, levels: 0 };
  const triangles = Math.max(fewest, Math.round(spec.triangles * part));
  if (spec.kind === 'simplified') return { ...spec, of: smallerMesh(spec.of, part) };
  return { ...spec, triangles };
}
