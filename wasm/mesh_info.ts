import type { MeshInfo } from './types.js';

/** The numbers and repairs of a mesh, which nobody can change. */
export function frozenInfo(info: MeshInfo): MeshInfo {
  info.repairs.forEach(Object.freeze);
  Object.freeze(info.repairs);
  return Object.freeze(info);
}
