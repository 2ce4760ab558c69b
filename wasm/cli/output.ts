import type { Writable } from 'node:stream';
import type { Mesh } from '../mesh.js';
import type { Path } from '../path.js';
import type { PathPoints } from '../path_types.js';
import type { Region } from '../region.js';
import type { CurvePoints, CurveSamples, Status } from '../types.js';
import type { Result } from './command.js';
import { writeError } from './errors.js';

/** The triples [x, y, z] of an array x, y, z, …, one after the other. */
export function* triples(flat: ArrayLike<number>): Generator<[number, number, number]> {
  for (let i = 0; i < flat.length; i += 3) yield [flat[i]!, flat[i + 1]!, flat[i + 2]!];
}

/** A path with its points. */
export function pathRecord(path: Path) {
  return {
    length: path.length,
    polyline: triples(path.polyline({ bits: 64 })),
    points: path.points(),
    lengths: Array.from(path.lengths()),
  };
}

/** The result of a command that finds lines of points at one distance. */
export function linesResult(mesh: Mesh, lines: readonly Path[]): Result {
  return {
    json: {
      lines: lines.map((line) => ({
        ...{ closed: line.closed, length: line.length },
        polyline: triples(line.polyline({ bits: 64 })),
      })),
    },
    mesh,
    curves: () => lines.map((path) => ({ path })),
  };
}

export interface SampleRecord {
  segment: number;
  t: number;
  face: number;
  bary: [number, number, number];
  position: [number, number, number];
  converged: boolean;
  status: Status;
}

/** Triple i of an array x, y, z, …. */
export const triple = (flat: Float64Array, i: number): [number, number, number] => [
  flat[3 * i]!,
  flat[3 * i + 1]!,
  flat[3 * i + 2]!,
];

/** Points of a path as objects, one after the other. */
export function* spacedRecords({ lengths, face, bary, position }: PathPoints) {
  for (let i = 0; i < lengths.length; i++) {
    yield {
      length: lengths[i]!,
      point: { face: face[i]!, bary: triple(bary, i) },
      position: triple(position, i),
    };
  }
}

/** Points of a curve as objects, one after the other. */
export function* pointRecords({ parameter, face, bary, position }: CurvePoints) {
  for (let i = 0; i < parameter.length; i++) {
    yield {
      parameter: parameter[i]!,
      point: { face: face[i]!, bary: triple(bary, i) },
      position: triple(position, i),
    };
  }
}

/** Samples as objects, one after the other. */
export function* sampleRecords(samples: CurveSamples): Generator<SampleRecord> {
  const { bary, position, status } = samples;
  for (let i = 0; i < samples.count; i++) {
    yield {
      segment: samples.segment[i]!,
      t: samples.t[i]!,
      face: samples.face[i]!,
      bary: triple(bary, i),
      position: triple(position, i),
      converged: status[i] === 'converged',
      status: status[i]!,
    };
  }
}

/**
 * A value as JSON, in pieces, since a large result does not fit into one string. Iterators in the
 * value become arrays. The entries of an iterator must be small, since each entry becomes one
 * piece.
 */
export function* jsonPieces(value: unknown): Generator<string> {
  if (typeof value !== 'object' || value === null) {
    yield JSON.stringify(value) ?? 'null';
    return;
  }
  const isIterator = Symbol.iterator in value && !Array.isArray(value);
  let separator = '';
  if (isIterator || Array.isArray(value)) {
    yield '[';
    for (const entry of value as Iterable<unknown>) {
      yield separator;
      if (isIterator) yield JSON.stringify(entry);
      else yield* jsonPieces(entry);
      separator = ',';
    }
    yield ']';
    return;
  }
  yield '{';
  for (const [name, entry] of Object.entries(value)) {
    if (entry === undefined) continue;
    yield `${separator}${JSON.stringify(name)}:`;
    yield* jsonPieces(entry);
    separator = ',';
  }
  yield '}';
}

/** A value as JSON on a separate line, in pieces. */
export function* jsonLine(value: unknown): Generator<string> {
  yield* jsonPieces(value);
  yield '\n';
}

/** The pieces of a result: texts, or the bytes of files. */
export type Pieces = Iterable<string | Uint8Array> | AsyncIterable<string | Uint8Array>;

/**
 * Writes pieces to a stream, each after the end of the previous write. Short texts are combined
 * into fewer writes. `name` names the stream in errors.
 */
export async function print(
  pieces: Pieces,
  stream: Writable,
  name = 'standard output',
): Promise<void> {
  const enough = 1 << 16;
  let text = '';
  for await (const piece of pieces) {
    if (typeof piece !== 'string') {
      await write(piece, stream, name);
      continue;
    }
    text += piece;
    if (text.length < enough) continue;
    await write(text, stream, name);
    text = '';
  }
  await write(text, stream, name);
}

/**
 * A text with question marks in place of control characters, except tabs and line ends. The names
 * of files and of their parts may contain characters that would act on a terminal.
 */
export const printable = (text: string) =>
  text.replace(/(?![\t\n])[\p{Cc}\p{Bidi_Control}]/gu, '?');

function write(text: string | Uint8Array, stream: Writable, name: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const fail = (cause: NodeJS.ErrnoException) => {
      reject(writeError(name, cause));
    };
    stream.once('error', fail);
    stream.write(typeof text === 'string' ? printable(text) : text, (error) => {
      if (error) return fail(error);
      stream.off('error', fail);
      resolve();
    });
  });
}

/** A region in the form of results. */
export const regionRecord = (region: Region) => ({
  area: region.area,
  perimeter: region.perimeter,
  boundary: region.boundary().map((path) => ({
    length: path.length,
    polyline: triples(path.polyline({ bits: 64 })),
  })),
});
