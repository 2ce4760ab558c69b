import { Color, Group, Vector3 } from 'three';
import type { Vector } from '../model/figure';
import { litSurface, type ViewerColors } from './colors';
import { FatLine, fineDash } from './fat_line';
import type { Layer } from './layer';
import { dotAt } from './object_lines';
import type { Surface } from './surface';

/** The length of a tangent's line, in units of the scene; a surface's diagonal is 2. */
const tangentLength = 0.16;

/** Lines that assist the user beside the drawing: legs, marks, and lines under construction. */
export class AidLines implements Layer {
  readonly object = new Group();
  readonly #polygon = new FatLine({ width: 1.5, hidden: 0.25 }, 2);
  readonly #sketch = new FatLine({ width: 2.5, dash: fineDash, hidden: 0.25 }, 2);
  readonly #shorter = new FatLine({ width: 2.5, dash: fineDash, hidden: 0.3 }, 2);
  readonly #marks = new FatLine({ width: 7.5, hidden: 0.26 }, 6);
  readonly #tangent = new FatLine({ width: 2.5, hidden: 0.5 }, 7);
  readonly #places = new FatLine({ width: 3, hidden: 0.45 }, 5);
  readonly #stroke = new FatLine({ width: 3, hidden: 0.25 }, 4);
  readonly #frame = new FatLine({ width: 1.5, dash: fineDash, hidden: 0.2 }, 5);
  readonly #band = new FatLine({ width: 2, dash: fineDash, hidden: 0.2 }, 4);
  readonly #lines = [
    ...[this.#polygon, this.#sketch, this.#shorter, this.#marks, this.#tangent],
    ...[this.#places, this.#stroke, this.#frame, this.#band],
  ];
  #surface: Surface | null = null;
  #shorterWays: readonly Float32Array[] = [];

  constructor(private readonly redraw: () => void) {
    this.object.add(...this.#lines.map(({ object }) => object));
  }

  follow(camera: Vector3): void {
    for (const line of this.#lines) line.follow(camera);
  }

  setColors(colors: ViewerColors): void {
    const surface = litSurface(colors);
    this.#places.setColor(new Color(colors.lost), surface);
    this.#polygon.setColor(new Color(colors.polygon), surface);
    this.#marks.setColor(new Color(colors.marks), surface);
    this.#frame.setColor(new Color(colors.frame), surface);
    for (const line of [this.#shorter, this.#tangent]) {
      line.setColor(new Color(colors.center), surface);
    }
  }

  /** Sets the color of the edited object, for lines that stand for it. */
  setOwnColor(own: Color, surface: Color): void {
    for (const line of [this.#sketch, this.#stroke, this.#band]) line.setColor(own, surface);
  }

  /** Removes all lines. Later lines lie on the given surface. */
  clear(surface: Surface): void {
    this.#surface = surface;
    this.#shorterWays = [];
    for (const line of this.#lines) line.clear();
    this.redraw();
  }

  /** Shows the geodesics between control points. With `bold`, they stand for the curve. */
  showPolygon(legs: readonly Float32Array[], bold: boolean): void {
    const lines = this.#inScene(legs);
    this.#polygon.set(bold ? [] : lines);
    this.#sketch.set(bold ? lines : []);
    this.redraw();
  }

  /** Shows paths that are shorter than the legs of the curve. */
  showShorter(lines: readonly Float32Array[]): void {
    this.#shorterWays = this.#inScene(lines);
    this.#show(this.#shorter, this.#shorterWays);
  }

  /** The shorter paths, in the scene. */
  get shorter(): readonly Float32Array[] {
    return this.#shorterWays;
  }

  /** Marks points of the curve, with x, y, z of each point in the surface's coordinates. */
  showMarks(places: ArrayLike<number>): void {
    const points = this.#surface?.toScene(Float32Array.from(places)) ?? new Float32Array();
    const dots = Array.from({ length: points.length / 3 }, (_, i) =>
      dotAt(new Vector3().fromArray(points, 3 * i)),
    );
    this.#show(this.#marks, dots);
  }

  /** Shows outlines of places of the surface, in its coordinates. */
  showPlaces(lines: readonly Float32Array[]): void {
    this.#show(this.#places, this.#inScene(lines));
  }

  /** Shows a curve's tangent at a place, in the surface's coordinates. */
  showTangent(at: { position: Vector; tangent: Vector } | null): void {
    const surface = this.#surface;
    const lines: Float32Array[] = [];
    if (at && surface) {
      const start = surface.inScene(at.position);
      const tip = surface.directionInScene(at.tangent).setLength(tangentLength).add(start);
      lines.push(Float32Array.of(...start.toArray(), ...tip.toArray()));
    }
    this.#show(this.#tangent, lines);
  }

  /** Shows the path to the point that a click would add, in the scene. */
  showBand(line: Float32Array | null): void {
    this.#show(this.#band, line ? [line] : []);
  }

  /** Shows an unfinished stroke, in the scene. */
  showStroke(line: Float32Array | null): void {
    this.#show(this.#stroke, line ? [line] : []);
  }

  /** Shows the frame of a transformation: polylines in the scene. */
  showFrame(lines: readonly Float32Array[]): void {
    this.#show(this.#frame, lines);
  }

  #show(line: FatLine, lines: readonly Float32Array[]): void {
    line.set(lines);
    this.redraw();
  }

  #inScene(lines: readonly Float32Array[]): Float32Array[] {
    const surface = this.#surface;
    return surface ? lines.map((line) => surface.toScene(line)) : [];
  }
}
