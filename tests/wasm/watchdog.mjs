// Ends a process whose case hangs, which no timer of its own could, and prints the case first: a worker
// watches.
import { writeSync } from 'node:fs';
import { Worker, workerData } from 'node:worker_threads';
import { seed } from '../web/part.mjs';

/** Long for a small case, on a busy machine. */
const longest = 60_000;
const mostBytes = 2 ** 16;

/** Returns a function that tells the watchdog of the bytes of a case that begins, or null after one. */
export function watchdog(test) {
  // How many times something began or ended, whether a case runs, and how long its bytes are.
  const state = new Int32Array(new SharedArrayBuffer(12));
  const bytes = new Uint8Array(new SharedArrayBuffer(mostBytes));
  const worker = new Worker(new URL(import.meta.url), { workerData: { state, bytes } });
  worker.unref();
  test.after(() => worker.terminate());
  return (given) => {
    if (given) bytes.set(given.subarray(0, mostBytes));
    state[1] = given ? 1 : 0;
    state[2] = given?.length ?? 0;
    Atomics.add(state, 0, 1);
    Atomics.notify(state, 0);
  };
}

if (workerData?.state) {
  const { state, bytes } = workerData;
  for (;;) {
    const waited = Atomics.wait(state, 0, Atomics.load(state, 0), longest);
    if (waited !== 'timed-out' || state[1] === 0) continue;
    const shown = Buffer.from(bytes.slice(0, state[2])).toString('base64');
    writeSync(2, `A case of seed ${seed} hangs: ${state[2]} bytes, in base64 ${shown}\n`);
    process.kill(process.pid, 'SIGKILL');
  }
}
