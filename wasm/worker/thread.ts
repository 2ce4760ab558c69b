/** The worker of `loadInWorker`: an engine that answers its client. */

import type { FileOptions } from '../formats/index.js';
import { load } from '../load.js';
import { serve } from './serve.js';

/** Files are read here, by readers that are loaded with the first one. */
const withFiles = load().then((karcher) =>
  Object.assign(karcher, {
    async meshFromFile(bytes: Uint8Array, options?: FileOptions) {
      const { meshFromFile } = await import('../formats/index.js');
      return meshFromFile(karcher, bytes, options);
    },
  }),
);

serve(withFiles);
