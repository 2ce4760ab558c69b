import type {
  Circle,
  CircleOptions,
  CurveOptions,
  EllipseOptions,
  IsolineOptions,
  LongWorkOptions,
  MeshInfo,
  PointLike,
} from 'karcher';
import type { FileInfo } from 'karcher/formats';
import { type RemoteCurve, type RemoteMesh, WorkerClient } from 'karcher/own-worker';
import type { MeshSource, UpAxis } from '../model/meshes';
import type { Measured, ShorterLeg, TracedCurve, TracedIsolines } from '../model/traced';
import { type Edit, type Edited, edited } from './edits';
import { tracedCircle, tracedCurve } from './traced';

export { KarcherError } from 'karcher/own-worker';

interface Loaded {
  mesh: RemoteMesh;
  positions: Float64Array;
  triangles: Int32Array;
  file: FileInfo | null;
  up: UpAxis;
}

/**
 * A surface in a worker of its own, and the curve that is edited on it. `close` ends the worker and
 * every call that is under way; every call fails with a `KarcherError`.
 */
export class EngineClient {
  readonly #worker = new WorkerClient(
    new Worker(new URL('./engine.ts', import.meta.url), { type: 'module' }),
  );
  #loaded: Loaded | null = null;
  #curve: Promise<RemoteCurve | null> | null = null;
  /** Called when the worker ends by itself, as when memory runs out. */
  onStopped: (() => void) | null = null;

  private constructor() {
    this.#worker.onFatal = () => this.onStopped?.();
  }

  /** Starts a worker and makes the surface there; ends the worker if that fails or is aborted. */
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

  /** What is asked of the surface itself. */
  get mesh(): RemoteMesh {
    return this.#loaded!.mesh;
  }

  /** What the file is that the surface comes from; null of another surface. */
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

  /** x, y, z of the vertices, in the caller's order. */
  positions(): Float64Array {
    return this.#loaded!.positions;
  }

  /** Vertices of the triangles, in the caller's order. */
  triangles(): Int32Array {
    return this.#loaded!.triangles;
  }

  /**
   * The edited curve, with so many points marked along it. The legs that meet at the `dragged` point
   * are continued.
   */
  async curve(value: CurveOptions, marks = 0, dragged?: number): Promise<TracedCurve> {
    const before = await this.#curve;
    const curve = before ?? (await this.#first(value));
    // Both are asked at once: nothing comes in between.
    const [view, marked] = await both(
      before ? curve.set(value, dragged === undefined ? {} : { dragged }) : curve.view(),
      marks > 0 ? curve.equallySpaced(marks) : null,
    );
    return tracedCurve(view, marked);
  }

  /**
   * The legs of the edited curve with a dragged point where the value has it, by the points that they
   * go through; the shortest are null.
   */
  async drawnLegs(
    value: CurveOptions,
    dragged: number,
  ): Promise<NonNullable<CurveOptions['legs']>> {
    const curve = await this.#curve;
    if (!curve) return [];
    const [, drawn] = await both(curve.set(value, { dragged }), curve.value());
    return drawn.legs ?? [];
  }

  /** Shorter ways that legs of the curve of a value could take, the edited one from then on. */
  async shorterLegs(value: CurveOptions): Promise<ShorterLeg[]> {
    const curve = (await this.#curve) ?? (await this.#first(value));
    const [, legs] = await both(curve.set(value), curve.legs());
    return legs.flatMap(({ path, shorter }, index) =>
      shorter ? [{ index, polyline: shorter.polyline(), part: shorter.length / path.length }] : [],
    );
  }

  /** A curve beside it. */
  async otherCurve(value: CurveOptions): Promise<TracedCurve> {
    const curve = await this.mesh.curve(value);
    try {
      return tracedCurve(await curve.view(), null);
    } finally {
      void curve.dispose();
    }
  }

  /** The edited curve, which has this value, where it is nearest to a place. */
  async measure(value: CurveOptions, near: [number, number, number]): Promise<Measured> {
    const curve = (await this.#curve) ?? (await this.#first(value));
    const [view, { parameter, position }] = await both(curve.set(value), curve.nearest(near));
    const [{ inSpace: tangent }, length] = await both(
      curve.tangentAt(parameter),
      curve.lengthAt(parameter),
    );
    return { parameter, position, length, wholeLength: view.length, tangent };
  }

  /** What an edit makes of the curve of a value, which is the edited one from then on. */
  async edited(value: CurveOptions, edit: Edit): Promise<Edited> {
    const curve = (await this.#curve) ?? (await this.#first(value));
    return edited(this.mesh, curve, value, edit);
  }

  async circle(center: PointLike, options: CircleOptions): Promise<TracedCurve> {
    return timed(() => this.mesh.circle(center, options));
  }

  async ellipse(center: PointLike, options: EllipseOptions): Promise<TracedCurve> {
    return timed(() => this.mesh.ellipse(center, options));
  }

  async isolines(center: PointLike, options: IsolineOptions): Promise<TracedIsolines> {
    const started = performance.now();
    const lines = (await this.mesh.isolines(center, options)).map((line) => ({
      ...{ closed: line.closed, length: line.length },
      polyline: line.polyline(),
    }));
    const length = lines.reduce((sum, line) => sum + line.length, 0);
    return { lines, length, milliseconds: performance.now() - started };
  }

  get closed(): boolean {
    return this.#worker.disposed;
  }

  close(): void {
    this.#worker.dispose();
  }

  #first(value: CurveOptions): Promise<RemoteCurve> {
    const curve = this.mesh.curve(value);
    this.#curve = curve.catch(() => null);
    return curve;
  }
}

/** Both answers; where one fails the other's failure is no other one. */
const both = <A, B>(a: Promise<A>, b: Promise<B> | B): Promise<[A, B]> => Promise.all([a, b]);

async function timed(trace: () => Promise<Circle>): Promise<TracedCurve> {
  const started = performance.now();
  return tracedCircle(await trace(), () => performance.now() - started);
}
