import { checkOptions, namesOf } from '../check.js';
import { KarcherError } from '../errors.js';
import { compiled } from '../instantiate.js';
import { checkLongWork } from '../options.js';
import type { StopSignal } from '../platform.js';
import type { WasmSource } from '../types.js';
import { unknownReason, WorkerClient } from './client.js';
import type { FirstRequest, WorkerLike } from './protocol.js';
import { type RemoteEngine, remoteKarcher } from './remote.js';

export { KarcherError } from '../errors.js';
export type { LogMap, MappedPoints } from '../maps.js';
export { Path } from '../path.js';
export type * from '../path_types.js';
export type * from '../path_values.js';
export { Region } from '../region.js';
export type * from '../types.js';
export { CurveView } from '../view.js';
export type { WorkerClient } from './client.js';
export type { WorkerLike } from './protocol.js';
export type { RemoteCurve, RemoteMesh } from './remote.js';

/** An engine in a worker: the methods of `Karcher`. `dispose` ends the worker. */
export type RemoteKarcher = RemoteEngine & { readonly client: WorkerClient };

/**
 * The worker of `loadInWorker`, in a page and in Node. If a bundler does not find the worker's file
 * through this code, pass a module worker of `karcher/worker-thread` to `loadInWorker`.
 */
export function startWorker(): WorkerLike {
  const { process } = globalThis as { process?: NodeJS.Process };
  const threads = process?.getBuiltinModule?.('node:worker_threads');
  if (threads) return new threads.Worker(new URL('./thread.js', import.meta.url));
  return new Worker(new URL('./thread.js', import.meta.url), { type: 'module' });
}

/** The options for starting a worker with the engine. */
export interface WorkerOptions {
  /**
   * A worker that runs `karcher/worker-thread`, or a function that starts one. A single worker does
   * not allow interruptions of calls.
   */
  worker?: WorkerLike | (() => WorkerLike) | undefined;
  /** The source of the engine, as for `load`. The worker receives it compiled. */
  wasm?: WasmSource | undefined;
  /** A signal that ends the loading. */
  signal?: StopSignal | undefined;
}

const workerOptionNames = namesOf<WorkerOptions>({ worker: true, wasm: true, signal: true });

/**
 * Loads the engine in a new worker. Classes and methods have the same names as with `load`. Methods
 * return promises, and a curve's properties are promises. Results belong to the caller; the worker
 * transfers large arrays.
 *
 * Every method takes `{ progress, signal }` after its other arguments. A signal rejects the call at
 * once with its reason. A waiting call then does not begin; files, graphs and check-ups stop. Any
 * other running call may continue for about as long as the creation of all meshes and curves takes.
 * Then a new worker replaces this one and receives the remaining calls. It creates each mesh and
 * curve again, as it was, before the first call that needs it. For this purpose the client keeps a
 * copy of the meshes' data, which takes a small part of their memory in the engine.
 *
 * In Node the worker keeps the process alive only while a call is pending.
 *
 * Rejects with `KarcherError` notLoaded, naming the address, if the worker's script cannot be
 * loaded. Every call rejects with the engine's `KarcherError`: with `internal` if the worker ended
 * by itself, with `disposed` after `dispose`.
 */
export async function loadInWorker(options: WorkerOptions = {}): Promise<RemoteKarcher> {
  checkOptions(options, workerOptionNames);
  const { worker = startWorker, wasm, signal } = options;
  checkLongWork(signal === undefined ? {} : { signal });
  const module = wasm === undefined ? undefined : await compiled(wasm);
  const start = worker === startWorker ? startOwnWorker : worker;
  const client = new WorkerClient(
    typeof start === 'function' ? () => supplied(start(), module) : supplied(start, module),
  );
  const abort = () => client.dispose();
  signal?.addEventListener('abort', abort, { once: true });
  try {
    signal?.throwIfAborted();
    const karcher = remoteKarcher(client);
    await karcher.allocatedBytes();
    return karcher;
  } catch (error) {
    client.dispose();
    if (signal?.aborted) throw signal.reason;
    throw client.hasAnswered ? error : notStarted(worker === startWorker, error);
  } finally {
    signal?.removeEventListener('abort', abort);
  }
}

/**
 * Sends the engine's module to a caller's worker as its first message, and returns the worker. The
 * client rejects a value that is no worker.
 */
function supplied(worker: WorkerLike, wasm: WebAssembly.Module | undefined): WorkerLike {
  const { postMessage } = (worker ?? {}) as Partial<WorkerLike>;
  if (wasm && typeof postMessage === 'function')
    worker.postMessage({ wasm } satisfies FirstRequest);
  return worker;
}

/**
 * Calls `startWorker`, and throws an error with advice if that fails: `Worker` throws if the
 * script's address has another origin than the page.
 */
function startOwnWorker(): WorkerLike {
  try {
    return startWorker();
  } catch (error) {
    throw notStarted(true, error);
  }
}

/**
 * The error of a worker that has never answered. Browsers give no reason if the script is missing
 * or blocked.
 */
function notStarted(isOwn: boolean, cause: unknown): unknown {
  if (cause instanceof KarcherError && cause.code !== 'internal') return cause;
  const { message } = cause as Partial<Error>;
  const reason = message && message !== unknownReason ? `: ${message}` : '';
  return new KarcherError(
    'notLoaded',
    `the worker does not start${reason}. ${isOwn ? adviceOnOwn() : adviceOnGiven}`,
    { cause },
  );
}

/**
 * The advice for the package's own script. A bundler may have chosen another name for it. The
 * address is computed as text, since a bundler would bundle the script again for a `new URL`.
 */
function adviceOnOwn(): string {
  const here = import.meta.url;
  const address = here.replace(/\/worker\/index\.js([?#].*)?$/, '/worker/thread.js');
  const script =
    address === here
      ? `what the bundler made of 'karcher/worker-thread' for ${here}`
      : `its script ${address}`;
  return (
    `Check that ${script} can be loaded, from the origin of the page and by its ` +
    "Content-Security-Policy (worker-src), or give `worker`: a module worker of 'karcher/worker-thread'"
  );
}

const adviceOnGiven =
  "Check that the script of the given worker can be loaded, and runs 'karcher/worker-thread' " +
  'as a module';
