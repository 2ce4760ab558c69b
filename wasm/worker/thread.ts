/** The worker of `loadInWorker`: an engine that answers its client. */

import type { FileOptions } from '../formats/index.js';
import { load } from '../load.js';
import type { LoadOptions } from '../types.js';
import type { FirstRequest, Request } from './protocol.js';
import { ownScope, serve } from './serve.js';

/** The options for loading the engine. The first message may bring the engine's module. */
const options = new Promise<LoadOptions>((resolve) => {
  ownScope().addEventListener('message', ({ data }) => {
    resolve('wasm' in (data as Request) ? (data as FirstRequest) : {});
  });
});

/** The engine with `meshFromFile`, whose code is loaded with the first file. */
const withFiles = options.then(load).then((karcher) =>
  Object.assign(karcher, {
    async meshFromFile(bytes: Uint8Array, options?: FileOptions) {
      const { meshFromFile } = await import('../formats/index.js');
      return meshFromFile(karcher, bytes, options);
    },
  }),
);

serve(withFiles);
