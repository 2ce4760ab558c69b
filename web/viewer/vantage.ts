import { Matrix4, type PerspectiveCamera, Ray, Vector3, Vector4 } from 'three';
import type { LineStyle } from '../model/drawing';
import type { Surface } from './surface';

/** A polyline on the stage: places in CSS pixels, and which of them are hidden. */
export interface SeenLine {
  x: number[];
  y: number[];
  hidden: boolean[];
}

/**
 * A part of a polyline on the stage, either visible or hidden, with the index of the polyline's
 * segment for each of its own.
 */
export interface SeenPart extends SeenLine {
  segments: number[];
  /** The place at the middle of the part, in the scene. */
  middle: Vector3;
}

/** A line's width in its unit. */
type Width = Pick<LineStyle, 'width' | 'onSurface'>;

/** The visible point of a line that appears nearest to a place of the stage. */
export interface NearestSeen {
  /** The place in the scene. */
  position: Vector3;
  /** The distance from the place, in CSS pixels. */
  distance: number;
}

/** A point that is at most this far behind the surface, in the scene, counts as on it. */
const grain = 0.004;
/** The largest distance between tests of whether a line is hidden, in CSS pixels. */
const step = 4;

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
   * The parts of a polyline, in the surface's coordinates, where a line of a width is in the view,
   * as they appear on the stage. A part has extra places on long segments, which may be hidden
   * between their ends.
   */
  *seenParts(polyline: Float32Array, width: Width): Generator<SeenPart> {
    const places = placesIn(this.surface?.toScene(polyline));
    const heights = places.map((place) => this.#heights(place, this.seenWidth(width, place) / 2));
    let part: Vector3[] = [];
    let segments: number[] = [];
    for (const [segment, from] of places.slice(0, -1).entries()) {
      const to = places[segment + 1]!;
      const [enters, leaves] = partAbove(heights[segment]!, heights[segment + 1]!);
      if (enters < leaves) {
        const [start, end] = [enters, leaves].map((t) => from.clone().lerp(to, t)) as [
          Vector3,
          Vector3,
        ];
        if (part.length === 0) part.push(start);
        const added = this.#inSteps(start, end);
        part.push(...added);
        segments.push(...added.map(() => segment));
      }
      if (part.length > 0 && (leaves < 1 || segment === places.length - 2)) {
        yield* this.#runs(part, segments);
        [part, segments] = [[], []];
      }
    }
  }

  /** The visible and the hidden parts of a line of the scene. */
  *#runs(places: readonly Vector3[], segments: readonly number[]): Generator<SeenPart> {
    const { x, y, hidden } = this.#onStage(places);
    const isHidden = (segment: number) => hidden[segment] && hidden[segment + 1];
    let first = 0;
    for (let last = 1; last <= segments.length; last++) {
      if (last < segments.length && isHidden(last) === isHidden(first)) continue;
      const [xs, ys, ends] = [x, y, hidden].map((all) => all.slice(first, last + 1)) as [
        number[],
        number[],
        boolean[],
      ];
      const middle = places[Math.floor((first + last + 1) / 2)]!;
      yield { x: xs, y: ys, hidden: ends, segments: segments.slice(first, last), middle };
      first = last;
    }
  }

  /**
   * The heights of a place of the scene above the planes that bound the view with a margin, in front
   * of the camera and at the four sides. The heights are linear in the place.
   */
  #heights(place: Vector3, margin: number): number[] {
    const { matrixWorldInverse, projectionMatrix, near } = this.camera;
    const { x, y, w } = new Vector4(...place.toArray(), 1)
      .applyMatrix4(matrixWorldInverse)
      .applyMatrix4(projectionMatrix);
    const [aside, up] = [this.size.width, this.size.height].map(
      (length) => w * (1 + (2 * margin) / length),
    ) as [number, number];
    return [w - near, aside + x, aside - x, up + y, up - y];
  }

  /** Places of the scene on a segment after its start, near to each other on the stage. */
  #inSteps(start: Vector3, end: Vector3): Vector3[] {
    const [from, to] = [start, end].map((place) => this.onStage(place.clone())) as [
      Vector3,
      Vector3,
    ];
    const pieces = Math.max(1, Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / step));
    const between = Array.from({ length: pieces - 1 }, (_, i) =>
      this.fromStage(from.clone().lerp(to, (i + 1) / pieces)),
    );
    return [...between, end];
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
  seenWidth({ width, onSurface }: Width, position: Vector3): number {
    return onSurface ? width / this.reach(position, 1) : width;
  }

  /** The visible width at a point of the scene, rounded to a hundredth of a CSS pixel. */
  widthOf(style: Width, position: Vector3): number {
    return rounded(this.seenWidth(style, position));
  }

  /** The visible lengths of a dash and a gap of the scene at a point of it, for an SVG. */
  dashesOf([dash, gap]: readonly [number, number], position: Vector3): string {
    const pixel = this.reach(position, 1) * this.surface!.frame.scale;
    return `${rounded(dash / pixel)} ${rounded(gap / pixel)}`;
  }
}

/**
 * The part of a segment where no height is negative, from 0 at the segment's start to 1 at its end,
 * by the heights at both; from 1 to 0 if there is none.
 */
function partAbove(from: readonly number[], to: readonly number[]): [number, number] {
  let [enters, leaves] = [0, 1];
  for (const [k, before] of from.entries()) {
    const after = to[k]!;
    if (before < 0 && after < 0) return [1, 0];
    const crosses = before / (before - after);
    if (before < 0) enters = Math.max(enters, crosses);
    else if (after < 0) leaves = Math.min(leaves, crosses);
  }
  return [enters, leaves];
}

const rounded = (pixels: number) => Number(pixels.toFixed(2));

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
