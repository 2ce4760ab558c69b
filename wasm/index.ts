export type { Curve } from './curve.js';
export { KarcherError } from './errors.js';
export type { Karcher } from './karcher.js';
export { load } from './load.js';
export type { Mesh } from './mesh.js';
export type * from './types.js';
