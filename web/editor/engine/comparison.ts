import type { Figure } from '../../model/figure';
import { type Gap, gapBetween } from '../../model/gap';
import { type MethodId, methodOptions, refinedOptions } from '../../model/methods';
import type { EngineClient } from '../../worker/client';
import type { State } from '../state/state';
import { compute, messageOf, nothing, type Shown } from './compute';
import { Refinement } from './refinement';
import type { Session } from './session';
import type { View } from './view';

/** The edited curve by a second method, for comparison with the visible one. */
export interface Compared {
  method: MethodId;
  /** The second curve; null if it or the visible curve does not exist. */
  polyline: Float32Array | null;
  /**
   * The distance between the two curves, in mean edges and relative to the visible curve's length.
   */
  inEdges: Gap | null;
  ofLength: Gap | null;
  /** Whether the comparison belongs to an earlier state. */
  late: boolean;
  /** A sentence that says why the second curve is missing. */
  problem: string | null;
}

/**
 * The longest time of a trace that may run during a drag, in milliseconds. Slower traces wait for
 * the drag's end.
 */
const longestOfDrag = 60;

/** A requested comparison and its result. */
interface Asked {
  figure: Figure;
  method: MethodId;
  shown: Shown | null;
}

const scaled = ({ mean, largest }: Gap, by: number): Gap => ({
  mean: mean * by,
  largest: largest * by,
});

/**
 * Traces the edited curve by a second method, and measures the distance between the two curves.
 * This happens in an engine of its own, so that no other work waits for it.
 */
export class Comparison {
  #method: MethodId | null = null;
  #client: EngineClient | null = null;
  #asked: Asked | null = null;
  #count = 0;
  #milliseconds = 0;
  #shown: Compared | null = null;
  #polyline: Float32Array | null = null;
  readonly #engine = new Refinement<Shown>();

  /** A listener for changes of the comparison. */
  onChange: (compared: Compared | null) => void = () => {};

  constructor(private readonly session: Session) {}

  get shown(): Compared | null {
    return this.#shown;
  }

  get method(): MethodId | null {
    return this.#method;
  }

  /** Compares with another method, or with none. */
  choose(method: MethodId | null, state: State): void {
    this.#method = method;
    this.#asked = null;
    this.#shown = null;
    this.#engine.drop();
    // Without a comparison there is no need for its engine.
    if (!method) {
      this.#engine.use(null);
      this.#client = null;
    }
    this.onChange(null);
    this.update(state, this.session.view);
  }

  /** Compares again if the shown curve has changed. */
  update(state: State, view: View): void {
    const { client } = this.session;
    const method = this.#method;
    if (!method || !client) return;
    if (method === state.method) {
      this.choose(null, state);
      return;
    }
    if (client !== this.#client) {
      this.#client = client;
      this.#engine.use(client);
      this.#asked = null;
    }
    if (view.revision !== state.revision) return;
    if (!view.curve) {
      this.#tell({ polyline: null, inEdges: null, ofLength: null, late: false, problem: null });
      return;
    }
    if (this.#asked?.figure === state.figure) this.#measure(view);
    else if (!state.dragging || this.#milliseconds <= longestOfDrag) this.#ask(state, method);
    else if (this.#shown && !this.#shown.late) this.#tell({ ...this.#shown, late: true });
  }

  #ask({ figure, drawing }: State, method: MethodId): void {
    const asked: Asked = { figure, method, shown: null };
    this.#asked = asked;
    const options = refinedOptions(method) ?? methodOptions(method);
    const took = (shown: Shown) => {
      if (this.#asked !== asked) return;
      asked.shown = shown;
      this.#milliseconds = shown.curve?.milliseconds ?? 0;
      this.#measure(this.session.view);
    };
    this.#engine.request({
      revision: ++this.#count,
      compute: (client) => compute(client, figure, options, { object: drawing.active }),
      done: took,
      failed: (error) => took({ ...nothing, problem: messageOf(error) }),
    });
  }

  #measure({ curve }: View): void {
    const other = this.#asked?.shown;
    if (!other || !curve) return;
    const polyline = other.curve?.polyline ?? null;
    if (this.#shown && !this.#shown.late && this.#shown.polyline === polyline) {
      if (this.#polyline === curve.polyline) return;
    }
    this.#polyline = curve.polyline;
    const gap = polyline && gapBetween(curve.polyline, polyline);
    this.#tell({
      polyline,
      inEdges: gap && scaled(gap, 1 / this.#client!.info.meanEdge),
      ofLength: gap && curve.length > 0 ? scaled(gap, 1 / curve.length) : null,
      late: false,
      problem: other.problem,
    });
  }

  #tell(compared: Omit<Compared, 'method'>): void {
    this.#shown = { ...compared, method: this.#method! };
    this.onChange(this.#shown);
  }
}
