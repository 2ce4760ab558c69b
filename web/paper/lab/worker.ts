/**
 * The worker that computes figures, one job after the other, so that no job removes another's mesh.
 */

import type { LongWorkOptions } from 'karcher';
import { serve } from 'karcher/own-worker';
import { type DragMeasures, loadPeers, type RulerMeasures } from 'karcher/peers';
import type { LineId, LineResult, MeshSpec, Vector } from '../figures/types';
import { Lab } from './lab';
import type { CarryJob, Placed, TraceJob } from './protocol';

const lab = loadPeers().then((peers) => new Lab(peers));
let last: Promise<unknown> = Promise.resolve();

function inOrder<Result>(work: () => Promise<Result>): Promise<Result> {
  const result = last.then(work);
  last = result.catch(() => {});
  return result;
}

/** The worker's calls. */
const calls = {
  mesh(mesh: MeshSpec) {
    return inOrder(async () => (await lab).mesh(mesh));
  },

  center(mesh: MeshSpec, points: readonly Vector[], weights: readonly number[]) {
    return inOrder(async () => (await lab).center(mesh, points, weights));
  },

  carry(job: CarryJob) {
    return inOrder(async () => (await lab).carry(job));
  },

  drag(
    { panel, points, lines }: TraceJob,
    measured: (id: LineId, drag: DragMeasures) => void,
    work: LongWorkOptions,
  ) {
    return inOrder(async () => {
      work.signal?.throwIfAborted();
      await (await lab).drag(panel, points, lines, measured, work);
    });
  },

  /** Sends the points of a panel, then its lines one by one. */
  trace(
    { panel, points, lines }: TraceJob,
    placed: (placed: Placed) => void,
    show: (line: LineResult) => void,
    measured: (id: LineId, ruler: RulerMeasures) => void,
    work: LongWorkOptions,
  ) {
    return inOrder(async () => {
      work.signal?.throwIfAborted();
      const ready = await lab;
      placed(await ready.place(panel.mesh, points));
      await ready.trace(panel, points, lines, show, measured, work);
    });
  },
};

serve(calls);
