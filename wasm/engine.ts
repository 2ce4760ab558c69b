import { KarcherError } from './errors.js';
import type { EngineModule } from './karcher-engine.mjs';
import type { ErrorCode, Status } from './types.js';

/** Calls into the module, so that each failure arrives as a `KarcherError`. */
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
   * Throws `KarcherError` `busy` where the engine is at work: a caller's basis runs within a call, and
   * what it would change is being read.
   */
  checkIdle(): void {
    if (!this.#atWork) return;
    throw new KarcherError(
      'busy',
      'the engine is at work: a basis must not call it, nor dispose of anything in it',
    );
  }

  /** Returns what `work` returns, or throws the `KarcherError` that the engine left. */
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

/**
 * An object of the module and what was made from it, which reads it: it is deleted once nobody holds
 * it, and nothing that was made from it is left.
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

/** Gives back what nobody can reach any more, in a turn of its own: never while the engine works. */
const forgotten = new FinalizationRegistry<Lease>((lease) => {
  try {
    lease.end();
  } catch {
    // An engine that has stopped has nothing to give back.
  }
});

/** An object in the module's memory, until it is disposed of, or nobody can reach it any more. */
export class Handle<Target extends { delete(): void }> {
  readonly #engine: Engine;
  readonly #what: string;
  readonly #lease: Lease;
  #target: Target | undefined;

  /**
   * `what` names the object in the error of a use after `dispose`: "the mesh"; `from` is what the
   * object was made from, and reads.
   */
  constructor(engine: Engine, what: string, target: Target, from?: Handle<{ delete(): void }>) {
    this.#engine = engine;
    this.#what = what;
    this.#target = target;
    this.#lease = new Lease(target, from ? from.#lease : undefined);
    forgotten.register(this, this.#lease, this);
  }

  get disposed(): boolean {
    return this.#target === undefined;
  }

  /** Throws `KarcherError` `disposed` if the object is gone. */
  check(): void {
    if (this.disposed) throw new KarcherError('disposed', `${this.#what} has been disposed of`);
  }

  call<Result>(work: (target: Target) => Result): Result {
    this.check();
    return this.#engine.call(() => work(this.#target!));
  }

  /** Throws `KarcherError` `busy` where the engine is at work. */
  dispose(): void {
    if (this.disposed) return;
    this.#engine.checkIdle();
    this.#target = undefined;
    forgotten.unregister(this);
    this.#lease.end();
  }
}

/** What was made from something and is disposed of with it; it does not keep it from being forgotten. */
export class Made<Item extends { dispose(): void }> {
  readonly #items = new Set<WeakRef<Item>>();
  readonly #refs = new WeakMap<Item, WeakRef<Item>>();
  #most = 16;

  add(item: Item): void {
    if (this.#items.size >= this.#most) {
      for (const ref of this.#items) if (!ref.deref()) this.#items.delete(ref);
      this.#most = Math.max(16, 2 * this.#items.size);
    }
    const ref = new WeakRef(item);
    this.#items.add(ref);
    this.#refs.set(item, ref);
  }

  delete(item: Item): void {
    const ref = this.#refs.get(item);
    if (ref) this.#items.delete(ref);
  }

  dispose(): void {
    for (const ref of this.#items) ref.deref()?.dispose();
  }
}

/** Lets a class be disposed of by `using`, where the language has it. */
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
