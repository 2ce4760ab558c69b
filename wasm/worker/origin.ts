import { isPlain, type WorkerLike } from './protocol.js';

/**
 * A mesh or curve in the worker, and the data from which another worker creates it again: a mesh by
 * its original call, a curve from its mesh by its last value.
 */
export interface Origin {
  /** Its number in its present or last worker. */
  target: number;
  /** Its worker, or null once it is disposed of. */
  worker: WorkerLike | null;
  /** The mesh or curve from which it was created; null if there was none. */
  readonly of: Origin | null;
  readonly call: string;
  /** The arguments of its call, which nobody else changes. */
  args: readonly unknown[];
  /** The duration of the call in milliseconds. */
  readonly took: number;
  /** Whether it is disposed of, or is about to be. */
  isDisposed: boolean;
}

/** A copy of a view alone, without the rest of its buffer. */
export const copyOf = (view: ArrayBufferView): unknown =>
  'slice' in view ? (view as Uint8Array).slice() : structuredClone(view);

/** Arguments without functions and signals, since a repeated call reports no progress. */
export const withoutWork = (args: readonly unknown[]): unknown[] =>
  args.map((arg) => {
    if (typeof arg !== 'object' || arg === null) return arg;
    if (!isPlain(arg)) return arg;
    const entries = Object.entries(arg);
    return Object.fromEntries(
      entries.filter(([, part]) => typeof part !== 'function' && !(part instanceof AbortSignal)),
    );
  });

/** Whether an object was disposed of, either itself or, if it is a curve, with its mesh. */
export const isGone = ({ isDisposed, call, of }: Origin): boolean =>
  isDisposed || (call === 'curve' && of !== null && of.isDisposed);
