import type {
  EngineFieldOptions,
  EngineMesh,
  EngineModule,
  EngineOptions,
  EngineSamples,
} from '../karcher-engine.mjs';
import type { ComparedPath } from './types.js';

/** The module of the comparison: the engine's own bindings and those of peers/bindings/*.cpp. */
export interface PeersModule extends EngineModule {
  /** `progress` returns whether to go on. */
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
  basisWeights(
    name: string,
    parameters: Float64Array,
    samples: number,
  ): { points: number; t: Float64Array; weights: Float64Array };
}

export interface EngineMethodOptions {
  method: string;
  field: EngineFieldOptions;
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
  /** Makes one field or up to so many samples; true when nothing is left. */
  advance(samples: number): boolean;
  samplesLeft(): number;
  samples(): EngineSamples;
  path(): ComparedPath;
}

declare const createPeers: (options: EngineOptions) => Promise<PeersModule>;
export default createPeers;
