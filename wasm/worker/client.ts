import { KarcherError } from '../errors.js';
import { Path } from '../path.js';
import type { LongWorkOptions } from '../types.js';
import { CurveView } from '../view.js';
import { errorOf, isSent, type Reply, type Request, replaced } from './protocol.js';
import { type RemoteCurve, type RemoteMesh, remoteCurve, remoteMesh } from './remote.js';

/** A page's worker, or one of Node's. */
export interface WorkerLike {
  postMessage(message: unknown): void;
  terminate(): unknown;
}

interface Pending {
  resolve(result: unknown): void;
  reject(error: unknown): void;
  callbacks: ((...args: unknown[]) => void)[];
}

/** The calls into one worker that runs `serve`. */
export class WorkerClient {
  readonly #worker: WorkerLike;
  readonly #pending = new Map<number, Pending>();
  /** The numbers of meshes and curves in the worker. */
  readonly #targets = new WeakMap<object, number>();
  #calls = 0;
  #end: KarcherError | null = null;

  /** Called when the worker ended by itself, or its engine broke: every call fails from then on. */
  onFatal: ((error: KarcherError) => void) | null = null;

  constructor(worker: WorkerLike) {
    this.#worker = worker;
    listen(worker, 'message', (reply) => this.#receive(reply as Reply));
    listen(worker, 'error', (error) => this.#break(error));
    listen(worker, 'messageerror', (error) => this.#break(error));
    // One of Node's that ended by itself, or was ended by others.
    listen(worker, 'exit', () => this.#break(new Error('the worker has ended')));
  }

  /** Whether it ended, or was disposed of. */
  get disposed(): boolean {
    return this.#end !== null;
  }

  /**
   * Calls a method of an object in the worker, by default of the one that it serves. A signal among
   * the arguments, or in an object among them, rejects the call with its reason at once. Rejects with
   * the `KarcherError` of the engine, or with `disposed`.
   *
   * `work` is for calls that know of no signals and progress themselves: its signal does the same, its
   * progress hears when the worker begins with the call (0) and has ended (1).
   */
  call(
    name: string,
    args: readonly unknown[],
    of?: object,
    { progress, signal: own }: LongWorkOptions = {},
  ): Promise<unknown> {
    if (this.#end) return Promise.reject(this.#end);
    const id = ++this.#calls;
    const callbacks: Pending['callbacks'] = [];
    const signals: AbortSignal[] = own ? [own] : [];
    if (progress) callbacks.push(progress as Pending['callbacks'][number]);
    const tells = progress !== undefined;
    const settled = new AbortController();
    const done = new Promise((resolve, reject) => {
      const target = of === undefined ? 0 : this.#targets.get(of)!;
      const sent = args.map((arg) => this.#sent(arg, callbacks, signals));
      for (const signal of signals) {
        signal.throwIfAborted();
        const abort = () => this.#cancel(id, signal.reason);
        signal.addEventListener('abort', abort, { once: true, signal: settled.signal });
      }
      try {
        this.#worker.postMessage({ id, target, call: name, args: sent, tells } satisfies Request);
      } catch (cause) {
        const why = cause instanceof Error ? cause.message : `${cause}`;
        throw new KarcherError('badArgument', `it cannot be sent to a worker: ${why}`, { cause });
      }
      this.#pending.set(id, { resolve, reject, callbacks });
    }).finally(() => settled.abort());
    return progress ? done.then((result) => told(result, progress)) : done;
  }

  /** Ends the worker, and every call that is under way. Safe to repeat. */
  dispose(): void {
    this.#stop(new KarcherError('disposed', 'the worker has been disposed of'));
  }

  #cancel(id: number, reason: unknown): void {
    const pending = this.#pending.get(id);
    if (!pending) return;
    this.#pending.delete(id);
    this.#worker.postMessage({ cancel: id } satisfies Request);
    pending.reject(reason);
  }

  #break(error: unknown): void {
    if (this.#end) return;
    (error as Partial<Event>).preventDefault?.();
    const { message } = error as Partial<Error>;
    const end = new KarcherError('internal', message || 'the engine could not go on in its worker');
    this.#stop(end);
    this.onFatal?.(end);
  }

  #stop(end: KarcherError): void {
    if (this.#end) return;
    this.#end = end;
    this.#worker.terminate();
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    for (const { reject } of pending) reject(end);
  }

  #receive(reply: Reply): void {
    const pending = this.#pending.get(reply.id);
    if ('callback' in reply) {
      try {
        pending?.callbacks[reply.callback]?.(...reply.args);
      } catch (error) {
        // What a function of the caller's throws ends its call.
        this.#cancel(reply.id, error);
      }
      return;
    }
    this.#pending.delete(reply.id);
    if ('result' in reply) {
      const result = this.#received(reply.result, pending === undefined);
      pending?.resolve(result);
      return;
    }
    pending?.reject(errorOf(reply.failure));
    if (reply.failure.fatal) this.#break(errorOf(reply.failure));
  }

  #sent(arg: unknown, callbacks: Pending['callbacks'], signals: AbortSignal[]): unknown {
    return replaced(arg, (part) => {
      const target = this.#targets.get(part);
      if (target !== undefined) return { sent: 'object', target };
      if (typeof part === 'function') {
        callbacks.push(part as (...args: unknown[]) => void);
        return { sent: 'callback', callback: callbacks.length - 1 };
      }
      if (!(part instanceof AbortSignal)) return undefined;
      signals.push(part);
      return { sent: 'signal' };
    });
  }

  /** What nobody waits for any more is disposed of. */
  #received(result: unknown, late: boolean): unknown {
    return replaced(result, (part) => {
      if (ArrayBuffer.isView(part)) return part;
      if (!isSent(part)) return undefined;
      if (part.sent === 'path') return new Path(part.data);
      if (part.sent === 'view') return new CurveView(part.data);
      if (part.sent !== 'mesh' && part.sent !== 'curve') return undefined;
      const object: RemoteMesh | RemoteCurve =
        part.sent === 'mesh' ? remoteMesh(this, part.info) : remoteCurve(this);
      this.#targets.set(object, part.target);
      if (late) object.dispose().catch(() => {});
      return object;
    });
  }
}

/** Tells the progress that a call is done, whose own failure is the call's. */
function told(result: unknown, progress: NonNullable<LongWorkOptions['progress']>): unknown {
  progress(1, 'done');
  return result;
}

/** Hears a worker's event: the data of a message, or an error. */
function listen(
  worker: WorkerLike,
  type: 'message' | 'error' | 'messageerror' | 'exit',
  hear: (value: unknown) => void,
): void {
  const { addEventListener, on } = worker as WorkerLike & {
    addEventListener?(type: string, hear: (event: { data?: unknown }) => void): void;
    on?(type: string, hear: (value: unknown) => void): void;
  };
  if (addEventListener) {
    addEventListener.call(worker, type, (event) => hear(type === 'message' ? event.data : event));
  } else on?.call(worker, type, hear);
}
