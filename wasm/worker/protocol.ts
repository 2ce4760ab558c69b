import { KarcherError } from '../errors.js';
import type { EnginePath, EngineRegion } from '../karcher-engine.mjs';
import type { CompiledModule } from '../platform.js';
import type { CurveOptions, ErrorCode, MeshInfo } from '../types.js';
import type { ViewData } from '../view.js';

/** A page's worker, or one of Node's. */
export interface WorkerLike {
  /** Sends a message to the worker. */
  postMessage(message: unknown): void;
  /** Ends the worker. */
  terminate(): unknown;
  /** In Node: makes the process wait for the worker again. */
  ref?(): void;
  /** In Node: lets the process end while the worker waits. */
  unref?(): void;
}

/**
 * With `tells` the first function among the arguments hears when the worker begins with the call. With
 * `keeps` the client hears that too, and what curves are that the call makes or edits. With `makes` the
 * call gives another worker's mesh or curve anew, which gets this number; that it failed is its only answer.
 */
export interface Call {
  id: number;
  target: number;
  call: string;
  args: unknown[];
  tells: boolean;
  keeps: boolean;
  makes?: number;
}

/**
 * The messages between a client and its worker. A call names a method of an object in the worker, of
 * which number 0 is the one that is served. Arguments and results travel as structured clones, but
 * for what is written as `Sent`.
 */
export type Request = Call | { cancel: number } | FirstRequest;

/** What a worker may hear before all else: the engine that it is to take. */
export interface FirstRequest {
  wasm: CompiledModule;
}

export type Reply =
  /** The answer, with the value of the curve that the call edited. */
  | { id: number; result: unknown; value?: CurveOptions }
  | { id: number; begun: true }
  /** The worker has heard that the call is cancelled. */
  | { id: number; cancelled: true }
  | { id: number; failure: Failure }
  /** A function among the call's arguments is to be called. */
  | { id: number; callback: number; args: unknown[] };

export interface Failure {
  message: string;
  /** Of a `KarcherError`. */
  code?: ErrorCode;
  /** The engine broke and takes no more calls. */
  fatal: boolean;
}

/** Values that cannot be cloned. */
export type Sent =
  | { sent: 'signal' }
  | { sent: 'callback'; callback: number }
  | { sent: 'mesh'; target: number; info: Readonly<MeshInfo> }
  | { sent: 'curve'; target: number; value?: CurveOptions }
  /** On the way to the worker, of either kind. */
  | { sent: 'object'; target: number }
  | { sent: 'path'; data: EnginePath }
  | { sent: 'region'; data: EngineRegion }
  | { sent: 'view'; data: ViewData };

export const isSent = (value: object): value is Sent => 'sent' in value;

/** Whether it is an object of no class. */
export function isPlain(value: object): boolean {
  const prototype = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null;
}

/** A value in which what `replace` knows has been replaced; undefined is what it does not know. */
export function replaced(value: unknown, replace: (part: object) => unknown): unknown {
  if ((typeof value !== 'object' || value === null) && typeof value !== 'function') return value;
  const other = replace(value);
  if (other !== undefined) return other;
  if (Array.isArray(value)) return Array.from(value, (entry) => replaced(entry, replace));
  if (!isPlain(value)) return value;
  return Object.fromEntries(
    Object.entries(value).map(([name, entry]) => [name, replaced(entry, replace)]),
  );
}

export function failureOf(error: unknown): Failure {
  const message = error instanceof Error ? error.message : `${error}`;
  if (!(error instanceof KarcherError)) return { message, fatal: false };
  // What the engine itself tells has no cause.
  const fatal = error.code === 'internal' && error.cause !== undefined;
  return { message, code: error.code, fatal };
}

export const errorOf = ({ message, code }: Failure): Error =>
  code === undefined ? new Error(message) : new KarcherError(code, message);
