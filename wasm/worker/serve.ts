import { Curve } from '../curve.js';
import { KarcherError } from '../errors.js';
import type { EnginePath } from '../karcher-engine.mjs';
import { Mesh } from '../mesh.js';
import { Path } from '../path.js';
import { pause } from '../prepare.js';
import { Region } from '../region.js';
import { CurveView } from '../view.js';
import {
  type Call,
  type ClassNames,
  failureOf,
  isSent,
  type Reply,
  type Request,
  replaced,
  type Sent,
} from './protocol.js';

/** The worker's own end of the channel for messages, in a worker of a page or of Node. */
interface Scope {
  postMessage(message: unknown, transfer: Transferable[]): void;
  addEventListener(type: 'message', hear: (event: { data: unknown }) => void): void;
}

export function ownScope(): Scope {
  const { process } = globalThis as { process?: NodeJS.Process };
  const threads = process?.getBuiltinModule?.('node:worker_threads');
  return (threads?.parentPort ?? globalThis) as unknown as Scope;
}

/**
 * Answers the calls of a client from within its worker. A call is a method of `root`, or a method
 * or property of a mesh or curve that an earlier call returned; these objects stay here. A call may
 * use functions among its arguments while it runs; such functions return nothing to it. A signal
 * among its arguments is aborted when the client cancels the call. The worker transfers the arrays
 * of results, so the methods must not keep them.
 */
export function serve(root: object | Promise<object>): void {
  const server = new Server(root, ownScope());
  server.listen();
}

const arraysOf = ({ face, bary, position, lengths }: EnginePath) => [face, bary, position, lengths];

/**
 * The names of a class's public methods and properties, with those of the class that it extends.
 */
function namesIn(prototype: object, internal: string): ClassNames {
  const base = Object.getPrototypeOf(prototype) as object;
  const all = [...(base === Object.prototype ? [] : [base]), prototype];
  const own = all
    .flatMap((each) => Object.entries(Object.getOwnPropertyDescriptors(each)))
    .filter(([name]) => name !== 'constructor' && name !== internal);
  const names = (ofMethods: boolean) =>
    own.filter(([, { get }]) => (get === undefined) === ofMethods).map(([name]) => name);
  return { methods: names(true), facts: names(false) };
}

const meshNames = namesIn(Mesh.prototype, 'handle');
const curveNames = namesIn(Curve.prototype, 'edits');

class Server {
  readonly #root: object | Promise<object>;
  readonly #scope: Scope;
  readonly #objects = new Map<number, Mesh | Curve>();
  readonly #running = new Map<number, AbortController>();
  /** The calls that have not begun. */
  readonly #waiting: Call[] = [];
  #beginning = false;
  #lastObject = 0;

  constructor(root: object | Promise<object>, scope: Scope) {
    this.#root = root;
    this.#scope = scope;
  }

