import type { SurfacePoint } from 'karcher';
import { type BufferGeometry, Color, Group, Mesh, type ShaderMaterial, Vector3 } from 'three';
import type { FillStyle } from '../model/drawing';
import { isInTriangle } from '../model/parts';
import type { Pattern, Region } from '../model/traced';
import { type Bars, barsOf, paintedParts, partPainted } from './bars';
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

function seenTriangles(
  places: Float32Array,
  vantage: Vantage,
  bars: (Bars & { values: Float32Array }) | null,
): Float32Array {
  const count = places.length / 9;
  const triangles: number[] = [];
  const [place, middle] = [new Vector3(), new Vector3()];
  for (let i = 0; i < count; i++) {
    middle.set(0, 0, 0);
    for (let at = 9 * i; at < 9 * i + 9; at += 3) {
      middle.addScaledVector(place.fromArray(places, at), 1 / 3);
    }
    if (vantage.project(middle).hidden) continue;
    const [a, b, c] = [0, 3, 6].map((corner) => {
      const { x, y } = vantage.onStage(place.fromArray(places, 9 * i + corner));
      return [x, y] as const;
    }) as [Place, Place, Place];
    // All triangles have the same orientation, so that the fills of neighbors add up at their
    // common edge and do not cancel.
    const turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const corners = turn < 0 ? [0, 2, 1] : [0, 1, 2];
    const onPaper = [a, b, c];
    if (!bars) for (const k of corners) triangles.push(...onPaper[k]!);
    else {
      const valued = corners.map((k) => [...onPaper[k]!, bars.values[3 * i + k]!] as const);
      triangles.push(...paintedParts(valued, bars));
    }
  }
  return Float32Array.from(triangles);
}

type Place = readonly [number, number];

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
