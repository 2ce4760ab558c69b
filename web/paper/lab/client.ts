import { madeKey } from '../../model/meshes';
import { slowLines } from '../figures/lines';
import type { LineId, LineResult, MeshSpec } from '../figures/types';
import type { DrawnMesh, Placed, Reply, Request, TraceJob } from './protocol';

export interface TraceEvents {
  placed(placed: Placed): void;
  line(line: LineResult): void;
  /** How far the line is that is computed. */
  progress(done: number, stage: string): void;
  failure(message: string): void;
  done(): void;
}

/** One worker and the calls that wait for it. */
class Channel {
  readonly #worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  readonly #waiting = new Map<number, (reply: Reply) => void>();
  #calls = 0;

  constructor() {
    this.#worker.onmessage = ({ data }: MessageEvent<Reply>) => this.#receive(data);
    this.#worker.onerror = (event) => {
      event.preventDefault();
      const failure = event.message || 'the engine could not start';
      for (const id of [...this.#waiting.keys()]) this.#receive({ id, failure });
    };
  }

  /** `hear` gets all replies, the last of which is a mesh, `done` or a failure. */
  send(request: (id: number) => Request, hear: (reply: Reply) => void): number {
    const id = ++this.#calls;
    this.#waiting.set(id, hear);
    this.#worker.postMessage(request(id));
    return id;
  }

  /** The call is no longer heard. */
  cancel(id: number): void {
    if (!this.#waiting.delete(id)) return;
    this.#worker.postMessage({ id, call: 'cancel' } satisfies Request);
  }

  #receive(reply: Reply): void {
    const hear = this.#waiting.get(reply.id);
    if ('mesh' in reply || 'done' in reply || 'failure' in reply) this.#waiting.delete(reply.id);
    hear?.(reply);
  }
}

/**
 * Computes panels in two workers: what is dragged is traced by the quick methods in one while the
 * others work in the other.
 */
export class LabClient {
  readonly #quick = new Channel();
  #slow: Channel | null = null;
  readonly #meshes = new Map<string, Promise<DrawnMesh>>();

  /** A mesh for drawing; each is asked for once. */
  mesh(mesh: MeshSpec): Promise<DrawnMesh> {
    const key = madeKey(mesh);
    const known = this.#meshes.get(key);
    if (known) return known;
    const made = new Promise<DrawnMesh>((resolve, reject) => {
      this.#quick.send(
        (id) => ({ id, call: 'mesh', mesh }),
        (reply) => {
          if ('mesh' in reply) resolve(reply.mesh);
          if ('failure' in reply) reject(new Error(reply.failure));
        },
      );
    });
    this.#meshes.set(key, made);
    return made;
  }

  /** Traces a panel; the result stops it, and no event comes after that. */
  trace(job: TraceJob, events: TraceEvents): () => void {
    const parts = [
      { channel: this.#quick, lines: job.lines.filter((id) => !slowLines.has(id)), first: true },
      { channel: null, lines: job.lines.filter((id) => slowLines.has(id)), first: false },
    ].filter(({ lines, first }) => first || lines.length > 0);
    let open = parts.length;
    const stops = parts.map(({ channel, lines, first }) => {
      this.#slow ??= channel ? null : new Channel();
      const used = channel ?? this.#slow!;
      const id = used.send(
        (id) => ({ id, call: 'trace', job: { ...job, lines: lines as LineId[] } }),
        (reply) => {
          if ('placed' in reply && first) events.placed(reply.placed);
          if ('line' in reply) events.line(reply.line);
          if ('progress' in reply) events.progress(reply.progress, reply.stage);
          if ('failure' in reply) events.failure(reply.failure);
          if ('done' in reply || 'failure' in reply) {
            open -= 1;
            if (open === 0) events.done();
          }
        },
      );
      return () => used.cancel(id);
    });
    return () => {
      for (const stop of stops) stop();
    };
  }
}
