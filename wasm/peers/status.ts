import type { Status } from '../types.js';

/**
 * Whether a curve has a sample of this status. Bridges and subdivided pieces are parts of a curve;
 * other samples without a center of mass are lost.
 */
export const isThere = (status: Status): boolean =>
  status === 'converged' || status === 'bridged' || status === 'subdivided';
