// The number of cases that a test draws with fast-check, and their seed.
import { long, seed } from '../web/part.mjs';

/** The number of cases; a long run draws many times as many. */
export const draws = (count) => ({
  ...{ seed, numRuns: long ? 30 * count : count, endOnFailure: true },
  includeErrorInReport: true,
});

const codes = new Set([
  ...['badFile', 'badIndex', 'notFinite', 'degenerateFace', 'nonManifoldEdge', 'nonManifoldVertex'],
  ...['notOrientable', 'badPoint', 'badWeights', 'tooFewPoints', 'badArgument', 'unreachable'],
  ...['boundary', 'radiusTooLarge', 'noEmbedding', 'disposed', 'busy', 'outOfMemory'],
]);

/**
 * Throws unless a failure is an intended one: a KarcherError with a code and a helpful sentence.
 */
export function checkMeant(error, unsaid = /abort\(|Aborted|internal|memory access/) {
  const meant = error?.name === 'KarcherError' && codes.has(error.code);
  if (meant && !unsaid.test(error.message)) return;
  throw new Error(`a failure that was not meant: ${error?.code} ${error?.stack ?? error}`);
}
