import { checkOneOf, shown } from '../check.js';
import { KarcherError } from '../errors.js';
import { binaryChunk, glbMagic, jsonChunk } from './glb.js';
import { linearLight } from './marks.js';

/**
 * The mesh to write, with arrays as `mesh.cut` returns them. Its other properties are those of `FileMarks`,
 * which can be spread into it: colors are written to PLY, OBJ and GLB, parts to OBJ and GLB.
 */
export interface Triangles {
  /** The positions of the vertices: x, y, z for each. */
  positions: ArrayLike<number>;
  /** Three vertex numbers for each triangle. */
  triangles: ArrayLike<number>;
  /** Red, green and blue of each vertex, 0 to 255. */
  colors?: ArrayLike<number> | null | undefined;
  /** The names of the parts, for formats that have parts. */
  parts?: readonly { name: string }[] | undefined;
  /** The number of each triangle's part. */
  partOf?: ArrayLike<number> | null | undefined;
}

const writers = { stl: stlFile, ply: plyFile, obj: objFile, glb: glbFile };

/** A format of mesh files that can be written, which is also the ending of a file's name. */
export type WrittenFormat = keyof typeof writers;

/** The formats that can be written, which are also the endings of files' names. */
export const writtenFormats = Object.keys(writers) as readonly WrittenFormat[];

/**
 * Triangles as a file: OBJ, or PLY, STL or GLB in binary. OBJ and PLY keep positions to the last
 * bit. STL and GLB hold single precision: positions on both sides of a cut are still equal, and
 * triangles of which two corners become one are left out. Throws `KarcherError` badArgument and
 * badIndex.
 */
export function meshFile(mesh: Triangles, format: WrittenFormat): Uint8Array<ArrayBuffer> {
  checkOneOf(format, writtenFormats, 'the format');
  checkTriangles(mesh);
  return writers[format](mesh);
}

function checkTriangles({ positions, triangles, colors, parts, partOf }: Triangles): void {
  for (const [numbers, what] of [
    [positions, 'positions'],
    [triangles, 'triangles'],
  ] as const) {
    if (numbers.length % 3 === 0) continue;
    throw new KarcherError('badArgument', `the ${what} must be three numbers each`);
  }
  const count = positions.length / 3;
  for (let i = 0; i < triangles.length; i++) {
    const vertex = triangles[i]!;
    if (Number.isInteger(vertex) && vertex >= 0 && vertex < count) continue;
    throw new KarcherError('badIndex', `there is no vertex ${shown(vertex)}: there are ${count}`);
  }
  if (colors && colors.length !== positions.length) {
    const what = `the colors must be three numbers a vertex, ${positions.length}, not ${colors.length}`;
    throw new KarcherError('badArgument', what);
  }
  for (let i = 0; i < (colors?.length ?? 0); i++) {
    const value = colors![i]!;
    if (Number.isInteger(value) && value >= 0 && value <= 255) continue;
    throw new KarcherError(
      'badArgument',
      `a color is ${shown(value)}, not a whole number from 0 to 255`,
    );
  }
  if (!partOf) return;
  if (3 * partOf.length !== triangles.length) {
    const what = `there must be a part for each of ${triangles.length / 3} triangles, not ${partOf.length}`;
    throw new KarcherError('badArgument', what);
  }
  for (let i = 0; i < partOf.length; i++) {
    if (parts?.[partOf[i]!] !== undefined) continue;
    throw new KarcherError(
      'badIndex',
      `there is no part ${shown(partOf[i])}: there are ${parts?.length ?? 0}`,
    );
  }
}

/** The name of a part, on one line. */
const partName = ({ name }: { name: string }) => name.replace(/\p{Cc}+/gu, ' ').trim() || 'unnamed';

