import type { CurveKind, CurveOptions, FieldOptions, SurfacePoint } from 'karcher';
import type { EngineClient } from '../worker/client';
import { Newest } from '../worker/newest';
import type { TracedCurve } from '../worker/protocol';
import type { CircleShape, Vector } from './document';
import { pointsNeeded } from './document';
import type { State } from './editor';
import { methodOptions, type Quality, qualityOf, refinedOptions } from './methods';
import { Refinement } from './refinement';
import { type Shift, shiftBetween } from './shift';

/** What the engine made of a state of the editor. */
export interface View {
  /** The revision that is shown. */
  revision: number;
  curve: TracedCurve | null;
  /** How good the curve is; null where the method knows no such words. */
  quality: Quality | null;
  /** Whether a better curve is awaited. */
  refining: boolean;
  /** How far the exact curve lies from the draft that it took the place of, in mean edges. */
  shift: Shift | null;
  /** Why a draft stays a draft, as a sentence. */
  notRefined: string | null;
  /** Geodesics between neighbouring control points, or the circle's radius. */
  legs: readonly Float32Array[];
  /** The polygon stands for the curve, which has too few points yet. */
  polygonOnly: boolean;
  circle: { radius: number; direction: Vector; rim: SurfacePoint } | null;
  /** Why there is no curve, as a sentence. */
  problem: string | null;
}

const emptyView: View = {
  revision: 0,
  curve: null,
  quality: null,
  refining: false,
  shift: null,
  notRefined: null,
  legs: [],
  polygonOnly: false,
  circle: null,
  problem: null,
};

const samplesPerSegment = 128;
const fewestLegsKept = 64;

/**
 * Keeps the view up to date with the editor: the newest state first, then its control polygon, and
 * once the edit is done the exact curve.
 */
export class Session {
  #client: EngineClient | null = null;
  #state: State | null = null;
  #view: View = emptyView;
  /** The newest state that was given to the engine. */
  #asked: State | null = null;
  readonly #refinement = new Refinement();
  /** Geodesics by their ends; null where there is none. */
  readonly #legs = new Map<string, Float32Array | null>();
  /** The legs that are shown, by their place, for while a drag outruns them. */
  #shownLegs: { epoch: number; legs: (Float32Array | null)[] } = { epoch: -1, legs: [] };
  readonly #newest = new Newest<State>(
    (state) => this.#trace(state),
    async () => (await this.#traceLeg()) || this.#refine(),
  );

  /** Called with every change of the view. */
  onView: (view: View) => void = () => {};
  /** Called when the engine begins with a curve, and when it has ended. */
  onBusy: (busy: boolean) => void = () => {};

  get view(): View {
    return this.#view;
  }

  /** Whether the newest state is traced, its polygon and the exact curve included. */
  get settled(): boolean {
    return !this.#newest.busy && !this.#refinement.busy;
  }

  /** Another surface: what was traced on the one before is dropped. */
  use(client: EngineClient): void {
    this.#client?.close();
    this.#client = client;
    this.#refinement.use(client);
    this.#legs.clear();
    this.#state = null;
    this.#asked = null;
    this.#newest.drop();
    this.#show(emptyView);
  }

  get client(): EngineClient | null {
    return this.#client;
  }

  update(state: State): void {
    this.#state = state;
    if (!this.#client) return;
    if (state.revision !== this.#asked?.revision) {
      this.#asked = state;
      this.#refinement.drop();
      this.#newest.push(state);
    } else if (!this.#newest.busy) {
      // A drag has ended: what it left is already traced.
      this.#refine();
    }
  }

  #show(part: Partial<View>): void {
    this.#view = { ...this.#view, ...part };
    this.onView(this.#view);
  }

  /** Whether an answer to a state may still be shown. */
  #current(client: EngineClient, state: State): boolean {
    return client === this.#client && state.epoch === this.#state?.epoch;
  }

  async #trace(state: State): Promise<void> {
    const client = this.#client;
    if (!client || client.closed) return;
    const { kind } = state.document;
    this.onBusy(true);
    try {
      const part =
        kind === 'circle'
          ? await this.#circle(client, state)
          : await this.#spline(client, state, kind);
      if (!this.#current(client, state)) return;
      const { revision } = state;
      const quality = part.curve ? qualityOf(state.method) : null;
      const fresh = { problem: null, quality, refining: false, shift: null, notRefined: null };
      this.#show({ ...fresh, ...part, revision, ...this.#polygon() });
    } catch (error) {
      if (!this.#current(client, state) || client.closed) return;
      const none = { curve: null, quality: null, refining: false, shift: null, circle: null };
      const problem = messageOf(error);
      this.#show({ ...none, problem, revision: state.revision, ...this.#polygon() });
    } finally {
      this.onBusy(false);
    }
  }

  async #spline(client: EngineClient, state: State, kind: CurveKind): Promise<Partial<View>> {
    const points = [...state.document.points];
    if (points.length < pointsNeeded[kind]) return { curve: null, circle: null };
    const curve = await client.curve(splineOptions(state, kind, methodOptions(state.method)));
    return { curve, circle: null };
  }

