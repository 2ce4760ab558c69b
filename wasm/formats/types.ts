import type { FileMarks, LongWorkOptions, MeshOptions } from '../types.js';
import type { FileCurve } from './curves.js';

export type { FileMarks, FilePart } from '../types.js';

/** The formats of readable mesh files; `gltf` also stands for GLB. */
export type MeshFormat = 'obj' | 'ply' | 'stl' | 'off' | 'gltf';

/** The axis of a file's coordinates that points up. */
export type UpAxis = 'x' | 'y' | 'z';

export interface FileOptions extends LongWorkOptions, MeshOptions {
  /** The file's name. Its ending decides the format if the content does not. */
  name?: string;
  /** The numbers of the parts to read, in the file's order; all by default. */
  parts?: readonly number[];
  /** The bytes of the files that a glTF file names, by these names (see `namesBeside`). */
  beside?: Readonly<Record<string, Uint8Array>>;
}

/** The properties of a file beside its surface. */
export interface FileInfo extends FileMarks {
  /** The format of the file. */
  format: MeshFormat;
}

/** The result of a reader: positions of vertices, and the corners of polygons. */
export interface Polygons {
  /** x, y, z for each vertex. */
  positions: Float64Array;
  /** Vertex numbers, polygon by polygon. */
  corners: Int32Array;
  /** The number of corners of each polygon; null if all are triangles. */
  sizes: Int32Array | null;
  /** The format, parts and marks of the file. */
  info: Pick<FileInfo, 'format' | 'parts' | 'notRead'> & Partial<FileMarks>;
}

/**
 * The mesh to write, with arrays as `mesh.cut` returns them. You can spread the `FileMarks` of a
 * file into it. PLY, OBJ and GLB store colors; OBJ and GLB store parts.
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
  /** Curves in the same file, as lines or tubes; the mesh may then have no triangles. */
  curves?: readonly FileCurve[] | undefined;
}
