import { shown } from '../check.js';
import { KarcherError } from '../errors.js';
import { Path } from '../path.js';
import { Region } from '../region.js';
import type { CurveOptions, LongWorkOptions } from '../types.js';
import { CurveView } from '../view.js';
import {
  type Call,
  errorOf,
  isPlain,
  isSent,
  type Reply,
  type Request,
  replaced,
  type Sent,
  type WorkerLike,
} from './protocol.js';
import { type RemoteCurve, type RemoteMesh, remoteCurve, remoteMesh } from './remote.js';

/**
 * A mesh or curve in the worker, and the data from which another worker creates it again: a mesh by
 * its original call, a curve from its mesh by its last value.
 */
interface Origin {
  /** The object's number in its present or last worker. */
  target: number;
  /** The object's worker; null after its disposal. */
  worker: WorkerLike | null;
  /** The mesh or curve from which the object was created, or null. */
  readonly of: Origin | null;
  readonly call: string;
  /** The arguments of the call that created the object. No other code changes them. */
  args: readonly unknown[];
  /** The duration of the call in milliseconds. */
  readonly took: number;
  /** Whether the object is disposed of, or is about to be. */
  isDisposed: boolean;
}

interface Pending {
  resolve(result: unknown): void;
  reject(error: unknown): void;
  call: string;
  args: readonly unknown[];
  of: Origin | null;
  tells: ((...args: unknown[]) => void) | undefined;
  callbacks: ((...args: unknown[]) => void)[];
  /** The time at which the worker began the call; 0 before. */
  begun: number;
}

/** A cancelled call that the worker has to acknowledge. */
interface Cancelled {
  pending: Pending;
  begun: boolean;
  timer?: ReturnType<typeof setTimeout>;
}

/** The sentence for a worker that ended without a reason. */
export const unknownReason = 'the engine could not go on in its worker';

/** The least time, in milliseconds, that a worker has to acknowledge a cancelled call. */
const leastPatience = 200;

/**
 * The calls into one worker that runs `serve`. A client with a function that starts workers can
 * interrupt a running call. If the worker does not acknowledge a cancellation in time, the client
 * terminates and replaces it. It sends the other calls to the new worker, which creates each mesh
 * and curve again before the first call that needs it. Before the client terminates a worker, it
 * waits for about as long as the creation of all meshes and curves takes, so that little is lost if
 * the call was about to end. Except for meshes and curves, nothing in the worker may depend on
 * earlier calls.
 */
export class WorkerClient {
  readonly #start: (() => WorkerLike) | null;
  #worker: WorkerLike;
  readonly #pending = new Map<number, Pending>();
  readonly #cancelled = new Map<number, Cancelled>();
  /** The origins of meshes and curves in the worker. */
  readonly #origins = new WeakMap<object, Origin>();
  /** The origins of the objects that a new worker would have to create again. */
  readonly #kept = new Set<Origin>();
  /** Whether a new worker could create all objects again. */
  #keepsAll = true;
  #hasAnswered = false;
  #calls = 0;
  /** The number of objects created again. Their own numbers are negative. */
  #remade = 0;
  #end: KarcherError | null = null;

  /**
   * A callback that runs if the worker ended by itself, or its engine broke. Every call fails from
   * then on.
   */
  onFatal: ((error: KarcherError) => void) | null = null;
  /** A callback that runs after a new worker has replaced one whose call was interrupted. */
  onRestart: (() => void) | null = null;

  constructor(worker: WorkerLike | (() => WorkerLike)) {
    this.#start = typeof worker === 'function' ? worker : null;
    this.#worker = checkedWorker(typeof worker === 'function' ? worker() : worker);
    this.#listen();
  }

