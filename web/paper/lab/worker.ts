/** The worker that computes figures: one job after the other, so that none finds its mesh gone. */

import { loadPeers } from 'karcher/peers';
import { Lab } from './lab';
import type { Reply, Request } from './protocol';

const lab = loadPeers().then((peers) => new Lab(peers));
const cancelled = new Map<number, AbortController>();
let last: Promise<void> = Promise.resolve();

function answer(reply: Reply, transfer: Transferable[] = []): void {
  self.postMessage(reply, { transfer });
}

async function run(request: Request, signal: AbortSignal): Promise<void> {
  const { id } = request;
  const ready = await lab;
  if (request.call === 'mesh') {
    // The lab keeps its arrays: what is posted are copies.
    answer({ id, mesh: await ready.mesh(request.mesh) });
  } else if (request.call === 'trace') {
    const { panel, points, lines } = request.job;
    answer({ id, placed: await ready.place(panel.mesh, points) });
    const work = {
      signal,
      progress: (progress: number, stage: string) => answer({ id, progress, stage }),
    };
    await ready.trace(panel, points, lines, (line) => answer({ id, line }), work);
    answer({ id, done: true });
  }
}

self.onmessage = ({ data }: MessageEvent<Request>) => {
  if (data.call === 'cancel') {
    cancelled.get(data.id)?.abort();
    return;
  }
  const controller = new AbortController();
  cancelled.set(data.id, controller);
  last = last.then(async () => {
    try {
      controller.signal.throwIfAborted();
      await run(data, controller.signal);
    } catch (error) {
      if (controller.signal.aborted) answer({ id: data.id, done: true });
      else answer({ id: data.id, failure: error instanceof Error ? error.message : `${error}` });
    } finally {
      cancelled.delete(data.id);
    }
  });
};
