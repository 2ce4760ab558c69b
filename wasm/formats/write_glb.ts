import { KarcherError } from '../errors.js';
import { tubeAlong } from '../tube.js';
import type { FileCurve } from './curves.js';
import { binaryChunk, glbMagic, jsonChunk } from './glb.js';
import { linearLight } from './marks.js';
import type { Triangles } from './types.js';

/** The triangles in single precision, without those in which rounding merges two corners. */
export function single({ positions, triangles, partOf }: Triangles) {
  const rounded = Float32Array.from(positions);
  const isOne = (v: number, w: number) =>
    [0, 1, 2].every((axis) => rounded[3 * v + axis] === rounded[3 * w + axis]);
  const kept: number[] = [];
  const keptParts: number[] = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [triangles[i]!, triangles[i + 1]!, triangles[i + 2]!];
    if (isOne(a, b) || isOne(b, c) || isOne(c, a)) continue;
    kept.push(a, b, c);
    keptParts.push(partOf?.[i / 3] ?? 0);
  }
  return { rounded, kept, keptParts };
}

/** The corners of each part that has triangles, in order. */
function cornersOfParts(kept: readonly number[], keptParts: readonly number[]) {
  const ofParts = new Map<number, number[]>();
  for (const [triangle, part] of keptParts.entries()) {
    const corners = ofParts.get(part) ?? [];
    ofParts.set(part, corners);
    corners.push(kept[3 * triangle]!, kept[3 * triangle + 1]!, kept[3 * triangle + 2]!);
  }
  return [...ofParts].sort(([a], [b]) => a - b);
}

/**
 * The numbers that glTF has for types of components, targets of buffers and modes of primitives.
 */
const [float, unsignedInt, ofVertices, ofIndices, lineStrip] = [5126, 5125, 34962, 34963, 3];

/** The buffer of a GLB file, with an accessor for each array. */
class Buffer {
  readonly arrays: (Float32Array | Uint32Array)[] = [];
  readonly views: { buffer: 0; byteOffset: number; byteLength: number; target: number }[] = [];
  readonly accessors: object[] = [];
  byteLength = 0;

  /** Adds vectors, one for each vertex, and returns the number of their accessor. */
  vectors(array: Float32Array, bounds = {}): number {
    const count = array.length / 3;
    return this.#add(array, ofVertices, { componentType: float, count, type: 'VEC3', ...bounds });
  }

  positions(array: Float32Array): number {
    const extent = (pick: (...values: number[]) => number, start: number) =>
      [0, 1, 2].map((axis) => {
        let most = start;
        for (let i = axis; i < array.length; i += 3) most = pick(most, array[i]!);
        return most;
      });
    const min = extent(Math.min, Number.POSITIVE_INFINITY);
    return this.vectors(array, { min, max: extent(Math.max, Number.NEGATIVE_INFINITY) });
  }

  indices(array: Uint32Array): number {
    const count = array.length;
    return this.#add(array, ofIndices, { componentType: unsignedInt, count, type: 'SCALAR' });
  }

  #add(array: Float32Array | Uint32Array, target: number, accessor: object): number {
    const { byteLength } = array;
    this.views.push({ buffer: 0, byteOffset: this.byteLength, byteLength, target });
    this.arrays.push(array);
    this.byteLength += byteLength;
    return this.accessors.push({ bufferView: this.views.length - 1, ...accessor }) - 1;
  }
}

/** An object of a GLB file. */
interface GlbObject {
  name?: string;
  primitive: { attributes: object; indices?: number; mode?: number; material?: number };
}

/**
 * A GLB file with a mesh and a node for each part and for each curve. All parts share their
 * vertices. A curve has vertices of its own and, if it has a color, a material of its own.
 */
