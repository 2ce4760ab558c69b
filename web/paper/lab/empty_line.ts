import type { LineId, LineResult } from '../figures/types';

/** An empty result. */
export function emptyLine(id: LineId): LineResult {
  return {
    id,
    ok: true,
    reason: null,
    prepareMs: null,
    traceMs: null,
    samples: null,
    lost: null,
    lostByOwnRule: null,
    deviation: null,
    turningNoise: null,
    breaks: null,
    sharpestTurn: null,
    ruler: null,
    drag: null,
    polylines: [],
    status: [],
    marker: null,
  };
}
