/** A mesh, with vertices and triangles in the order of its source. */
export interface MeshArrays {
  /** Coordinates x, y, z of the vertices. */
  positions: Float64Array;
  /** Vertices of the triangles, three for each. */
  triangles: Int32Array;
}

/**
 * A mesh's arrays as Blobs, which pass between threads without a copy. The page hands the arrays of
 * two million triangles from worker to worker, and never holds them itself.
 */
export interface MeshBlobs {
  readonly positions: Blob;
  readonly triangles: Blob;
}

export const blobsOf = ({ positions, triangles }: MeshArrays): MeshBlobs => ({
  positions: new Blob([positions as Float64Array<ArrayBuffer>]),
  triangles: new Blob([triangles as Int32Array<ArrayBuffer>]),
});

export async function arraysOf({ positions, triangles }: MeshBlobs): Promise<MeshArrays> {
  const [places, corners] = await Promise.all([positions.arrayBuffer(), triangles.arrayBuffer()]);
  return { positions: new Float64Array(places), triangles: new Int32Array(corners) };
}
