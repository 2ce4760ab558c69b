import { checkOneOf, shown } from '../check.js';
import { KarcherError } from '../errors.js';
import { tubeAlong } from '../tube.js';
import { type FileCurve, normalOf } from './curves.js';
import type { Triangles } from './types.js';
import { glbFile, single } from './write_glb.js';

const writers = { stl: stlFile, ply: plyFile, obj: objFile, glb: glbFile };

/** A format for writing mesh files, which is also the ending of a file's name. */
export type WrittenFormat = keyof typeof writers;

/** The formats for writing, which are also the endings of files' names. */
export const writtenFormats = Object.keys(writers) as readonly WrittenFormat[];

/**
 * Triangles as a file: OBJ, or PLY, STL or GLB in binary. OBJ and PLY keep positions to the last
 * bit. STL and GLB have single precision. Positions on both sides of a cut are then still equal,
 * and triangles in which rounding merges two corners are left out.
 *
 * Curves with a radius are tubes with flat ends. Other curves are lines: line strips in GLB, `l`
 * elements in OBJ, edges in PLY. STL has no lines. In OBJ and GLB each curve is an object with its
 * name. In GLB the color of a curve is that of its material. In OBJ and PLY, all vertices have
 * colors if the mesh or a curve has any. Vertices without a given color are white.
 *
 * Throws `KarcherError` badArgument and badIndex.
 *
 * @example
 * ```ts
 * const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
 * const curves = [{ name: 'seam', path: curve.path(), color: [200, 30, 30] as const, radius: 0.5 }];
 * const bytes = meshFile({ ...surface, curves }, 'glb');
 * ```
 */
export function meshFile(mesh: Triangles, format: WrittenFormat): Uint8Array<ArrayBuffer> {
  checkOneOf(format, writtenFormats, 'the format');
  checkTriangles(mesh);
  for (const curve of mesh.curves ?? []) checkCurve(curve, format);
  return writers[format](mesh);
}

function checkCurve({ name, color, radius, path }: FileCurve, format: WrittenFormat): void {
  if (format === 'stl' && radius === undefined) {
    throw new KarcherError('badArgument', 'STL has no lines: a curve needs a radius, for a tube');
  }
  if (path.count < 2) {
    const what = name === undefined ? 'a curve' : `the curve '${name}'`;
    throw new KarcherError('badArgument', `${what} needs two points, and has ${path.count}`);
  }
  if (!color) return;
  if (color.length !== 3) {
    throw new KarcherError('badArgument', `a curve's color has three numbers, not ${color.length}`);
  }
  checkColors(color);
}

