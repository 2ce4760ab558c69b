import type { FieldOptions } from 'karcher';
import type { Figure } from '../../model/figure';
import { anchorOfLeg } from '../../model/pen_legs';
import type { ShorterLeg } from '../../model/traced';
import type { EngineClient } from '../../worker/client';
import { curveValueOf } from './compute';

/**
 * Shorter paths that could replace a figure's stored legs; null if the figure stores none. As a
 * side effect, the object's curve in the engine becomes the figure's curve with the stored legs.
 */
export async function shorterLegs(
  client: EngineClient,
  object: number,
  figure: Figure,
  options: FieldOptions,
): Promise<ShorterLeg[] | null> {
  if (!figure.points.some(({ leg }) => leg)) return null;
  const value = await curveValueOf(client, figure, options);
  if (!value?.legs) return null;
  const found = await client.shorterLegs(object, value);
  if (figure.kind !== 'pen') return found;
  return found.flatMap((leg) => {
    const index = anchorOfLeg(leg.index);
    return index === null ? [] : [{ ...leg, index }];
  });
}
