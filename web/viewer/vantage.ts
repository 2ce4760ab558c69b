import { Matrix4, type PerspectiveCamera, Ray, Vector3 } from 'three';
import type { LineStyle } from '../model/drawing';
import type { Surface } from './surface';

/** A polyline on the stage: places in CSS pixels, and which of them are hidden. */
export interface SeenLine {
  x: number[];
  y: number[];
  hidden: boolean[];
}

/** The visible point of a line that appears nearest to a place of the stage. */
export interface NearestSeen {
  /** The place in the scene. */
  position: Vector3;
  /** The distance from the place, in CSS pixels. */
  distance: number;
}

/** A point that is at most this far behind the surface, in the scene, counts as on it. */
const grain = 0.004;

/** The view of a camera on a surface, on a stage. */
export class Vantage {
  readonly #ray = new Ray();

  constructor(
    private readonly surface: Surface | null,
    private readonly camera: PerspectiveCamera,
    /** The size of the stage, in CSS pixels. */
    readonly size: Readonly<{ width: number; height: number }>,
  ) {}

  /**
   * The place of a point of the scene on the stage, in CSS pixels, and whether the point is hidden:
   * behind the surface or behind the camera. `height` is the height above the camera's near plane.
   */
  project(position: Vector3): { x: number; y: number; hidden: boolean; height: number } {
    const { origin, direction } = this.#ray;
    const distance = this.camera.position.distanceTo(position);
    origin.copy(this.camera.position);
    direction.copy(position).sub(origin).normalize();
    const hidden = (this.surface?.depth(this.#ray) ?? Infinity) < distance - grain;
    const { x, y, z } = this.onStage(position.clone());
    return { x, y, hidden: hidden || z > 1, height: this.height(position) };
  }

  /** Converts a point of the scene to its place on the stage, in CSS pixels, and its depth. */
  onStage(position: Vector3): Vector3 {
    return toStage(position.project(this.camera), this.size);
  }

  /** The inverse of `onStage`. */
  fromStage(place: Vector3): Vector3 {
    const { width, height } = this.size;
    place.x = (2 * place.x) / width - 1;
    place.y = 1 - (2 * place.y) / height;
    return place.unproject(this.camera);
  }

  /** The height of a point of the scene above the camera's near plane; behind it less than 0. */
  height(position: Vector3): number {
    const { matrixWorldInverse, near } = this.camera;
    return -position.clone().applyMatrix4(matrixWorldInverse).z - near;
  }

  /** A polyline in the surface's coordinates as it appears on the stage. */
  seen(polyline: Float32Array): SeenLine {
    return this.#onStage(placesIn(this.surface?.toScene(polyline)));
  }

  /**
   * The parts of a polyline, in the surface's coordinates, that the camera's near plane does not cut
   * off, as they appear on the stage. Each part has the index of its first segment.
   */
  *seenParts(polyline: Float32Array): Generator<SeenLine & { first: number }> {
    const places = placesIn(this.surface?.toScene(polyline));
    const heights = places.map((place) => this.height(place));
    let part: Vector3[] = [];
    let first = 0;
    for (const [i, place] of places.entries()) {
      const [before, height] = [heights[Math.max(0, i - 1)]!, heights[i]!];
      if (before >= 0 !== height >= 0) {
        if (height >= 0) first = i - 1;
        part.push(places[i - 1]!.clone().lerp(place, before / (before - height)));
      }
      if (height >= 0) part.push(place);
      if (part.length > 0 && (height < 0 || i === places.length - 1)) {
        yield { ...this.#onStage(part), first };
        part = [];
      }
    }
  }

  #onStage(places: readonly Vector3[]): SeenLine {
    const seen = places.map((place) => this.project(place));
    return {
      x: seen.map(({ x }) => x),
      y: seen.map(({ y }) => y),
      hidden: seen.map(({ hidden }) => hidden),
    };
  }

  /**
   * The visible point of a polyline in the scene that appears nearest to a place of the stage, at
   * most `within` CSS pixels away, which may depend on the point; null if there is none. Segments
   * that are partly behind the camera do not count.
   */
  nearest(
    line: Float32Array,
    place: { x: number; y: number },
    within: (position: Vector3) => number,
  ): NearestSeen | null {
    const { camera, size } = this;
    const matrix = new Matrix4().multiplyMatrices(
      camera.projectionMatrix,
      camera.matrixWorldInverse,
    );
    const seen = (i: number, target: Vector3) =>
      toStage(target.fromArray(line, i).applyMatrix4(matrix), size);
    const near: NearestSeen[] = [];
    const [a, b, from, to] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
    if (line.length >= 3) seen(0, b);
    for (let i = 3; i < line.length; i += 3) {
      a.copy(b);
      seen(i, b);
      if (a.z > 1 || b.z > 1) continue;
      const [dx, dy] = [b.x - a.x, b.y - a.y];
      const length = dx * dx + dy * dy;
      const along = ((place.x - a.x) * dx + (place.y - a.y) * dy) / (length || 1);
      const part = Math.min(1, Math.max(0, along));
      const distance = Math.hypot(a.x + part * dx - place.x, a.y + part * dy - place.y);
      const position = from.fromArray(line, i - 3).lerp(to.fromArray(line, i), part);
      if (distance <= within(position)) near.push({ position: position.clone(), distance });
    }
    // Only near points need a ray, the nearest first.
    near.sort((one, other) => one.distance - other.distance);
    return near.find(({ position }) => !this.project(position).hidden) ?? null;
  }

  /**
   * The length, in the surface's unit, that a number of CSS pixels covers at a point of the scene.
   */
  reach(position: Vector3, pixels: number): number {
    const away = this.camera.position.distanceTo(position);
    const height = 2 * away * Math.tan((this.camera.fov * Math.PI) / 360);
    return ((height / this.size.height) * pixels) / (this.surface?.frame.scale ?? 1);
  }

  /** The width of a line in CSS pixels, at a point of the scene where the surface faces the view. */
  seenWidth({ width, onSurface }: LineStyle, position: Vector3): number {
    return onSurface ? width / this.reach(position, 1) : width;
  }

  /**
   * The visible width at the middle of a polyline in the surface's coordinates, rounded to a
   * hundredth of a CSS pixel.
   */
  widthOf(style: LineStyle, polyline: Float32Array): number {
    const middle = 3 * Math.floor(polyline.length / 6);
    const [x = 0, y = 0, z = 0] = polyline.subarray(middle, middle + 3);
    return Number(this.seenWidth(style, this.surface!.inScene([x, y, z])).toFixed(2));
  }
}

const placesIn = (coordinates: ArrayLike<number> = []): Vector3[] =>
  Array.from({ length: coordinates.length / 3 }, (_, i) =>
    new Vector3().fromArray(coordinates, 3 * i),
  );

/**
 * Converts a place from coordinates between -1 and 1 across the stage to CSS pixels from the
 * stage's corner.
 */
function toStage(place: Vector3, { width, height }: { width: number; height: number }): Vector3 {
  place.x = ((place.x + 1) / 2) * width;
  place.y = ((1 - place.y) / 2) * height;
  return place;
}
