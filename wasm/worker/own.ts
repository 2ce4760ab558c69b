/** Tools for a worker with other calls: `serve` in the worker, `WorkerClient` on the other side. */
export { KarcherError } from '../errors.js';
export { WorkerClient } from './client.js';
export type { WorkerLike } from './protocol.js';
export type { RemoteCurve, RemoteMesh } from './remote.js';
export { serve } from './serve.js';
