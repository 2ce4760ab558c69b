import { KarcherError } from '../errors.js';
import type { EnginePath, EngineRegion } from '../karcher-engine.mjs';
import type { CompiledModule } from '../platform.js';
import type { CurveOptions, ErrorCode, MeshInfo } from '../types.js';
import type { ViewData } from '../view.js';

/** A worker of a page or of Node. */
export interface WorkerLike {
  /** Sends a message to the worker. */
  postMessage(message: unknown): void;
  /** Ends the worker. */
  terminate(): unknown;
  /** Makes the process wait for the worker again, in Node. */
  ref?(): void;
  /** Lets the process end while the worker waits, in Node. */
  unref?(): void;
}

/**
 * A call. With `tells`, the worker announces the start of the call to the first function among the
 * arguments. With `keeps`, it announces the start to the client, too, and its answer includes the
 * values of curves that the call creates or edits. With `makes`, the call creates a mesh or curve
 * of an earlier worker again, under this number. The worker answers such a call only if it fails.
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
 * The messages between a client and its worker. A call names a method of an object in the worker;
 * number 0 is the root object. Arguments and results are structured clones, except those written as
 * `Sent`.
 */
export type Request = Call | { cancel: number } | FirstRequest;

/** A message that a worker may receive before all others: the engine that it should use. */
export interface FirstRequest {
  wasm: CompiledModule;
}

export type Reply =
  /** The answer, with the value of the curve that the call edited. */
  | { id: number; result: unknown; value?: CurveOptions }
  | { id: number; begun: true }
  /** The worker acknowledges that the call is cancelled. */
  | { id: number; cancelled: true }
  | { id: number; failure: Failure }
  /** The client should call a function among the call's arguments. */
  | { id: number; callback: number; args: unknown[] };

export interface Failure {
  message: string;
  /** The code of a `KarcherError`. */
  code?: ErrorCode;
  /** Whether the engine broke and allows no more calls. */
  fatal: boolean;
}

/** The names of a class's methods, and of its other properties. */
export interface ClassNames {
  methods: string[];
  facts: string[];
}

/** Values that cannot be cloned, in the form in which they are sent. */
export type Sent =
  | { sent: 'signal' }
  | { sent: 'callback'; callback: number }
  | { sent: 'mesh'; target: number; names: ClassNames; info: Readonly<MeshInfo> }
  | { sent: 'curve'; target: number; names: ClassNames; value?: CurveOptions }
  /** The number of an object in the worker, where it stays. */
  | { sent: 'object'; target: number }
  | { sent: 'path'; data: EnginePath }
  | { sent: 'region'; data: EngineRegion }
  | { sent: 'view'; data: ViewData };

export const isSent = (value: object): value is Sent => 'sent' in value;

/** Whether a value is a plain object, of no class. */
export function isPlain(value: object): boolean {
  const prototype = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null;
}

/**
 * A copy of a value in which `replace` may replace each part. If `replace` returns undefined, the
 * part remains, and its own parts are passed to `replace`.
 */
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
  // An error that the engine itself reports has no cause.
  const fatal = error.code === 'internal' && error.cause !== undefined;
  return { message, code: error.code, fatal };
}

export const errorOf = ({ message, code }: Failure): Error =>
  code === undefined ? new Error(message) : new KarcherError(code, message);
