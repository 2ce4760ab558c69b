import { checkOneOf, shown } from '../check.js';
import { KarcherError } from '../errors.js';
import { binaryChunk, glbMagic, jsonChunk } from './glb.js';

/** What is written: x, y, z a vertex, and three vertices a triangle, as `mesh.cut` gives them. */
export interface Triangles {
  positions: ArrayLike<number>;
  triangles: ArrayLike<number>;
}

const writers = { stl: stlFile, ply: plyFile, obj: objFile, glb: glbFile };

export type WrittenFormat = keyof typeof writers;

/** The formats that are written, which are the endings of files' names too. */
export const writtenFormats = Object.keys(writers) as readonly WrittenFormat[];

/**
 * Triangles as a file: OBJ, and PLY and STL and GLB as binary. OBJ and PLY keep positions to the last bit.
 * STL and GLB hold single precision: what lies on both sides of a cut is still equal there, and triangles of
 * which two corners become one are left out. Throws `KarcherError` badArgument and badIndex.
 */
export function meshFile(mesh: Triangles, format: WrittenFormat): Uint8Array<ArrayBuffer> {
  checkOneOf(format, writtenFormats, 'the format');
  checkTriangles(mesh);
  return writers[format](mesh);
}

function checkTriangles({ positions, triangles }: Triangles): void {
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
}

function objFile({ positions, triangles }: Triangles): Uint8Array<ArrayBuffer> {
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3) {
    lines.push(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}\n`);
  }
  for (let i = 0; i < triangles.length; i += 3) {
    lines.push(`f ${triangles[i]! + 1} ${triangles[i + 1]! + 1} ${triangles[i + 2]! + 1}\n`);
  }
  return new TextEncoder().encode(lines.join(''));
}

function plyFile({ positions, triangles }: Triangles): Uint8Array<ArrayBuffer> {
  const header = new TextEncoder().encode(
    'ply\nformat binary_little_endian 1.0\n' +
      `element vertex ${positions.length / 3}\nproperty double x\nproperty double y\nproperty double z\n` +
      `element face ${triangles.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`,
  );
  const faces = header.length + 8 * positions.length;
  const bytes = new Uint8Array(faces + 13 * (triangles.length / 3));
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  for (let i = 0; i < positions.length; i++) {
    view.setFloat64(header.length + 8 * i, positions[i]!, true);
  }
  for (let i = 0, at = faces; i < triangles.length; i += 3, at += 13) {
    view.setUint8(at, 3);
    for (let k = 0; k < 3; k++) view.setInt32(at + 1 + 4 * k, triangles[i + k]!, true);
  }
  return bytes;
}

/** The triangles in single precision, without those of which rounding makes two corners one. */
function single({ positions, triangles }: Triangles) {
  const rounded = Float32Array.from(positions);
  const isOne = (v: number, w: number) =>
    [0, 1, 2].every((axis) => rounded[3 * v + axis] === rounded[3 * w + axis]);
  const kept: number[] = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [triangles[i]!, triangles[i + 1]!, triangles[i + 2]!];
    if (!isOne(a, b) && !isOne(b, c) && !isOne(c, a)) kept.push(a, b, c);
  }
  return { rounded, kept };
}

function stlFile(mesh: Triangles): Uint8Array<ArrayBuffer> {
  const { rounded, kept } = single(mesh);
  const [headerBytes, triangleBytes] = [84, 50];
  const bytes = new Uint8Array(headerBytes + triangleBytes * (kept.length / 3));
  // It must not begin with 'solid', as files of text do.
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

function glbFile(mesh: Triangles): Uint8Array<ArrayBuffer> {
  const { rounded, kept } = single(mesh);
  const indices = Uint32Array.from(kept);
  const extent = (pick: (...values: number[]) => number, start: number) =>
    [0, 1, 2].map((axis) => {
      let most = start;
      for (let i = axis; i < rounded.length; i += 3) most = pick(most, rounded[i]!);
      return most;
    });
  const [vertexBytes, indexBytes] = [rounded.byteLength, indices.byteLength];
  const json = JSON.stringify({
    asset: { version: '2.0', generator: 'Karcher' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: rounded.length / 3,
        type: 'VEC3',
        min: extent(Math.min, Number.POSITIVE_INFINITY),
        max: extent(Math.max, Number.NEGATIVE_INFINITY),
      },
      { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteLength: vertexBytes, target: 34962 },
      { buffer: 0, byteOffset: vertexBytes, byteLength: indexBytes, target: 34963 },
    ],
    buffers: [{ byteLength: vertexBytes + indexBytes }],
  });
  const text = new TextEncoder().encode(json.padEnd(4 * Math.ceil(json.length / 4)));
  const bytes = new Uint8Array(12 + 8 + text.length + 8 + vertexBytes + indexBytes);
  const view = new DataView(bytes.buffer);
  const words = (at: number, values: number[]) => {
    values.forEach((value, i) => {
      view.setUint32(at + 4 * i, value, true);
    });
  };
  words(0, [glbMagic, 2, bytes.length, text.length, jsonChunk]);
  bytes.set(text, 20);
  const binary = 20 + text.length;
  words(binary, [vertexBytes + indexBytes, binaryChunk]);
  rounded.forEach((value, i) => {
    view.setFloat32(binary + 8 + 4 * i, value, true);
  });
  indices.forEach((value, i) => {
    view.setUint32(binary + 8 + vertexBytes + 4 * i, value, true);
  });
  return bytes;
}
