import type { DrawnLeg, SurfacePoint } from 'karcher';
import { activeObject } from '../../model/drawing';
import {
  type Figure,
  type Inside,
  isCurve,
  isRound,
  pointsNeeded,
  type Spline,
  type Vector,
} from '../../model/figure';
import type { DrawnBefore } from '../../model/legs';
import { methodOptions, type Quality, refinedOptions } from '../../model/methods';
import { legsOfAnchors } from '../../model/pen_legs';
import { isSource, resolvedFigure } from '../../model/sources';
import { curveOptions, splineFrom, splineOf, usesLegs } from '../../model/splines';
import type { Measured, Pattern } from '../../model/traced';
import { type EngineClient, Stopped } from '../../worker/client';
import type { Edit } from '../../worker/edits';
import type { State } from '../state/state';
import { asksFill, BesideObjects } from './beside';
import {
  compute,
  curveValueOf,
  messageOf,
  noFill,
  nothing,
  qualityShown,
  type Shown,
  shiftOf,
  withUniqueness,
} from './compute';
import { Drag, DragTracing } from './drag';
import { linesOf, type ObjectLines } from './lines';
import { Newest } from './newest';
import { type Patterned, Patterns } from './patterns';
import { Refinement } from './refinement';
import { shorterLegs } from './shorter_legs';
import { type Ends, geodesicEnds, ShortestLegs } from './shortest_legs';
import { emptyView, type View } from './view';

/**
 * The view shows a shorter path only if the path is shorter than its leg by more than this
 * fraction.
 */
const leastGain = 0.02;

/** The sentence that replaces a curve whose computation was stopped. */
const stoppedHint = 'it was stopped; an edit or another method computes it again';

/** The pause after a display of legs, as a multiple of the time that the display took. */
const restPart = 5;

/** Replaces a failed answer by null. Throws the error again if it reports a stop. */
function unlessStopped(error: unknown): null {
  if (error instanceof Stopped) throw error;
  return null;
}

/**
 * Keeps the view up to date with the editor: the newest state first, then the geodesics beside it,
 * and after an edit the exact curve.
 */
