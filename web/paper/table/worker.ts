/**
 * The worker that measures rows of Table 1, one after the other. The page terminates the worker to
 * cancel the work.
 */

import { serve } from 'karcher/own-worker';
import { loadPeers } from 'karcher/peers';
import { runTable, type TableEvents, type TableOptions } from './run';

const peers = loadPeers();

serve({
  async run(options: TableOptions, events: TableEvents) {
    await runTable(await peers, options, events);
  },
});
