import type {
  CircleOptions,
  CurveOptions,
  CurvePoint,
  DistanceOptions,
  DrawnLeg,
  Ellipse,
  EllipseOptions,
  IsolineOptions,
  LongWorkOptions,
  MappedPoints,
  MeshInfo,
  Path,
  PointLike,
  SurfacePoint,
} from 'karcher';
import type { FileInfo, WrittenFormat } from 'karcher/formats';
import { type RemoteCurve, type RemoteMesh, WorkerClient } from 'karcher/own-worker';
import type { BooleanKind, Offset } from '../model/derived';
import type { FillPattern } from '../model/drawing';
import type { CurvesFormat, DrawnCurve } from '../model/drawn_curves';
import { type Enclosing, plain, type Vector } from '../model/figure';
import { type ToldLegs, waypointsOf, withDrawnLegs } from '../model/legs';
import type { MeshBlobs } from '../model/mesh_blobs';
import type { MeshSource, UpAxis } from '../model/meshes';
import type { SurfacePart } from '../model/parts';
import type {
  Fill,
  Measured,
  Pattern,
  Region,
  ShorterLeg,
  TracedCurve,
  TracedDistances,
  TracedIsolines,
} from '../model/traced';
import { sentCurve } from './curves_file';
import type { DerivedLines } from './derived';
import { type Edit, type Edited, edited } from './edits';
import type { Box, Extent } from './extent';
import type { DirectedPlaces, Framed, Step } from './framed';
import { tracedCircle, tracedCurve, tracedLines } from './traced';

export { KarcherError } from 'karcher/own-worker';

/** The error of a call that the user stopped. */
export class Stopped extends Error {
  constructor() {
    super('it was stopped before it was done');
  }
}

/** A client that reports the beginning of the first call and the end of the last one. */
class TellingClient extends WorkerClient {
  onBusy: (busy: boolean) => void = () => {};
  #calls = 0;

  get busy(): boolean {
    return this.#calls > 0;
  }

