import type { MeshInfo } from './types.js';

/**
 * The WebAssembly module as the facade sees it: what bindings/*.cpp export.
 *
 * A point travels as four numbers: face, b0, b1, b2; faces and vertices are the caller's. After a
 * call that failed `takeFailure` returns why, once, and the call's own result means nothing.
 */
export interface EngineModule {
  takeFailure(): { code: string; message: string } | undefined;
  allocatedBytes(): number;
  meshFromObj(bytes: Uint8Array): EngineMesh;
  meshFromArrays(positions: Float64Array, triangles: Int32Array): EngineMesh;
  builtInShape(name: string, triangles: number): EngineMesh;
}

export interface EngineMesh {
  delete(): void;
  info(): MeshInfo;
  positions(): Float64Array;
  triangles(): Int32Array;
  subdivided(levels: number): EngineMesh;
  checkedPoint(point: Float64Array): Float64Array;
  vertexPoint(vertex: number): Float64Array;
  position(point: Float64Array): [number, number, number];
  straightest(
    from: Float64Array,
    direction: Float64Array,
    length: number,
  ): { end: Float64Array; remaining: number; polyline: Float64Array };
}

export interface EngineOptions {
  wasmBinary?: Uint8Array;
  locateFile?: (name: string) => string;
}

declare const createEngine: (options: EngineOptions) => Promise<EngineModule>;
export default createEngine;
