import type { Arguments } from './arguments.js';
import type { Described } from './options.js';

/**
 * What a command gives: one JSON object, in which iterators stand for long arrays, and its polylines
 * (x, y, z, …) for `--format obj`.
 */
export interface Result {
  json: object;
  /** In its place, where the result goes to standard output: a file. */
  bytes?: Uint8Array;
  polylines?: Float64Array[];
}

/** A command of `karcher`; each takes one mesh at a time. */
export interface Command extends Described {
  /** A line for the list of commands. */
  summary: string;
  /** The call that does the same in JavaScript; its options have the same names. */
  call: string;
  /** What the JSON object holds. */
  output: string;
  /** `tell` says on standard error how far a long command is. */
  run(args: Arguments, tell: (sentence: string) => void): Promise<Result>;
}
