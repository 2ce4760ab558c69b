import type { SurfacePoint } from 'karcher';
import { type Figure, isRound } from '../../model/figure';
import type { EngineClient } from '../../worker/client';

export type Ends = readonly [SurfacePoint, SurfacePoint];

/** The ends of geodesics beside a curve: neighbouring points, or a center and its points. */
export function geodesicEnds(figure: Figure, center: SurfacePoint | null): Ends[] {
  const { kind, points, settings } = figure;
  if (isRound(kind) || kind === 'points' || kind === 'pen') return [];
  if (kind === 'center') return center ? points.map((point) => [center, point]) : [];
  const ends = points.slice(1).map((point, i): Ends => [points[i]!, point]);
  if (settings.closed && points.length > 2) ends.push([points.at(-1)!, points[0]!]);
  return ends;
}

const keyOf = (ends: Ends) =>
  ends.map(({ face, bary }) => `${face},${bary[1]},${bary[2]}`).join(';');

const fewestKept = 64;

/** Shortest paths by their ends. Each path is traced once. */
export class ShortestLegs {
  /** The known paths; null if the ends are not connected. */
  readonly #known = new Map<string, Float32Array | null>();
  /**
   * The visible path of each pair of points. The path stays while a drag is too fast for a new one.
   */
  #shown: { epoch: number; legs: (Float32Array | null)[] } = { epoch: -1, legs: [] };

  clear(): void {
    this.#known.clear();
    this.#shown = { epoch: -1, legs: [] };
  }

  /**
   * The known paths between these ends. If a path is unknown, the last visible path of the same
   * drag (`epoch`) replaces it.
   */
  between(pairs: readonly Ends[], epoch: number): Float32Array[] {
    const before = this.#shown.epoch === epoch ? this.#shown.legs : [];
    const legs = pairs.map((ends, i) => {
      const leg = this.#known.get(keyOf(ends));
      return leg === undefined ? (before[i] ?? null) : leg;
    });
    this.#shown = { epoch, legs };
    return legs.filter((leg) => leg !== null);
  }

  /** Traces one missing path; false if none is missing. */
  async trace(client: EngineClient, pairs: readonly Ends[]): Promise<boolean> {
    const missing = pairs.find((ends) => !this.#known.has(keyOf(ends)));
    if (!missing) return false;
    if (this.#known.size > fewestKept + 4 * pairs.length) this.#forget(pairs);
    // Points on two components have no path between them. Their leg stays invisible.
    const path = await client.mesh.shortestPath(...missing).catch(() => null);
    this.#known.set(keyOf(missing), path?.polyline() ?? null);
    return true;
  }

  /** Forgets all paths except those between these ends. */
  #forget(pairs: readonly Ends[]): void {
    const used = new Set(pairs.map(keyOf));
    for (const key of this.#known.keys()) if (!used.has(key)) this.#known.delete(key);
  }
}
