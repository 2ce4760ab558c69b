import { Matrix4, type PerspectiveCamera } from 'three';
import type { MeshBlobs } from '../model/mesh_blobs';
import type { Frame } from './frame';
import type { Sight } from './hidden_lines';

export interface OutlineRequest {
  /** The surface, or its parts, whose vertices fit each other exactly. */
  meshes: readonly MeshBlobs[];
  frame: Frame;
  sight: Sight;
}

/**
 * The lines of the surface's outline in the camera's view: x, y of their points, in CSS pixels of
 * the stage. Rejects with the signal's reason.
 */
export async function requestOutline(
  { meshes, frame }: Pick<OutlineRequest, 'meshes' | 'frame'>,
  camera: PerspectiveCamera,
  stage: { width: number; height: number },
  signal: AbortSignal,
): Promise<Float32Array[]> {
  camera.updateMatrixWorld();
  const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const sight: Sight = { eye: camera.position.toArray(), matrix: matrix.toArray(), ...stage };
  const worker = new Worker(new URL('./outline_worker.ts', import.meta.url), { type: 'module' });
  try {
    return await new Promise<Float32Array[]>((resolve, reject) => {
      signal.throwIfAborted();
      signal.addEventListener('abort', () => reject(signal.reason), { once: true });
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(event.message || 'the outline could not be drawn'));
      };
      worker.postMessage({ meshes, frame, sight } satisfies OutlineRequest);
    });
  } finally {
    worker.terminate();
  }
}
