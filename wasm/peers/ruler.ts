import type { Mesh } from '../mesh.js';
import type { Path } from '../path.js';
import { pause } from '../prepare.js';
import type { CurveSamples, LongWorkOptions, SurfacePoint } from '../types.js';
import { add, at, cross, dot, length, scaled, subtract, type Vector } from '../vectors.js';
import type { ReferenceSamples } from './measure.js';
import { isThere } from './status.js';
import type { CurvePlan } from './types.js';

/** The number of evenly spaced samples at which the ruler measures a curve's error. */
const rulerSamples = 33;

/**
 * The barycentric weight below which a point counts as lying on a side of its face. The same
 * number, in mean edges, is the length up to which a path's first pieces count as rounding errors.
 */
const onSide = 1e-6;

/**
 * The error of a curve's samples as centers of mass. Exact shortest paths measure this error for
 * every method, whatever distances the method itself uses.
 */
export interface RulerMeasures {
  /**
   * |sum of w_i log_x p_i| in mean edges: 0 at a center of mass. On a surface that bends little,
   * this length is about the distance to a center.
   */
  residual: { median: number; max: number } | null;
  /**
   * The energy of a sample is the sum of w_i d(x, p_i)^2. `median` is the median of the energies.
   * `excess` is the median of the differences from the reference's energies (null without a
   * reference). Both are in squared mean edges.
   */
  energy: { median: number; excess: number | null } | null;
  /**
   * The number of measured samples. They are the samples that are not lost among `rulerSamples`
   * evenly spaced samples, or among all samples if the curve has fewer.
   */
  measured: number;
  /** The number of samples chosen for the measurement. */
  of: number;
}

/** The measurements at each of a ruler's samples; NaN if the sample is lost. */
export interface RulerReading {
  /** The length of the weighted sum of log vectors, in units of the mesh. */
  residual: Float64Array;
  /** The weighted sum of squared distances, in squared units of the mesh. */
  energy: Float64Array;
}

/** A ruler, which measures curves of one plan on one mesh. */
export class Ruler {
  readonly #mesh: Mesh;
  readonly #plan: CurvePlan;
  readonly #positions: Float64Array;
  readonly #triangles: Int32Array;
  #reference: Float64Array | null = null;

  constructor(mesh: Mesh, plan: CurvePlan) {
    this.#mesh = mesh;
    this.#plan = plan;
    this.#positions = mesh.positions();
    this.#triangles = mesh.triangles();
  }

  /** The numbers of the samples to measure. */
  samplesOf(count: number): number[] {
    if (count <= rulerSamples) return Array.from({ length: count }, (_, i) => i);
    return Array.from({ length: rulerSamples }, (_, k) =>
      Math.round((k * (count - 1)) / (rulerSamples - 1)),
    );
  }

  /**
   * Takes the energies of the reference at the measured samples, for comparison in `measure`.
   * Rejects with the signal's reason.
   */
  async compareWith(
    reference: ReferenceSamples | CurveSamples,
    work: LongWorkOptions = {},
  ): Promise<void> {
    const { energy } = reference as ReferenceSamples;
    const samples = this.samplesOf(reference.count);
    if (energy) this.#reference = Float64Array.from(samples, (i) => energy[i]!);
    else this.#reference = (await this.read(reference as CurveSamples, work)).energy;
  }

