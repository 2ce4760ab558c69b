import type {
  BooleanOperation,
  Certificate,
  CurveKind,
  CurvePoints,
  CutPart,
  FileMarks,
  FillRule,
  MeanWeights,
  MeshInfo,
  Method,
  Solver,
  Star,
  Status,
  Uniqueness,
} from './types.js';

/**
 * The WebAssembly module as the facade sees it: what bindings/*.cpp export.
 *
 * A point travels as four numbers: face, b0, b1, b2, and to the engine also as NaN, vertex, 0, 0;
 * faces and vertices are the caller's. After a
 * call that failed `takeFailure` returns why, once, and the call's own result means nothing.
 */
export interface EngineModule {
  takeFailure(): { code: string; message: string } | undefined;
  /** Statuses by the numbers that samples give them. */
  statusNames(): Status[];
  allocatedBytes(): number;
  /** `weld` is negative for the default. */
  meshFromObj(
    bytes: Uint8Array,
    parts: Int32Array | null,
    repair: boolean,
    weld: number,
  ): EngineMesh;
  meshFromArrays(
    positions: Float64Array,
    triangles: Int32Array,
    repair: boolean,
    weld: number,
  ): EngineMesh;
  meshFromPolygons(
    positions: Float64Array,
    corners: Int32Array,
    sizes: Int32Array,
    repair: boolean,
    weld: number,
  ): EngineMesh;
  builtInShape(name: string, triangles: number): EngineMesh;
}

export interface EngineFieldOptions {
  method: Method;
  solver: Solver;
  rings: number;
  star: Star;
}

export interface EngineRegion {
  area: number;
  perimeter: number;
  boundary: EnginePath[];
  /** Per triangle 0 where nothing of it lies in the region, 1 where all of it does, 2 for a part. */
  share: Uint8Array;
  /** Of the sides of such parts the triangles, in order, ... */
  triangles: Int32Array;
  /** Four numbers each: the second and third weight of one end, and those of the other. */
  sides: Float64Array;
  /** Of a region of one shape: whether it lies left of its first outline. */
  isLeft?: boolean;
}

/** What the exp map leads to: four numbers a point, three a direction. */
export interface EngineMapped {
  points: Float64Array;
  directions: Float64Array;
  remaining: Float64Array;
}

export interface EngineMesh {
  delete(): void;
  info(): MeshInfo;
  /** The caller's vertices, before repairs. */
  inputVertices(): number;
  positions(): Float64Array;
  triangles(): Int32Array;
  marks(): FileMarks;
  subdivided(levels: number): EngineMesh;
  checkedPoint(point: Float64Array): Float64Array;
  position(point: Float64Array): [number, number, number];
  positionsOf(points: Float64Array): Float64Array;
  normal(point: Float64Array): [number, number, number];
  nearestPoint(place: Float64Array): { point: Float64Array; distance: number };
  distance(from: Float64Array, field: EngineFieldOptions): Float64Array;
  shortestPath(from: Float64Array, to: Float64Array): EnginePath;
  logMap(
    from: Float64Array,
    points: Float64Array,
    directions: Float64Array,
  ): { vectors: Float64Array; directions: Float64Array };
  logMapOfVertices(from: Float64Array): Float64Array;
  expMap(from: Float64Array, vectors: Float64Array, directions: Float64Array): EngineMapped;
  mirror(line: Float64Array, points: Float64Array, directions: Float64Array): EngineMapped;
  transport(from: Float64Array, to: Float64Array, vectors: Float64Array): Float64Array;
  straightest(
    from: Float64Array,
    direction: Float64Array,
    length: number,
  ): {
    path: EnginePath;
    end: Float64Array;
    stop: 'complete' | 'boundary' | 'limit';
    remaining: number;
  };
  hasRingGraph(rings: number): boolean;
  graphBuilder(rings: number): EngineGraphBuilder;
  prepareFields(field: EngineFieldOptions): void;
  /** `start` is empty for the engine's choice. */
  centerOfMass(
    points: Float64Array,
    weights: Float64Array,
    start: Float64Array,
    normalize: boolean,
    looksForOthers: boolean,
    certifies: boolean,
    field: EngineFieldOptions,
  ): EngineMean;
  /** `given` is empty for equal weights. */
  centersOfMass(
    points: Float64Array,
    rows: Float64Array,
    start: Float64Array,
    normalize: boolean,
    isChecked: boolean,
    field: EngineFieldOptions,
  ): { point: Float64Array; position: Float64Array; energy: Float64Array; status: Status[] };
  weightsOf(
    point: Float64Array,
    points: Float64Array,
    given: Float64Array,
    nonNegative: boolean,
    field: EngineFieldOptions,
  ): MeanWeights;
  /** `distances`: one array after another. */
  centerOfMassOfDistances(
    distances: Float64Array,
    weights: Float64Array,
    start: Float64Array,
    normalize: boolean,
  ): EngineMean;
  circle(
    center: Float64Array,
    radius: number,
    arcs: number | undefined,
    samples: number,
    levels: number,
    field: EngineFieldOptions,
    tolerance: number,
  ): EngineCircle;
  ellipse(
    center: Float64Array,
    along: number,
    across: number,
    direction: Float64Array,
    arcs: number | undefined,
    samples: number,
    levels: number,
    field: EngineFieldOptions,
  ): EngineCircle;
  isolines(
    center: Float64Array,
    radius: number,
    exact: boolean,
    field: EngineFieldOptions,
  ): EnginePath[];
  /** The side is 1 for the left, -1 for the right, 0 for both. */
  offset(
    outlines: Float64Array[],
    distance: number,
    side: number,
    corners: number,
    miterLimit: number,
  ): EnginePath[];
  distanceFromPaths(outlines: Float64Array[], points: Float64Array): Float64Array;
  /** Of each shape `counts` has the number of its outlines, `insides` a point, none, or 1 for the left of its first outline, 0 for the right. */
  regions(
    outlines: Float64Array[],
    counts: Int32Array,
    insides: Float64Array[],
    rule: FillRule,
    combine: BooleanOperation | 'none',
  ): EngineRegion[];
  cut(outlines: Float64Array[]): CutPart[];
  curve(value: EngineCurveValue): EngineCurve;
}

