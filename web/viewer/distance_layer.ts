import type { SurfacePoint } from 'karcher';
import { Color, Group, type Vector3 } from 'three';
import type { TracedDistances } from '../model/traced';
import { isolineColor } from './color_ramp';
import type { ViewerColors } from './colors';
import { FatLine } from './fat_line';
import type { Layer } from './layer';
import { dotAt } from './object_lines';
import type { Surface } from './surface';

/** Shows the distances from a point: colors of the surface, isolines, and a dot at the point. */
export class DistanceLayer implements Layer {
  readonly object = new Group();
  // Isolines lie below the curves, and appear only where the surface is visible.
  readonly #lines = new FatLine({ width: 1.25, hidden: 0 }, 0);
  readonly #dot = new FatLine({ width: 11, hidden: 0 }, 1);
  #surface: Surface | null = null;

  constructor() {
    this.object.add(this.#lines.object, this.#dot.object);
  }

  /** Replaces the shown distances; null removes them. */
  show(
    surface: Surface | null,
    distances: TracedDistances | null,
    from: SurfacePoint | null,
  ): void {
    if (surface !== this.#surface) this.#surface?.colorBy(null);
    this.#surface = surface;
    surface?.colorBy(distances && { values: distances.values, most: distances.most });
    const lines = distances?.lines.flat() ?? [];
    this.#lines.set(surface ? lines.map((line) => surface.toScene(line)) : []);
    this.#dot.set(surface && from ? [dotAt(surface.position(from))] : []);
  }

  follow(camera: Vector3): void {
    this.#lines.follow(camera);
    this.#dot.follow(camera);
  }

  setColors({ front }: ViewerColors): void {
    const surface = new Color(front);
    this.#lines.setColor(new Color(isolineColor), surface);
    this.#dot.setColor(new Color(isolineColor), surface);
  }
}
