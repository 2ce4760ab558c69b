import type {
  BooleanOperation,
  Certificate,
  CurveKind,
  CurvePoints,
  CutPart,
  FileMarks,
  FillRule,
  Frame,
  MeanWeights,
  MeshInfo,
  Method,
  Solver,
  Star,
  Status,
  Uniqueness,
} from './types.js';

/**
 * The WebAssembly module as the facade sees it: the exports of bindings/*.cpp. A point is four
 * numbers: face, b0, b1, b2. In arguments, NaN, vertex, 0, 0 stands for a vertex. Faces and
 * vertices have the caller's numbers. After a failed call, `takeFailure` returns the reason once,
 * and the result of the call has no meaning.
 */
export interface EngineModule {
  takeFailure(): { code: string; message: string } | undefined;
  /** The names of statuses. The status number of a sample is an index of this list. */
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
  /** A number for each triangle: 0 outside the region, 1 inside, 2 if it is partly inside. */
  share: Uint8Array;
  /** The triangle of each entry of `sides`, in ascending order. */
  triangles: Int32Array;
  /**
   * The sides of the region within partial triangles, four numbers for each: the second and third
   * weight of one end, and then of the other end.
   */
  sides: Float64Array;
  /** Whether the region lies left of its first outline, for a region of one shape. */
  isLeft?: boolean;
}

/**
 * The result of the exp map or of a mirror: four numbers for each point, three for each direction.
 */
export interface EngineMapped {
  points: Float64Array;
  directions: Float64Array;
  remaining: Float64Array;
}

/** The planes of a mesh's tangent vectors. */
export interface EnginePlanes {
  /** The face in whose plane each vertex has its vectors; -1 for a dropped vertex. */
  faceOf: Int32Array;
  /** 1 for each face that the import turned over; else 0. */
  turnedOver: Uint8Array;
}

/** What remains of the caller's triangles after the import. */
export interface EngineKept {
  /** 1 for each triangle that is a part of the surface; 0 if it repeats another or has no area. */
  areFaces: Uint8Array;
  /** The vertices at both ends of each edge that has a single face. */
  boundary: Int32Array;
}

/**
 * The vertices of triangles on the surface. Where several fans of faces meet at a vertex, it has its
 * own number in one fan, and numbers after those of all vertices in the others.
 */
export interface EngineFans {
  /**
   * The numbers of the vertices of each triangle; -1 for triangles that repeat another, or of which
   * the surface lacks a vertex.
   */
  corners: Int32Array;
  /** The vertex of each number after those of all vertices. */
  copies: Int32Array;
  /** The connected part of each number; -1 for vertices that no face uses. */
  parts: Int32Array;
}

export interface EngineMesh {
  delete(): void;
  info(): MeshInfo;
  /** The number of the caller's vertices, before repairs. */
  inputVertices(): number;
  positions(): Float64Array;
  triangles(): Int32Array;
  kept(): EngineKept;
  fans(): EngineFans;
  marks(): FileMarks;
  subdivided(levels: number): EngineMesh;
  checkedPoint(point: Float64Array): Float64Array;
  position(point: Float64Array): [number, number, number];
  positionsOf(points: Float64Array): Float64Array;
  normal(point: Float64Array): [number, number, number];
  frame(point: Float64Array): Frame;
  planes(): EnginePlanes;
  nearestPoint(place: Float64Array): { point: Float64Array; distance: number };
  /** Vertices beyond the radius are NaN. */
  distance(from: Float64Array, field: EngineFieldOptions, radius: number): Float64Array;
  shortestPath(from: Float64Array, to: Float64Array): EnginePath;
  logMap(
    from: Float64Array,
    points: Float64Array,
    directions: Float64Array,
  ): { vectors: Float64Array; directions: Float64Array };
  logMapOfVertices(from: Float64Array, radius: number): Float64Array;
  expMap(from: Float64Array, vectors: Float64Array, directions: Float64Array): EngineMapped;
  mirror(line: Float64Array, points: Float64Array, directions: Float64Array): EngineMapped;
  transport(from: Float64Array, to: Float64Array, vectors: Float64Array): Float64Array;
  transportAlong(line: Float64Array, vectors: Float64Array): Float64Array;
  /**
   * The points at `lengths` from the start, and then `count` equally spaced ones. A `length` of 0
   * stands for the sum of the chords.
   */
  pointsAlong(
    line: Float64Array,
    lengths: Float64Array,
    length: number,
    count: number,
  ): { points: Float64Array; lengths: Float64Array };
  carried(points: Float64Array, levels: number): Float64Array;
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
  centersOfMass(
    points: Float64Array,
    rows: Float64Array,
    start: Float64Array,
    normalize: boolean,
    isChecked: boolean,
    field: EngineFieldOptions,
  ): { point: Float64Array; position: Float64Array; energy: Float64Array; status: Status[] };
  /** `given` is empty for equal weights. */
  weightsOf(
    point: Float64Array,
    points: Float64Array,
    given: Float64Array,
    nonNegative: boolean,
    field: EngineFieldOptions,
  ): MeanWeights;
  /** `distances` has the distances of one point after another. */
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
    distances: Float64Array,
    side: number,
    corners: number,
    miterLimit: number,
  ): EnginePath[];
  distanceFromPaths(outlines: Float64Array[], points: Float64Array): Float64Array;
  /**
   * The regions of shapes. `counts` has the number of outlines of each shape. `insides` has an
   * array for each shape: a point inside the shape, or the inner side of its first outline (1 for
   * the left, 0 for the right), or an empty array.
   */
  regions(
    outlines: Float64Array[],
    counts: Int32Array,
    insides: Float64Array[],
    rule: FillRule,
    combine: BooleanOperation | 'none',
  ): EngineRegion[];
  cut(outlines: Float64Array[], report: (done: number) => boolean): CutPart[];
  curve(value: EngineCurveValue): EngineCurve;
}

