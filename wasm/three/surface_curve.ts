import { Object3D, type Object3DEventMap } from 'three';
import type { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { KarcherError } from '../errors.js';
import type { CurveOptions, PointLike } from '../types.js';
import type { CurveView } from '../view.js';
import { drawLine, type LineLook, lineMaterial } from './fat_line.js';
import type { AnyMesh, Surface } from './surface.js';

/** What of a `Curve` or a `RemoteCurve` is used here. */
interface ShownCurve {
  set(value: CurveOptions): CurveView | Promise<CurveView>;
  view(): CurveView | Promise<CurveView>;
  dispose(): unknown;
}

interface Edit {
  value: CurveOptions;
  /** Whether points were dragged: the legs of the curve that is drawn are continued. */
  isDrag: boolean;
  tell(isShown: boolean): void;
  fail(error: unknown): void;
}

/** The events that a curve on a surface sends. */
export interface SurfaceCurveEvents extends Object3DEventMap {
  /** What is drawn has changed. */
  change: { view: CurveView };
}

/**
 * A curve on a surface, as a line of so many pixels: make it a child of the object that draws the surface. Its
 * line is drawn a little nearer to the camera than it lies, so that the surface does not cut it.
 *
 * Edits return promises, with an engine in a worker and in the page. One edit is under way; of those that
 * come meanwhile the newest alone is made.
 */
export class SurfaceCurve extends Object3D<SurfaceCurveEvents> {
  override readonly type: string = 'SurfaceCurve';
  /** The surface that the curve lies on. */
  readonly surface: Surface<AnyMesh>;
  /** The fat line that draws the curve. */
  readonly line: LineSegments2;
  /** The length, samples and bridges of the curve as it is drawn; undefined until it is drawn first. */
  view: CurveView | undefined;
  /** When the curve is drawn for the first time; it rejects with what `Mesh.curve` throws. */
  readonly ready: Promise<void>;
  #curve: ShownCurve | undefined;
  #value: CurveOptions;
  #drawn: CurveOptions;
  #waiting: Edit | undefined;
  #isBusy = true;
  #isDisposed = false;

  /** The options are those of `Mesh.curve`. The look is the width in pixels and the color, or a material. */
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
    // Who waits for it hears of its failure; nobody has to.
    this.ready.catch(() => {});
  }

  /** The line's material: its `linewidth` is in pixels. */
  get material(): LineMaterial {
    return this.line.material;
  }

  /** The options that make the newest curve, also where it is not drawn yet. */
  get value(): CurveOptions {
    return this.#value;
  }

  /** Moves a control point. The promise is that of `set`. */
  movePoint(number: number, point: PointLike): Promise<boolean> {
    if (!Number.isInteger(number) || number < 0 || number >= this.#value.points.length) {
      const error = new KarcherError('badIndex', `there is no control point ${number}`);
      return Promise.reject(error);
    }
    const points = this.#value.points.map((old, i) => (i === number ? point : old));
    return this.#edit({ ...this.#value, points }, true);
  }

  /**
   * Makes it another curve: true when that is drawn, false when a newer edit took its place. Rejects with
   * what `Curve.set` throws; then the curve stays what it was.
   */
  set(value: CurveOptions): Promise<boolean> {
    return this.#edit({ ...value, points: [...value.points] }, false);
  }

  /** Gives the memory back, that of the engine and that of the graphics card; not the material's. */
  override dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    // Objects of older versions of three.js have none.
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
      // A worker that has ended has nothing left to give back.
    }
  }

  async #make(): Promise<void> {
    try {
      const made = await this.surface.mesh.curve(this.#value);
      this.#curve = made as ShownCurve;
      if (this.#isDisposed) return await this.#end();
      this.#draw(await this.#curve.view());
    } finally {
      this.#isBusy = false;
      void this.#next();
    }
  }

  #edit(value: CurveOptions, isDrag: boolean): Promise<boolean> {
    if (this.#isDisposed) {
      return Promise.reject(new KarcherError('disposed', 'the curve has been disposed of'));
    }
    this.#value = value;
    return new Promise((tell, fail) => {
      this.#waiting?.tell(false);
      this.#waiting = { value, isDrag, tell, fail };
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
      if (!this.#curve) throw new KarcherError('badArgument', 'the curve could not be made');
      const legs = isDrag && this.view?.drawnLegs.map((leg, i) => value.legs?.[i] ?? leg);
      const view = await this.#curve.set(legs ? { ...value, legs } : value);
      this.#drawn = value;
      if (!this.#isDisposed) this.#draw(view);
      tell(!this.#isDisposed);
    } catch (error) {
      // What waits is made of the curve as it was wanted, and may be none either.
      if (!this.#waiting) this.#value = this.#drawn;
      fail(error);
    }
    this.#isBusy = false;
    void this.#next();
  }

  #draw(view: CurveView): void {
    drawLine(this.line, view.polyline);
    this.visible ||= this.view === undefined;
    this.view = view;
    this.dispatchEvent({ type: 'change', view });
  }
}
