import type { CurveOptions, SetOptions } from '../types.js';
import type { WorkerLike } from './client.js';
import { isPlain, isSent, replaced } from './protocol.js';

/**
 * A mesh or curve of the worker's, and how another worker makes it anew: a mesh by the call that made
 * it, a curve from its mesh by what it is.
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
  /**
   * Of a curve the edits since it was what `args` say: steps of a drag, which continue legs from where they
   * lie; and those since its kind changed, as it keeps numbers that another kind has use for, which its
   * value does not tell.
   */
  edits: Pick<Origin, 'call' | 'args'>[];
  /** Milliseconds that the call took. */
  readonly took: number;
  /** Whether it is being disposed of. */
  leaving: boolean;
}

/** More edits are not made again: then a curve has what its own kind has use for. */
const mostEdits = 200;

/** More steps of a drag are not, as each takes its time: what a curve has become is asked for then. */
const mostSteps = 16;

type Edit = Origin['edits'][number];

const isSet = ({ call }: Edit) => call === 'set';
const isStep = ({ args: [, options] }: Edit) =>
  (options as SetOptions | undefined)?.dragged !== undefined;

/** Whether the curve after an edit is known without its value. */
export const isTold = (origin: Origin, edit: Edit): boolean =>
  isSet(edit) && (!isStep(edit) || origin.edits.length < mostSteps);

/** Notes what an edit made of a curve: its value, where that was told. Other calls change nothing. */
export function noteEdit(origin: Origin, edit: Edit, value: CurveOptions | undefined): void {
  if (isSet(edit)) {
    if (isStep(edit)) origin.edits.push(edit);
    else becomes(origin, edit.args[0]);
    return;
  }
  if (!value) return;
  const changesKind = edit.call === 'setKind' || origin.edits.length > 0;
  if (changesKind && origin.edits.length < mostEdits) origin.edits.push(edit);
  else becomes(origin, value);
}

/** Notes what a curve is: nothing of its edits has to be made again. */
export function becomes(origin: Origin, value: unknown): void {
  origin.args = [value];
  origin.edits = [];
}

/** A copy of a view alone, however large the buffer that it is of. */
export const copyOf = (view: ArrayBufferView): unknown =>
  'slice' in view ? (view as Uint8Array).slice() : structuredClone(view);

/** Arguments without functions and signals: a call that is made again tells nothing. */
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