/** A curve's value, as the engine receives it. */
export interface EngineCurveValue {
  points: Float64Array;
  /**
   * The points through which each leg passes: none for a shortest path. The list is empty if all
   * legs are shortest paths.
   */
  legs: Float64Array[];
  /** 1 for each drawn leg, whose list has all points of the leg, including both ends; else 0. */
  areDrawn: Int32Array;
  shape: EngineCurveShape;
  sampling: EngineSampling;
  field: EngineFieldOptions;
}

/** The options for sampling and drawing a curve. */
export interface EngineSampling {
  samples: number;
  /** The tolerance, or 0 for a fixed number of samples. */
  tolerance: number;
  /** Whether the curve's own crossings of edges join the samples, instead of geodesics. */
  exact: boolean;
  /** The number of levels, -1 for `auto`, or -2 for the limit. */
  levels: number;
  /** The fewest levels of `auto`. */
  leastLevels: number;
  /** The tolerance of automatic levels, in mean edges. */
  levelsTolerance: number;
}

/** The shape of a curve. Arrays that its kind does not use are empty. */
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
  /** The legs of a curve's value, as in `EngineCurveValue`. */
  legs?: Float64Array[];
}

export interface EngineCurvePoint {
  parameter: number;
  point: Float64Array;
  position: [number, number, number];
  status: Status;
}

/** A path as arrays, with one entry (or three) for each point. */
export interface EnginePath {
  closed: boolean;
  length: number;
  face: Int32Array;
  bary: Float64Array;
  position: Float64Array;
  lengths: Float64Array;
}

/**
 * Whether a view has 64-bit instead of 32-bit positions, and whether it has the faces and weights
 * of the path's points.
 */
export interface EngineViewOptions {
  inDouble: boolean;
  withPoints: boolean;
}

export interface EngineCircle {
  /**
   * The view (view.ts). It has 64-bit positions, and the faces and weights of the path's points.
   */
  view: Uint8Array;
  notShortest: Int32Array;
  /** The deviation; undefined for ellipses, which have none. */
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

/** What each edit of a curve sets. The edits have the names of methods of `Curve`. */
export interface EngineCurveEdits {
  movePoint: Float64Array;
  /** Moves a point and continues its legs from their present course. */
  dragPoint: Float64Array;
  insertPoint: Float64Array;
  removePoint: undefined;
  /** The point's new number. */
  movePointInOrder: number;
  reverse: undefined;
  setKind: CurveKind;
  setClosed: boolean;
  setWeight: number;
  setBeta: number;
  setPoints: Float64Array;
  setWeights: Float64Array;
  setBetas: Float64Array;
  /** The parameter of the new control point. */
  insertOnCurve: number;
}

export interface EngineCurve {
  delete(): void;
  /**
   * Makes an edit of control point `i`, or of the whole curve. Returns the number of a control
   * point that it inserted on the curve. An edit that fails changes nothing.
   */
  edit<Name extends keyof EngineCurveEdits>(
    name: Name,
    i: number,
    to: EngineCurveEdits[Name] | undefined,
  ): number;
  /** Changes the curve into the one that a value describes, and returns its view (view.ts). */
  set(value: EngineCurveValue, options: EngineViewOptions): Uint8Array;
  view(options: EngineViewOptions): Uint8Array;
  /** The curve's value. Arrays that its kind does not use are empty. */
  value(): EngineCurveParts;
  legs(): { path: EnginePath; shorter?: EnginePath }[];
  splitAt(parameter: number): EngineCurveParts[];
  joined(other: EngineCurve): EngineCurveParts;
  pointCount(): number;
  fieldsComputed(): number;
  /** The deviation, or NaN if it does not exist. */
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

/** Builds the graph of the solver `graph` in slices of work. */
export interface EngineGraphBuilder {
  delete(): void;
  /** Adds the next `vertices` vertices. Returns true when the graph is complete. */
  advance(vertices: number): boolean;
  /** The completed fraction, from 0 to 1. */
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
