import { isPlain, type WorkerLike } from './protocol.js';

/**
 * A mesh or curve in the worker, and how another worker creates it again: a mesh by the call that created it, a
 * curve from its mesh by its last value.
 */
export interface Origin {
  /** Its number in the worker that it is in, or was in. */
  target: number;
  /** Null once it is disposed of. */
  worker: WorkerLike | null;
  /** The mesh that it was made of; null of one that was made of nothing. */
  readonly of: Origin | null;
  readonly call: string;
  /** Nobody else changes them. */
  args: readonly unknown[];
  /** Milliseconds that the call took. */
  readonly took: number;
  /** Whether it is disposed of, or is about to be. */
  isDisposed: boolean;
}

/** A copy of a view alone, however large the buffer that it is of. */
export const copyOf = (view: ArrayBufferView): unknown =>
  'slice' in view ? (view as Uint8Array).slice() : structuredClone(view);

/** Arguments without functions and signals, since a repeated call reports nothing. */
export const withoutWork = (args: readonly unknown[]): unknown[] =>
  args.map((arg) => {
    if (typeof arg !== 'object' || arg === null) return arg;
    if (!isPlain(arg)) return arg;
    const entries = Object.entries(arg);
    return Object.fromEntries(
      entries.filter(([, part]) => typeof part !== 'function' && !(part instanceof AbortSignal)),
    );
  });

/** Whether it was disposed of, or with its mesh a curve. */
export const isGone = ({ isDisposed, call, of }: Origin): boolean =>
  isDisposed || (call === 'curve' && of !== null && of.isDisposed);
