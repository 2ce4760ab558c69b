import type { Mesh } from '../mesh.js';
import type { Path } from '../path.js';
import type { CurveSamples } from '../types.js';
import { at, cross, dot, length, subtract, type Vector } from '../vectors.js';
import { isThere } from './status.js';
import type { WeightTable } from './types.js';

/** The differences of a curve from a reference with samples at the same parameters. */
export interface CurveMeasures {
  /** The number of samples. */
  samples: number;
  /** The number of samples that are lost (`isThere`). */
  lost: number;
  /**
   * The distances, in mean edges, between corresponding samples, neither of them lost. `samples` is
   * the number of these pairs.
   */
  deviation: { median: number; max: number; samples: number } | null;
  /**
   * The root mean square, in radians, of the differences in turning angle between the curve and the
   * reference, at about 128 samples of each segment.
   */
  turningNoise: number | null;
  /**
   * The number of leaps. A leap is a step between two consecutive samples, neither of them lost, that
   * is longer than a mean edge and more than five times as long as the steps before and after it. If
   * `measure` has affine averages, it compares the steps relative to the steps of these averages.
   */
  breaks: number;
  /**
   * The largest angle, in degrees, by which the curve turns at a sample, and the sample's
   * parameter.
   */
  sharpestTurn: { degrees: number; t: number } | null;
}

/** A reference: the positions of its samples, and the status of each. */
export interface ReferenceSamples extends Pick<CurveSamples, 'count' | 'position' | 'status'> {
  /** The energy of each sample, if it is known in closed form, in squared units of the mesh. */
  energy?: Float64Array;
}

/**
 * The centers of mass of a path's two ends. They are points of the path; the weights give the
 * fractions of the path's length at which they lie.
 */
export function alongPath(path: Path, { t, weights }: WeightTable): ReferenceSamples {
  const polyline = path.polyline({ bits: 64 });
  const lengths = [0];
  for (let i = 1; 3 * i < polyline.length; i++) {
    const step = subtract(at(polyline, i), at(polyline, i - 1));
    lengths.push(lengths[i - 1]! + Math.sqrt(dot(step, step)));
  }
  const last = lengths.length - 1;
  const position = new Float64Array(3 * t.length);
  const energy = new Float64Array(t.length);
  for (let i = 0; i < t.length; i++) {
    energy[i] = weights[2 * i]! * weights[2 * i + 1]! * lengths[last]! ** 2;
    const length = weights[2 * i + 1]! * lengths[last]!;
    let next = 1;
    while (next < last && lengths[next]! < length) next++;
    const [before, after] = [at(polyline, next - 1), at(polyline, Math.min(next, last))];
    const step = lengths[next]! - lengths[next - 1]!;
    const part = step > 0 ? (length - lengths[next - 1]!) / step : 0;
    position.set(
      before.map((x, c) => x + part * (after[c]! - x)),
      3 * i,
    );
  }
  return { count: t.length, position, energy, status: Array.from(t, () => 'converged' as const) };
}

/**
 * A step between samples is a leap if it is longer than the steps before and after it by more than
 * this factor.
 */
const leapRatio = 5;

/** A meter of curves on one mesh. */
export class CurveMeter {
  readonly #meanEdge: number;
  readonly #triangles: Int32Array;
  /** For each vertex, the area-weighted sum of the normals of its faces. */
  readonly #normals: Float64Array;

  constructor(mesh: Mesh) {
    const positions = mesh.positions();
    this.#meanEdge = mesh.info.meanEdge;
    this.#triangles = mesh.triangles();
    this.#normals = vertexNormals(positions, this.#triangles);
  }

  /**
   * Measures a curve against a reference with the same segments and parameters. `affine` has
   * averages of the control points in space, with the weights of the samples. They show where a
   * curve moves fast without a leap, as rational curves do at their ends.
   */
  measure(
    curve: CurveSamples,
    reference: ReferenceSamples,
    affine: ReferenceSamples | null = null,
  ): CurveMeasures {
    const distances: number[] = [];
    for (let i = 0; i < curve.count; i++) {
      if (!isThere(curve.status[i]!) || !isThere(reference.status[i]!)) continue;
      const offset = subtract(at(curve.position, i), at(reference.position, i));
      distances.push(Math.sqrt(dot(offset, offset)) / this.#meanEdge);
    }
    distances.sort((a, b) => a - b);
    return {
      samples: curve.count,
      lost: curve.status.filter((status) => !isThere(status)).length,
      deviation:
        distances.length === 0
          ? null
          : {
              median: distances[Math.floor(distances.length / 2)]!,
              max: distances.at(-1)!,
              samples: distances.length,
            },
      turningNoise: this.#turningNoise(curve, reference),
      breaks: this.#breaks(curve, affine),
      sharpestTurn: this.#sharpestTurn(curve),
    };
  }

  #sharpestTurn(curve: CurveSamples): CurveMeasures['sharpestTurn'] {
    const least = 1e-6 * this.#meanEdge;
    let sharpest: CurveMeasures['sharpestTurn'] = null;
    for (const [begin, end] of segments(curve)) {
      for (let i = begin + 1; i + 1 < end; i++) {
        if (![i - 1, i, i + 1].every((k) => isThere(curve.status[k]!))) continue;
        const here = at(curve.position, i);
        const before = subtract(here, at(curve.position, i - 1));
        const after = subtract(at(curve.position, i + 1), here);
        if (length(before) < least || length(after) < least) continue;
        const angle = Math.atan2(length(cross(before, after)), dot(before, after));
        const degrees = (angle * 180) / Math.PI;
        if (degrees > (sharpest?.degrees ?? 0)) sharpest = { degrees, t: curve.t[i]! };
      }
    }
    return sharpest;
  }

