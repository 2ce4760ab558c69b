/** The worker that measures the plots. The page terminates the worker to cancel the work. */

import { serve } from 'karcher/own-worker';
import { loadPeers } from 'karcher/peers';
import { type ConvergencePoint, convergence } from '../claims/convergence';
import { type RoughnessPoint, roughness } from '../claims/roughness';

const peers = loadPeers();

serve({
  async convergence(sizes: readonly number[], tell: (points: ConvergencePoint[]) => void) {
    return await convergence(await peers, { sizes, tell });
  },
  async roughness(triangles: number, tell: (points: RoughnessPoint[]) => void) {
    return await roughness(await peers, { triangles, tell });
  },
});