  listen(): void {
    this.#scope.addEventListener('message', ({ data }) => {
      const request = data as Request;
      if ('wasm' in request) return;
      if ('cancel' in request) this.#cancel(request.cancel);
      else {
        this.#waiting.push(request);
        void this.#begin();
      }
    });
  }

  /**
   * Executes the waiting calls. Between two calls, the worker can receive cancellations of the
   * other calls.
   */
  async #begin(): Promise<void> {
    if (this.#beginning) return;
    this.#beginning = true;
    for (let next = this.#waiting.shift(); next; next = this.#waiting.shift()) {
      if (next.makes === undefined) void this.#answer(next);
      else await this.#make(next, next.makes);
      await pause();
    }
    this.#beginning = false;
  }

  /**
   * Creates an object of an earlier worker again. A failure is fatal, since the client's later
   * calls need the object.
   */
  async #make({ id, target, call, args }: Call, number: number): Promise<void> {
    try {
      const owner = target === 0 ? await this.#root : this.#object(target);
      const make = (owner as Record<string, (...args: unknown[]) => unknown>)[call]!;
      const { signal } = new AbortController();
      replaced(
        await make.apply(
          owner,
          args.map((arg) => this.#received(arg, id, signal)),
        ),
        (part) => {
          const isObject = part instanceof Mesh || part instanceof Curve;
          if (isObject && !this.#objects.has(number)) this.#objects.set(number, part);
          return ArrayBuffer.isView(part) ? part : undefined;
        },
      );
      if (!this.#objects.has(number)) throw new Error(`'${call}' made nothing`);
    } catch (error) {
      this.#post({ id, failure: { ...failureOf(error), fatal: true } });
    }
  }

  #cancel(id: number): void {
    const waiting = this.#waiting.findIndex((call) => call.id === id);
    if (waiting >= 0) this.#waiting.splice(waiting, 1);
    else this.#running.get(id)?.abort();
    this.#post({ id, cancelled: true });
  }

  async #answer({ id, target, call, args, tells, keeps }: Call): Promise<void> {
    const controller = new AbortController();
    this.#running.set(id, controller);
    try {
      // A second disposal has no effect.
      if (call === 'dispose' && target !== 0 && !this.#objects.has(target)) {
        this.#post({ id, result: undefined });
        return;
      }
      const owner = target === 0 ? await this.#root : this.#object(target);
      // The call may have been cancelled while the root loaded.
      controller.signal.throwIfAborted();
      if (keeps) this.#post({ id, begun: true });
      if (tells) this.#post({ id, callback: 0, args: [0, 'begun'] });
      const asked: unknown = (owner as Record<string, unknown>)[call];
      // Methods that every object has are not calls.
      if (asked === undefined || call in Object.prototype) {
        throw new KarcherError('badArgument', `there is no call '${call}'`);
      }
      const edits = owner instanceof Curve ? owner.edits() : 0;
      const given = args.map((arg) => this.#received(arg, id, controller.signal));
      const result = typeof asked === 'function' ? await asked.apply(owner, given) : asked;
      if (call === 'dispose') this.#objects.delete(target);
      const transfer = new Set<Transferable>();
      const sent = this.#sent(result, transfer, keeps);
      const isEdited = keeps && owner instanceof Curve && owner.edits() > edits;
      const value = isEdited && { value: owner.value() };
      this.#post({ id, result: sent, ...value }, [...transfer]);
    } catch (error) {
      this.#post({ id, failure: failureOf(error) });
    } finally {
      this.#running.delete(id);
    }
  }

  #post(reply: Reply, transfer: Transferable[] = []): void {
    this.#scope.postMessage(reply, transfer);
  }

  #object(target: number): Mesh | Curve {
    const object = this.#objects.get(target);
    if (object) return object;
    throw new KarcherError('disposed', 'the mesh or curve has been disposed of');
  }

  #received(arg: unknown, id: number, signal: AbortSignal): unknown {
    return replaced(arg, (part) => {
      if (!isSent(part)) return undefined;
      if (part.sent === 'signal') return signal;
      if (part.sent === 'object') return this.#object(part.target);
      if (part.sent !== 'callback') return undefined;
      const { callback } = part;
      return (...args: unknown[]) => this.#post({ id, callback, args });
    });
  }

  #sent(result: unknown, transfer: Set<Transferable>, keeps: boolean): unknown {
    const add = (array: ArrayBufferView) => transfer.add(array.buffer as ArrayBuffer);
    return replaced(result, (part): Sent | object | undefined => {
      if (ArrayBuffer.isView(part)) {
        add(part);
        return part;
      }
      if (part instanceof Path) {
        const data = part.data();
        for (const array of arraysOf(data)) add(array);
        return { sent: 'path', data };
      }
      if (part instanceof Region) {
        const data = part.data();
        for (const array of [data.share, data.triangles, data.sides]) add(array);
        for (const array of data.boundary.flatMap(arraysOf)) add(array);
        return { sent: 'region', data };
      }
      if (part instanceof CurveView) {
        const data = part.data();
        add(data.bytes);
        return { sent: 'view', data };
      }
      if (!(part instanceof Mesh) && !(part instanceof Curve)) return undefined;
      const target = ++this.#lastObject;
      this.#objects.set(target, part);
      return part instanceof Mesh
        ? { sent: 'mesh', target, names: meshNames, info: part.info }
        : { sent: 'curve', target, names: curveNames, ...(keeps && { value: part.value() }) };
    });
  }
}
