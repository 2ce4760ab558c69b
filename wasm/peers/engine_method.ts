import { checkInteger } from '../check.js';
import type { Curve } from '../curve.js';
import { KarcherError } from '../errors.js';
import type { Mesh } from '../mesh.js';
import type { CurveLevels, CurveSamples, CurveTimes, PointLike } from '../types.js';
import { isThere } from './status.js';
import type {
  ComparedCenter,
  ComparedLine,
  ComparedMethod,
  CurvePlan,
  MethodCurve,
  MethodOptions,
  PreparedCurves,
} from './types.js';

/** The methods that are curves of the engine, each with its option `levels` and its name. */
const engineMethods = {
  /**
   * b/Surf (C. Mancinelli, G. Nazzaro, F. Pellacini, E. Puppo, "b/Surf: Interactive Bezier Splines
   * on Surface Meshes", 2022) by the engine: repeated averages of two points along geodesics. It
   * needs no fields, and its points are not centers of mass.
   */
  bSurf: { levels: 'limit', name: 'b/Surf' },
  /** Our default, which first refines the control polygon as often as necessary. */
  leveled: { levels: 'auto', name: 'a refined curve' },
} as const;

export type EngineMethodName = keyof typeof engineMethods;

/** Whether a method's curves are curves of the engine. */
export const isOfEngine = (method: ComparedMethod): method is EngineMethodName =>
  method in engineMethods;

/** A compared method whose curves are curves of the engine. It needs no preparation. */
export class EngineMethod implements PreparedCurves {
  readonly options: MethodOptions;
  readonly prepareMs = 0;
  readonly #mesh: Mesh;
  readonly #method: EngineMethodName;
  readonly #curves = new Set<EngineCurve>();
  #disposed = false;

  /** @internal `Peers.prepare` creates one. */
  constructor(mesh: Mesh, options: MethodOptions & { method: EngineMethodName }) {
    this.#mesh = mesh;
    this.#method = options.method;
    this.options = { ...options };
  }

  curve(plan: CurvePlan): MethodCurve {
    if (this.#disposed) throw disposedOf('the method');
    const { levels = engineMethods[this.#method].levels } = this.options;
    const curve = new EngineCurve(this.#mesh, this.#method, levels, plan, (disposed) => {
      this.#curves.delete(disposed);
    });
    this.#curves.add(curve);
    return curve;
  }

  centerOfMass(): ComparedCenter {
    const { name } = engineMethods[this.#method];
    throw new KarcherError('badArgument', `${name} has no single center`);
  }

  dispose(): void {
    this.#disposed = true;
    for (const curve of this.#curves) curve.dispose();
  }
}

const disposedOf = (what: string) => new KarcherError('disposed', `${what} has been disposed of`);

class EngineCurve implements MethodCurve {
  readonly #mesh: Mesh;
  readonly #levels: CurveLevels;
  readonly #plan: CurvePlan;
  readonly #moved = new Map<number, PointLike>();
  readonly #forget: (curve: EngineCurve) => void;
  #curve: Curve | null = null;
  #disposed = false;
  #fieldsMs = 0;

  constructor(
    mesh: Mesh,
    method: EngineMethodName,
    levels: CurveLevels,
    plan: CurvePlan,
    forget: (curve: EngineCurve) => void,
  ) {
    if (!plan.shape) {
      const { name } = engineMethods[method];
      throw new KarcherError('badArgument', `${name} is a Bezier curve or a B-spline only`);
    }
    this.#mesh = mesh;
    this.#levels = levels;
    this.#plan = plan;
    this.#forget = forget;
  }

  /**
   * The milliseconds that the fields of the last trace took. Averages of two points need no fields.
   */
  get fieldsMs(): number {
    return this.#fieldsMs;
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

  /** Has no effect, since the engine chooses the starts of its searches. */
  startAt(): void {}

  finish(): number {
    this.#check();
    let milliseconds = 0;
    this.#fieldsMs = 0;
    const count = ({ polygon, fields, trace, bridge }: CurveTimes) => {
      milliseconds += polygon + fields + trace + bridge;
      this.#fieldsMs += fields;
    };
    if (this.#curve) {
      for (const [i, point] of this.#moved) {
        this.#curve.movePoint(i, point);
        count(this.#curve.times());
      }
    } else {
      const { points, table, shape } = this.#plan;
      const all = points.map((point, i) => this.#moved.get(i) ?? point);
      const samples = table.t.length;
      const levels = this.#levels;
      this.#curve = this.#mesh.curve({ ...shape!, points: all, samples, levels });
      count(this.#curve.times());
    }
    this.#moved.clear();
    return milliseconds;
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
    return this.samples().status.filter((status) => !isThere(status)).length;
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
