import type { FileCurve } from '../formats/index.js';
import type { Mesh } from '../mesh.js';
import type { Arguments } from './arguments.js';
import type { Described } from './options.js';

/**
 * The result of a command: one JSON object, in which iterators stand for long arrays. For the other
 * formats, the result also has the mesh and the curves on it.
 */
export interface Result {
  json: object;
  /** The bytes of a file, which go to standard output instead of the JSON object. */
  bytes?: Uint8Array;
  mesh?: Mesh;
  curves?: () => FileCurve[];
}

/** A command of `karcher`. It runs for one mesh at a time. */
export interface Command extends Described {
  /** A line for the list of commands. */
  summary: string;
  /** The call that does the same in JavaScript; its options have the same names. */
  call: string;
  /** A description of the JSON object. */
  output: string;
  /** Runs the command. `tell` writes the progress of a long command to standard error. */
  run(args: Arguments, tell: (sentence: string) => void): Promise<Result>;
}