export class Session {
  #client: EngineClient | null = null;
  #state: State | null = null;
  #view: View = emptyView;
  /** The newest state that the engine received. */
  #asked: State | null = null;
  readonly #dragTracing = new DragTracing();
  #drag: Drag | null = null;
  /** The drawn legs of figures' curves. */
  #drawn = new WeakMap<Figure, readonly DrawnLeg[]>();
  /** The figure whose legs were last compared with the shortest paths. */
  #compared: Figure | null = null;
  /** Whether the view has other samples or levels than the figure, because of a drag. */
  #coarse = false;
  readonly #legs = new ShortestLegs();
  /** Newly traced legs wait until `#legsRest`; `#legsUnseen` says whether some are waiting. */
  #legsRest = 0;
  #legsUnseen = false;
  readonly #others = new BesideObjects(() => this.#newest.wake());
  readonly #patterns = new Patterns((error) => this.onFailure(error));
  readonly #refinement = new Refinement<Shown>();
  readonly #newest = new Newest<State>(
    (state) => this.#trace(state),
    async () =>
      (await this.#traceLeg()) ||
      (await this.#traceOther()) ||
      (await this.#makePattern()) ||
      (await this.#compareLegs()) ||
      this.#refine(),
  );

  /** A listener for changes of the view. */
  onView: (view: View) => void = () => {};
  /** A listener for the beginning and the end of the engine's work. */
  onBusy: (busy: boolean) => void = () => {};
  /** A listener for the progress of the engine's work, if it reports any. */
  onProgress: (done: number, stage: string) => void = () => {};
  /** A listener for errors: a requested edit is impossible, or a pattern fails. */
  onFailure: (error: unknown) => void = () => {};

  get view(): View {
    return this.#view;
  }

  /** The figure at the end of its drag, with the legs of its last step. */
  ended(figure: Figure): Figure {
    return this.#drag?.ended(figure) ?? figure;
  }

  /**
   * The side that a figure encloses in the view; null if it encloses no region, or if the side is
   * unknown.
   */
  insideOf(figure: Figure): Inside | null {
    return figure.inside ?? this.#others.insideOf(figure);
  }

  /** Whether the newest state is complete, with the geodesics and the exact curve. */
  get settled(): boolean {
    return !this.#newest.busy && !this.#refinement.busy && !this.#others.resting;
  }

  /** Uses the engine of another surface. Results of the previous one then have no effect. */
  use(client: EngineClient): void {
    if (this.#client) {
      this.#client.onBusy = () => {};
      this.#client.close();
    }
    this.#client = client;
    this.onBusy(false);
    client.onBusy = (busy) => this.onBusy(busy);
    client.onProgress = (done, stage) => this.onProgress(done, stage);
    this.#refinement.use(client);
    this.#legs.clear();
    this.#others.clear();
    this.#state = null;
    this.#asked = null;
    this.#drag = null;
    this.#drawn = new WeakMap();
    this.#compared = null;
    this.#newest.drop();
    this.#show(emptyView);
  }

  get client(): EngineClient | null {
    return this.#client;
  }

  /** Stops the engine's computation. Only another figure or method starts it again. */
  stop(): void {
    this.#client?.stop();
  }

  update(given: State): void {
    const resolved = resolvedFigure(given.drawing, activeObject(given.drawing));
    const state = resolved === given.figure ? given : { ...given, figure: resolved };
    if (state.drawing.active !== this.#state?.drawing.active) {
      this.#dragTracing.forget();
    }
    const drag = this.#state?.dragging ? this.#drag : null;
    this.#state = state;
    const isDrag = state.dragged.length > 0 && usesLegs(state.figure.kind);
    this.#drag = isDrag ? (drag?.has(state) ? drag : new Drag(state)) : null;
    if (!this.#client) return;
    if (state.revision !== this.#asked?.revision) {
      this.#asked = state;
      this.#refinement.drop();
      this.#newest.push(state);
    } else if ((this.#coarse || drag !== null) && !state.dragging) this.#newest.push(state);
    else if (!this.#newest.busy) {
      // The drag has ended after the trace of its last step. Work that waited meanwhile continues.
      this.#newest.wake();
    }
  }

  /** The lines of objects as paths. */
  async linesOf(ids: readonly number[]): Promise<ObjectLines[]> {
    const [state, client] = [this.#state, this.#client];
    return state && client ? linesOf(client, state, ids, this.#others) : [];
  }

  /** Measures the visible curve where it is nearest to a place; null if that is impossible. */
  async measured(near: Vector): Promise<Measured | null> {
    const [state, view] = [this.#state, this.#view];
    const isShown = view.curve && view.revision === state?.revision;
    if (!state || !isShown || state.dragging || !isCurve(state.figure.kind)) return null;
    const refined = view.quality === 'exact' ? refinedOptions(state.method) : null;
    const client = refined ? this.#refinement.client : this.#client;
    const options = refined ?? methodOptions(state.method);
    const value = client && (await curveValueOf(client, state.figure, options).catch(() => null));
    if (!value) return null;
    const measured = await client.measure(state.drawing.active, value, near).catch(() => null);
    return this.#state?.revision === state.revision ? (measured ?? null) : null;
  }

  /**
   * A sentence about the problem of a spline, which need not be visible; null without a problem.
   * The view does not change.
   */
  async problemWith(spline: Spline): Promise<string | null> {
    const [client, state] = [this.#client, this.#state];
    if (!client || !state) return null;
    const options = curveOptions(spline, methodOptions(state.method));
    return client.curve(options).then(() => null, messageOf);
  }

  /**
   * The curves after an edit of the figure's curve, and the index of an inserted point; null if the
   * edit is impossible, or the figure has changed meanwhile.
   */
  async reshaped(
    edit: Exclude<Edit, { type: 'join' }> | { type: 'join'; other: Spline },
  ): Promise<{ splines: Spline[]; point: number | null } | null> {
    const [client, state] = [this.#client, this.#state];
    const spline = state && splineOf(state.figure);
    if (!client || !spline) return null;
    const options = (one: Spline) => curveOptions(one, methodOptions(state.method));
    const wanted = edit.type === 'join' ? { ...edit, other: options(edit.other) } : edit;
    const made = await client
      .edited(state.drawing.active, options(spline), wanted)
      .catch((error) => {
        if (!client.closed) this.onFailure(error);
        return null;
      });
    if (this.#state?.revision !== state.revision || client !== this.#client) return null;
    return made && { ...made, splines: made.curves.map((curve) => splineFrom(curve, spline)) };
  }

  /**
   * A B-spline's own knots after an edit; null if it has none, or if the engine cannot find them,
   * for example because the points define no curve.
   */
  async knotsAfter(spline: Spline, edit: Edit): Promise<number[] | null> {
    const [client, state] = [this.#client, this.#state];
    if (!client || !state) return null;
    const options = curveOptions(spline, methodOptions(state.method));
    const made = await client.edited(state.drawing.active, options, edit).catch(() => null);
    const knots = made?.curves[0]?.knots;
    return knots === undefined || typeof knots === 'string' ? null : Array.from(knots);
  }

  #show(part: Partial<View>): void {
    this.#view = { ...this.#view, ...part };
    this.onView(this.#view);
  }

  /** Whether the view may still show an answer to a state. */
  #current(client: EngineClient, state: State): boolean {
    return client === this.#client && state.epoch === this.#state?.epoch;
  }

  async #trace(state: State): Promise<void> {
    const client = this.#client;
    if (!client || client.closed) return;
    const { method } = state;
    try {
      const drag = this.#drag?.has(state) ? this.#drag : null;
      const ids = state.drawing.objects.map(({ id }) => id);
      for (const one of [client, this.#refinement.client]) one?.keepCurves(ids);
      const active = activeObject(state.drawing);
      const fill = asksFill(state.drawing, active);
      const known = state.dragging ? null : this.#others.known(state.figure, method, fill);
      if (known) {
        this.#coarse = false;
        this.#dragTracing.rested(state.figure, known.shown);
        this.#showTraced(state, known.shown, known.quality);
        return;
      }
      const { figure, coarse } = this.#dragTracing.traced(state);
      let stopped = false;
      this.#coarse = coarse;
      const computed = async () => {
        const answer = await compute(client, figure, methodOptions(method), {
          object: state.drawing.active,
          draft: refinedOptions(method) !== null,
          drawnBefore: drag ? await this.#drawnBefore(client, state, drag) : undefined,
          uniqueness: true,
          fill,
          outlines: isSource(state.drawing, active.id),
          outlinesOf: this.#others.outlinesOf(client, method),
        });
        this.#others.tell(state.figure, method, answer);
        // After a problem the drawn legs stay, so that a drag continues them.
        const legs = answer.problem ? null : (answer.curve?.drawnLegs ?? []);
        if (legs) this.#drawn.set(state.figure, legs);
        if (legs && drag) drag.legs = legs;
        return answer;
      };
      const shown = await computed().catch((error) => {
        if (client.closed) throw error;
        stopped = error instanceof Stopped;
        const problem = stopped ? stoppedHint : messageOf(error);
        return { ...nothing, problem, fill: fill ? noFill : null };
      });
      if (!this.#current(client, state)) return;
      const quality = qualityShown(shown, method);
      if (!coarse) this.#dragTracing.rested(figure, shown);
      if (!coarse && !state.dragging && !stopped) {
        this.#others.keep(figure, { method, shown, quality }, state.drawing);
      }
      this.#dragTracing.stepped(state.dragging, figure, shown);
      this.#showTraced(state, shown, quality);
      if (drag && shown.curve) {
        // A release cannot wait for the engine, so each step asks.
        const told = await client.toldLegs(state.drawing.active);
        drag.told = figure.kind === 'pen' ? legsOfAnchors(told) : told;
      }
    } catch {
      // The engine has stopped; a new one receives its open requests.
    }
  }

  #showTraced(state: State, traced: Shown, quality: Quality | null): void {
    const { visible, fill } = activeObject(state.drawing);
    // The trace may contain the region of an object that shows no fill.
    const shown = visible ? { ...traced, fill: fill > 0 ? traced.fill : null } : nothing;
    // Shorter paths of another figure may be longer than the legs of this one.
    const shorter = this.#compared === state.figure ? this.#view.shorter : [];
    // Hidden objects have no quality; otherwise the engine would compute a better form.
    const fresh = {
      ...{ quality: visible ? quality : null, refining: false },
      ...{ shift: null, notRefined: null, shorter },
    };
    const { revision } = state;
    this.#show({ ...fresh, ...shown, revision, ...this.#beside(shown) });
  }

  /**
   * The legs that a drag continues: the legs of its last step or, before the first step, those of
   * its base figure.
   */
  async #drawnBefore(client: EngineClient, state: State, drag: Drag): Promise<DrawnBefore> {
    const { base, points } = drag;
    drag.legs ??= this.#drawn.get(base) ?? null;
    if (!drag.legs) {
      const { figure } = this.#dragTracing.traced({ ...state, figure: base, dragging: true });
      const value = await curveValueOf(client, figure, methodOptions(state.method));
      const object = state.drawing.active;
      const curve = value && (await client.curve(value, { object }).catch(unlessStopped));
      drag.legs = curve?.drawnLegs ?? [];
    }
    return { legs: drag.legs, points };
  }

  /** Looks for paths that are shorter than the legs of the newest figure. */
  async #compareLegs(): Promise<boolean> {
    const [client, state] = [this.#client, this.#state];
    if (!client || !state || state.dragging || this.#compared === state.figure) return false;
    if (!isCurve(state.figure.kind)) return false;
    // Without a curve no legs exist.
    if (this.#view.problem) return false;
    const { figure, method, drawing } = state;
    this.#compared = figure;
    const options = methodOptions(method);
    const found = await shorterLegs(client, drawing.active, figure, options).catch(() => null);
    if (this.#state?.figure !== figure || client !== this.#client) return false;
    const shorter = found?.filter(({ part }) => part < 1 - leastGain) ?? [];
    if (shorter.length > 0 || this.#view.shorter.length > 0) this.#show({ shorter });
    return true;
  }

  /** Requests the exact form of the view, if it is a draft and no drag is under way. */
  #refine(): false {
    const [state, draft] = [this.#state, this.#view];
    if (!state || state.dragging || draft.revision !== state.revision) return false;
    const options = refinedOptions(state.method);
    if (!options || draft.quality !== 'draft' || draft.notRefined) return false;
    const unit = this.#client!.info.meanEdge;
    this.#refinement.request({
      revision: state.revision,
      compute: (client) => {
        const active = activeObject(state.drawing);
        const { id } = active;
        return compute(client, state.figure, options, {
          ...{ object: id, fill: asksFill(state.drawing, active) },
          outlines: isSource(state.drawing, id),
          certificate: true,
        });
      },
      done: (found) => {
        const exact = { ...found, center: withUniqueness(found.center, draft.center) };
        const refined = { quality: 'exact', refining: false } as const;
        const { figure, method, drawing } = state;
        this.#others.tell(figure, method, exact);
        this.#others.keep(figure, { method, shown: exact, quality: 'exact' }, drawing);
        const fill = activeObject(drawing).fill > 0 ? exact.fill : null;
        this.#show({ ...exact, fill, ...refined, shift: shiftOf(draft, exact, unit) });
        // A refined center has moved a little, so that its paths start elsewhere.
        this.#newest.wake();
      },
      failed: (error) => this.#show({ refining: false, notRefined: messageOf(error) }),
    });
    if (!draft.refining) this.#show({ refining: true });
    return false;
  }

  /** The pairs of points that the legs of the newest figure join. */
  #ends(): Ends[] {
    if (this.#view.curve && this.#view.curve.legs.length > 0) return [];
    return this.#state ? geodesicEnds(this.#state.figure, this.#view.center?.point ?? null) : [];
  }

  /** The visible geodesics beside the newest figure. */
  #beside(shown: Shown): Partial<View> {
    const state = this.#state;
    if (!state) return {};
    const { kind, points } = state.figure;
    const others = this.#others.of(state);
    if (!activeObject(state.drawing).visible) return { legs: [], others, polygonOnly: false };
    if (isRound(kind)) {
      const { circle } = shown;
      // The geodesic of a refused radius may go around the surface many times.
      const paths = shown.problem ? [] : [circle?.path, circle?.across?.path];
      const legs = paths.filter((leg) => leg !== undefined);
      return { legs, others, polygonOnly: false };
    }
    const ends = geodesicEnds(state.figure, shown.center?.point ?? null);
    if (kind === 'pen') return { legs: [], others, polygonOnly: false };
    const own = shown.curve?.legs ?? [];
    return {
      legs: own.length > 0 ? own : this.#legs.between(ends, state.epoch),
      others,
      polygonOnly: points.length < pointsNeeded(state.figure),
    };
  }

  async #traceOther(): Promise<boolean> {
    const [client, state] = [this.#client, this.#state];
    if (!client || client.closed || !state) return false;
    const traced = await this.#others.trace(client, state);
    if (client !== this.#client) return false;
    if (traced) this.#show(this.#beside(this.#view));
    return traced;
  }

  /** The regions with a fill, in the drawing's order. */
  painted({ drawing }: State): (Patterned & { pattern: Pattern | null | undefined })[] {
    const { fill, others } = this.#view;
    return drawing.objects.flatMap((object) => {
      const own = object.id === drawing.active && object.visible && object.fill > 0;
      const region = own ? fill?.region : others.find(({ id }) => id === object.id)?.region;
      if (!region) return [];
      return [{ object, region, pattern: this.#patterns.of({ object, region }) }];
    });
  }

  /** The centroid of an object's fill; null if the object has no filled region. */
  async centroidOf(id: number): Promise<SurfacePoint | null> {
    const [client, state] = [this.#client, this.#state];
    const one = state && this.painted(state).find(({ object }) => object.id === id);
    return client && one ? client.centroid(one.region) : null;
  }

  /** Computes a pattern. Fills are solid during a drag. */
  async #makePattern(): Promise<boolean> {
    const [client, state] = [this.#client, this.#state];
    if (!client || client.closed || !state || state.dragging) return false;
    const made = await this.#patterns.make(client, this.painted(state));
    if (client !== this.#client) return false;
    if (made) this.#show({});
    return made;
  }

  async #traceLeg(): Promise<boolean> {
    const client = this.#client;
    if (!client || client.closed) return false;
    const traced = await this.#legs.trace(client, this.#ends());
    if (client !== this.#client) return false;
    // A display takes longer than a trace. Paths traced soon after a display therefore appear
    // later, together with others.
    const started = performance.now();
    if (traced && started < this.#legsRest) this.#legsUnseen = true;
    else if (traced || this.#legsUnseen) {
      this.#legsUnseen = false;
      this.#show(this.#beside(this.#view));
      const ended = performance.now();
      this.#legsRest = ended + restPart * (ended - started);
    }
    return traced;
  }
}
