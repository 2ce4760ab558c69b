import type { Karcher } from '../karcher.js';
import type { LineLook } from '../three/fat_line.js';
import type { CurveOptions, MeshOptions } from '../types.js';
import type { CurveView } from '../view.js';
import type { RemoteKarcher } from '../worker/index.js';

/** An engine in the page, or one in a worker. */
export type AnyKarcher = Karcher | RemoteKarcher;

/** Where the engine runs. */
export interface EngineHookOptions {
  /** Whether the engine runs in a worker; false by default. */
  worker?: boolean | undefined;
}

/** The callback of hooks that hears of failures. */
export interface FailureOptions {
  /**
   * Called with what went wrong. Without it, the hook throws that while the component renders, so that
   * the nearest error boundary shows it.
   */
  onError?: ((error: unknown) => void) | undefined;
}

export interface SurfaceHookOptions extends MeshOptions, EngineHookOptions, FailureOptions {}

/** How a component's curve looks, and what the component hears of it. */
export interface CurveHookOptions extends LineLook, FailureOptions {
  /** Called when what is drawn has changed. */
  onChange?: ((value: CurveOptions, view: CurveView) => void) | undefined;
}

/** How control points are dragged. */
export interface DragHookOptions {
  /** How near to a control point, in pixels, a press takes hold of it; 12 by default. */
  reach?: number | undefined;
  /** Called with what an edit threw, as where the pointer is over another component. */
  onError?: ((error: unknown) => void) | undefined;
}
