import { type PerspectiveCamera, Ray, Vector3 } from 'three';
import type { Surface } from './surface';

/** A polyline as it is seen: places in CSS pixels of the stage, and which of them are hidden. */
export interface SeenLine {
  x: number[];
  y: number[];
  hidden: boolean[];
}

/** What is so little farther than the surface, in the scene, lies on it. */
const grain = 0.004;

/** A surface as a camera sees it on a stage. */
export class Vantage {
  readonly #ray = new Ray();

  constructor(
    private readonly surface: Surface | null,
    private readonly camera: PerspectiveCamera,
    /** The stage's, in CSS pixels. */
    readonly size: Readonly<{ width: number; height: number }>,
  ) {}

  /** Where a point of the scene is on the stage, in CSS pixels, and whether the surface hides it. */
  project(position: Vector3): { x: number; y: number; hidden: boolean } {
    const { origin, direction } = this.#ray;
    const distance = this.camera.position.distanceTo(position);
    origin.copy(this.camera.position);
    direction.copy(position).sub(origin).normalize();
    const hidden = (this.surface?.depth(this.#ray) ?? Infinity) < distance - grain;
    const { x, y, z } = this.onStage(position.clone());
    return { x, y, hidden: hidden || z > 1 };
  }

  /** Takes a point of the scene to where it is on the stage, in CSS pixels, and its depth. */
  onStage(position: Vector3): Vector3 {
    const place = position.project(this.camera);
    place.x = ((place.x + 1) / 2) * this.size.width;
    place.y = ((1 - place.y) / 2) * this.size.height;
    return place;
  }

  /** A polyline in the surface's coordinates as it is seen on the stage. */
  seen(polyline: Float32Array): SeenLine {
    const line: SeenLine = { x: [], y: [], hidden: [] };
    const places = this.surface?.toScene(polyline) ?? [];
    for (let i = 0; i < places.length; i += 3) {
      const { x, y, hidden } = this.project(new Vector3().fromArray(places, i));
      line.x.push(x);
      line.y.push(y);
      line.hidden.push(hidden);
    }
    return line;
  }
}
