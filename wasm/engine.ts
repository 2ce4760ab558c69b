import { KarcherError } from './errors.js';
import type { EngineModule } from './karcher-engine.mjs';
import type { ErrorCode, Status } from './types.js';

/** Calls into the module, so that each failure arrives as a `KarcherError`. */
export class Engine {
  readonly #module: EngineModule;
  #statusNames: Status[] | undefined;

  constructor(module: EngineModule) {
    this.#module = module;
  }

  get statusNames(): readonly Status[] {
    this.#statusNames ??= this.call((module) => module.statusNames());
    return this.#statusNames;
  }

  /** Returns what `work` returns, or throws the `KarcherError` that the engine left. */
  call<Result>(work: (module: EngineModule) => Result): Result {
    let result: Result;
    try {
      result = work(this.#module);
    } catch (cause) {
      throw new KarcherError('internal', `the engine stopped: ${String(cause)}`, { cause });
    }
    const failure = this.#module.takeFailure();
    if (failure) throw new KarcherError(failure.code as ErrorCode, failure.message);
    return result;
  }
}

/** An object in the module's memory, until it is disposed of. */
export class Handle<Target extends { delete(): void }> {
  readonly #engine: Engine;
  readonly #what: string;
  #target: Target | undefined;

  /** `what` names the object in the error of a use after `dispose`: "the mesh". */
  constructor(engine: Engine, what: string, target: Target) {
    this.#engine = engine;
    this.#what = what;
    this.#target = target;
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

  dispose(): void {
    this.#target?.delete();
    this.#target = undefined;
  }
}
