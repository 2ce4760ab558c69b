import type { CurveOptions } from 'karcher';
import type { EngineClient } from '../worker/client';

/** Polylines of the curves that lie beside the edited one, by what they are made of. */
export class Others {
  /** Null where there is no curve. */
  readonly #known = new Map<string, Float32Array | null>();

  clear(): void {
    this.#known.clear();
  }

  /** A curve that was edited may lie beside another one next. */
  keep(options: CurveOptions, polyline: Float32Array): void {
    this.#known.set(keyOf(options), polyline);
  }

  /** One a curve; null while it is not traced. */
  of(all: readonly CurveOptions[]): (Float32Array | null)[] {
    return all.map((options) => this.#known.get(keyOf(options)) ?? null);
  }

  /** Traces one that is missing; false when there is none. */
  async trace(client: EngineClient, all: readonly CurveOptions[]): Promise<boolean> {
    const missing = all.find((options) => !this.#known.has(keyOf(options)));
    if (!missing) return false;
    const curve = await client.otherCurve(missing).catch(() => null);
    this.#forgetAllBut(all);
    this.#known.set(keyOf(missing), curve?.polyline ?? null);
    return true;
  }

  #forgetAllBut(all: readonly CurveOptions[]): void {
    const used = new Set(all.map(keyOf));
    for (const key of this.#known.keys()) if (!used.has(key)) this.#known.delete(key);
  }
}

const keyOf = (options: CurveOptions) => JSON.stringify(options);
