import {
  type Color,
  DynamicDrawUsage,
  Float32BufferAttribute,
  GreaterDepth,
  Group,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  type Vector3,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

export interface LineStyle {
  /** In CSS pixels. */
  width: number;
  /** Dash and gap in the scene's units; solid where there are none. */
  dash?: readonly [number, number] | null;
  /** How much of the color is left where the surface hides the line. */
  hidden: number;
}

/** Lines are drawn this part of the way to the camera nearer, so that the surface cuts none. */
const nearer = 0.003;

/** How wide a line is where the surface hides it, as a part of its width. */
const hiddenWidth = 0.55;

/** Of what stands in for something else, as a part of a curve without a center. */
export const fineDash = [0.009, 0.006] as const;
const smallest = 256;

/** Without an index: by one, software rendering in Chromium 156 draws the first of the instances alone. */
function segmentGeometry(): LineSegmentsGeometry {
  const geometry = new LineSegmentsGeometry();
  const index = geometry.getIndex();
  if (!index) return geometry;
  for (const name of ['position', 'uv']) {
    const attribute = geometry.getAttribute(name);
    const values = Array.from(index.array, (i) =>
      Array.from({ length: attribute.itemSize }, (_, k) => attribute.getComponent(i, k)),
    );
    geometry.setAttribute(name, new Float32BufferAttribute(values.flat(), attribute.itemSize));
  }
  return geometry.setIndex(null);
}

/**
 * Polylines of constant width on the screen; what the surface hides shows through faintly. The
 * buffers are kept and only grow, so that a drag makes none.
 */
export class FatLine {
  readonly object = new Group();
  readonly #materials: LineMaterial[];
  readonly #left: number;
  #geometry = new LineSegmentsGeometry();
  #ends = new Float32Array(0);
  #distances = new Float32Array(0);
  #segments = 0;

  constructor(style: LineStyle, order: number) {
    this.#left = style.hidden;
    const common = { transparent: true, depthWrite: false };
    const seen = new LineMaterial(common);
    // Not see-through: the segments' round ends lie over each other, and would show as beads.
    const hidden = new LineMaterial(common);
    hidden.depthFunc = GreaterDepth;
    hidden.visible = style.hidden > 0;
    this.#materials = [hidden, seen];
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

  setStyle({ width, dash }: Pick<LineStyle, 'width' | 'dash'>): void {
    for (const material of this.#materials) {
      // What is hidden is thin beside what is seen.
      material.linewidth = material === this.#materials[0] ? hiddenWidth * width : width;
      material.dashed = Boolean(dash);
      if (dash) [material.dashSize, material.gapSize] = dash;
    }
  }

  /** The line's color, and the surface's around it. */
  setColor(color: Color, surface: Color): void {
    const [hidden, seen] = this.#materials;
    seen!.color.copy(color);
    hidden!.color.copy(surface).lerp(color, this.#left);
  }

  /** Whether what the surface hides shows through. */
  showHidden(shown: boolean): void {
    this.#materials[0]!.visible = shown && this.#left > 0;
  }

  /** Takes the lines nearer to the camera, each point along its own ray. */
  follow(camera: Vector3): void {
    this.object.position.copy(camera).multiplyScalar(nearer);
    this.object.scale.setScalar(1 - nearer);
  }

  clear(): void {
    this.#segments = 0;
    this.#upload();
  }

  /** Shows these polylines, x, y, z each, instead of what was there. */
  set(polylines: readonly Float32Array[]): void {
    const count = polylines.reduce((sum, line) => sum + Math.max(0, line.length / 3 - 1), 0);
    this.#reserve(count);
    this.#segments = 0;
    for (const line of polylines) {
      for (let i = 3; i < line.length; i += 3) this.#add(line, i);
    }
    this.#upload();
  }

  /** Shows the segments of a polyline that the choice takes. */
  setChosen(line: Float32Array, choice: (segment: number) => boolean): void {
    this.#reserve(line.length / 3);
    this.#segments = 0;
    for (let i = 3; i < line.length; i += 3) if (choice(i / 3 - 1)) this.#add(line, i);
    this.#upload();
  }

  dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }

  #add(line: Float32Array, at: number): void {
    const segment = this.#segments++;
    for (let i = 0; i < 6; i++) this.#ends[6 * segment + i] = line[at - 3 + i]!;
    const before = segment > 0 ? this.#distances[2 * segment - 1]! : 0;
    const x = line[at]! - line[at - 3]!;
    const y = line[at + 1]! - line[at - 2]!;
    const z = line[at + 2]! - line[at - 1]!;
    this.#distances[2 * segment] = before;
    this.#distances[2 * segment + 1] = before + Math.sqrt(x * x + y * y + z * z);
  }

  #reserve(count: number): void {
    if (6 * count <= this.#ends.length) return;
    const capacity = Math.max(smallest, 2 ** Math.ceil(Math.log2(count)));
    this.#ends = new Float32Array(6 * capacity);
    this.#distances = new Float32Array(2 * capacity);
    this.#geometry.dispose();
    this.#geometry = segmentGeometry();
    const [ends, distances] = [
      new InstancedInterleavedBuffer(this.#ends, 6, 1),
      new InstancedInterleavedBuffer(this.#distances, 2, 1),
    ];
    for (const buffer of [ends, distances]) buffer.setUsage(DynamicDrawUsage);
    const attributes = {
      instanceStart: new InterleavedBufferAttribute(ends, 3, 0),
      instanceEnd: new InterleavedBufferAttribute(ends, 3, 3),
      instanceDistanceStart: new InterleavedBufferAttribute(distances, 1, 0),
      instanceDistanceEnd: new InterleavedBufferAttribute(distances, 1, 1),
    };
    for (const [name, attribute] of Object.entries(attributes)) {
      this.#geometry.setAttribute(name, attribute);
    }
    for (const line of this.object.children) (line as LineSegments2).geometry = this.#geometry;
  }

  #upload(): void {
    this.#geometry.instanceCount = this.#segments;
    this.object.visible = this.#segments > 0;
    for (const name of ['instanceStart', 'instanceDistanceStart']) {
      const { data } = this.#geometry.getAttribute(name) as InterleavedBufferAttribute;
      data.clearUpdateRanges();
      data.addUpdateRange(0, this.#segments * data.stride);
      data.needsUpdate = true;
    }
  }
}
