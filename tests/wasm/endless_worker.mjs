// An engine in a worker with an additional endless call.
import { load } from 'karcher';
import { serve } from 'karcher/own-worker';

const root = load().then((karcher) =>
  Object.assign(karcher, {
    spin() {
      for (;;);
    },
  }),
);

serve(root);
