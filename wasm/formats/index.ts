import { checkArray, checkInteger, checkOptions, namesOf, shown } from '../check.js';
import { KarcherError } from '../errors.js';
import { checkLongWork } from '../options.js';
import type { FileMarks, MeshOptions, ObjOptions } from '../types.js';
import { formatOf, withoutMark } from './format.js';
import { gltfBeside, readGltf } from './gltf.js';
import { noMarks } from './marks.js';
import { readOff } from './off.js';
import { readPly } from './ply.js';
import { readStl } from './stl.js';
import type { FileInfo, FileOptions, MeshFormat, Polygons } from './types.js';

export { KarcherError } from '../errors.js';
export { curvesCsv, type FileCurve, type FilePath, pathParameters } from './curves.js';
export { fileEndings, formatOf } from './format.js';
export { marksOfPart } from './part_marks.js';
export { curvesOnPart, pointsOnPart } from './part_points.js';
export type * from './types.js';
export { guessUp } from './up.js';
export { meshFile, type WrittenFormat, writtenFormats } from './write.js';

/** A mesh that keeps the marks of its OBJ file. */
export interface MarkedMesh {
  /** The parts, materials and colors of the file. */
  fileMarks(): FileMarks | Promise<FileMarks>;
}

/** An engine that creates meshes: a `Karcher`, in this thread or in a worker. */
export interface MeshMaker<Mesh extends MarkedMesh> {
  /** Creates a mesh from an OBJ file's bytes, like `Karcher.meshFromObj`. */
  meshFromObj(bytes: Uint8Array, options?: ObjOptions): Mesh | Promise<Mesh>;
  /** Creates a mesh from arrays, like `Karcher.meshFromArrays`. */
  meshFromArrays(
    positions: Float64Array,
    triangles: Int32Array,
    options?: MeshOptions,
  ): Mesh | Promise<Mesh>;
  /** Creates a mesh from polygons, like `Karcher.meshFromPolygons`. */
  meshFromPolygons(
    positions: Float64Array,
    corners: Int32Array,
    sizes: Int32Array,
    options?: MeshOptions,
  ): Mesh | Promise<Mesh>;
}

const optionNames = namesOf<FileOptions>({
  name: true,
  parts: true,
  beside: true,
  progress: true,
  signal: true,
  repair: true,
  weld: true,
});

/**
 * Creates a mesh from a file: OBJ, PLY (text or binary), STL or OFF (text or binary), or glTF 2
 * (GLB, or text with its buffers in `beside`). The content determines the format, or else the
 * name's ending does.
 *
 * Vertices and faces keep the file's order; a polygon counts as its triangles. In an STL file,
 * which has no vertices, corners at exactly the same place are one vertex. Files are read in slices
 * of a few milliseconds, between which the thread does other work. The creation of the mesh is one
 * call; for OBJ this call also reads the file.
 *
 * Rejects with the signal's reason when it is aborted, and with `KarcherError`: badFile (with the
 * line or byte, or with the kind of the file), badIndex, badArgument (options, and a part that the
 * file does not have), and those of `meshFromObj`.
 */
export async function meshFromFile<Mesh extends MarkedMesh>(
  karcher: MeshMaker<Mesh>,
  given: Uint8Array,
  options: FileOptions = {},
): Promise<{ mesh: Mesh; file: FileInfo }> {
  if (!(given instanceof Uint8Array)) {
    throw new KarcherError('badArgument', `a file must be a Uint8Array, not ${shown(given)}`);
  }
  checkOptions(options, optionNames);
  const { name, parts, beside, progress, signal, ...meshOptions } = options;
  const work = { ...(progress && { progress }), ...(signal && { signal }) };
  checkLongWork(work);
  const wantedParts = parts && checkArray(parts, 'the parts').map((part) => checkPart(part));
  const wanted = (part: number) => wantedParts?.includes(part) ?? true;
  const bytes = withoutMark(given);
  const format = formatOf(bytes, name);
  if (format === 'obj') {
    // The engine itself reads OBJ files, in one call.
    signal?.throwIfAborted();
    progress?.(0, 'making');
    const mesh = await karcher.meshFromObj(bytes, {
      ...meshOptions,
      ...(wantedParts && { parts: wantedParts }),
    });
    return { mesh, file: { format, ...(await mesh.fileMarks()) } };
  }
  const polygons = await read(format, bytes, wanted, beside ?? {}, work);
  const { positions, corners, sizes, info } = polygons;
  const file: FileInfo = { ...noMarks, ...info };
  checkParts(wantedParts, file);
  if (sizes) {
    progress?.(1, 'making');
    return { mesh: await karcher.meshFromPolygons(positions, corners, sizes, meshOptions), file };
  }
  progress?.(1, 'making');
  return { mesh: await karcher.meshFromArrays(positions, corners, meshOptions), file };
}

/**
 * The names of the files that lie beside a glTF file and hold its buffers, for `beside`; none for
 * any other file. Throws `KarcherError` badFile if the file's JSON is not valid, or names files
 * elsewhere.
 */
export function namesBeside(bytes: Uint8Array, name?: string): string[] {
  return formatOf(bytes, name) === 'gltf' ? gltfBeside(withoutMark(bytes)) : [];
}

function read(
  format: Exclude<MeshFormat, 'obj'>,
  bytes: Uint8Array,
  wanted: (part: number) => boolean,
  beside: Readonly<Record<string, Uint8Array>>,
  work: Pick<FileOptions, 'progress' | 'signal'>,
): Promise<Polygons> {
  switch (format) {
    case 'ply':
      return readPly(bytes, work);
    case 'stl':
      return readStl(bytes, wanted, work);
    case 'off':
      return readOff(bytes, work);
    case 'gltf':
      return readGltf(bytes, wanted, beside, work);
  }
}

function checkPart(part: unknown): number {
  if (checkInteger(part, 'the number of a part') >= 0) return part as number;
  throw new KarcherError('badArgument', `the number of a part must be at least 0, not ${part}`);
}

function checkParts(wanted: readonly number[] | undefined, { parts }: FileInfo): void {
  if (wanted?.length === 0) throw new KarcherError('badArgument', 'the list of parts is empty');
  const missing = wanted?.find((part) => part >= parts.length);
  if (missing === undefined) return;
  throw new KarcherError(
    'badArgument',
    `there is no part ${missing}: the file has ${parts.length}, numbered from 0`,
  );
}