  override call(...call: Parameters<WorkerClient['call']>): Promise<unknown> {
    if (this.#calls++ === 0) this.onBusy(true);
    return super.call(...call).finally(() => {
      if (--this.#calls === 0) this.onBusy(false);
    });
  }
}

interface Loaded {
  mesh: RemoteMesh;
  arrays: MeshBlobs;
  file: FileInfo | null;
  up: UpAxis;
}

/** The places x, y, z of the corners. */
type Corners = [Vector, Vector, Vector];

/** The side and the rule of the enclosed region to compute; null for a line alone. */
export type AskedFill = Enclosing | null;

/** Lines and the region that they enclose; by default the smaller side, by the even-odd rule. */
export interface OutlinedShape extends Enclosing {
  outlines: readonly Path[];
}

/** The object of a curve, and the results to compute besides the curve's view. */
export interface CurveRequest {
  /** The id of the curve's object. A curve without an object ends after its view. */
  object?: number;
  /** The number of marks along the curve. */
  marks?: number;
  /** The enclosed region to compute. */
  fill?: AskedFill;
  /** Whether to return the path that the curve follows. */
  outlines?: boolean;
}

/** A curve whose points move repeatedly. The engine continues its legs from value to value. */
export class LooseCurve {
  #legs: readonly DrawnLeg[] | undefined;

  constructor(private readonly curve: RemoteCurve) {}

  /** The curve's point at a parameter. */
  pointAt(parameter: number): Promise<CurvePoint> {
    return this.curve.pointAt(parameter);
  }

  polyline(): Promise<Float32Array> {
    return this.curve.polyline();
  }

  /** Gives the curve a value with moved points, and returns its point at a parameter. */
  async placeOn(value: CurveOptions, parameter: number): Promise<CurvePoint> {
    const { curve } = this;
    this.#legs ??= (await curve.view()).drawnLegs;
    const points = value.points.map((_, i) => i);
    const wanted = withDrawnLegs(value, { legs: this.#legs, points });
    const [{ drawnLegs }, point] = await both(curve.set(wanted), curve.pointAt(parameter));
    this.#legs = drawnLegs;
    return point;
  }

  dispose(): void {
    // A worker that has ended has no curve.
    void this.curve.dispose().catch(() => {});
  }
}

/**
 * A surface in a worker of its own, with a curve for each object on it. After a change it computes
 * only changed parts. `stop` cancels the work under way. `close` ends the worker; its calls then
 * fail with a `KarcherError`.
 */
export class EngineClient {
  readonly #worker = new TellingClient(
    () => new Worker(new URL('./engine.ts', import.meta.url), { type: 'module' }),
  );
  #loaded: Loaded | null = null;
  /** The face of the last request for corners. */
  #cornersAsked: { face: number; corners: Promise<Corners> } | null = null;
  /** The curves by their objects' ids; null if the first requested value was no valid curve. */
  readonly #curves = new Map<number, Promise<RemoteCurve | null>>();
  /** A listener for a worker that ends by itself, for example because memory runs out. */
  onStopped: (() => void) | null = null;
  /** A listener for the finished fraction of long work, and the name of its stage. */
  onProgress: (done: number, stage: string) => void = () => {};

  private constructor() {
    this.#worker.onFatal = () => this.onStopped?.();
  }

  /** Starts a worker and creates the surface there. Ends the worker if that fails or is aborted. */
  static async load(source: MeshSource, work: LongWorkOptions = {}): Promise<EngineClient> {
    const client = new EngineClient();
    try {
      client.#loaded = (await client.#worker.call('load', [source, work])) as Loaded;
      return client;
    } catch (error) {
      client.close();
      throw error;
    }
  }

  /** Whether the engine still has to answer a call. */
  get busy(): boolean {
    return this.#worker.busy;
  }

  /** Sets the listener for the beginning of the first call and the end of the last one. */
  set onBusy(hear: (busy: boolean) => void) {
    this.#worker.onBusy = hear;
  }

  /**
   * Cancels the work under way, which fails with `Stopped`. If the worker is busy with a long call,
   * another worker with the surface and the loose curves replaces it. The next request for an
   * object's curve traces it again.
   */
  stop(): void {
    this.keepCurves([]);
    this.#cornersAsked = null;
    this.#worker.giveUp(new Stopped());
  }

  /** The surface in the worker. Its methods are calls of the worker. */
  get mesh(): RemoteMesh {
    return this.#loaded!.mesh;
  }

  /** The properties of the surface's file; null for other surfaces. */
  get file(): FileInfo | null {
    return this.#loaded!.file;
  }

  /** The axis of the surface's coordinates that seems to point up. */
  get up(): UpAxis {
    return this.#loaded!.up;
  }

  get info(): Readonly<MeshInfo> {
    return this.mesh.info;
  }

  /** Vertices and triangles, in the caller's order. */
  get arrays(): MeshBlobs {
    return this.#loaded!.arrays;
  }

  /** The places of a face's corners. */
  corners(face: number): Promise<Corners> {
    if (this.#cornersAsked?.face !== face) {
      const at = (...bary: Vector) => this.mesh.position({ face, bary });
      this.#cornersAsked = { face, corners: Promise.all([at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)]) };
    }
    return this.#cornersAsked.corners;
  }

  /** The view of a curve with a value, and the requested results. An object keeps its curve. */
  async curve(
    value: CurveOptions,
    { object, marks = 0, fill = null, outlines = false }: CurveRequest = {},
  ): Promise<TracedCurve> {
    const known = object === undefined ? null : await this.#curves.get(object);
    const curve = known ?? (await this.#first(object, value));
    try {
      // The client sends both calls at once, so that no other call comes between them.
      const [[view, marked], [filled, path]] = await both(
        both(
          known ? curve.set(value) : curve.view(),
          marks > 0 ? curve.equallySpaced(marks) : null,
        ),
        Promise.all([fill ? this.#fill(curve, fill) : null, outlines ? curve.path() : null]),
      );
      return { ...tracedCurve(view, marked, filled), outlines: path && [path] };
    } finally {
      if (object === undefined) void curve.dispose();
    }
  }

  /** Disposes of the curves of all objects but these. */
  keepCurves(objects: readonly number[]): void {
    for (const object of [...this.#curves.keys()]) {
      if (!objects.includes(object)) this.forget(object);
    }
  }

  /** Disposes of the curve of an object: its next curve starts afresh. */
  forget(object: number): void {
    const curve = this.#curves.get(object);
    this.#curves.delete(object);
    // A worker that has ended has no curve.
    void curve?.then((one) => one?.dispose()).catch(() => {});
  }

  /** The points that describe the present legs of an object's curve; null for shortest paths. */
  async toldLegs(object: number): Promise<ToldLegs> {
    const curve = await this.#curves.get(object);
    return (await curve?.value())?.legs?.map(waypointsOf) ?? [];
  }

  /** Shorter paths for the legs of a value's curve. That curve becomes the object's curve. */
  async shorterLegs(object: number, value: CurveOptions): Promise<ShorterLeg[]> {
    const curve = await this.#curveOf(object, value);
    const [, legs] = await both(curve.set(value), curve.legs());
    return legs.flatMap(({ path, shorter }, index) =>
      shorter ? [{ index, polyline: shorter.polyline(), part: shorter.length / path.length }] : [],
    );
  }

  /**
   * The point at which a value's curve is nearest to a place, with its measurements. That curve
   * becomes the object's curve.
   */
  async measure(
    object: number,
    value: CurveOptions,
    near: [number, number, number],
  ): Promise<Measured> {
    const curve = await this.#curveOf(object, value);
    const [view, { parameter, point, position }] = await both(
      curve.set(value),
      curve.nearest(near),
    );
    const [{ inSpace: tangent }, length] = await both(
      curve.tangentAt(parameter),
      curve.lengthAt(parameter),
    );
    return { parameter, point, position, length, wholeLength: view.length, tangent };
  }

  /** A curve that belongs to no object; the caller disposes of it. */
  async looseCurve(value: CurveOptions): Promise<LooseCurve> {
    return new LooseCurve(await this.mesh.curve(value));
  }

  /** The result of an edit of a value's curve. That curve becomes the object's curve. */
  async edited(object: number, value: CurveOptions, edit: Edit): Promise<Edited> {
    return edited(this.mesh, await this.#curveOf(object, value), value, edit);
  }

  async circle(
    center: PointLike,
    options: CircleOptions,
    fill: AskedFill = null,
  ): Promise<TracedCurve> {
    return this.#timed(() => this.mesh.circle(center, options), fill);
  }

  async ellipse(
    center: PointLike,
    options: EllipseOptions,
    fill: AskedFill = null,
  ): Promise<TracedCurve> {
    return this.#timed(() => this.mesh.ellipse(center, options), fill);
  }

  async isolines(
    center: PointLike,
    options: IsolineOptions,
    fill: AskedFill = null,
  ): Promise<TracedIsolines> {
    const started = performance.now();
    const paths = await this.mesh.isolines(center, options);
    const milliseconds = performance.now() - started;
    const filled = fill && paths.length > 0 ? await this.#fill(paths, fill) : null;
    return tracedLines(paths, milliseconds, filled);
  }

  /** Lines at a distance from outlines. */
  offset(
    outlines: readonly Path[],
    options: Offset & Enclosing,
    fill = false,
  ): Promise<TracedIsolines> {
    const closed = outlines.every((path) => path.closed);
    return this.#derived('offset', [outlines, { ...options, closed }, fill]);
  }

  /**
   * The outline of a union, intersection, difference or exclusion of the regions that outlines
   * enclose.
   */
  combined(
    shapes: readonly OutlinedShape[],
    kind: BooleanKind,
    fill = false,
  ): Promise<TracedIsolines> {
    return this.#derived('combined', [shapes, kind, fill]);
  }

  /**
   * The parts of the surface after a cut along outlines, the largest first. A positive thickness
   * turns them into shells.
   */
  async cut(outlines: readonly Path[], thickness: number): Promise<SurfacePart[]> {
    const progress = (done: number, stage: string) => this.onProgress(done, stage);
    const args = [this.mesh, outlines, thickness, { progress }];
    return (await this.#worker.call('cut', args)) as SurfacePart[];
  }

  /**
   * A part of the cut surface as a file, with the properties of the surface's own file and the
   * pieces of curves that lie on it.
   */
  async partFile(
    { thick, positions, triangles, faces }: Omit<SurfacePart, 'weights' | 'point'>,
    format: WrittenFormat,
    curves: readonly DrawnCurve[] = [],
  ): Promise<Uint8Array> {
    const more = { marks: this.file, sheets: thick ? 2 : 1, curves: curves.map(sentCurve) };
    const args = [this.mesh, { positions, triangles, faces }, thick, format, more];
    return (await this.#worker.call('partFile', args)) as Uint8Array;
  }

  /** Points of the surface as points of a part; null for points outside the part. */
  async pointsOnPart(
    { positions, triangles, faces }: SurfacePart,
    points: readonly SurfacePoint[],
  ): Promise<(SurfacePoint | null)[]> {
    const args = [this.mesh, { positions, triangles, faces }, points];
    return (await this.#worker.call('pointsOnPart', args)) as (SurfacePoint | null)[];
  }

  /** Curves on the surface as a file. All but CSV also have the surface and its properties. */
  async curvesFile(curves: readonly DrawnCurve[], format: CurvesFormat): Promise<Uint8Array> {
    const args = [this.mesh, curves.map(sentCurve), format, this.file];
    return (await this.#worker.call('curvesFile', args)) as Uint8Array;
  }

  async #derived(call: string, args: unknown[]): Promise<TracedIsolines> {
    const started = performance.now();
    const made = (await this.#worker.call(call, [this.mesh, ...args])) as DerivedLines;
    return tracedLines(made.paths, performance.now() - started, made.fill);
  }

  /** Distances along the surface from a point to every vertex. */
  async distances(
    from: PointLike,
    options: DistanceOptions,
    work: LongWorkOptions,
  ): Promise<TracedDistances> {
    const args = [this.mesh, from, options];
    return (await this.#worker.call('distances', args, undefined, work)) as TracedDistances;
  }

  /** Places and directions in a frame at their middle. Rejects if a place is unreachable. */
  framedAt(places: DirectedPlaces): Promise<Framed> {
    return this.#worker.call('framedAt', [this.mesh, places]) as Promise<Framed>;
  }

  /** The result of a step of a move on the surface. A single call keeps drags quick. */
  putDown(step: Step): Promise<MappedPoints> {
    return this.#worker.call('putDown', [this.mesh, step]) as Promise<MappedPoints>;
  }

  /** The rectangle along two axes around log vectors. Rejects if a place is unreachable. */
  boxAround(
    at: SurfacePoint,
    around: readonly Extent[],
    axes: readonly [Vector, Vector],
  ): Promise<Box> {
    const plainly = around.map(({ place, radius }) => ({ place: plain(place), radius }));
    return this.#worker.call('boxAround', [this.mesh, plain(at), plainly, axes]) as Promise<Box>;
  }

  get closed(): boolean {
    return this.#worker.disposed;
  }

  close(): void {
    this.#worker.dispose();
  }

  #fill(lines: RemoteCurve | Path[], fill: Enclosing): Promise<Fill> {
    return this.#worker.call('fill', [this.mesh, lines, fill]) as Promise<Fill>;
  }

  /** The centroid of a region. */
  centroid({ whole, parts, corners, boundary }: Region): Promise<SurfacePoint> {
    const args = [this.mesh, boundary, insideOf({ whole, parts, corners })];
    return this.#worker.call('centroid', args) as Promise<SurfacePoint>;
  }

  /** The pattern of a region; null if it would have too many lines, or the region has no border. */
  pattern(region: Region, kind: FillPattern, spacing: number): Promise<Pattern | null> {
    const { whole, parts, corners, area, boundary } = region;
    const args = [this.mesh, { whole, parts, corners, area, boundary }, kind, spacing];
    return this.#worker.call('pattern', args) as Promise<Pattern | null>;
  }

  async #timed(trace: () => Promise<Ellipse>, fill: AskedFill): Promise<TracedCurve> {
    const started = performance.now();
    const circle = await trace();
    const milliseconds = performance.now() - started;
    const filled = fill ? await this.#fill([circle.path], fill) : null;
    return tracedCircle(circle, () => milliseconds, filled);
  }

  async #curveOf(object: number, value: CurveOptions): Promise<RemoteCurve> {
    return (await this.#curves.get(object)) ?? (await this.#first(object, value));
  }

  #first(object: number | undefined, value: CurveOptions): Promise<RemoteCurve> {
    const curve = this.mesh.curve(value);
    if (object !== undefined)
      this.#curves.set(
        object,
        curve.catch(() => null),
      );
    return curve;
  }
}

/**
 * A point inside a region: the centroid of a whole face or, if the region has none, of the triangle
 * that covers the largest part of its face.
 */
function insideOf({ whole, parts, corners }: Pick<Region, 'whole' | 'parts' | 'corners'>) {
  if (whole.length > 0) return { face: whole[0]!, bary: [1 / 3, 1 / 3, 1 / 3] };
  let [best, most] = [0, -1];
  for (let i = 0; i < parts.length; i++) {
    const [ax, ay, bx, by, cx, cy] = corners.subarray(6 * i, 6 * i + 6);
    const area = Math.abs((bx! - ax!) * (cy! - ay!) - (by! - ay!) * (cx! - ax!));
    if (area > most) [best, most] = [i, area];
  }
  const mean = (k: number) =>
    [0, 2, 4].reduce((sum, at) => sum + corners[6 * best + at + k]! / 3, 0);
  const [u, v] = [mean(0), mean(1)];
  return { face: parts[best]!, bary: [1 - u - v, u, v] };
}

/** Both answers. If both fail, the second failure does not count as unhandled. */
const both = <A, B>(a: Promise<A>, b: Promise<B> | B): Promise<[A, B]> => Promise.all([a, b]);
