import { Object3D, type Object3DEventMap } from 'three';
import type { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { KarcherError } from '../errors.js';
import type { Path } from '../path.js';
import type { CurveOptions, PointLike } from '../types.js';
import type { CurveView } from '../view.js';
import { drawLine, type LineLook, lineMaterial } from './fat_line.js';
import type { AnyMesh, Surface } from './surface.js';

/** The members of a `Curve` or a `RemoteCurve` that this class uses. */
interface ShownCurve {
  set(value: CurveOptions): CurveView | Promise<CurveView>;
  view(): CurveView | Promise<CurveView>;
  path(): Path | Promise<Path>;
  dispose(): unknown;
}

interface Edit {
  value: CurveOptions;
  /** Whether the edit follows a drag of points, so that the legs of the drawn curve continue. */
  isDrag: boolean;
  tell(isShown: boolean): void;
  fail(error: unknown): void;
}

/** The events that a curve on a surface sends. */
export interface SurfaceCurveEvents extends Object3DEventMap {
  /**
   * The drawn curve has changed. `value` has the options that recreate it; after a drag these
   * include its legs.
   */
  change: { view: CurveView; value: CurveOptions };
}

/**
 * A curve on a surface, as a line with a width in pixels. Make it a child of the object that draws
 * the surface. Its line appears slightly nearer to the camera, so that the surface does not cut it.
 * Edits return promises, whether the engine runs in a worker or in the page. One edit runs at a
 * time. Of the edits that arrive meanwhile, only the newest follows.
 */
export class SurfaceCurve extends Object3D<SurfaceCurveEvents> {
  override readonly type: string = 'SurfaceCurve';
  /** The surface on which the curve lies. */
  readonly surface: Surface<AnyMesh>;
  /** The fat line that draws the curve. */
  readonly line: LineSegments2;
  /**
   * The view of the drawn curve, such as its length, samples and bridges; undefined until the first
   * drawing.
   */
  view: CurveView | undefined;
  /**
   * A promise that resolves at the first drawing. It rejects with the error of `Mesh.curve`; the
   * next valid edit then makes the curve.
   */
  readonly ready: Promise<void>;
  #curve: ShownCurve | undefined;
  #value: CurveOptions;
  #drawn: CurveOptions;
  #waiting: Edit | undefined;
  #isBusy = true;
  #isDisposed = false;

  /**
   * The options are those of `Mesh.curve`. The look is the width in pixels and the color, or a
   * material.
   */
  constructor(
    surface: Surface<AnyMesh>,
    options: CurveOptions,
    look: LineLook | LineMaterial = {},
  ) {
    super();
    this.surface = surface;
    const material = 'isLineMaterial' in look ? look : lineMaterial(look);
    this.line = new LineSegments2(undefined, material);
    this.add(this.line);
    this.#value = { ...options, points: [...options.points] };
    this.#drawn = this.#value;
    this.visible = false;
    this.ready = this.#make();
    // A caller that waits for `ready` receives the failure, but no caller has to wait.
    this.ready.catch(() => {});
  }

  /** The line's material: its `linewidth` is in pixels. */
  get material(): LineMaterial {
    return this.line.material;
  }

  /**
   * The options of the newest curve, even if it is not drawn yet. Those of a curve that was dragged
   * have its legs once it is drawn.
   */
  get value(): CurveOptions {
    return this.#value;
  }

  /**
   * The path of the drawn curve. If an edit has begun, it is the path of the edited curve, which is
   * not drawn yet. Rejects with `KarcherError` disposed, and without a drawn curve as `ready` does.
   *
   * @example
   * ```ts
   * const { length } = await curve.path();
   * ```
   */
  async path(): Promise<Path> {
    if (!this.view) await this.ready;
    return this.#curve!.path();
  }

  /** Moves a control point. The promise has the same meaning as that of `set`. */
  movePoint(number: number, point: PointLike): Promise<boolean> {
    if (!Number.isInteger(number) || number < 0 || number >= this.#value.points.length) {
      const error = new KarcherError('badIndex', `there is no control point ${number}`);
      return Promise.reject(error);
    }
    const points = this.#value.points.map((old, i) => (i === number ? point : old));
    return this.#edit({ ...this.#value, points }, true);
  }

  /**
   * Changes the curve to another one. The promise resolves to true when the new curve is drawn, and
   * to false if a newer edit has replaced this one or the curve is disposed of. It rejects with the
   * error of `Curve.set`; the curve is then unchanged.
   */
  set(value: CurveOptions): Promise<boolean> {
    return this.#edit({ ...value, points: [...value.points] }, false);
  }

  /** Frees the memory of the engine and of the graphics card, but not that of the material. */
  override dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    // Objects of older versions of three.js do not have this method.
    super.dispose?.();
    this.removeFromParent();
    this.line.geometry.dispose();
    this.#waiting?.tell(false);
    this.#waiting = undefined;
    void this.#end();
  }

  async #end(): Promise<void> {
    try {
      await this.#curve?.dispose();
    } catch {
      // A worker that has ended has no memory to free.
    }
  }

  async #make(): Promise<void> {
    try {
      const value = this.#value;
      const view = await this.#viewOf(value);
      if (view && !this.#isDisposed) this.#draw(view, value);
    } finally {
      this.#isBusy = false;
      void this.#next();
    }
  }

  /** Gives the engine's curve these options. The first valid ones make it, unless disposed of. */
  async #viewOf(value: CurveOptions): Promise<CurveView | undefined> {
    if (this.#curve) return this.#curve.set(value);
    this.#curve = (await this.surface.mesh.curve(value)) as ShownCurve;
    if (!this.#isDisposed) return this.#curve.view();
    await this.#end();
    return undefined;
  }

  #edit(value: CurveOptions, isDrag: boolean): Promise<boolean> {
    if (this.#isDisposed) {
      return Promise.reject(new KarcherError('disposed', 'the curve has been disposed of'));
    }
    this.#value = value;
    return new Promise((tell, fail) => {
      // A drag of a curve that is not drawn yet has no legs to continue.
      const continues = isDrag && this.#waiting?.isDrag !== false;
      this.#waiting?.tell(false);
      this.#waiting = { value, isDrag: continues, tell, fail };
      void this.#next();
    });
  }

  async #next(): Promise<void> {
    const edit = this.#waiting;
    if (this.#isBusy || !edit) return;
    this.#waiting = undefined;
    this.#isBusy = true;
    const { value, isDrag, tell, fail } = edit;
    try {
      const legs = isDrag && this.view?.drawnLegs;
      const view = await this.#viewOf(legs ? { ...value, legs } : value);
      const drawn = legs && view ? { ...value, legs: view.drawnLegs } : value;
      this.#drawn = drawn;
      if (this.#value === value) this.#value = drawn;
      if (view && !this.#isDisposed) this.#draw(view, drawn);
      tell(!this.#isDisposed);
    } catch (error) {
      if (this.#isDisposed) return tell(false);
      // A waiting edit starts from the value that failed here, and may fail, too. The drawn legs
      // are not those of a curve that could not be set.
      const waiting = this.#waiting as Edit | undefined;
      if (waiting) waiting.isDrag &&= isDrag;
      else this.#value = this.#drawn;
      fail(error);
    }
    this.#isBusy = false;
    void this.#next();
  }

  #draw(view: CurveView, value: CurveOptions): void {
    drawLine(this.line, view.polyline);
    this.visible ||= this.view === undefined;
    this.view = view;
    this.dispatchEvent({ type: 'change', view, value });
  }
}