  #breaks(curve: CurveSamples, affine: ReferenceSamples | null): number {
    let breaks = 0;
    for (const [begin, end] of segments(curve)) {
      const numbers = Array.from({ length: end - begin - 1 }, (_, k) => begin + k);
      const steps = numbers.map((i) => this.#step(curve, i));
      const paces = numbers.map((i) => (affine ? stepOf(affine, i) : 1));
      steps.forEach((step, k) => {
        // A step without a neighbouring step cannot be compared.
        const beside = [k - 1, k + 1].filter((other) => typeof steps[other] === 'number');
        if (step === null || beside.length === 0 || step <= this.#meanEdge) return;
        const isLeap = beside.every(
          (other) => step * paces[other]! > leapRatio * steps[other]! * paces[k]!,
        );
        if (isLeap) breaks++;
      });
    }
    return breaks;
  }

  /** The distance from a sample to the next; null if one of the two samples is lost. */
  #step(curve: CurveSamples, i: number): number | null {
    if (!isThere(curve.status[i]!) || !isThere(curve.status[i + 1]!)) return null;
    return stepOf(curve, i);
  }

  #turningNoise(curve: CurveSamples, reference: ReferenceSamples): number | null {
    const samplesPerNoise = 128;
    let squares = 0;
    let count = 0;
    for (const [begin, end] of segments(curve)) {
      const stride = Math.max(1, Math.round((end - begin - 1) / (samplesPerNoise - 1)));
      for (let i = begin + stride; i + stride < end; i += stride) {
        const normal = this.#normalAt(curve, i);
        const turn = this.#turningAngle(curve, i, stride, normal);
        const truth = this.#turningAngle(reference, i, stride, normal);
        if (turn === null || truth === null) continue;
        // The difference is taken modulo a full turn.
        const difference = Math.abs(turn - truth);
        squares += Math.min(difference, 2 * Math.PI - difference) ** 2;
        count++;
      }
    }
    return count === 0 ? null : Math.sqrt(squares / count);
  }

  /** The angle by which the curve turns left at sample i; null if samples are lost or coincide. */
  #turningAngle(samples: ReferenceSamples, i: number, stride: number, normal: Vector) {
    for (const k of [i - stride, i, i + stride]) {
      if (!isThere(samples.status[k]!)) return null;
    }
    const here = at(samples.position, i);
    const before = subtract(here, at(samples.position, i - stride));
    const after = subtract(at(samples.position, i + stride), here);
    const least = (1e-9 * this.#meanEdge) ** 2;
    if (dot(before, before) <= least || dot(after, after) <= least) return null;
    return Math.atan2(dot(normal, cross(before, after)), dot(before, after));
  }

  #normalAt(samples: CurveSamples, i: number): Vector {
    const normal: Vector = [0, 0, 0];
    for (let k = 0; k < 3; k++) {
      const vertex = this.#triangles[3 * samples.face[i]! + k]!;
      for (let c = 0; c < 3; c++) {
        normal[c]! += samples.bary[3 * i + k]! * this.#normals[3 * vertex + c]!;
      }
    }
    const length = Math.sqrt(dot(normal, normal));
    return length > 0 ? [normal[0] / length, normal[1] / length, normal[2] / length] : normal;
  }
}

const stepOf = ({ position }: Pick<CurveSamples, 'position'>, i: number): number =>
  length(subtract(at(position, i + 1), at(position, i)));

/** The first sample of each segment, and the sample after its last. */
function segments(samples: CurveSamples): [number, number][] {
  const result: [number, number][] = [];
  for (let i = 0; i < samples.count; i++) {
    if (i === 0 || samples.segment[i] !== samples.segment[i - 1]) result.push([i, i]);
    result.at(-1)![1] = i + 1;
  }
  return result;
}

function vertexNormals(positions: Float64Array, triangles: Int32Array): Float64Array {
  const normals = new Float64Array(positions.length);
  for (let f = 0; f < triangles.length; f += 3) {
    const corners = [triangles[f]!, triangles[f + 1]!, triangles[f + 2]!];
    const [a, b, c] = corners.map((vertex) => at(positions, vertex)) as [Vector, Vector, Vector];
    const normal = cross(subtract(b, a), subtract(c, a));
    for (const vertex of corners) {
      for (let k = 0; k < 3; k++) normals[3 * vertex + k]! += normal[k]!;
    }
  }
  return normals;
}
