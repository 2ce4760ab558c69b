import {
  AlwaysStencilFunc,
  type Color,
  DynamicDrawUsage,
  GreaterDepth,
  Group,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  KeepStencilOp,
  NotEqualStencilFunc,
  ReplaceStencilOp,
  type Vector3,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { type Band, withBand } from './band';

export interface LineStyle {
  /** The width in CSS pixels. */
  width: number;
  /** Dash and gap in the scene's units; without them the line is solid. */
  dash?: readonly [number, number] | null;
  /** The fraction of the color that remains where the surface hides the line. */
  hidden: number;
  /** The width on the surface, in addition to the one in pixels. */
  band?: Band | null;
  /** The opacity; below 1 the line shows what lies below it. */
  opacity?: number;
  /**
   * A number from 1 to 254 that marks a line in the stencil, to separate overlapping lines that are
   * not opaque.
   */
  mark?: number;
  /** An `inside` line is invisible, and `around` lines do not cover its pixels. */
  frames?: 'inside' | 'around' | null;
}

/** The stencil's mark for the pixels of `inside` lines. */
const free = 255;

/**
 * Lines appear nearer by this fraction of their distance from the camera, so that the surface does
 * not cut them.
 */
const nearer = 0.003;

/** The fraction of a line's width that remains where the surface hides the line. */
const hiddenWidth = 0.55;

/** Dash and gap of auxiliary lines, and of the lost parts of a curve. */
export const fineDash = [0.009, 0.006] as const;
const smallest = 256;

const segmentsOf = (polylines: readonly Float32Array[]) =>
  polylines.reduce((sum, line) => sum + Math.max(0, line.length / 3 - 1), 0);

/**
 * A geometry without an index: with one, software rendering in Chromium 156 draws only the first
 * instance.
 */
function segmentGeometry(): LineSegmentsGeometry {
  const geometry = new LineSegmentsGeometry();
  if (!geometry.index) return geometry;
  const { position, uv } = geometry.toNonIndexed().attributes;
  return geometry.setAttribute('position', position!).setAttribute('uv', uv!).setIndex(null);
}

/**
 * Polylines of constant width on the screen, or on the surface, with faint hidden parts. Larger
 * buffers replace the present ones only if the polylines do not fit, so that a drag rarely
 * allocates.
 */
export class FatLine {
  readonly object = new Group();
  readonly #materials: LineMaterial[];
  readonly #bands: { value: number }[];
  #left: number;
  #opacity = 1;
  #normals: Band['normals'] | null = null;
  /** Sets the visible polylines again, for another style. */
  #again = () => {};
  /** The polylines in the buffers, if all of their segments are visible. */
  #whole: readonly Float32Array[] = [];
  #geometry = new LineSegmentsGeometry();
  #ends = new Float32Array(0);
  #distances = new Float32Array(0);
  /** The surface's normals at the segments' ends, if the line has a width on the surface. */
  #asides = new Float32Array(0);
  #segments = 0;

  constructor(style: LineStyle, order: number) {
    this.#left = style.hidden;
    const common = { transparent: true, depthWrite: false };
    const made = [0, 1].map(() => withBand(new LineMaterial(common)));
    const [hidden, seen] = made.map(({ material }) => material) as [LineMaterial, LineMaterial];
    // The hidden part's color is mixed with the surface's in advance: transparent segments would
    // show their overlapping round ends as beads.
    hidden.depthFunc = GreaterDepth;
    hidden.visible = style.hidden > 0;
    this.#materials = [hidden, seen];
    this.#bands = made.map(({ band }) => band);
    for (const [i, material] of this.#materials.entries()) {
      const line = new LineSegments2(this.#geometry, material);
      line.frustumCulled = false;
      line.renderOrder = order + i;
      this.object.add(line);
    }
    this.setStyle(style);
    this.#reserve(smallest);
    this.clear();
  }

  setStyle(style: Omit<LineStyle, 'hidden'>): void {
    const { width, dash, band = null, opacity = 1, mark = 1, frames = null } = style;
    for (const [i, material] of this.#materials.entries()) {
      // The hidden part of a line is thinner than the visible one.
      const part = i === 0 ? hiddenWidth : 1;
      material.linewidth = part * width;
      this.#bands[i]!.value = part * (band?.width ?? 0);
      material.dashed = Boolean(dash);
      if (dash) [material.dashSize, material.gapSize] = dash;
    }
    const seen = this.#materials[1]!;
    this.#opacity = opacity;
    seen.opacity = opacity;
    // The stencil lets each pixel be painted only once, even where segments overlap.
    seen.stencilWrite = opacity < 1 || frames !== null;
    seen.stencilRef = frames === null ? mark : free;
    seen.stencilFunc = frames === 'inside' ? AlwaysStencilFunc : NotEqualStencilFunc;
    seen.stencilZPass = frames === 'around' ? KeepStencilOp : ReplaceStencilOp;
    seen.colorWrite = frames !== 'inside';
    const isNew = band !== null && this.#normals === null;
    this.#normals = band?.normals ?? null;
    if (isNew) this.#again();
  }

  /** Sets the color of the line, and the color of the surface around the line. */
  setColor(color: Color, surface: Color): void {
    const [hidden, seen] = this.#materials;
    seen!.color.copy(color);
    hidden!.color.copy(surface).lerp(color, this.#left * this.#opacity);
  }

  /** Sets whether parts behind the surface are visible. */
  showHidden(shown: boolean): void {
    this.#materials[0]!.visible = shown && this.#left > 0;
  }

  /** Moves the lines nearer to the camera, each point along its own ray. */
  follow(camera: Vector3): void {
    this.object.position.copy(camera).multiplyScalar(nearer);
    this.object.scale.setScalar(1 - nearer);
  }

  clear(): void {
    this.set([]);
  }

  /**
   * Replaces the visible polylines. Each has the coordinates x, y, z of its points. Those before the
   * first new one stay in the buffers, so that a drag of one object does not draw all others anew.
   */
  set(polylines: readonly Float32Array[]): void {
    this.#again = () => {
      this.#whole = [];
      this.set(polylines);
    };
    this.#reserve(segmentsOf(polylines));
    const before = this.#whole;
    const changed = polylines.findIndex((line, i) => line !== before[i]);
    const kept = changed < 0 ? polylines.length : changed;
    const first = segmentsOf(polylines.slice(0, kept));
    this.#segments = first;
    for (const line of polylines.slice(kept)) {
      const normals = this.#normals?.(line);
      for (let i = 3; i < line.length; i += 3) this.#add(line, i, normals);
    }
    this.#whole = [...polylines];
    this.#upload(first);
  }

  /** Shows the segments of a polyline that `choice` accepts. */
  setChosen(line: Float32Array, choice: (segment: number) => boolean): void {
    this.#again = () => this.setChosen(line, choice);
    this.#reserve(line.length / 3);
    this.#segments = 0;
    const normals = this.#normals?.(line);
    for (let i = 3; i < line.length; i += 3) if (choice(i / 3 - 1)) this.#add(line, i, normals);
    this.#whole = [];
    this.#upload(0);
  }

  dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }

  #add(line: Float32Array, at: number, normals?: Float32Array): void {
    const segment = this.#segments++;
    for (let i = 0; i < 6; i++) this.#ends[6 * segment + i] = line[at - 3 + i]!;
    if (normals) for (let i = 0; i < 6; i++) this.#asides[6 * segment + i] = normals[at - 3 + i]!;
    const before = segment > 0 ? this.#distances[2 * segment - 1]! : 0;
    const x = line[at]! - line[at - 3]!;
    const y = line[at + 1]! - line[at - 2]!;
    const z = line[at + 2]! - line[at - 1]!;
    this.#distances[2 * segment] = before;
    this.#distances[2 * segment + 1] = before + Math.sqrt(x * x + y * y + z * z);
  }

  #reserve(count: number): void {
    const isOnSurface = this.#normals !== null;
    if (6 * count <= (isOnSurface ? this.#asides : this.#ends).length) return;
    this.#whole = [];
    const capacity = Math.max(smallest, 2 ** Math.ceil(Math.log2(count)), this.#ends.length / 6);
    this.#ends = new Float32Array(6 * capacity);
    this.#distances = new Float32Array(2 * capacity);
    this.#asides = new Float32Array(isOnSurface ? 6 * capacity : 0);
    this.#geometry.dispose();
    this.#geometry = segmentGeometry();
    const [ends, distances, normals] = [
      new InstancedInterleavedBuffer(this.#ends, 6, 1),
      new InstancedInterleavedBuffer(this.#distances, 2, 1),
      new InstancedInterleavedBuffer(this.#asides, 6, 1),
    ];
    for (const buffer of [ends, distances, normals]) buffer.setUsage(DynamicDrawUsage);
    const attributes = {
      instanceStart: new InterleavedBufferAttribute(ends, 3, 0),
      instanceEnd: new InterleavedBufferAttribute(ends, 3, 3),
      instanceDistanceStart: new InterleavedBufferAttribute(distances, 1, 0),
      instanceDistanceEnd: new InterleavedBufferAttribute(distances, 1, 1),
      ...(isOnSurface && {
        instanceNormalStart: new InterleavedBufferAttribute(normals, 3, 0),
        instanceNormalEnd: new InterleavedBufferAttribute(normals, 3, 3),
      }),
    };
    for (const [name, attribute] of Object.entries(attributes)) {
      this.#geometry.setAttribute(name, attribute);
    }
    for (const line of this.object.children) (line as LineSegments2).geometry = this.#geometry;
  }

  /** Uploads the segments from `first` on. */
  #upload(first: number): void {
    this.#geometry.instanceCount = this.#segments;
    this.object.visible = this.#segments > 0;
    if (first === this.#segments) return;
    for (const name of ['instanceStart', 'instanceDistanceStart', 'instanceNormalStart']) {
      const attribute = this.#geometry.getAttribute(name) as InterleavedBufferAttribute | undefined;
      if (!attribute) continue;
      const { data } = attribute;
      // Earlier ranges remain until the next frame.
      const starts = data.updateRanges.map(({ start }) => start);
      const start = Math.min(first * data.stride, ...starts);
      data.clearUpdateRanges();
      data.addUpdateRange(start, this.#segments * data.stride - start);
      data.needsUpdate = true;
    }
  }
}
