/** The worker of `loadInWorker`: an engine that answers its client. */

import { load } from '../load.js';
import { serve } from './serve.js';

serve(load());