  /** Measures the error of samples. Rejects with the signal's reason. */
  async measure(samples: CurveSamples, work: LongWorkOptions = {}): Promise<RulerMeasures> {
    const { residual, energy } = await this.read(samples, work);
    const { meanEdge } = this.#mesh.info;
    const residuals = residual.filter((value) => !Number.isNaN(value)).toSorted();
    const energies = energy.filter((value) => !Number.isNaN(value)).toSorted();
    const excess = energy
      .map((value, k) => value - (this.#reference?.[k] ?? Number.NaN))
      .filter((value) => !Number.isNaN(value))
      .toSorted();
    const scale = meanEdge ** 2;
    return {
      residual: residuals.length
        ? { median: middle(residuals) / meanEdge, max: residuals.at(-1)! / meanEdge }
        : null,
      energy: energies.length
        ? {
            median: middle(energies) / scale,
            excess: excess.length ? middle(excess) / scale : null,
          }
        : null,
      measured: residuals.length,
      of: residual.length,
    };
  }

  /**
   * The residuals and energies at the measured samples, in units of the mesh. Rejects with the
   * signal's reason.
   */
  async read(
    samples: CurveSamples,
    { progress, signal }: LongWorkOptions = {},
  ): Promise<RulerReading> {
    const chosen = this.samplesOf(samples.count);
    const reading: RulerReading = {
      residual: new Float64Array(chosen.length).fill(Number.NaN),
      energy: new Float64Array(chosen.length).fill(Number.NaN),
    };
    for (const [k, i] of chosen.entries()) {
      signal?.throwIfAborted();
      if (isThere(samples.status[i]!)) {
        const { residual, energy } = this.#readAt(samples, i);
        reading.residual[k] = residual;
        reading.energy[k] = energy;
      }
      progress?.((k + 1) / chosen.length, 'residual');
      // The pause lets a message that cancels the work arrive between two samples.
      await pause();
    }
    return reading;
  }

  #readAt({ face, bary, segment }: CurveSamples, i: number): { residual: number; energy: number } {
    const here: SurfacePoint = { face: face[i]!, bary: at(bary, i) };
    const { points, first, table } = this.#plan;
    const row = (i % table.t.length) * table.points;
    const steps: Vector[] = [];
    let energy = 0;
    const tangent = this.#tangentPlane(here);
    for (let k = 0; k < table.points; k++) {
      const weight = table.weights[row + k]!;
      if (weight === 0) continue;
      const path = this.#mesh.shortestPath(here, points[first[segment[i]!]! + k]!);
      energy += weight * path.length ** 2;
      const away = firstStep(path, onSide * this.#mesh.info.meanEdge);
      if (away) steps.push(scaled(tangent(away), weight * path.length));
    }
    return { residual: length(steps.reduce(add, [0, 0, 0])), energy };
  }

  /**
   * Returns a function for the directions of paths that leave a point. The function turns a
   * direction into the plane of the point's face.
   */
  #tangentPlane({ face, bary }: SurfacePoint): (direction: Vector) => Vector {
    const corners = this.#cornersOf(face);
    const normal = unit(normalOf(corners));
    const sides = [0, 1, 2].filter((k) => bary[k]! < onSide);
    if (sides.length !== 1) return (direction) => direction;
    // The side opposite to corner k, and the face behind it.
    const k = sides[0]!;
    const [from, to] = [(k + 1) % 3, (k + 2) % 3] as const;
    const along = unit(subtract(corners[to]!, corners[from]!));
    const inward = cross(normal, along);
    const behind = this.#faceBehind(face, from, to);
    const other = behind === null ? null : unit(normalOf(this.#cornersOf(behind)));
    return (direction) => {
      const part = dot(direction, along);
      const across = length(subtract(direction, scaled(along, part)));
      const leaves =
        other !== null && Math.abs(dot(direction, other)) < Math.abs(dot(direction, normal));
      const side = leaves || dot(direction, inward) < 0 ? -1 : 1;
      return add(scaled(along, part), scaled(inward, side * across));
    };
  }

  #cornersOf(face: number): [Vector, Vector, Vector] {
    const corner = (k: number) => at(this.#positions, this.#triangles[3 * face + k]!);
    return [corner(0), corner(1), corner(2)];
  }

  /** The face on the other side of an edge of a face; null at the boundary. */
  #faceBehind(face: number, from: number, to: number): number | null {
    const [a, b] = [this.#triangles[3 * face + from]!, this.#triangles[3 * face + to]!];
    for (let h = 0; h < this.#triangles.length; h++) {
      const f = Math.floor(h / 3);
      const next = 3 * f + ((h + 1) % 3);
      if (f === face) continue;
      const [tail, head] = [this.#triangles[h]!, this.#triangles[next]!];
      if ((tail === a && head === b) || (tail === b && head === a)) return f;
    }
    return null;
  }
}

const middle = (sorted: Float64Array): number => sorted[Math.floor(sorted.length / 2)]!;
const unit = (a: Vector): Vector => scaled(a, 1 / length(a));
const normalOf = ([a, b, c]: [Vector, Vector, Vector]) => cross(subtract(b, a), subtract(c, a));

/**
 * The direction in which a path leaves its start; null for a path that stays at its start. It is
 * the direction of the first piece longer than a rounding error, since the start may lie next to a
 * side.
 */
function firstStep(path: Path, least: number): Vector | null {
  const polyline = path.polyline({ bits: 64 });
  for (let i = 1; i < path.count; i++) {
    const step = subtract(at(polyline, i), at(polyline, i - 1));
    const size = length(step);
    if (size > least || (i === path.count - 1 && size > 0)) return scaled(step, 1 / size);
  }
  return null;
}
