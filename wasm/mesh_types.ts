/** The types of meshes: the options for reading one, its repairs, and its counts and sizes. */

/** The options for reading a mesh. */
export interface MeshOptions {
  /**
   * `safe` (the default) repairs defects where that is safe, and lists them in `info.repairs`.
   * `none` rejects a mesh with defects. It still cuts polygons into triangles, welds vertices at
   * exactly the same place, and drops vertices of no face.
   */
  repair?: 'safe' | 'none' | undefined;
  /**
   * The largest distance between boundary vertices that the import welds, in the units of the mesh,
   * but at most a third of the shortest edge at either vertex. 0 welds no vertices. The default is
   * the smaller of 1e-6 of the diagonal and 1 % of the shortest edge.
   */
  weld?: number | undefined;
}

/** The options for reading an OBJ file. */
export interface ObjOptions extends MeshOptions {
  /** The numbers of the parts to read (`FileMarks`); all by default. */
  parts?: readonly number[] | undefined;
}

/** An object or group of an OBJ file, a solid of an STL file, a primitive of a glTF scene. */
export interface FilePart {
  /** The name in the file; if it has none, a name made of the part's kind and number. */
  name: string;
  /** The number of triangles; a polygon counts as its triangles. */
  triangles: number;
}

/**
 * The marks that a file gives its vertices and triangles, beside the surface. Vertices and
 * triangles have the caller's numbers, which repairs do not change.
 */
export interface FileMarks {
  /** All parts of the file, even if only some were requested. */
  parts: FilePart[];
  /** The number of each triangle's part; null if there is only one part. */
  partOf: Int32Array | null;
  /** Names of materials. */
  materials: string[];
  /** The number of each triangle's material, -1 for none; null without materials. */
  materialOf: Int32Array | null;
  /** Red, green and blue of each vertex, 0 to 255, as in the file; null if it has no colors. */
  colors: Uint8Array | null;
  /**
   * Sentences about content of the file that a mesh does not have: lines, skins, other elements.
   */
  notRead: string[];
}

/**
 * The kinds of repairs of a mesh, in this order. `count` is the number of the elements in brackets.
 *
 * - `triangulated`: polygons were cut into triangles (polygons);
 * - `leftOut`: faces that have fewer than three corners, cross themselves or have no area were left
 *   out; the message names the first (faces);
 * - `contracted`: edges of at most 1e-14 of the diagonal, or 1e-12 of their face's longest edge,
 *   were contracted to a point (vertices);
 * - `welded`: vertices at one place were merged where their faces share an edge (vertices);
 * - `keptApart`: vertices at one place stayed apart because the parts only touch there (vertices);
 * - `repeatedCorner`: faces with one vertex at two corners were dropped (faces);
 * - `duplicate`: faces with the same corners as another were dropped (faces);
 * - `noArea`: faces whose corners lie on a line were flipped away: the corner between the ends of
 *   the longest edge became a corner of the face on the other side of this edge (faces);
 * - `turnedOver`: faces oriented against their neighbours were turned over (faces);
 * - `branching`: where more than two faces share an edge, the pairs with the widest angle between
 *   them stayed together, and each other face got an edge of its own (edges);
 * - `bowTie`: vertices where several fans of faces met were divided into one for each fan
 *   (vertices);
 * - `dropped`: vertices of no face were dropped (vertices).
 */
export type RepairKind =
  | 'triangulated'
  | 'leftOut'
  | 'contracted'
  | 'welded'
  | 'keptApart'
  | 'repeatedCorner'
  | 'duplicate'
  | 'noArea'
  | 'turnedOver'
  | 'branching'
  | 'bowTie'
  | 'dropped';

/**
 * One kind of repair. Vertices and faces keep the caller's numbers, and a point keeps its place,
 * even if its face changed.
 */
export interface Repair {
  /** The kind of the repair. */
  kind: RepairKind;
  /** The number of repaired places. */
  count: number;
  /** The repair as a sentence. */
  message: string;
}

/** The counts of a mesh's elements, its sizes, and its repairs. */
export interface MeshInfo {
  /** The number of vertices of the surface, after repairs. */
  vertices: number;
  /** The number of triangles. */
  triangles: number;
  /** The number of connected components. */
  components: number;
  /** The number of boundary loops; a closed surface has none. */
  boundaryLoops: number;
  /** The number of handles. */
  genus: number;
  /** The mean length of the edges. */
  meanEdge: number;
  /** The length of the bounding box's diagonal. */
  diagonal: number;
  /** The repairs of the mesh. */
  repairs: readonly Readonly<Repair>[];
}

/** A built-in shape; sizes are about 1. */
export type Shape = 'sphere' | 'torus' | 'knot' | 'genus3' | 'openSheet';
