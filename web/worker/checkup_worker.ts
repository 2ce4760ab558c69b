/** The worker that looks a surface over, so that neither the page nor the engine waits. */
import type { LongWorkOptions, MeshInfo } from 'karcher';
import { checkUp } from 'karcher/checkup';
import { serve } from 'karcher/own-worker';

serve({
  checkUp(info: MeshInfo, positions: Float64Array, triangles: Int32Array, work: LongWorkOptions) {
    return checkUp({ info, positions: () => positions, triangles: () => triangles }, work);
  },
});
