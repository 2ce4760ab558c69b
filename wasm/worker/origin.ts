import { isPlain, isSent, replaced, type WorkerLike } from './protocol.js';

/**
 * A mesh or curve in the worker, and how another worker creates it again: a mesh by the call that created it, a
 * curve from its mesh by its last value.
 */
export interface Origin {
  /** Its number in the worker that it is in, or was in. */
  target: number;
  worker: WorkerLike;
  /** The mesh that it was made of; null of one that was made of nothing. */
  readonly of: Origin | null;
  readonly call: string;
  /** Nobody else changes them. */
  args: readonly unknown[];
  /** Milliseconds that the call took. */
  readonly took: number;
  /** Whether it is being disposed of. */
  leaving: boolean;
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

/** The number of the mesh or curve in what a call returned. */
export function targetIn(result: unknown): number | undefined {
  let target: number | undefined;
  replaced(result, (part) => {
    if (ArrayBuffer.isView(part)) return part;
    if (!isSent(part)) return undefined;
    if (part.sent === 'mesh' || part.sent === 'curve') target ??= part.target;
    return part;
  });
  return target;
}
