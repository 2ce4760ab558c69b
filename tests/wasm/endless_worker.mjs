// An engine in a worker that also has a call without an end.
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
