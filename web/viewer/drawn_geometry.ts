import type { SerializedBVH } from 'three-mesh-bvh';
import type { MeshBlobs } from '../model/mesh_blobs';
import type { UpAxis } from '../model/meshes';
import type { Frame } from './frame';

export interface DrawnGeometry {
  /** The mesh of the geometry. */
  mesh: MeshBlobs;
  frame: Frame;
  /** Positions in the scene's coordinates. */
  positions: Float32Array;
  normals: Float32Array;
  /** The depth of each vertex in its neighborhoods (`hollows.ts`). */
  hollows: Int8Array;
  triangles: Uint32Array;
  /** The colors of the vertices, in bytes of red, green and blue; null for clay. */
  colors: Uint8Array | null;
  tree: SerializedBVH;
  /** The sides of the triangles that face outwards. */
  outside: 'front' | 'back' | 'both';
}

export interface GeometryRequest {
  mesh: MeshBlobs;
  /** The colors of the vertices, in bytes of red, green and blue, if the file has colors. */
  colors?: Uint8Array | null;
  /** Whether the surface has no boundary. */
  closed: boolean;
  /** The axis that points up. */
  up: UpAxis;
}

/** Prepares a surface for drawing and picking in a worker of its own. */
export function drawnGeometry(
  request: GeometryRequest,
  signal?: AbortSignal,
): Promise<DrawnGeometry> {
  const worker = new Worker(new URL('./geometry_worker.ts', import.meta.url), { type: 'module' });
  return new Promise<DrawnGeometry>((resolve, reject) => {
    signal?.throwIfAborted();
    signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(event.message || 'the surface could not be drawn'));
    };
    worker.postMessage(request);
  }).finally(() => worker.terminate());
}
