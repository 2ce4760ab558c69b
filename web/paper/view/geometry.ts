import type { DrawnGeometry, GeometryRequest } from '../../viewer/drawn_geometry';
import type { DrawnMesh } from '../lab/protocol';

/** Prepares meshes for drawing and picking in a worker, one after the other. */
export class GeometryMaker {
  readonly #worker = new Worker(new URL('../../viewer/geometry_worker.ts', import.meta.url), {
    type: 'module',
  });
  #last: Promise<unknown> = Promise.resolve();

  make({ info, arrays }: DrawnMesh): Promise<DrawnGeometry> {
    const made = this.#last.then(
      () =>
        new Promise<DrawnGeometry>((resolve, reject) => {
          this.#worker.onmessage = ({ data }: MessageEvent<DrawnGeometry>) => resolve(data);
          this.#worker.onerror = (event) => reject(new Error(event.message));
          const closed = info.boundaryLoops === 0;
          const request: GeometryRequest = { mesh: arrays, closed, up: 'y' };
          this.#worker.postMessage(request);
        }),
    );
    this.#last = made.catch(() => {});
    return made;
  }
}
