import { checkArray, checkInteger, toFloat64 } from '../check.js';
import { Engine, type Handle } from '../engine.js';
import { KarcherError } from '../errors.js';
import { Karcher } from '../karcher.js';
import { Mesh } from '../mesh.js';
import { engineFieldOptions } from '../options.js';
import { wirePoints } from '../points.js';
import type { FieldOptions, LongWorkOptions, PointLike } from '../types.js';
import type { EngineBenchmark, PeersModule } from './karcher-peers.mjs';
import { prepareMethod } from './prepared_method.js';
import type {
  CurvePlan,
  MethodOptions,
  NewtonSteps,
  PreparedCurves,
  WeightTable,
} from './types.js';

/** The number of values that the module's `newtonSteps` returns for each search. */
const numbersASearch = 10;

/** The engine and the methods that it is compared with. */
export class Peers {
  /** The engine of this module, which creates the meshes that the methods take. */
  readonly karcher: Karcher;
  readonly #engine: Engine;
  readonly #module: PeersModule;

  /** @internal `loadPeers` creates one. */
  constructor(module: PeersModule) {
    this.#module = module;
    this.#engine = new Engine(module);
    this.karcher = new Karcher(this.#engine);
  }

  /**
   * Prepares a method on a mesh, which must outlive the method. After each step (some vertices of a
   * graph, or a landmark of an embedding) the preparation calls `work.progress` and checks the
   * signal. Rejects with the signal's reason, and with `KarcherError`: noEmbedding, degenerateFace,
   * unreachable, badArgument.
   */
  async prepare(
    mesh: Mesh,
    options: MethodOptions,
    work: LongWorkOptions = {},
  ): Promise<PreparedCurves> {
    this.#checkMesh(mesh);
    return prepareMethod(this.#module, mesh, options, work);
  }

  /** The weights of a Bernstein basis of a given degree at evenly spaced parameters. */
  bezier(degree: number, samples: number): WeightTable {
    return this.#table('bezier', [checkInteger(degree, 'the degree')], samples);
  }

  /** The weights of the uniform cubic B-spline. */
  bspline(samples: number): WeightTable {
    return this.#table('bspline', [], samples);
  }

  /** The weights of a rational Bezier curve whose points have these weights. */
  rational(weights: readonly number[], samples: number): WeightTable {
    return this.#table('rational', weights, samples);
  }

  /** The weights of rational interpolation in barycentric form (Ramanantoanina, Hormann 2021). */
  barycentric(betas: readonly number[], samples: number): WeightTable {
    return this.#table('barycentric', betas, samples);
  }

  /**
   * The plan of a curve that suits the number of its points: a shortest path for two, a quadratic
   * Bezier curve for three, a uniform cubic B-spline for four and more.
   */
  plan(points: CurvePlan['points'], samples: number): CurvePlan {
    checkArray(points, 'the points');
    if (points.length < 2) {
      throw new KarcherError('tooFewPoints', `a curve needs 2 points, not ${points.length}`);
    }
    if (points.length < 4) {
      const table = this.bezier(points.length - 1, samples);
      return { points, first: [0], table, shape: { kind: 'bezier' } };
    }
    const first = Array.from({ length: points.length - 3 }, (_, j) => j);
    return { points, first, table: this.bspline(samples), shape: { kind: 'bspline' } };
  }

  /**
   * The steps that `karcher bench` times, on a mesh that must outlive them.
   * @internal
   */
  benchmark(mesh: Mesh): Handle<EngineBenchmark> {
    this.#checkMesh(mesh);
    return mesh.handle.made('the benchmark', (target) => this.#module.benchmark(target));
  }

  /**
   * Records of the paper's searches, one for each row of weights. Searches begin at the point with
   * the largest weight. If `warm`, a search that follows a converged search begins where that
   * search ended.
   * @internal
   */
  newtonSteps(
    mesh: Mesh,
    points: readonly PointLike[],
    weights: ArrayLike<number>,
    { warm, ...field }: Pick<FieldOptions, 'solver' | 'rings'> & { warm: boolean },
  ): NewtonSteps[] {
    this.#checkMesh(mesh);
    const options = engineFieldOptions({ method: 'paper', ...field });
    const wire = wirePoints(points);
    const rows = toFloat64(weights, 'the weights');
    const numbers = mesh.handle.call((engineMesh) =>
      this.#module.newtonSteps(engineMesh, wire, rows, options, warm),
    );
    return Array.from({ length: numbers.length / numbersASearch }, (_, k) => {
      const [converged, iterations, traced, shortened, needed, stuck, inside, ...gradients] =
        numbers.slice(numbersASearch * k, numbersASearch * (k + 1)) as unknown as number[];
      return {
        ...{ converged: converged === 1, inside: inside === 1, iterations: iterations! },
        ...{ traced: traced!, shortened: shortened!, needed: needed!, stuck: stuck!, gradients },
      };
    });
  }

  #checkMesh(mesh: Mesh): void {
    if (mesh instanceof Mesh && mesh.handle.engine === this.#engine) return;
    throw new KarcherError(
      'badArgument',
      'the mesh must be one that `karcher` of these peers made',
    );
  }

  #table(name: string, parameters: readonly number[], samples: number): WeightTable {
    const numbers = toFloat64(parameters, 'the parameters of the basis');
    const count = checkInteger(samples, 'the number of samples');
    return this.#engine.call(() => this.#module.basisWeights(name, numbers, count));
  }
}