function objFile({ positions, triangles, colors, parts, partOf }: Triangles) {
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3) {
    const color = colors ? [0, 1, 2].map((k) => ` ${colors[i + k]! / 255}`).join('') : '';
    lines.push(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}${color}\n`);
  }
  for (let i = 0; i < triangles.length; i += 3) {
    const part = partOf?.[i / 3];
    if (part !== undefined && part !== partOf![i / 3 - 1])
      lines.push(`o ${partName(parts![part]!)}\n`);
    lines.push(`f ${triangles[i]! + 1} ${triangles[i + 1]! + 1} ${triangles[i + 2]! + 1}\n`);
  }
  return new TextEncoder().encode(lines.join(''));
}

function plyFile({ positions, triangles, colors }: Triangles): Uint8Array<ArrayBuffer> {
  const count = positions.length / 3;
  const colored = 'property uchar red\nproperty uchar green\nproperty uchar blue\n';
  const header = new TextEncoder().encode(
    'ply\nformat binary_little_endian 1.0\n' +
      `element vertex ${count}\nproperty double x\nproperty double y\nproperty double z\n` +
      (colors ? colored : '') +
      `element face ${triangles.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`,
  );
  const rowBytes = colors ? 27 : 24;
  const faces = header.length + rowBytes * count;
  const bytes = new Uint8Array(faces + 13 * (triangles.length / 3));
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  for (let vertex = 0, at = header.length; vertex < count; vertex++, at += rowBytes) {
    for (let k = 0; k < 3; k++) {
      view.setFloat64(at + 8 * k, positions[3 * vertex + k]!, true);
      if (colors) view.setUint8(at + 24 + k, colors[3 * vertex + k]!);
    }
  }
  for (let i = 0, at = faces; i < triangles.length; i += 3, at += 13) {
    view.setUint8(at, 3);
    for (let k = 0; k < 3; k++) view.setInt32(at + 1 + 4 * k, triangles[i + k]!, true);
  }
  return bytes;
}

/** The triangles in single precision, without those of which rounding unites two corners. */
function single({ positions, triangles, partOf }: Triangles) {
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

function stlFile(mesh: Triangles): Uint8Array<ArrayBuffer> {
  const { rounded, kept } = single(mesh);
  const [headerBytes, triangleBytes] = [84, 50];
  const bytes = new Uint8Array(headerBytes + triangleBytes * (kept.length / 3));
  // The text must not begin with 'solid', as text files do.
  bytes.set(new TextEncoder().encode('binary STL of Karcher'));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, kept.length / 3, true);
  for (let i = 0, at = headerBytes; i < kept.length; i += 3, at += triangleBytes) {
    const corners = [0, 1, 2].map((k) => rounded.subarray(3 * kept[i + k]!, 3 * kept[i + k]! + 3));
    [normalOf(corners), ...corners].forEach((numbers, k) => {
      for (let axis = 0; axis < 3; axis++) {
        view.setFloat32(at + 12 * k + 4 * axis, numbers[axis]!, true);
      }
    });
  }
  return bytes;
}

function normalOf(corners: readonly Float32Array[]): number[] {
  const [a, b, c] = corners as [Float32Array, Float32Array, Float32Array];
  const [ux, uy, uz] = [b[0]! - a[0]!, b[1]! - a[1]!, b[2]! - a[2]!];
  const [vx, vy, vz] = [c[0]! - a[0]!, c[1]! - a[1]!, c[2]! - a[2]!];
  const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(...normal);
  return normal.map((value) => (length > 0 ? value / length : 0));
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

/** A GLB file with a mesh and a node for each part. All have the same vertices. */
function glbFile(mesh: Triangles): Uint8Array<ArrayBuffer> {
  const { rounded, kept, keptParts } = single(mesh);
  const light = mesh.colors && Float32Array.from(mesh.colors, (byte) => linearLight(byte / 255));
  const ofParts = cornersOfParts(kept, keptParts);
  const columns = [rounded, ...(light ? [light] : [])];
  const arrays = [...columns, ...ofParts.map(([, corners]) => Uint32Array.from(corners))];
  let end = 0;
  const bufferViews = arrays.map((array, i) => {
    const byteOffset = end;
    end += array.byteLength;
    const target = i < columns.length ? 34962 : 34963;
    return { buffer: 0, byteOffset, byteLength: array.byteLength, target };
  });
  const extent = (pick: (...values: number[]) => number, start: number) =>
    [0, 1, 2].map((axis) => {
      let most = start;
      for (let i = axis; i < rounded.length; i += 3) most = pick(most, rounded[i]!);
      return most;
    });
  const ofVertices = { componentType: 5126, count: rounded.length / 3, type: 'VEC3' };
  const bounds = {
    min: extent(Math.min, Number.POSITIVE_INFINITY),
    max: extent(Math.max, Number.NEGATIVE_INFINITY),
  };
  const attributes = { POSITION: 0, ...(light ? { COLOR_0: 1 } : {}) };
  const names = ofParts.map(([part]) => (mesh.partOf ? { name: mesh.parts![part]!.name } : {}));
  const json = JSON.stringify({
    asset: { version: '2.0', generator: 'Karcher' },
    scene: 0,
    scenes: [{ nodes: names.map((_, i) => i) }],
    nodes: names.map((name, i) => ({ ...name, mesh: i })),
    meshes: names.map((name, i) => ({
      ...name,
      primitives: [{ attributes, indices: columns.length + i }],
    })),
    accessors: arrays.map((array, bufferView) =>
      bufferView < columns.length
        ? { bufferView, ...ofVertices, ...(bufferView === 0 ? bounds : {}) }
        : { bufferView, componentType: 5125, count: array.length, type: 'SCALAR' },
    ),
    bufferViews,
    buffers: [{ byteLength: end }],
  });
  const text = new TextEncoder().encode(json);
  const textLength = 4 * Math.ceil(text.length / 4);
  const bytes = new Uint8Array(12 + 8 + textLength + 8 + end);
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
  words(binary, [end, binaryChunk]);
  arrays.forEach((array, i) => {
    const at = binary + 8 + bufferViews[i]!.byteOffset;
    array.forEach((value, k) => {
      if (array instanceof Float32Array) view.setFloat32(at + 4 * k, value, true);
      else view.setUint32(at + 4 * k, value, true);
    });
  });
  return bytes;
}