  async #circle(client: EngineClient, state: State): Promise<Partial<View>> {
    const { circle } = state.document;
    if (!circle) return { curve: null, circle: null, legs: [], polygonOnly: false };
    const { radius, direction, rim, path } = await resolveCircle(client, circle);
    const options = methodOptions(state.method);
    const shown = { circle: { radius, direction, rim }, legs: [path], polygonOnly: false };
    try {
      const curve = await client.circle({ ...options, center: circle.center, radius });
      return { curve, ...shown };
    } catch (error) {
      // The handles stay, so that the radius can be taken back.
      return { curve: null, ...shown, problem: messageOf(error) };
    }
  }

  /** Asks for the exact curve of what is shown, where it is a draft and nothing is dragged. */
  #refine(): false {
    const [state, view] = [this.#state, this.#view];
    if (!state || state.dragging || view.revision !== state.revision) return false;
    const options = refinedOptions(state.method);
    const draft = view.curve;
    if (!options || !draft || view.quality !== 'draft' || view.notRefined) return false;
    const unit = this.#client!.info.meanEdge;
    this.#refinement.request({
      revision: state.revision,
      trace: (client) => traceExactly(client, state, view, options),
      done: (curve) => {
        const shift = shiftBetween(draft.samples.position, curve.samples.position, unit);
        this.#show({ curve, quality: 'exact', refining: false, shift });
      },
      failed: (error) => this.#show({ refining: false, notRefined: messageOf(error) }),
    });
    if (!view.refining) this.#show({ refining: true });
    return false;
  }

  /** The polygon of the newest document: its legs that are known, or what a drag left behind. */
  #polygon(): Partial<View> {
    const state = this.#state;
    if (!state || state.document.kind === 'circle') return {};
    const { kind, points } = state.document;
    const before = this.#shownLegs.epoch === state.epoch ? this.#shownLegs.legs : [];
    const legs = pairsOf(points).map((pair, i) => {
      const leg = this.#legs.get(keyOf(...pair));
      return leg === undefined ? (before[i] ?? null) : leg;
    });
    this.#shownLegs = { epoch: state.epoch, legs };
    return {
      legs: legs.filter((leg) => leg !== null),
      polygonOnly: points.length < pointsNeeded[kind],
    };
  }

  /** Traces one leg that is missing; false when there is none. */
  async #traceLeg(): Promise<boolean> {
    const client = this.#client;
    const document = this.#state?.document;
    if (!client || client.closed || !document || document.kind === 'circle') return false;
    const pairs = pairsOf(document.points);
    const missing = pairs.find((pair) => !this.#legs.has(keyOf(...pair)));
    if (!missing) return false;
    if (this.#legs.size > fewestLegsKept + 4 * pairs.length) this.#forgetLegs(pairs);
    // Points on two components have no path between them: that leg stays away.
    const path = await client.shortestPath(...missing).catch(() => null);
    if (client !== this.#client) return false;
    this.#legs.set(keyOf(...missing), path?.polyline ?? null);
    this.#show(this.#polygon());
    return true;
  }

  /** Forgets the legs of what is no longer there. */
  #forgetLegs(pairs: readonly Pair[]): void {
    const used = new Set(pairs.map((pair) => keyOf(...pair)));
    for (const key of this.#legs.keys()) if (!used.has(key)) this.#legs.delete(key);
  }
}

function splineOptions(state: State, kind: CurveKind, options: FieldOptions): CurveOptions {
  return { ...options, kind, points: [...state.document.points], samples: samplesPerSegment };
}

/** What a view shows as a draft, with other options. */
function traceExactly(
  client: EngineClient,
  state: State,
  view: View,
  options: FieldOptions,
): Promise<TracedCurve> {
  const { kind, circle } = state.document;
  if (kind !== 'circle') return client.curve(splineOptions(state, kind, options));
  return client.circle({ ...options, center: circle!.center, radius: view.circle!.radius });
}

const messageOf = (error: unknown) => (error instanceof Error ? error.message : `${error}`);

interface ResolvedCircle {
  radius: number;
  direction: Vector;
  rim: SurfacePoint;
  path: Float32Array;
}

async function resolveCircle(
  client: EngineClient,
  { center, rim }: CircleShape,
): Promise<ResolvedCircle> {
  if ('face' in rim) {
    const { length, polyline } = await client.shortestPath(center, rim);
    return { radius: length, direction: directionOf(polyline), rim, path: polyline };
  }
  const { radius, direction } = rim;
  const { end, polyline } = await client.straightest(center, direction, radius);
  return { radius, direction, rim: end, path: polyline };
}

/** The first step of a polyline that is no repeated point; any direction when all are. */
function directionOf(polyline: Float32Array): Vector {
  for (let i = 3; i < polyline.length; i += 3) {
    const step = [0, 1, 2].map((axis) => polyline[i + axis]! - polyline[axis]!) as Vector;
    const length = Math.hypot(...step);
    if (length > 0) return step.map((value) => value / length) as Vector;
  }
  return [1, 0, 0];
}

type Pair = readonly [SurfacePoint, SurfacePoint];

const pairsOf = (points: readonly SurfacePoint[]): Pair[] =>
  points.slice(1).map((point, i) => [points[i]!, point]);

const keyOf = (a: SurfacePoint, b: SurfacePoint) =>
  [a, b].map(({ face, bary }) => `${face},${bary[1]},${bary[2]}`).join(';');
