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

/**
 * One mesh of several. A vertex of a later mesh at exactly the place of an earlier mesh's vertex is
 * the same vertex, so that neighboring parts of a surface have no boundary between them.
 */
export function joined(meshes: readonly MeshArrays[]): MeshArrays {
  if (meshes.length === 1) return meshes[0]!;
  const known = new Map<string, number>();
  const places: number[] = [];
  const triangles = meshes.map((mesh) => {
    const keys = Array.from({ length: mesh.positions.length / 3 }, (_, vertex) =>
      mesh.positions.subarray(3 * vertex, 3 * vertex + 3).join(' '),
    );
    const numbers = keys.map((key, vertex) => {
      const before = known.get(key);
      if (before !== undefined) return before;
      return places.push(...mesh.positions.subarray(3 * vertex, 3 * vertex + 3)) / 3 - 1;
    });
    for (const [vertex, key] of keys.entries()) known.set(key, numbers[vertex]!);
    return mesh.triangles.map((vertex) => numbers[vertex]!);
  });
  const corners = new Int32Array(triangles.reduce((sum, { length }) => sum + length, 0));
  let to = 0;
  for (const some of triangles) {
    corners.set(some, to);
    to += some.length;
  }
  return { positions: Float64Array.from(places), triangles: corners };
}
