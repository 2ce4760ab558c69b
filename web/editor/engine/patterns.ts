/** The patterns of fills. A pattern is computed once for each region, kind and spacing. */
import type { DrawnObject } from '../../model/drawing';
import type { Pattern, Region } from '../../model/traced';
import type { EngineClient } from '../../worker/client';

export interface Patterned {
  object: DrawnObject;
  region: Region;
}

const keyOf = ({ pattern, spacing }: DrawnObject) => `${pattern} ${spacing}`;

export class Patterns {
  readonly #made = new WeakMap<Region, Map<string, Pattern | null>>();
  /**
   * For each region, the last failed pattern and its engine, which does not try the pattern again.
   */
  readonly #failed = new WeakMap<Region, { key: string; client: EngineClient }>();

  /** `failed` receives an error, after which the pattern stays missing. */
  constructor(private readonly failed: (error: unknown) => void) {}

  /** The pattern; undefined before its computation, null if the fill stays solid. */
  of({ object, region }: Patterned): Pattern | null | undefined {
    return object.pattern === 'solid' ? null : this.#made.get(region)?.get(keyOf(object));
  }

  /** Computes a missing pattern; false if none is missing. */
  async make(client: EngineClient, all: readonly Patterned[]): Promise<boolean> {
    const missing = all.find((one) => this.of(one) === undefined && !this.#hasFailed(client, one));
    if (!missing) return false;
    const { object, region } = missing;
    const { pattern, spacing } = object;
    let made: Pattern | null = null;
    try {
      if (pattern !== 'solid' && spacing !== null) {
        made = await client.pattern(region, pattern, spacing);
      }
    } catch (error) {
      if (client.closed) return false;
      this.#failed.set(region, { key: keyOf(object), client });
      this.failed(error);
      return true;
    }
    if (client.closed) return false;
    const known = this.#made.get(region) ?? new Map<string, Pattern | null>();
    this.#made.set(region, known.set(keyOf(object), made));
    return true;
  }

  #hasFailed(client: EngineClient, { object, region }: Patterned): boolean {
    const failed = this.#failed.get(region);
    return failed?.client === client && failed.key === keyOf(object);
  }
}