export function glbFile(mesh: Triangles): Uint8Array<ArrayBuffer> {
  const buffer = new Buffer();
  const objects = partsOf(mesh, buffer);
  const materials: object[] = [];
  for (const curve of mesh.curves ?? []) {
    const shape = primitiveOf(curve, buffer);
    if (!shape) continue;
    const material = curve.color && { material: materials.length };
    if (curve.color) materials.push(materialOf(curve.name, curve.color));
    const primitive = { ...shape, ...material };
    objects.push({ ...(curve.name && { name: curve.name }), primitive });
  }
  // The format has no empty lists.
  if (objects.length === 0) {
    throw new KarcherError('badArgument', 'GLB needs a triangle or a line, and there is neither');
  }
  const { arrays, views, accessors, byteLength } = buffer;
  const named = objects.map(({ name }) => (name === undefined ? {} : { name }));
  const json = {
    asset: { version: '2.0', generator: 'Karcher' },
    scene: 0,
    scenes: [{ nodes: objects.map((_, i) => i) }],
    nodes: named.map((name, i) => ({ ...name, mesh: i })),
    meshes: objects.map(({ primitive }, i) => ({ ...named[i], primitives: [primitive] })),
    ...(materials.length > 0 && { materials }),
    accessors,
    bufferViews: views,
    buffers: [{ byteLength }],
  };
  return packed(JSON.stringify(json), arrays, byteLength);
}

/** The parts of the mesh that have triangles. */
function partsOf(mesh: Triangles, buffer: Buffer): GlbObject[] {
  const { rounded, kept, keptParts } = single(mesh);
  const ofParts = cornersOfParts(kept, keptParts);
  // A curve alone needs none of the mesh's vertices.
  if (mesh.curves && ofParts.length === 0) return [];
  const light = mesh.colors && Float32Array.from(mesh.colors, (byte) => linearLight(byte / 255));
  const attributes = {
    POSITION: buffer.positions(rounded),
    ...(light && { COLOR_0: buffer.vectors(light) }),
  };
  return ofParts.map(([part, corners]) => ({
    ...(mesh.partOf && { name: mesh.parts![part]!.name }),
    primitive: { attributes, indices: buffer.indices(Uint32Array.from(corners)) },
  }));
}

/** A curve as a strip of lines, or as a tube; null for a tube without triangles. */
function primitiveOf(
  { path, radius, sides }: FileCurve,
  buffer: Buffer,
): GlbObject['primitive'] | null {
  const places = path.polyline({ bits: 64 });
  if (radius === undefined) {
    return {
      attributes: { POSITION: buffer.positions(Float32Array.from(places)) },
      mode: lineStrip,
    };
  }
  const line = { places, closed: path.closed };
  const tube = tubeAlong(line, { radius, ...(sides !== undefined && { sides }), caps: true });
  const { rounded, kept } = single(tube);
  if (kept.length === 0) return null;
  const attributes = {
    POSITION: buffer.positions(rounded),
    NORMAL: buffer.vectors(Float32Array.from(tube.normals)),
  };
  return { attributes, indices: buffer.indices(Uint32Array.from(kept)) };
}

const materialOf = (name: string | undefined, color: readonly number[]) => ({
  ...(name && { name }),
  pbrMetallicRoughness: {
    baseColorFactor: [...color.map((byte) => linearLight(byte / 255)), 1],
    metallicFactor: 0,
  },
});

function packed(
  json: string,
  arrays: readonly (Float32Array | Uint32Array)[],
  byteLength: number,
): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(json);
  const textLength = 4 * Math.ceil(text.length / 4);
  const bytes = new Uint8Array(12 + 8 + textLength + 8 + byteLength);
  const view = new DataView(bytes.buffer);
  const words = (at: number, values: number[]) => {
    values.forEach((value, i) => {
      view.setUint32(at + 4 * i, value, true);
    });
  };
  words(0, [glbMagic, 2, bytes.length, textLength, jsonChunk]);
  bytes.fill(32, 20, 20 + textLength);
  bytes.set(text, 20);
  const binary = 20 + textLength;
  words(binary, [byteLength, binaryChunk]);
  let at = binary + 8;
  for (const array of arrays) {
    for (const value of array) {
      if (array instanceof Float32Array) view.setFloat32(at, value, true);
      else view.setUint32(at, value, true);
      at += 4;
    }
  }
  return bytes;
}
