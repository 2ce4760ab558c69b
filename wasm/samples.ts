import type { Engine } from './engine.js';
import type { EngineSamples } from './karcher-engine.mjs';
import type { CurveSamples } from './types.js';

/** Samples with their statuses by name. */
export function toCurveSamples(engine: Engine, samples: EngineSamples): CurveSamples {
  const { statusNames } = engine;
  return {
    count: samples.t.length,
    ...samples,
    status: Array.from(samples.status, (code) => statusNames[code]!),
  };
}
