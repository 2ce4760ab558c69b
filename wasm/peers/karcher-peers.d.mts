import type {
  EngineFieldOptions,
  EngineMesh,
  EngineModule,
  EngineOptions,
} from '../karcher-engine.mjs';

/** The module of the comparison: the engine's own bindings and those of peers/bindings/*.cpp. */
export interface PeersModule extends EngineModule {
  /** `progress` returns whether to continue. */
  prepareMethod(
    mesh: EngineMesh,
    options: EngineMethodOptions,
    progress: ((landmarks: number) => boolean) | undefined,
  ): EnginePreparedMethod;
  comparedCurve(
    method: EnginePreparedMethod,
    points: Float64Array,
    first: Int32Array,
    t: Float64Array,
    weights: Float64Array,
  ): EngineComparedCurve;
  benchmark(mesh: EngineMesh): EngineBenchmark;
  /**
   * Ten numbers for each row of weights:
   * - whether the search converged;
   * - the number of its iterations;
   * - the numbers of all its geodesics, of geodesics cut at a joint, of cut geodesics whose
   *   original end has no smaller gradient than their start, and of geodesics whose joints and end
   *   have no smaller gradient than their start;
   * - whether the search ended inside a triangle;
   * - the gradients at the starts of its last three iterations, the last one first, with 0 for an
   *   iteration that did not take place.
   */
  newtonSteps(
    mesh: EngineMesh,
    points: Float64Array,
    weights: Float64Array,
    field: EngineFieldOptions,
    warm: boolean,
  ): Float64Array;
  basisWeights(
    name: string,
    parameters: Float64Array,
    samples: number,
  ): { points: number; t: Float64Array; weights: Float64Array };
}

/** The steps that the benchmark times. */
export interface EngineBenchmark {
  delete(): void;
  prepare(): void;
  edgeDijkstra(): void;
  ringGraph(rings: number): void;
  gradientOperator(): void;
  field(point: Float64Array, field: EngineFieldOptions): void;
  /**
   * Chooses a field and the vertices within a radius of its point. Returns the number of these
   * vertices.
   */
  chooseField(point: Float64Array, field: EngineFieldOptions, radius: number): number;
  /** Computes the chosen field again and reads it at the chosen vertices. */
  readField(): void;
  gradient(): void;
}

export interface EngineMethodOptions {
  method: string;
  field: EngineFieldOptions;
  seeds: string;
  delaunay: boolean;
  adaptive: boolean;
  landmarks: number;
  landmarkDistances: string;
}

export interface EnginePreparedMethod {
  delete(): void;
}

export interface EngineComparedCurve {
  delete(): void;
  movePoint(i: number, point: Float64Array): void;
  startAt(point: Float64Array): void;
  /** Computes one field, or up to `samples` samples. Returns true when the curve is complete. */
  advance(samples: number): boolean;
  samplesLeft(): number;
  lostByOwnRule(): number;
  /**
   * The numbers of computed and of requested log maps, and the milliseconds that the computed ones
   * took; null for methods without log maps.
   */
  logMaps(): { made: number; asked: number; ms: number } | null;
  /** The view (../view.ts) of the samples alone. */
  samples(): Uint8Array;
  /** The view of the path alone, in 64 bits and with points. */
  joined(): Uint8Array;
}

declare const createPeers: (options: EngineOptions) => Promise<PeersModule>;
export default createPeers;
