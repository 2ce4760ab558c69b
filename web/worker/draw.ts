import type { DrawnGeometry, GeometryRequest } from './geometry';

/** Prepares a surface for drawing and picking in a worker of its own. */
export function drawnGeometry(mesh: GeometryRequest, signal?: AbortSignal): Promise<DrawnGeometry> {
  const worker = new Worker(new URL('./geometry.ts', import.meta.url), { type: 'module' });
  return new Promise<DrawnGeometry>((resolve, reject) => {
    signal?.throwIfAborted();
    signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
    worker.onmessage = ({ data }) => resolve(data);
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new Error(event.message || 'the surface could not be drawn'));
    };
    worker.postMessage(mesh);
  }).finally(() => worker.terminate());
}
