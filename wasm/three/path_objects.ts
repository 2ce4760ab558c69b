import {
  BufferGeometry,
  DoubleSide,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
} from 'three';
import type { Path } from '../path.js';
import type { PathValue } from '../path_values.js';
import { liftMaterial, lineColor, nearer } from './fat_line.js';
import { type RibbonOptions, ribbonGeometry, type TubeOptions, tubeGeometry } from './geometry.js';
import type { AnyMesh, Surface } from './surface.js';
import { SurfaceCurve } from './surface_curve.js';

/** A path, its value, or a curve on the surface. */
export type Followed = Path | PathValue | SurfaceCurve;

/**
 * An object along a path. Make it a child of the object that draws the surface. An object along a
 * curve follows the curve's edits. Of several edits that arrive while it is drawn, it follows only
 * the newest.
 */
class ObjectAlong extends Mesh<BufferGeometry, Material> {
  /** The surface on which the path lies. */
  readonly surface: Surface<AnyMesh>;
  readonly #draw: (path: Path | PathValue) => BufferGeometry;
  #curve: SurfaceCurve | undefined;
  #isStale = false;
  #drawing: Promise<void> | undefined;
  /** A promise that resolves when the object is first drawn. */
  readonly ready: Promise<void>;

  /** @internal */
  constructor(
    surface: Surface<AnyMesh>,
    along: Followed,
    material: Material,
    draw: (path: Path | PathValue) => BufferGeometry,
  ) {
    super(new BufferGeometry(), material);
    this.surface = surface;
    this.#draw = draw;
    this.ready = this.follow(along);
    // A caller that waits for `ready` receives the failure, but no caller has to wait.
    this.ready.catch(() => {});
  }

  /**
   * Follows another path or curve. The promise resolves when the object is drawn: for a path at
   * once, for a curve when the curve is drawn.
   *
   * @throws {KarcherError} badArgument for what is no path; rejects with the error of `Curve.path`.
   * @example
   * ```ts
   * await tube.follow(surface.mesh.shortestPath(a, b));
   * ```
   */
  follow(along: Followed): Promise<void> {
    this.#curve?.removeEventListener('change', this.#onChange);
    this.#curve = undefined;
    if (along instanceof SurfaceCurve) {
      this.#curve = along;
      along.addEventListener('change', this.#onChange);
      return this.#update();
    }
    this.#show(along);
    return Promise.resolve();
  }

  /** Stops following, and frees the memory of the graphics card except that of the material. */
  override dispose(): void {
    this.#curve?.removeEventListener('change', this.#onChange);
    this.#curve = undefined;
    // Objects of older versions of three.js do not have this method.
    super.dispose?.();
    this.removeFromParent();
    this.geometry.dispose();
  }

  readonly #onChange = () => {
    this.#update().catch(() => {
      // A disposed curve leaves the object as it is.
    });
  };

  /** Draws the curve, and once more if it has changed meanwhile. */
  #update(): Promise<void> {
    this.#isStale = true;
    this.#drawing ??= this.#drawCurve().finally(() => {
      this.#drawing = undefined;
    });
    return this.#drawing;
  }

  async #drawCurve(): Promise<void> {
    while (this.#isStale && this.#curve) {
      this.#isStale = false;
      const curve = this.#curve;
      let path: Path;
      try {
        path = await curve.path();
      } catch (error) {
        // A newer curve, or a newer edit of this one, may have a path.
        if (this.#curve === curve && !this.#isStale) throw error;
        continue;
      }
      if (this.#curve === curve) this.#show(path);
    }
  }

  #show(path: Path | PathValue): void {
    const geometry = this.#draw(path);
    this.geometry.dispose();
    this.geometry = geometry;
  }
}

/** A tube along a path or a curve, as an object that follows the curve's edits. */
export class TubeOnSurface extends ObjectAlong {
  /** The name of the class. */
  override readonly type: string = 'TubeOnSurface';

  /**
   * The options are those of `tubeGeometry`, and a material; by default a red one that needs light.
   *
   * @throws {KarcherError} badArgument for what is no path, and as `tubeGeometry`.
   * @example
   * ```ts
   * object.add(new TubeOnSurface(surface, curve, { radius: 0.01 }));
   * ```
   */
  constructor(
    surface: Surface<AnyMesh>,
    along: Followed,
    { material, ...shape }: TubeOptions & { material?: Material | undefined } = {},
  ) {
    super(surface, along, material ?? new MeshStandardMaterial({ color: lineColor }), (path) =>
      tubeGeometry(surface, path, shape),
    );
  }
}

/**
 * A flat ribbon along a path or a curve, as an object that follows the curve's edits. By default it
 * is drawn slightly nearer to the camera, so that the surface does not cut it.
 */
export class RibbonOnSurface extends ObjectAlong {
  /** The name of the class. */
  override readonly type: string = 'RibbonOnSurface';

  /**
   * The options are those of `ribbonGeometry`, and a material; by default a red one that needs no
   * light.
   *
   * @throws {KarcherError} badArgument for what is no path, and as `ribbonGeometry`.
   * @example
   * ```ts
   * object.add(new RibbonOnSurface(surface, curve, { width: 0.05, material }));
   * ```
   */
  constructor(
    surface: Surface<AnyMesh>,
    along: Followed,
    { material, ...shape }: RibbonOptions & { material?: Material | undefined } = {},
  ) {
    super(surface, along, material ?? ribbonMaterial(), (path) =>
      ribbonGeometry(surface, path, shape),
    );
  }
}

function ribbonMaterial(): Material {
  const material = new MeshBasicMaterial({ color: lineColor, side: DoubleSide });
  liftMaterial(material, '#include <project_vertex>\n', nearer);
  return material;
}
