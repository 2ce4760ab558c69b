import { checkInteger } from '../check.js';
import type { Curve } from '../curve.js';
import { KarcherError } from '../errors.js';
import type { Mesh } from '../mesh.js';
import type { CurveSamples, PointLike } from '../types.js';
import type {
  ComparedCenter,
  ComparedLine,
  CurvePlan,
  MethodCurve,
  MethodOptions,
  PreparedCurves,
} from './types.js';

/**
 * b/Surf (C. Mancinelli, G. Nazzaro, F. Pellacini, E. Puppo, "b/Surf: Interactive Bezier Splines on Surface
 * Meshes", 2022) as the engine has it, the curve of `levels: 'limit'`: repeated averages of two points along
 * geodesics. It needs no fields and nothing prepared, and its points are no centers of mass.
 */
export class SubdivisionMethod implements PreparedCurves {
  readonly options: MethodOptions;
  readonly prepareMs = 0;
  readonly #mesh: Mesh;
  readonly #curves = new Set<SubdivisionCurve>();
  #disposed = false;

  /** @internal `Peers.prepare` makes one. */
  constructor(mesh: Mesh, options: MethodOptions) {
    this.#mesh = mesh;
    this.options = { ...options };
  }

  curve(plan: CurvePlan): MethodCurve {
    if (this.#disposed) throw disposedOf('the method');
    const curve = new SubdivisionCurve(this.#mesh, plan, (disposed) => {
      this.#curves.delete(disposed);
    });
    this.#curves.add(curve);
    return curve;
  }

  centerOfMass(): ComparedCenter {
    throw new KarcherError(
      'badArgument',
      'b/Surf averages two points at a time, and has no center',
    );
  }

  dispose(): void {
    this.#disposed = true;
    for (const curve of this.#curves) curve.dispose();
  }
}

const disposedOf = (what: string) => new KarcherError('disposed', `${what} has been disposed of`);

class SubdivisionCurve implements MethodCurve {
  readonly #mesh: Mesh;
  readonly #plan: CurvePlan;
  readonly #moved = new Map<number, PointLike>();
  readonly #forget: (curve: SubdivisionCurve) => void;
  #curve: Curve | null = null;
  #disposed = false;
  /** Averages of two points need none. */
  readonly fieldsMs = 0;

  constructor(mesh: Mesh, plan: CurvePlan, forget: (curve: SubdivisionCurve) => void) {
    if (!plan.shape) {
      throw new KarcherError('badArgument', 'b/Surf makes Bezier curves and B-splines only');
    }
    this.#mesh = mesh;
    this.#plan = plan;
    this.#forget = forget;
  }

  movePoint(i: number, point: PointLike): void {
    this.#check();
    const { length } = this.#plan.points;
    const index = checkInteger(i, 'the number of the control point');
    if (index < 0 || index >= length) {
      throw new KarcherError('badIndex', `there is no control point ${index}: there are ${length}`);
    }
    this.#moved.set(index, point);
  }

  /** Nothing is searched for. */
  startAt(): void {}

  finish(): number {
    this.#check();
    const start = performance.now();
    if (this.#curve) {
      for (const [i, point] of this.#moved) this.#curve.movePoint(i, point);
    } else {
      const { points, table, shape } = this.#plan;
      const all = points.map((point, i) => this.#moved.get(i) ?? point);
      const samples = table.t.length;
      this.#curve = this.#mesh.curve({ ...shape!, points: all, samples, levels: 'limit' });
    }
    this.#moved.clear();
    return performance.now() - start;
  }

  async trace(): Promise<number> {
    return this.finish();
  }

  samples(): CurveSamples {
    return this.#traced().samples();
  }

  line(): ComparedLine {
    const curve = this.#traced();
    return { path: curve.path(), unconverged: curve.unconverged() };
  }

  lostByOwnRule(): number {
    return this.samples().status.filter((status) => status !== 'converged').length;
  }

  logMaps(): null {
    return null;
  }

  dispose(): void {
    this.#disposed = true;
    this.#curve?.dispose();
    this.#curve = null;
    this.#forget(this);
  }

  #check(): void {
    if (this.#disposed) throw disposedOf('the curve');
  }

  #traced(): Curve {
    this.#check();
    if (this.#curve && this.#moved.size === 0) return this.#curve;
    this.finish();
    return this.#curve!;
  }
}
