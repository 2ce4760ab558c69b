/**
 * Karcher with three.js: surfaces of geometries, curves as objects, distances and log maps as
 * attributes.
 */
export { KarcherError } from '../errors.js';
export { CurveDrag, type CurveDragOptions } from './curve_drag.js';
export type { LineLook } from './fat_line.js';
export {
  type ColorOptions,
  type DecalOptions,
  decalGeometry,
  type GeometryGroup,
  geometryOf,
  logMapUvs,
  type RibbonOptions,
  ribbonGeometry,
  type TubeOptions,
  tubeGeometry,
  vertexColors,
} from './geometry.js';
export { type Followed, RibbonOnSurface, TubeOnSurface } from './path_objects.js';
export {
  type AnyMesh,
  Surface,
  type SurfaceHit,
  surfaceFromGeometry,
  surfaceFromMesh,
} from './surface.js';
export { SurfaceCurve, type SurfaceCurveEvents } from './surface_curve.js';
