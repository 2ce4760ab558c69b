import type { CurveSamples, Status } from '../types.js';
import { UsageError } from './errors.js';

/** x, y, z, … as [[x, y, z], …]. */
export function triples(flat: ArrayLike<number>): [number, number, number][] {
  return Array.from({ length: flat.length / 3 }, (_, i) => [
    flat[3 * i]!,
    flat[3 * i + 1]!,
    flat[3 * i + 2]!,
  ]);
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

/** Samples as a list of objects. */
export function sampleRecords(samples: CurveSamples): SampleRecord[] {
  const barys = triples(samples.bary);
  const positions = triples(samples.position);
  return Array.from({ length: samples.count }, (_, i) => ({
    segment: samples.segment[i]!,
    t: samples.t[i]!,
    face: samples.face[i]!,
    bary: barys[i]!,
    position: positions[i]!,
    converged: samples.status[i] === 'converged',
    status: samples.status[i]!,
  }));
}

/** Polylines as an OBJ file: their vertices, and an `l` line each. */
export function polylinesAsObj(polylines: readonly Float64Array[]): string {
  const vertices: string[] = [];
  const lines: string[] = [];
  for (const polyline of polylines) {
    const first = vertices.length + 1;
    for (const position of triples(polyline)) vertices.push(`v ${position.join(' ')}\n`);
    const numbers = Array.from({ length: polyline.length / 3 }, (_, i) => first + i);
    lines.push(`l ${numbers.join(' ')}\n`);
  }
  return vertices.join('') + lines.join('');
}

/** Writes all of a text to standard output. */
export function print(text: string): Promise<void> {
  return new Promise((resolve, reject) => {
    const fail = (cause: NodeJS.ErrnoException) => {
      const reason =
        cause.code === 'EPIPE' ? 'it was closed before everything was written' : cause.message;
      reject(new UsageError(`cannot write to standard output: ${reason}`, { cause }));
    };
    process.stdout.once('error', fail);
    process.stdout.write(text, (error) => (error ? fail(error) : resolve()));
  });
}
