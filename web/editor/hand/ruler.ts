import type { SurfacePoint } from 'karcher';
import type { Viewer } from '../../viewer/viewer';
import { KarcherError } from '../../worker/client';
import { Newest } from '../engine/newest';
import type { Session } from '../engine/session';
import type { Editor } from '../state/editor';

/** The distances between two points, along the surface and straight, in the surface's unit. */
export interface Ruled {
  /** Null if no path along the surface joins the points. */
  along: number | null;
  straight: number;
}

/**
 * Measures between two clicks, along the surface and in a straight line. A third click starts
 * again.
 */
export class Ruler {
  #from: SurfacePoint | null = null;
  #to: SurfacePoint | null = null;
  readonly #newest = new Newest<SurfacePoint>((to) => this.#show(to));

  /** A listener for the measurement (null without one), and for whether the first end is placed. */
  onChange: (ruled: Ruled | null, begun: boolean) => void = () => {};

  constructor(
    editor: Editor,
    private readonly session: Session,
    private readonly viewer: Viewer,
  ) {
    editor.subscribe(({ tool, mesh }, before) => {
      if (this.#from && (tool !== 'measure' || mesh !== before.mesh)) this.#clear();
    });
  }

  /** Measures from the first click to a point, until the second click. */
  aim(point: SurfacePoint): void {
    if (this.#from && !this.#to) this.#newest.push(point);
  }

  click(point: SurfacePoint): void {
    if (this.#from && !this.#to) {
      this.#to = point;
      this.#newest.push(point);
      return;
    }
    this.#clear();
    this.#from = point;
    this.onChange(null, true);
  }

  #clear(): void {
    [this.#from, this.#to] = [null, null];
    this.#newest.drop();
    this.viewer.aids.showBand(null);
    this.onChange(null, false);
  }

  async #show(to: SurfacePoint): Promise<void> {
    const from = this.#from;
    const { client } = this.session;
    const { surface } = this.viewer;
    if (!from || !client || !surface) return;
    const path = await client.mesh.shortestPath(from, to).catch((error) => {
      return error instanceof KarcherError && error.code === 'unreachable' ? 'none' : null;
    });
    if (!path || this.#from !== from || (this.#to && this.#to !== to)) return;
    if (this.viewer.surface !== surface) return;
    if (path === 'none') {
      const apart = surface.position(from).distanceTo(surface.position(to));
      this.viewer.aids.showBand(null);
      this.onChange({ along: null, straight: apart / surface.frame.scale }, true);
      return;
    }
    const line = path.polyline({ bits: 64 });
    const straight = Math.hypot(...[0, 1, 2].map((axis) => line.at(axis - 3)! - line[axis]!));
    this.viewer.aids.showBand(surface.toScene(path.polyline()));
    this.onChange({ along: path.length, straight }, true);
  }
}
