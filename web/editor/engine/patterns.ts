/** The patterns of fills, each computed once for a region, a kind and a spacing. */
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

  /** The pattern; undefined if it is not computed yet, null if the fill stays solid. */
  of({ object, region }: Patterned): Pattern | null | undefined {
    return object.pattern === 'solid' ? null : this.#made.get(region)?.get(keyOf(object));
  }

  /** Computes a missing pattern; false if none is missing. */
  async make(client: EngineClient, all: readonly Patterned[]): Promise<boolean> {
    const missing = all.find((one) => this.of(one) === undefined);
    if (!missing) return false;
    const { object, region } = missing;
    const { pattern, spacing } = object;
    const made =
      pattern === 'solid' || spacing === null
        ? null
        : await client.pattern(region, pattern, spacing).catch(() => null);
    if (client.closed) return false;
    const known = this.#made.get(region) ?? new Map<string, Pattern | null>();
    this.#made.set(region, known.set(keyOf(object), made));
    return true;
  }
}