function checkColors(colors: ArrayLike<number>): void {
  for (let i = 0; i < colors.length; i++) {
    const value = colors[i]!;
    if (Number.isInteger(value) && value >= 0 && value <= 255) continue;
    throw new KarcherError(
      'badArgument',
      `a color is ${shown(value)}, not a whole number from 0 to 255`,
    );
  }
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
  if (colors) checkColors(colors);
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

const white = [255, 255, 255] as const;

/**
 * `solid` is the mesh with the tubes of its curves, each tube as a separate part. `lines` are the
 * curves without tubes.
 */
function withTubes(mesh: Triangles): { solid: Triangles; lines: readonly FileCurve[] } {
  const { curves = [] } = mesh;
  const tubes = curves.filter(({ radius }) => radius !== undefined);
  const lines = curves.filter(({ radius }) => radius === undefined);
  if (curves.length === 0) return { solid: mesh, lines };
  const isColored = mesh.colors || curves.some(({ color }) => color);
  const positions = Array.from(mesh.positions);
  const triangles = Array.from(mesh.triangles);
  const colors = Array.from(mesh.colors ?? positions, (value) => (mesh.colors ? value : 255));
  const parts = mesh.partOf ? [...mesh.parts!] : [{ name: 'surface' }];
  const partOf = Array.from({ length: triangles.length / 3 }, (_, i) => mesh.partOf?.[i] ?? 0);
  for (const { name = '', path, color = white, radius, sides } of tubes) {
    const line = { places: path.polyline({ bits: 64 }), closed: path.closed };
    const tube = tubeAlong(line, {
      radius: radius!,
      ...(sides !== undefined && { sides }),
      caps: true,
    });
    const first = positions.length / 3;
    for (const value of tube.positions) positions.push(value);
    for (const vertex of tube.triangles) triangles.push(first + vertex);
    for (let i = 0; i < tube.positions.length; i += 3) colors.push(...color);
    for (let i = 0; i < tube.triangles.length; i += 3) partOf.push(parts.length);
    parts.push({ name });
  }
  // The surface is a named part, too. Readers of OBJ would otherwise add the first curve to its
  // object.
  const marks = { ...(isColored && { colors }), parts, partOf };
  return { solid: { positions, triangles, ...marks }, lines };
}

/** One string would be too long for the text of a large mesh, so lines are encoded in blocks. */
class LineBlocks {
  readonly #blocks: Uint8Array[] = [];
  #lines: string[] = [];
  #byteCount = 0;

  push(line: string): void {
    if (this.#lines.push(line) === 10_000) this.#encode();
  }

  bytes(): Uint8Array<ArrayBuffer> {
    this.#encode();
    const bytes = new Uint8Array(this.#byteCount);
    let at = 0;
    for (const block of this.#blocks) {
      bytes.set(block, at);
      at += block.length;
    }
    return bytes;
  }

  #encode(): void {
    const block = new TextEncoder().encode(this.#lines.join(''));
    this.#blocks.push(block);
    this.#byteCount += block.length;
    this.#lines = [];
  }
}

function objFile(mesh: Triangles) {
  const { solid, lines: curves } = withTubes(mesh);
  const { positions, triangles, colors, parts, partOf } = solid;
  const lines = new LineBlocks();
  const addVertices = (places: ArrayLike<number>, colorOf: (i: number) => number) => {
    for (let i = 0; i < places.length; i += 3) {
      const color = colors ? [0, 1, 2].map((k) => ` ${colorOf(i + k) / 255}`).join('') : '';
      lines.push(`v ${places[i]} ${places[i + 1]} ${places[i + 2]}${color}\n`);
    }
  };
  addVertices(positions, (i) => colors![i]!);
  for (let i = 0; i < triangles.length; i += 3) {
    const part = partOf?.[i / 3];
    if (part !== undefined && part !== partOf![i / 3 - 1])
      lines.push(`o ${partName(parts![part]!)}\n`);
    lines.push(`f ${triangles[i]! + 1} ${triangles[i + 1]! + 1} ${triangles[i + 2]! + 1}\n`);
  }
  let first = positions.length / 3 + 1;
  for (const { name = '', path, color = white } of curves) {
    lines.push(`o ${partName({ name })}\n`);
    addVertices(path.polyline({ bits: 64 }), (i) => color[i % 3]!);
    lines.push(`l ${Array.from({ length: path.count }, (_, i) => first + i).join(' ')}\n`);
    first += path.count;
  }
  return lines.bytes();
}

function plyFile(mesh: Triangles): Uint8Array<ArrayBuffer> {
  const { solid, lines } = withTubes(mesh);
  const { triangles } = solid;
  const edges: number[] = [];
  const positions = lines.length > 0 ? Array.from(solid.positions) : solid.positions;
  const colors = solid.colors && lines.length > 0 ? Array.from(solid.colors) : solid.colors;
  for (const { path, color = white } of lines) {
    const first = positions.length / 3;
    for (const value of path.polyline({ bits: 64 })) (positions as number[]).push(value);
    for (let i = 0; i < path.count; i++) {
      if (colors) (colors as number[]).push(...color);
      if (i > 0) edges.push(first + i - 1, first + i);
    }
  }
  const count = positions.length / 3;
  const colored = 'property uchar red\nproperty uchar green\nproperty uchar blue\n';
  const edged = `element edge ${edges.length / 2}\nproperty int vertex1\nproperty int vertex2\n`;
  const header = new TextEncoder().encode(
    'ply\nformat binary_little_endian 1.0\n' +
      `element vertex ${count}\nproperty double x\nproperty double y\nproperty double z\n` +
      (colors ? colored : '') +
      `element face ${triangles.length / 3}\nproperty list uchar int vertex_indices\n` +
      `${edges.length > 0 ? edged : ''}end_header\n`,
  );
  const rowBytes = colors ? 27 : 24;
  const faces = header.length + rowBytes * count;
  const ends = faces + 13 * (triangles.length / 3);
  const bytes = new Uint8Array(ends + 4 * edges.length);
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
  edges.forEach((vertex, i) => {
    view.setInt32(ends + 4 * i, vertex, true);
  });
  return bytes;
}

function stlFile(mesh: Triangles): Uint8Array<ArrayBuffer> {
  const { rounded, kept } = single(withTubes(mesh).solid);
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