/** A curve as it is given. */
export interface EngineCurveValue {
  points: Float64Array;
  /** The points that each leg goes through, none for the shortest; none at all where all are. */
  legs: Float64Array[];
  /** For each whether it is all its points, with its ends. */
  areDrawn: Int32Array;
  shape: EngineCurveShape;
  sampling: EngineSampling;
  field: EngineFieldOptions;
}

/** How a curve is sampled and drawn. */
export interface EngineSampling {
  samples: number;
  /** 0 for a fixed number of samples. */
  tolerance: number;
  /** Whether crossings of edges lie between the samples, not geodesics. */
  exact: boolean;
  /** -1 for as many as fit, -2 for the limit. */
  levels: number;
  /** Of those that fit. */
  leastLevels: number;
  /** Mean edges. */
  levelsTolerance: number;
}

/** Arrays are empty where there are none. */
export interface EngineCurveShape {
  kind: CurveKind;
  closed: boolean;
  degree: number;
  clamped: boolean;
  knots: Float64Array;
  weights: Float64Array;
  betas: Float64Array;
  centripetal: boolean;
  basis?: ((points: number, t: number) => Float64Array) | undefined;
}

/** A curve as data. */
export interface EngineCurveParts extends EngineCurveShape {
  points: Float64Array;
  /** Of a curve's value, as in `EngineCurveValue`. */
  legs?: Float64Array[];
}

export interface EngineCurvePoint {
  parameter: number;
  point: Float64Array;
  position: [number, number, number];
  status: Status;
}

/** A path in arrays over its points. */
export interface EnginePath {
  closed: boolean;
  length: number;
  face: Int32Array;
  bary: Float64Array;
  position: Float64Array;
  lengths: Float64Array;
}

/** What a view holds of a path: positions in 64 bits, and the faces and weights of its points. */
export interface EngineViewOptions {
  inDouble: boolean;
  withPoints: boolean;
}

export interface EngineCircle {
  /** Of 64 bits, with points. */
  view: Uint8Array;
  notShortest: Int32Array;
  /** Undefined of ellipses, which hide it. */
  deviation: number;
}

export interface EngineMean {
  point: Float64Array;
  position: [number, number, number];
  status: Status;
  iterations: number;
  energy: number;
  uniqueness: Uniqueness;
  otherMinima: EngineMinimum[];
  certificate?: Certificate;
}

export interface EngineMinimum {
  point: Float64Array;
  position: [number, number, number];
  energy: number;
}

/** Each edit makes it another curve, whole, or fails and changes nothing. */
export interface EngineCurveEdits {
  movePoint(i: number, point: Float64Array): void;
  /** The same, with its legs continued from where they lie. */
  dragPoint(i: number, point: Float64Array): void;
  insertPoint(i: number, point: Float64Array): void;
  removePoint(i: number): void;
  movePointInOrder(from: number, to: number): void;
  reverse(): void;
  setKind(kind: CurveKind): void;
  setClosed(closed: boolean): void;
  setWeight(i: number, weight: number): void;
  setBeta(i: number, beta: number): void;
  setPoints(points: Float64Array): void;
  setWeights(weights: Float64Array): void;
  setBetas(betas: Float64Array): void;
  /** Returns the number of the new control point. */
  insertOnCurve(parameter: number): number;
}

export interface EngineCurve extends EngineCurveEdits {
  delete(): void;
  /** Makes it the curve of a value: its view (view.ts). */
  set(value: EngineCurveValue, options: EngineViewOptions): Uint8Array;
  view(options: EngineViewOptions): Uint8Array;
  /** What it is; arrays are empty where there are none. */
  value(): EngineCurveParts;
  legs(): { path: EnginePath; shorter?: EnginePath }[];
  splitAt(parameter: number): EngineCurveParts[];
  joined(other: EngineCurve): EngineCurveParts;
  pointCount(): number;
  fieldsComputed(): number;
  /** NaN where there is none. */
  deviation(): number;
  pointAt(parameter: number): EngineCurvePoint;
  tangentAt(parameter: number): EngineCurvePoint & {
    inFace: [number, number, number];
    inSpace: [number, number, number];
  };
  nearest(place: Float64Array): EngineCurvePoint & { distance: number };
  lengthAt(parameter: number): number;
  pointAtLength(length: number): EngineCurvePoint;
  equallySpaced(count: number): CurvePoints;
}

/** The graph of the graph solver, built in slices. */
export interface EngineGraphBuilder {
  delete(): void;
  /** True when all is done. */
  advance(vertices: number): boolean;
  /** From 0 to 1. */
  progress(): number;
}

export interface EngineOptions {
  instantiateWasm(
    imports: Record<string, Record<string, never>>,
    done: (instance: object) => void,
  ): object;
}

declare const createEngine: (options: EngineOptions) => Promise<EngineModule>;
export default createEngine;
