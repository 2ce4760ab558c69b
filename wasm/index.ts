export { Curve } from './curve.js';
export { KarcherError } from './errors.js';
export { Karcher } from './karcher.js';
export { load } from './load.js';
export type { LogMap, MappedPoints } from './maps.js';
export { Mesh } from './mesh.js';
export { Path } from './path.js';
export type * from './types.js';
export { CurveView } from './view.js';
