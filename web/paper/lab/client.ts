import { WorkerClient } from 'karcher/own-worker';
import type { DragMeasures, RulerMeasures } from 'karcher/peers';
import { madeKey } from '../../model/meshes';
import { slowLines } from '../figures/lines';
import type { LineId, LineResult, MeshSpec, Vector } from '../figures/types';
import type { Carried } from './carry';
import type { KnownCenter } from './center';
import type { CarryJob, DrawnMesh, Placed, TraceJob } from './protocol';

export interface TraceEvents {
  placed(placed: Placed): void;
  line(line: LineResult): void;
  /** Receives the measurements by exact paths of a line that has arrived. */
  measured(id: LineId, ruler: RulerMeasures): void;
  /** Receives the progress of the line under way. */
  progress(done: number, stage: string): void;
  failure(message: string): void;
  done(): void;
}

const startWorker = () =>
  new WorkerClient(new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }));

/**
 * Computes panels in two workers, one for slow methods and one for quick methods. Quick methods can
 * thus trace and follow drags while slow methods work.
 */
export class LabClient {
  readonly #quick = startWorker();
  #slow: WorkerClient | null = null;
  readonly #meshes = new Map<string, Promise<DrawnMesh>>();

  /** A mesh for drawing. The worker creates each mesh only once. */
  mesh(mesh: MeshSpec): Promise<DrawnMesh> {
    const key = madeKey(mesh);
    const known = this.#meshes.get(key);
    if (known) return known;
    const made = this.#quick.call('mesh', [mesh]) as Promise<DrawnMesh>;
    this.#meshes.set(key, made);
    return made;
  }

  /** The center of mass of a panel's points, and other minima of their energy. */
  center(mesh: MeshSpec, points: readonly Vector[], weights: readonly number[]) {
    return this.#quick.call('center', [mesh, points, weights]) as Promise<KnownCenter>;
  }

  carry(job: CarryJob): Promise<Carried> {
    return this.#quick.call('carry', [job]) as Promise<Carried>;
  }

  /**
   * Drags a control point of a panel's curves. Resolves at the end of the drag; rejects when it is
   * aborted.
   */
  async drag(
    job: TraceJob,
    measured: (id: LineId, drag: DragMeasures) => void,
    signal: AbortSignal,
  ): Promise<void> {
    const isSlow = (id: LineId) => slowLines.has(id);
    const part = (worker: WorkerClient, lines: readonly LineId[]) =>
      worker.call('drag', [{ ...job, lines }, measured, { signal }]);
    this.#slow ??= startWorker();
    await Promise.all([
      part(
        this.#quick,
        job.lines.filter((id) => !isSlow(id)),
      ),
      part(this.#slow, job.lines.filter(isSlow)),
    ]);
  }

  /** Traces a panel. The returned function stops the work; no event follows. */
  trace(job: TraceJob, events: TraceEvents): () => void {
    const controller = new AbortController();
    const { signal } = controller;
    const slow = job.lines.filter((id) => slowLines.has(id));
    const work = { signal, progress: events.progress };
    const trace = (worker: WorkerClient, lines: readonly LineId[], placed: TraceEvents['placed']) =>
      worker
        .call('trace', [{ ...job, lines }, placed, events.line, events.measured, work])
        .catch((error) => {
          if (!signal.aborted) events.failure(error.message);
        });
    const quick = job.lines.filter((id) => !slowLines.has(id));
    const parts = [trace(this.#quick, quick, events.placed)];
    if (slow.length > 0) {
      this.#slow ??= startWorker();
      parts.push(trace(this.#slow, slow, () => {}));
    }
    void Promise.all(parts).then(() => {
      if (!signal.aborted) events.done();
    });
    return () => controller.abort();
  }
}
