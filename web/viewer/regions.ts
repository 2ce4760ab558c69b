import type { SurfacePoint } from 'karcher';
import { type BufferGeometry, Color, Group, Mesh, type ShaderMaterial, Vector3 } from 'three';
import type { FillStyle } from '../model/drawing';
import { isInTriangle } from '../model/parts';
import type { Pattern, Region } from '../model/traced';
import { type Bars, barsOf, clipped, paintedParts, partPainted, type Valued } from './bars';
import { paint } from './clay';
import type { Surface } from './surface';
import type { Vantage } from './vantage';

/** A painted region of an object. */
export interface PaintedRegion {
  id: number;
  region: Region;
  /** The pattern of the fill; null for a solid fill, undefined before its computation. */
  pattern: Pattern | null | undefined;
  style: FillStyle;
  /** The color of the line, for a fill without a color of its own. */
  color: string | null;
  locked: boolean;
}

/** The painted regions on the surface, below the lines. */
export class Regions {
  readonly object = new Group();
  #painted: readonly PaintedRegion[] = [];
  #surface: Surface | null = null;
  #color = new Color();
  readonly #geometries = new Map<Region | Pattern, BufferGeometry>();

  /** Sets the color of lines without a color of their own. */
  setColor(color: Color): void {
    this.#color = color;
    this.#paint();
  }

  /** Shows regions on a surface, unless they are already visible. */
  show(painted: readonly PaintedRegion[], surface: Surface | null): void {
    if (surface === this.#surface && `${painted.map(keyOf)}` === `${this.#painted.map(keyOf)}`) {
      if (painted.every((one, i) => shapeOf(one) === shapeOf(this.#painted[i]!))) return;
    }
    if (surface !== this.#surface) this.#forget([]);
    [this.#painted, this.#surface] = [painted, surface];
    this.#forget(painted.map(shapeOf));
    this.#paint();
  }

  /** The id of the topmost object that has a painted region at a point and is not locked. */
  at(point: SurfacePoint): number | null {
    const found = this.#painted.findLast(({ region, locked }) => !locked && holds(region, point));
    return found?.id ?? null;
  }

  /** The visible triangles of each region, for a drawing on paper. */
  *seen(vantage: Vantage): Generator<{ painted: PaintedRegion; triangles: Float32Array }> {
    for (const painted of this.#painted) {
      const geometry = this.#geometryOf(painted);
      const places = geometry.getAttribute('position').array as Float32Array;
      const bars = painted.pattern ? barsOf(painted.style) : null;
      const values = painted.pattern?.values ?? new Float32Array();
      yield { painted, triangles: seenTriangles(places, vantage, bars && { ...bars, values }) };
    }
  }

  #paint(): void {
    for (const mesh of this.object.children) ((mesh as Mesh).material as ShaderMaterial).dispose();
    this.object.clear();
    for (const [i, one] of this.#painted.entries()) {
      const { style, color, pattern } = one;
      const own = style.fillColor ?? color;
      const bars = barsOf(style);
      // Until its pattern is computed, a fill is solid and as dark as the pattern on average.
      const opacity = bars && pattern === undefined ? partPainted(bars) * style.fill : style.fill;
      const mesh = new Mesh(
        this.#geometryOf(one),
        paint(own ? new Color(own) : this.#color, opacity, pattern ? bars : null),
      );
      // Regions come after the surface, and before all lines.
      mesh.renderOrder = 0.1 + i * 1e-4;
      this.object.add(mesh);
    }
  }

  #geometryOf(painted: PaintedRegion): BufferGeometry {
    const shape = shapeOf(painted);
    const surface = this.#surface!;
    const geometry =
      this.#geometries.get(shape) ??
      ('values' in shape ? surface.patternGeometry(shape) : surface.regionGeometry(shape));
    this.#geometries.set(shape, geometry);
    return geometry;
  }

  #forget(kept: readonly (Region | Pattern)[]): void {
    for (const [region, geometry] of this.#geometries) {
      if (kept.includes(region)) continue;
      geometry.dispose();
      this.#geometries.delete(region);
    }
  }
}

/** The source of a region's triangles: its pattern or, without one, the region itself. */
const shapeOf = ({ region, pattern }: PaintedRegion) => pattern ?? region;

/** The parts of triangles in the view, without those behind the camera or the surface. */
export function seenTriangles(
  places: ArrayLike<number>,
  vantage: Vantage,
  bars: (Bars & { values: Float32Array }) | null,
): Float32Array {
  const triangles: number[] = [];
  const place = new Vector3();
  const cornerAt = (i: number): Corner => {
    const [x, y, z] = [places[3 * i]!, places[3 * i + 1]!, places[3 * i + 2]!];
    return [x, y, z, bars?.values[i] ?? 0];
  };
  const heightOf = ([x, y, z]: Corner) => vantage.height(place.set(x, y, z));
  for (let i = 0; i < places.length / 3; i += 3) {
    const polygon = clipped([cornerAt(i), cornerAt(i + 1), cornerAt(i + 2)], heightOf);
    for (let k = 2; k < polygon.length; k++) {
      triangles.push(...seenTriangle([polygon[0]!, polygon[k - 1]!, polygon[k]!], vantage, bars));
    }
  }
  return Float32Array.from(triangles);
}

/** A corner of a triangle in the scene: x, y, z, and the distance that a pattern follows. */
type Corner = readonly [number, number, number, number];

function seenTriangle(
  corners: readonly [Corner, Corner, Corner],
  vantage: Vantage,
  bars: Bars | null,
): number[] {
  const [place, middle] = [new Vector3(), new Vector3()];
  for (const [x, y, z] of corners) middle.addScaledVector(place.set(x, y, z), 1 / 3);
  if (vantage.project(middle).hidden) return [];
  const [a, b, c] = corners.map(([px, py, pz, value]) => {
    const { x, y } = vantage.onStage(place.set(px, py, pz));
    return [x, y, value] as const;
  }) as [Valued, Valued, Valued];
  // All triangles have the same orientation, so that the fills of neighbors add up at their common
  // edge and do not cancel.
  const turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const onPaper = turn < 0 ? [a, c, b] : [a, b, c];
  return bars ? paintedParts(onPaper, bars) : onPaper.flatMap((corner) => corner.slice(0, 2));
}

const keyOf = ({ id, style, color, locked, pattern }: PaintedRegion) => {
  const { fill, fillColor, pattern: kind, spacing } = style;
  return `${[id, fill, fillColor, kind, spacing, color, locked, pattern === undefined]}`;
};

/** Whether a point lies in a region. */
export function holds({ whole, parts, corners }: Region, { face, bary }: SurfacePoint): boolean {
  if (whole[firstOf(whole, face)] === face) return true;
  const [, x, y] = bary;
  for (let i = firstOf(parts, face); parts[i] === face; i++) {
    if (isInTriangle(corners, i, x, y)) return true;
  }
  return false;
}

/** The index of the first number in `sorted` that is not below `value`. */
function firstOf(sorted: Int32Array, value: number): number {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
