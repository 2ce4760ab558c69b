import type { CurveSamples, Path } from 'karcher';
import { objectOf } from '../../model/drawing';
import { methodOptions, refinedOptions } from '../../model/methods';
import { resolvedFigure } from '../../model/sources';
import type { EngineClient } from '../../worker/client';
import type { State } from '../state/state';
import type { BesideObjects } from './beside';
import { compute, outlinesShown } from './compute';

/** The lines of an object as paths, with the samples if it is a curve. */
export interface ObjectLines {
  id: number;
  paths: readonly Path[];
  samples: Omit<CurveSamples, 'status'> | null;
}

/** The lines of objects, of the same quality as in the view. */
export async function linesOf(
  client: EngineClient,
  { drawing, method }: State,
  ids: readonly number[],
  beside: BesideObjects,
): Promise<ObjectLines[]> {
  const found: ObjectLines[] = [];
  for (const id of ids) {
    const object = objectOf(drawing, id);
    if (!object) continue;
    const figure = resolvedFigure(drawing, object);
    const isExact = beside.known(figure, method)?.quality === 'exact';
    const refined = refinedOptions(method);
    const options = (isExact && refined) || methodOptions(method);
    const shown = await compute(client, figure, options, {
      object: id,
      draft: refined !== null && !isExact,
      outlines: true,
      outlinesOf: beside.outlinesOf(client, method),
    });
    const samples = shown.curve?.samples ?? null;
    found.push({ id, paths: outlinesShown(shown) ?? [], samples });
  }
  return found;
}
