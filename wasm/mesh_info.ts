import type { MeshInfo } from './types.js';

/** What a mesh is like, with its repairs, which nobody can change. */
export function frozenInfo(info: MeshInfo): MeshInfo {
  for (const repair of info.repairs) Object.freeze(repair);
  Object.freeze(info.repairs);
  return Object.freeze(info);
}
