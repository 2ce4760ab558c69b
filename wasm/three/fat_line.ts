import {
  type ColorRepresentation,
  DynamicDrawUsage,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  type Material,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/** The look of a line. */
export interface LineLook {
  /** The width in pixels; the default is 3. */
  width?: number | undefined;
  /** The color; the default is a red. */
  color?: ColorRepresentation | undefined;
}

/**
 * A line appears nearer to the camera by this fraction of its distance from the camera, so that its
 * surface does not cut it.
 */
export const nearer = 0.003;

/** The color of a line for which none is given. */
export const lineColor = 0xd03a1e;

/**
 * Brings a material's depth nearer to the camera by the fraction `part` of the distance. `after` is
 * the line of the vertex shader after which `gl_Position` is known.
 */
export function liftMaterial(material: Material, after: string, part: number): void {
  material.onBeforeCompile = (shader) => {
    // A place moved along its ray stays at the same pixel: only the depth changes. In perspective
    // that change depends only on the last entry of the projection's third row.
    const lift = `projectionMatrix[3][3] == 0.0 ? projectionMatrix[3][2] * ${part / (1 - part)} : ${-part}`;
    shader.vertexShader = shader.vertexShader.replace(after, `${after} gl_Position.z += ${lift};`);
  };
  material.customProgramCacheKey = () => `karcher ${part}`;
}

/**
 * A material for lines of this width in pixels, with the depth of a line slightly nearer to the
 * camera.
 */
export function lineMaterial({ width = 3, color = lineColor }: LineLook): LineMaterial {
  const material = new LineMaterial({ color, linewidth: width });
  liftMaterial(material, 'gl_Position = clip;', nearer);
  return material;
}

/**
 * A geometry of segments without an index. With an index, software rendering in Chromium 156 draws
 * only the first instance.
 */
function segmentGeometry(): LineSegmentsGeometry {
  const geometry = new LineSegmentsGeometry();
  if (!geometry.index) return geometry;
  const { position, uv } = geometry.toNonIndexed().attributes;
  return geometry.setAttribute('position', position!).setAttribute('uv', uv!).setIndex(null);
}

/**
 * Draws a polyline as a fat line. It reuses the line's buffers, and replaces them by larger ones
 * only if the polyline does not fit, so that a drag seldom allocates memory.
 */
export function drawLine(line: LineSegments2, polyline: ArrayLike<number>): void {
  const count = Math.max(0, polyline.length / 3 - 1);
  let ends = bufferOf(line);
  if (!ends || ends.count < count) {
    // Buffers of the graphics card do not grow.
    line.geometry.dispose();
    ends = new InstancedInterleavedBuffer(new Float32Array(6 * Math.ceil(1.5 * count)), 6, 1);
    ends.setUsage(DynamicDrawUsage);
    line.geometry = segmentGeometry();
    line.geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(ends, 3, 0));
    line.geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(ends, 3, 3));
  }
  const places = ends.array as Float32Array;
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < 6; k++) places[6 * i + k] = polyline[3 * i + k]!;
  }
  // Bounds include the whole array, so its unused rest repeats the last point.
  for (let i = 6 * count; i < places.length; i++) places[i] = places[i - 3]!;
  ends.needsUpdate = true;
  line.geometry.instanceCount = count;
  line.geometry.computeBoundingBox();
  line.geometry.computeBoundingSphere();
}

function bufferOf({ geometry }: LineSegments2): InstancedInterleavedBuffer | undefined {
  const start = geometry.getAttribute('instanceStart') as InterleavedBufferAttribute | undefined;
  return start?.data as InstancedInterleavedBuffer | undefined;
}