  #listen(): void {
    const worker = this.#worker;
    const heard = (type: Parameters<typeof listen>[1], hear: (value: unknown) => void) =>
      // Nobody listens to a replaced worker.
      listen(worker, type, (value) => worker === this.#worker && hear(value));
    heard('message', (reply) => this.#receive(reply as Reply));
    heard('error', (error) => this.#break(error));
    heard('messageerror', (error) => this.#break(error));
    // A worker of Node ended by itself, or others ended it.
    heard('exit', () => this.#break(new Error('the worker has ended')));
  }

  /** Whether the worker ended, or was disposed of. */
  get disposed(): boolean {
    return this.#end !== null;
  }

  /** Whether the worker has answered anything. */
  get hasAnswered(): boolean {
    return this.#hasAnswered;
  }

  /**
   * Calls a method of an object in the worker, by default of the root object that `serve` received.
   * When a signal among the arguments, or in an object among them, is aborted, the call rejects at
   * once with the signal's reason. Rejects with the `KarcherError` of the engine, or with
   * `disposed`. `work` is for calls that do not take signals and progress themselves. Its signal
   * has the same effect; its progress is 0 when the worker begins the call, and 1 when the call has
   * ended.
   */
  call(
    name: string,
    args: readonly unknown[],
    of?: object,
    { progress, signal: own }: LongWorkOptions = {},
  ): Promise<unknown> {
    if (this.#end) return Promise.reject(this.#end);
    const id = ++this.#calls;
    const signals: AbortSignal[] = own ? [own] : [];
    const settled = new AbortController();
    const done = new Promise((resolve, reject) => {
      const origin = of === undefined ? null : this.#origins.get(of);
      if (origin === undefined) throw gone();
      if (name === 'dispose' && origin) {
        // An object of a former worker is already gone if the present one did not create it again.
        if (this.#hasLeft(origin)) return resolve(undefined);
      }
      const pending: Pending = {
        ...{ resolve, reject, call: name, args: this.#copied(args, signals), of: origin },
        ...{ tells: progress as Pending['tells'], callbacks: [], begun: 0 },
      };
      for (const signal of signals) {
        signal.throwIfAborted();
        const abort = () => this.#cancel(id, signal.reason);
        signal.addEventListener('abort', abort, { once: true, signal: settled.signal });
      }
      this.#post(id, pending);
      this.#pending.set(id, pending);
    }).finally(() => {
      settled.abort();
      this.#hold();
      if (name === 'dispose') this.#forgetGone();
    });
    this.#hold();
    return progress ? done.then((result) => told(result, progress)) : done;
  }

  /**
   * Cancels every pending call, as a signal would, except those that dispose of an object. The
   * cancelled calls reject with the reason.
   */
  giveUp(reason: unknown): void {
    for (const [id, { call }] of this.#pending) {
      if (call !== 'dispose') this.#cancel(id, reason);
    }
  }

  /** Ends the worker and every pending call. A second call has no effect. */
  dispose(): void {
    this.#stop(new KarcherError('disposed', 'the worker has been disposed of'));
  }

  #post(id: number, pending: Pending): void {
    const { call, tells, of } = pending;
    pending.callbacks = tells ? [tells] : [];
    const disposed = call === 'dispose' ? of : null;
    const target = disposed?.target ?? (of ? this.#targetOf(of) : 0);
    const args = pending.args.map((arg) => this.#sent(arg, pending.callbacks));
    const request = { id, target, call, args, tells: tells !== undefined };
    if (disposed) Object.assign(disposed, { isDisposed: true, worker: null });
    const keeps = this.#start !== null;
    sending(() => this.#worker.postMessage({ ...request, keeps } satisfies Request));
  }

  /** In Node the process waits for pending calls, not for an idle worker. */
  #hold(): void {
    const waits = this.#pending.size + this.#cancelled.size > 0;
    if (waits) this.#worker.ref?.();
    else this.#worker.unref?.();
  }

  #cancel(id: number, reason: unknown): void {
    const pending = this.#pending.get(id);
    if (!pending) return;
    this.#pending.delete(id);
    pending.reject(reason);
    this.#worker.postMessage({ cancel: id } satisfies Request);
    if (!this.#start || !this.#keepsAll) return;
    const cancelled = { pending, begun: false };
    this.#cancelled.set(id, cancelled);
    if (pending.begun > 0) this.#impatient(cancelled);
  }

  /**
   * Gives the worker time to acknowledge the cancellation of the call that it executes, and then
   * replaces the worker.
   */
  #impatient(cancelled: Cancelled): void {
    if (cancelled.begun) return;
    cancelled.begun = true;
    const since = performance.now();
    const wait = () => {
      let left = since + leastPatience - performance.now();
      this.#forgetGone();
      for (const { took } of this.#kept) left += took;
      if (left > 0) cancelled.timer = setTimeout(wait, left);
      else this.#restart();
    };
    cancelled.timer = setTimeout(wait, leastPatience);
  }

  /** Lets go of the arguments of objects that were disposed of, such as whole files. */
  #forgetGone(): void {
    for (const origin of this.#kept) if (isGone(origin)) this.#kept.delete(origin);
  }

  #forgetCancelled(): void {
    for (const { timer } of this.#cancelled.values()) clearTimeout(timer);
    this.#cancelled.clear();
  }

  /** Replaces this worker by another one, and sends it the pending calls again. */
  #restart(): void {
    this.#forgetCancelled();
    const before = this.#worker;
    try {
      this.#worker = this.#start!();
    } catch (error) {
      this.#break(error);
      return;
    }
    before.terminate();
    this.#listen();
    const calls = [...this.#pending];
    // Pending calls of an object come before its disposal, so it is not disposed of yet.
    for (const [, { call, of }] of calls) if (call === 'dispose' && of) of.isDisposed = false;
    for (const [id, pending] of calls) {
      pending.begun = 0;
      const { call, of } = pending;
      try {
        if (call !== 'dispose' || !of || !this.#hasLeft(of)) {
          this.#post(id, pending);
          continue;
        }
        pending.resolve(undefined);
      } catch (error) {
        pending.reject(error);
      }
      this.#pending.delete(id);
    }
    this.#hold();
    this.onRestart?.();
  }

  /** Whether an object to be disposed of is already gone, together with its worker. */
  #hasLeft(origin: Origin): boolean {
    if (origin.worker === this.#worker) return false;
    origin.isDisposed = true;
    return true;
  }

  /**
   * The number of an object in the present worker. If the worker does not have the object, the
   * client first lets it create the object again.
   */
  #targetOf(origin: Origin): number {
    if (isGone(origin)) throw gone();
    if (origin.worker !== this.#worker) this.#make(origin);
    return origin.target;
  }

  /** Creates an object again, before the calls that follow. */
  #make(origin: Origin): void {
    const { of, call } = origin;
    const isWithout = of !== null && of.worker !== this.#worker;
    if (isWithout) this.#make(of);
    const target = of?.target ?? 0;
    const args = origin.args.map((arg) => this.#sent(arg, []));
    const send = (request: Pick<Call, 'call' | 'args' | 'makes'>) => {
      const id = ++this.#calls;
      const whole = { id, target, tells: false, keeps: false, ...request };
      this.#worker.postMessage(whole satisfies Request);
    };
    origin.target = -++this.#remade;
    origin.worker = this.#worker;
    send({ call, args, makes: origin.target });
    // `of` had been disposed of before. So the new worker, too, disposes of it after this use.
    if (!isWithout || !of.isDisposed) return;
    of.worker = null;
    send({ call: 'dispose', args: [] });
  }

  #break(error: unknown): void {
    if (this.#end) return;
    (error as Partial<Event>).preventDefault?.();
    const { message } = error as Partial<Error>;
    const end = new KarcherError('internal', message || unknownReason);
    this.#stop(end);
    this.onFatal?.(end);
  }

  #stop(end: KarcherError): void {
    if (this.#end) return;
    this.#end = end;
    this.#forgetCancelled();
    this.#worker.terminate();
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    for (const { reject } of pending) reject(end);
  }

  #receive(reply: Reply): void {
    this.#hasAnswered = true;
    const pending = this.#pending.get(reply.id);
    const cancelled = this.#cancelled.get(reply.id);
    if ('callback' in reply) {
      try {
        pending?.callbacks[reply.callback]?.(...reply.args);
      } catch (error) {
        // An error of a caller's function ends the call that received the function.
        this.#cancel(reply.id, error);
      }
      return;
    }
    if ('begun' in reply) {
      if (pending) pending.begun = performance.now();
      if (cancelled) this.#impatient(cancelled);
      return;
    }
    clearTimeout(cancelled?.timer);
    this.#cancelled.delete(reply.id);
    this.#pending.delete(reply.id);
    if ('cancelled' in reply) this.#hold();
    else if ('result' in reply) {
      const result = this.#received(reply.result, pending);
      // A cancelled call that ended nevertheless had its effect, too.
      this.#keep(reply, pending ?? cancelled?.pending);
      pending?.resolve(result);
    } else {
      pending?.reject(errorOf(reply.failure));
      if (reply.failure.fatal) this.#break(errorOf(reply.failure));
    }
  }

  /**
   * Copies of arguments, which may have to be sent again to a new worker. Adds the signals among
   * the arguments to `signals`.
   */
  #copied(args: readonly unknown[], signals: AbortSignal[]): unknown[] {
    const copied = (arg: unknown) =>
      replaced(arg, (part) => {
        if (part instanceof AbortSignal) signals.push(part);
        if (part instanceof Path) return part.data();
        if (ArrayBuffer.isView(part)) return this.#start ? copyOf(part) : part;
        const isAsItIs = part instanceof AbortSignal || typeof part === 'function';
        if (isAsItIs || this.#origins.has(part)) return part;
        if (!this.#start || Array.isArray(part) || isPlain(part)) return undefined;
        return structuredClone(part);
      });
    // The copy fails for a value that contains itself, and for a transferred buffer.
    return sending(() => args.map(copied));
  }

  #sent(arg: unknown, callbacks: Pending['callbacks']): unknown {
    return replaced(arg, (part) => {
      const origin = this.#origins.get(part);
      if (origin) return { sent: 'object', target: this.#targetOf(origin) };
      if (typeof part === 'function') {
        callbacks.push(part as (...args: unknown[]) => void);
        return { sent: 'callback', callback: callbacks.length - 1 };
      }
      return part instanceof AbortSignal ? { sent: 'signal' } : undefined;
    });
  }

  /** Receives a result. If nobody waits for it, its meshes and curves are disposed of. */
  #received(result: unknown, pending: Pending | undefined): unknown {
    let meshes = 0;
    return replaced(result, (part) => {
      if (ArrayBuffer.isView(part)) return part;
      if (!isSent(part)) return undefined;
      if (part.sent === 'path') return new Path(part.data);
      if (part.sent === 'region') return new Region(part.data);
      if (part.sent === 'view') return new CurveView(part.data);
      if (part.sent !== 'mesh' && part.sent !== 'curve') return undefined;
      const object: RemoteMesh | RemoteCurve =
        part.sent === 'mesh'
          ? remoteMesh(this, part.names, part.info)
          : remoteCurve(this, part.names);
      if (part.sent === 'mesh') meshes++;
      const origin = this.#originOf(part, pending);
      this.#origins.set(object, origin);
      if (this.#start && pending) {
        this.#kept.add(origin);
        this.#keepsAll &&= meshes < 2 && (part.sent === 'mesh' || origin.of !== null);
      }
      if (!pending) object.dispose().catch(() => {});
      return object;
    });
  }

  #originOf(
    { sent, target, ...more }: Extract<Sent, { sent: 'mesh' | 'curve' }>,
    pending: Pending | undefined,
  ): Origin {
    const { of = null, call = '', args = [], begun = 0 } = pending ?? {};
    const worker = this.#worker;
    if (sent === 'mesh') {
      const took = performance.now() - begun;
      return { target, worker, of, call, args: this.#start ? args : [], took, isDisposed: false };
    }
    // A curve created by another curve has the same mesh.
    const mesh = of?.call === 'curve' ? of.of : of;
    const { value } = more as { value?: CurveOptions };
    const took = performance.now() - begun;
    const made = { of: mesh, call: 'curve', args: [value], took, isDisposed: false };
    return { target, worker, ...made };
  }

  /** Records the effect of the call on its mesh or curve. */
  #keep({ value }: { value?: CurveOptions }, pending: Pending | undefined): void {
    const of = pending?.of;
    if (!of) return;
    if (pending.call === 'set') of.args = pending.args.slice(0, 1);
    else if (value) of.args = [value];
  }
}

function checkedWorker(worker: WorkerLike): WorkerLike {
  const { postMessage, terminate } = (worker ?? {}) as Partial<WorkerLike>;
  if (typeof postMessage === 'function' && typeof terminate === 'function') return worker;
  throw new KarcherError('badArgument', `the worker must be a Worker, not ${shown(worker)}`);
}

/** Whether an object was disposed of, either itself or, if it is a curve, with its mesh. */
const isGone = ({ isDisposed, call, of }: Origin): boolean =>
  isDisposed || (call === 'curve' && of !== null && of.isDisposed);

/** A copy of a view alone, without the rest of its buffer. The `slice` of a `Buffer` is no copy. */
const copyOf = (view: ArrayBufferView): unknown =>
  'slice' in view ? Uint8Array.prototype.slice.call(view) : structuredClone(view);

const gone = () => new KarcherError('disposed', 'the mesh or curve has been disposed of');

/** Throws `KarcherError` if `clone` cannot create a structured clone. */
function sending<Result>(clone: () => Result): Result {
  try {
    return clone();
  } catch (cause) {
    if (cause instanceof KarcherError) throw cause;
    const why = cause instanceof Error ? cause.message : `${cause}`;
    throw new KarcherError('badArgument', `it cannot be sent to a worker: ${why}`, { cause });
  }
}

/** Reports the end of a call. An error of the progress function is the call's failure. */
function told(result: unknown, progress: NonNullable<LongWorkOptions['progress']>): unknown {
  progress(1, 'done');
  return result;
}

/** Listens to a worker's event: the data of a message, or an error. */
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
