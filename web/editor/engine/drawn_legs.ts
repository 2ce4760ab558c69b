/** The legs of a figure's control polygon as the engine has them, by the points that they are told with. */
import type { DrawnLeg, FieldOptions, SurfacePoint } from 'karcher';
import type { Figure } from '../../model/figure';
import { anchorOfLeg, legsOfAnchors } from '../../model/pen_legs';
import { withDrawnLegs } from '../../model/legs';
import { waypointsOf } from '../../model/splines';
import type { ShorterLeg } from '../../model/traced';
import type { EngineClient } from '../../worker/client';
import { curveValueOf } from './compute';

/** The legs of a figure, drawn on from those of the last step of a drag; null where it has none. */
export async function drawnLegs(
  client: EngineClient,
  object: number,
  figure: Figure,
  options: FieldOptions,
  before: readonly DrawnLeg[],
): Promise<(SurfacePoint[] | null)[] | null> {
  const value = await curveValueOf(client, figure, options);
  if (!value) return null;
  const legs = (await client.legs(object, withDrawnLegs(value, before))).map(waypointsOf);
  return figure.kind === 'pen' ? legsOfAnchors(legs) : legs;
}

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
