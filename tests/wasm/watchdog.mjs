// Ends a process whose case hangs, and prints the case first. A worker watches, since no timer of
// the process could.
import { writeSync } from 'node:fs';
import { Worker, workerData } from 'node:worker_threads';
import { seed } from '../web/part.mjs';

/** A long time for a small case, even on a busy machine. */
const longest = 60_000;
const mostBytes = 2 ** 16;

/** Returns a function that takes the bytes of each case before it, and null after it. */
export function watchdog(test) {
  // The number of beginnings and ends, whether a case runs, and the length of its bytes.
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
