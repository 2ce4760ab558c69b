import { KarcherError } from './errors.js';
import type { EngineMesh, EngineModule } from './karcher-engine.mjs';
import type { ErrorCode, Status } from './types.js';

/** Makes the calls into the module, and throws each failure as a `KarcherError`. */
export class Engine {
  readonly #module: EngineModule;
  #statusNames: Status[] | undefined;
  #atWork = false;

  constructor(module: EngineModule) {
    this.#module = module;
  }

  get statusNames(): readonly Status[] {
    this.#statusNames ??= this.call((module) => module.statusNames());
    return this.#statusNames;
  }

  /**
   * Throws `KarcherError` `busy` if the engine is at work. A caller's basis or progress function
   * runs within a call of the engine. A second call from such a function could change the data that
   * the first call reads.
   */
  checkIdle(): void {
    if (!this.#atWork) return;
    throw new KarcherError(
      'busy',
      'the engine is at work: a basis or progress must not call it, nor dispose of anything in it',
    );
  }

  /** The number of bytes of the engine's memory in use. */
  readonly allocatedBytes = (): number => this.call((module) => module.allocatedBytes());

  /** Returns what `work` returns, or throws the engine's failure as a `KarcherError`. */
  call<Result>(work: (module: EngineModule) => Result): Result {
    this.checkIdle();
    let result: Result;
    this.#atWork = true;
    try {
      result = work(this.#module);
    } catch (cause) {
      throw new KarcherError('internal', `the engine stopped: ${String(cause)}`, { cause });
    } finally {
      this.#atWork = false;
    }
    const failure = this.#module.takeFailure();
    if (failure) throw new KarcherError(failure.code as ErrorCode, failure.message);
    return result;
  }
}

/** A caller's function in the form that the engine calls. */
export interface Callback<Args extends unknown[], Result> {
  call(...args: Args): Result;
  /**
   * Returns what `work` returns. If the caller's function threw, throws its exception instead of
   * the engine's resulting error.
   */
  guard<Returned>(work: () => Returned): Returned;
}

/**
 * Exceptions must not pass through the engine. So the callback keeps the first exception, and
 * returns `failed`, which the engine rejects.
 */
export function callback<Args extends unknown[], Result>(
  own: (...args: Args) => Result,
  failed: Result,
): Callback<Args, Result> {
  let failure: { cause: unknown } | undefined;
  return {
    call(...args) {
      try {
        return own(...args);
      } catch (cause) {
        failure ??= { cause };
        return failed;
      }
    },
    guard(work) {
      try {
        return work();
      } catch (error) {
        const kept = failure;
        failure = undefined;
        throw kept ? kept.cause : error;
      }
    },
  };
}

/**
 * Counts the holders of an object of the module, and deletes the object when no holder is left. An
 * object created from it reads its data, and is therefore a holder, too.
 */
class Lease {
  readonly #target: { delete(): void };
  readonly #from: Lease | undefined;
  #holders = 1;

  constructor(target: { delete(): void }, from: Lease | undefined) {
    this.#target = target;
    this.#from = from;
    if (from) from.#holders++;
  }

  end(): void {
    if (--this.#holders > 0) return;
    this.#target.delete();
    this.#from?.end();
  }
}

/**
 * Frees objects that nobody can reach any more, in a separate task: never while the engine works.
 */
const forgotten = new FinalizationRegistry<Lease>((lease) => {
  try {
    lease.end();
  } catch {
    // An engine that has stopped has no memory to free.
  }
});

/**
 * A handle that has this many references to created objects removes, for the first time, the
 * references whose objects are gone.
 */
const leastMost = 16;

/** An object in the module's memory. `dispose` frees it, or else the handle's garbage collection. */
export class Handle<Target extends { delete(): void }> {
  readonly engine: Engine;
  readonly #what: string;
  readonly #lease: Lease;
  #target: Target | undefined;
  /** The objects created from this one. Some may already be disposed of, or out of reach. */
  readonly #made = new Set<WeakRef<Handle<{ delete(): void }>>>();
  #most = leastMost;

  /**
   * `what` names the object, such as "the mesh", in the error of a use after `dispose`. `from` is
   * the object from which it was created, and which it reads.
   */
  constructor(engine: Engine, what: string, target: Target, from?: Handle<{ delete(): void }>) {
    this.engine = engine;
    this.#what = what;
    this.#target = target;
    this.#lease = new Lease(target, from ? from.#lease : undefined);
    forgotten.register(this, this.#lease, this);
  }

  get disposed(): boolean {
    return this.#target === undefined;
  }

  /** Throws `KarcherError` `disposed` if the object has been disposed of. */
  check(): void {
    if (this.disposed) throw new KarcherError('disposed', `${this.#what} has been disposed of`);
  }

  /**
   * An object that `make` creates from this one. It reads this object and is disposed of with it.
   * `what` names it as in the constructor.
   */
  made<Other extends { delete(): void }>(
    what: string,
    make: (target: Target) => Other,
  ): Handle<Other> {
    const other = new Handle(this.engine, what, this.call(make), this);
    if (this.#made.size >= this.#most) {
      for (const ref of this.#made) if (ref.deref()?.disposed ?? true) this.#made.delete(ref);
      this.#most = Math.max(leastMost, 2 * this.#made.size);
    }
    this.#made.add(new WeakRef(other));
    return other;
  }

  call<Result>(work: (target: Target) => Result): Result {
    this.check();
    return this.engine.call(() => work(this.#target!));
  }

  /** Throws `KarcherError` `busy` if the engine is at work. */
  dispose(): void {
    if (this.disposed) return;
    this.engine.checkIdle();
    for (const ref of this.#made) ref.deref()?.dispose();
    this.#target = undefined;
    forgotten.unregister(this);
    this.#lease.end();
  }
}

export type MeshHandle = Handle<EngineMesh>;

/** Gives a class the method for `using`, if the language supports it. */
export function disposable(prototype: { dispose(): void }): void {
  if (typeof Symbol.dispose !== 'symbol') return;
  Object.defineProperty(prototype, Symbol.dispose, {
    value(this: { dispose(): void }) {
      this.dispose();
    },
    configurable: true,
    writable: true,
  });
}
