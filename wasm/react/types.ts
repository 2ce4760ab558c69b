import type { Karcher } from '../karcher.js';
import type { LineLook } from '../three/fat_line.js';
import type { CurveOptions, MeshOptions } from '../types.js';
import type { CurveView } from '../view.js';
import type { RemoteKarcher } from '../worker/index.js';

/** An engine in the page or in a worker. */
export type AnyKarcher = Karcher | RemoteKarcher;

/** The options of the engine. */
export interface EngineHookOptions {
  /** Whether the engine runs in a worker; false by default. */
  worker?: boolean | undefined;
}

/** The callback of hooks that receives failures. */
export interface FailureOptions {
  /**
   * A function that receives the error. Without it, the hook throws the error while the component
   * renders, so that the nearest error boundary shows it.
   */
  onError?: ((error: unknown) => void) | undefined;
}

export interface SurfaceHookOptions extends MeshOptions, EngineHookOptions, FailureOptions {}

/** The look of a component's curve, and the component's callbacks. */
export interface CurveHookOptions extends LineLook, FailureOptions {
  /**
   * A function that runs when the drawn curve has changed. It receives the options that recreate
   * this curve, with the legs of a drag.
   */
  onChange?: ((value: CurveOptions, view: CurveView) => void) | undefined;
}

/** The options for dragging control points. */
export interface DragHookOptions {
  /**
   * The distance from a control point, in pixels, within which a press takes hold of it; 12 by
   * default.
   */
  reach?: number | undefined;
  /**
   * A function that receives the error of an edit, such as `unreachable` if the pointer is over
   * another connected component of the mesh.
   */
  onError?: ((error: unknown) => void) | undefined;
}
