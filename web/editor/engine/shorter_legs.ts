import type { FieldOptions } from 'karcher';
import type { Figure } from '../../model/figure';
import { anchorOfLeg } from '../../model/pen_legs';
import type { ShorterLeg } from '../../model/traced';
import type { EngineClient } from '../../worker/client';
import { curveValueOf } from './compute';

/** Shorter ways than the legs that a figure tells, whose curve is the object's then; null where it tells none. */
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
