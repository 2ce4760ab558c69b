import type { SurfacePoint } from 'karcher';
import { objectOf } from '../../model/drawing';
import { isRound } from '../../model/figure';
import { methodOptions } from '../../model/methods';
import type { TracedDistances } from '../../model/traced';
import { type EngineClient, Stopped } from '../../worker/client';
import type { Editor } from '../state/editor';
import type { State } from '../state/state';
import { messageOf } from './compute';
import { Newest } from './newest';
import type { Session } from './session';

/** The source of distances: an object's control point by its index, or its center. */
interface Origin {
  object: number;
  handle: number | 'center';
}

export interface ShownDistances {
  traced: TracedDistances;
  origin: Origin;
  from: SurfacePoint;
  /** Whether the distances start at the point's present place. */
  current: boolean;
}

interface Job {
  client: EngineClient;
  origin: Origin;
  from: SurfacePoint;
  state: State;
}

/**
 * Distances along the surface from the selected point or center. They are not updated before the
 * end of a drag, since the engine is busy with curves until then.
 */
export class Distances {
  #origin: Origin | null = null;
  #shown: ShownDistances | null = null;
  /** The latest request. */
  #asked: Job | null = null;
  /** Aborts the trace under way. */
  #running = new AbortController();
  readonly #newest = new Newest<Job>((job) => this.#trace(job));

  /** A listener for changes of the distances. It receives null if there are none. */
  onChange: (shown: ShownDistances | null) => void = () => {};
  /** A listener for sentences that say why distances are missing. */
  onProblem: (sentence: string) => void = () => {};

  constructor(
    private readonly editor: Editor,
    private readonly session: Session,
  ) {}

  get shown(): ShownDistances | null {
    return this.#shown;
  }

  /** Whether distances are visible or requested. */
  get on(): boolean {
    return this.#origin !== null;
  }

  toggle(): void {
    if (this.on) {
      this.off();
      return;
    }
    const origin = this.#chosen();
    if (!origin || !this.#placeOf(origin)) {
      this.onProblem('Select a point or a center first: distances are told from there.');
      return;
    }
    this.#origin = origin;
    this.onChange(this.#shown);
    this.update();
  }

  off(): void {
    if (!this.on) return;
    this.#origin = null;
    this.#asked = null;
    this.#newest.drop();
    this.#running.abort();
    this.#show(null);
  }

  /** Follows the selection and its place, unless a drag is under way. */
  update(): void {
    if (!this.on) return;
    const { state } = this.editor;
    const { client } = this.session;
    const surfaceLeft = this.#asked && this.#asked.state.mesh !== state.mesh;
    const origin = this.#chosen() ?? this.#origin!;
    const from = this.#placeOf(origin);
    if (!client || surfaceLeft || (!from && !state.dragging)) {
      this.off();
      return;
    }
    if (!from) return;
    this.#origin = origin;
    const asked = this.#asked;
    const same =
      asked?.client === client &&
      samePlace(asked.from, from) &&
      asked.state.method === state.method;
    if (same) {
      if (sameOrigin(asked.origin, origin)) return;
      // The new origin lies at the same place, so that the distances stay and only the origin's
      // name changes.
      this.#asked = { ...asked, origin };
      if (this.#shown) this.#show({ ...this.#shown, origin });
      return;
    }
    if (this.#shown?.current) this.#show({ ...this.#shown, current: false });
    if (state.dragging) return;
    this.#asked = { client, origin, from, state };
    this.#running.abort();
    this.#newest.push(this.#asked);
  }

  async #trace(job: Job): Promise<void> {
    const { client, from, state } = job;
    const { solver, rings } = methodOptions(state.method);
    const options = { ...(solver && { solver }), ...(rings && { rings }) };
    this.#running = new AbortController();
    const { signal } = this.#running;
    try {
      const traced = await client.distances(from, options, { signal });
      const asked = this.#asked;
      if (asked?.client !== client || !samePlace(asked.from, from)) return;
      this.#show({ traced, origin: asked.origin, from, current: true });
    } catch (error) {
      if (client.closed || this.#asked !== job) return;
      this.off();
      if (!(error instanceof Stopped)) this.onProblem(messageOf(error));
    }
  }

  #show(shown: ShownDistances | null): void {
    this.#shown = shown;
    this.onChange(shown);
  }

  /** The selected point or center; null if something else is selected. */
  #chosen(): Origin | null {
    const { figure, selection, drawing } = this.editor.state;
    const object = drawing.active;
    if (typeof selection === 'number') return { object, handle: selection };
    if (isRound(figure.kind)) return figure.circle && { object, handle: 'center' };
    return figure.kind === 'center' && this.session.view.center
      ? { object, handle: 'center' }
      : null;
  }

  #placeOf({ object, handle }: Origin): SurfacePoint | null {
    const { drawing } = this.editor.state;
    const figure = objectOf(drawing, object)?.figure;
    if (!figure) return null;
    if (handle !== 'center') return figure.points[handle] ?? null;
    if (isRound(figure.kind)) return figure.circle?.center ?? null;
    const { view } = this.session;
    const beside = view.others.find(({ id }) => id === object);
    return (object === drawing.active ? view.center?.point : beside?.center) ?? null;
  }
}

const samePlace = (a: SurfacePoint, b: SurfacePoint) =>
  a.face === b.face && a.bary.every((weight, i) => weight === b.bary[i]);

const sameOrigin = (a: Origin, b: Origin) => a.object === b.object && a.handle === b.handle;
