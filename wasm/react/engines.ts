import { load } from '../load.js';
import { loadInWorker } from '../worker/index.js';
import type { AnyKarcher } from './types.js';

/** An engine that mounted components share. */
export interface SharedEngine {
  engine: Promise<AnyKarcher>;
  users: number;
}

/** The engines by whether they run in a worker. One that did not load is not among them. */
const engines = new Map<boolean, SharedEngine>();

/**
 * The engine of the page or of the worker. The first component that uses it loads it, and all share
 * it. If it does not load, the next component that mounts tries again.
 */
export function takeEngine(worker: boolean): SharedEngine {
  const shared = engines.get(worker) ?? { engine: worker ? loadInWorker() : load(), users: 0 };
  engines.set(worker, shared);
  shared.users++;
  shared.engine.catch(() => forget(shared));
  return shared;
}

function forget(shared: SharedEngine): boolean {
  for (const [worker, known] of engines) if (known === shared) return engines.delete(worker);
  return false;
}

/**
 * Releases an engine. The engine ends when its last user has released it, but only in the next
 * task: StrictMode unmounts every component once and mounts it again at once. This must not load a
 * worker twice.
 */
export function releaseEngine(shared: SharedEngine): void {
  shared.users--;
  setTimeout(() => {
    if (shared.users > 0 || !forget(shared)) return;
    shared.engine.then(
      (engine) => 'dispose' in engine && engine.dispose(),
      // An engine that did not load has nothing to release.
      () => {},
    );
  });
}
