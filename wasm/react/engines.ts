import { load } from '../load.js';
import { loadInWorker } from '../worker/index.js';
import type { AnyKarcher } from './types.js';

interface Shared {
  engine: Promise<AnyKarcher>;
  users: number;
}

/** The engines that mounted components share. A key says whether the engine runs in a worker. */
const engines = new Map<boolean, Shared>();

/**
 * The engine of the page or of the worker. The first component that uses it loads it, and all share
 * it.
 */
export function takeEngine(worker: boolean): Promise<AnyKarcher> {
  let shared = engines.get(worker);
  if (!shared) {
    shared = { engine: worker ? loadInWorker() : load(), users: 0 };
    engines.set(worker, shared);
  }
  shared.users++;
  return shared.engine;
}

/**
 * Releases an engine. The engine ends when its last user has released it, but only in the next
 * task: StrictMode unmounts every component once and mounts it again at once. This must not load a
 * worker twice.
 */
export function releaseEngine(worker: boolean): void {
  const shared = engines.get(worker)!;
  shared.users--;
  setTimeout(() => {
    if (shared.users > 0 || engines.get(worker) !== shared) return;
    engines.delete(worker);
    shared.engine.then(
      (engine) => 'dispose' in engine && engine.dispose(),
      // An engine that did not load has nothing to release.
      () => {},
    );
  });
}
