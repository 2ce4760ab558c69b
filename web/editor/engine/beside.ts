import type { Path, SurfacePoint } from 'karcher';
import { isDerived } from '../../model/derived';
import { type DrawnObject, type LineStyle, othersOf, styleOf } from '../../model/drawing';
import { type Figure, type Inside, isEmpty, type Operand } from '../../model/figure';
import { type MethodId, methodOptions, type Quality } from '../../model/methods';
import { isSource, resolvedFigure } from '../../model/sources';
import type { Region } from '../../model/traced';
import type { EngineClient } from '../../worker/client';
import type { State } from '../state/state';
import {
  compute,
  messageOf,
  noFill,
  nothing,
  outlinesShown,
  polylinesOf,
  qualityShown,
  type Shown,
} from './compute';
import type { ShownCut } from './cut';

/** An object besides the edited one, in its drawn form. */
export interface Beside {
  id: number;
  style: LineStyle;
  locked: boolean;
  /** The lines; empty before their trace. */
  lines: readonly Float32Array[];
  /** The points of a figure of single points, which appear as dots. */
  points: readonly SurfacePoint[];
  /** The center of mass, if the figure is a center. */
  center: SurfacePoint | null;
  /** The region that the figure's lines enclose, if the object has a fill. */
  region: Region | null;
  /** The parts into which a cut divides the surface. */
  cut: ShownCut | null;
}

/** The engine's result for a figure by a method, and its quality. */
interface Traced {
  method: MethodId;
  shown: Shown;
  quality: Quality | null;
  /** The lines of the sources, if the figure is derived from others. */
  from?: readonly (readonly Path[] | null)[];
}

/**
 * The pause in a drag after the trace of a derived object, as a multiple of the time that the trace
 * took.
 */
const restPart = 2;

/** The largest number of results kept for undo, besides the results for the drawing's figures. */
export const mostRemembered = 64;

/**
 * The engine's results for figures. Figures are immutable, so a result stays valid for every object
 * that uses its figure, and after undo.
 */
export class BesideObjects {
  readonly #traced = new Map<Figure, Traced>();
  readonly #drawn = new WeakMap<DrawnObject, Beside>();
  #last: readonly Beside[] = [];
  /** The lines of figures that are sources of others. */
  #outlines = new WeakMap<Figure, { method: MethodId; paths: readonly Path[] }>();
  /**
   * The last results for derived objects, by their ids. They stay visible until newer results
   * arrive.
   */
  readonly #lastOf = new Map<number, Traced>();
  #restUntil = 0;
  #timer: ReturnType<typeof setTimeout> | null = null;

  /** Calls `rested` at the end of a pause in a drag, when a trace may follow. */
  constructor(private readonly rested: () => void) {}

  /** Whether objects without a result wait for the end of a pause. */
  get resting(): boolean {
    return this.#timer !== null;
  }

  clear(): void {
    this.#traced.clear();
    this.#outlines = new WeakMap();
    this.#lastOf.clear();
    this.#last = [];
  }

  /**
   * Keeps the result for a figure, since the figure may appear again, in the edited object or in
   * another one. If more than `mostRemembered` results belong to no object of the drawing, forgets
   * the oldest of these.
   */
  keep(figure: Figure, traced: Traced, drawing: State['drawing']): void {
    const { operands } = figure;
    const from = operands?.map((operand) => this.#pathsOf(operand, traced.method));
    this.#traced.delete(figure);
    this.#traced.set(figure, { ...traced, ...(from && { from }) });
    this.#forgetAllBut(drawing);
  }

  /**
   * The result for a figure by a method; null if there is none, if the lines of an operand have
   * changed, or if the result lacks a required fill.
   */
  known(figure: Figure, method: MethodId, fill = false): Traced | null {
    const traced = this.#traced.get(figure);
    if (traced?.method !== method) return null;
    const isOld = (operand: Operand, i: number) =>
      this.#pathsOf(operand, method) !== traced.from?.[i];
    if (figure.operands?.some(isOld)) return null;
    return fill && !traced.shown.fill ? null : traced;
  }

  /** The side of a figure's lines that the figure encloses, by its last result; null if unknown. */
  insideOf(figure: Figure): Inside | null {
    return this.#traced.get(figure)?.shown.fill?.region?.side ?? null;
  }

  /** The objects beside the edited one; the same list as before if none has changed. */
  of({ drawing, method }: State): readonly Beside[] {
    const next = shownBeside(drawing).map((object) =>
      this.#besideOf(object, resolvedFigure(drawing, object), method),
    );
    const same = next.length === this.#last.length && next.every((one, i) => one === this.#last[i]);
    if (!same) this.#last = next;
    return this.#last;
  }

  /**
   * Traces a figure that has no result yet. Returns false if there is none, or if all such figures
   * wait for the end of a pause.
   */
  async trace(client: EngineClient, { drawing, method, dragging }: State): Promise<boolean> {
    const started = performance.now();
    const isMissing = (object: DrawnObject) =>
      !this.known(resolvedFigure(drawing, object), method, asksFill(drawing, object));
    const all = shownBeside(drawing).filter(isMissing);
    const left = this.#restUntil - started;
    const rests = dragging && left > 0;
    const missing = all.find(({ figure }) => !(rests && isDerived(figure.kind)));
    if (!missing && all.length > 0) this.#rest(left);
    if (!missing) return false;
    const { id } = missing;
    const figure = resolvedFigure(drawing, missing);
    const fill = asksFill(drawing, missing);
    const shown = await compute(client, figure, methodOptions(method), {
      ...{ object: id, fill, outlines: isSource(drawing, id) },
      outlinesOf: this.outlinesOf(client, method),
    }).catch((error) => ({
      ...nothing,
      problem: messageOf(error),
      fill: fill ? noFill : null,
    }));
    if (client.closed) return false;
    this.tell(figure, method, shown);
    this.keep(figure, { method, shown, quality: qualityShown(shown, method) }, drawing);
    const ended = performance.now();
    if (figure.operands) this.#restUntil = ended + restPart * (ended - started);
    return true;
  }

  #rest(milliseconds: number): void {
    this.#timer ??= setTimeout(() => {
      this.#timer = null;
      this.rested();
    }, milliseconds);
  }

  /** If a figure's result has paths, keeps them for the objects derived from the figure. */
  tell(figure: Figure, method: MethodId, shown: Shown): void {
    const paths = outlinesShown(shown);
    if (paths) this.#outlines.set(figure, { method, paths });
  }

  /** A function that returns the lines of a source: the known lines, or newly traced ones. */
  outlinesOf(client: EngineClient, method: MethodId) {
    const outlinesOf = async (operand: Operand): Promise<readonly Path[]> => {
      const known = this.#pathsOf(operand, method);
      if (known) return known;
      const { id, figure } = operand;
      const shown = await compute(client, figure, methodOptions(method), {
        ...{ object: id, outlines: true, outlinesOf },
      });
      this.tell(figure, method, shown);
      return outlinesShown(shown) ?? [];
    };
    return outlinesOf;
  }

  #pathsOf({ figure }: Operand, method: MethodId): readonly Path[] | null {
    const known = this.#outlines.get(figure);
    return known?.method === method ? known.paths : null;
  }

  #besideOf(object: DrawnObject, figure: Figure, method: MethodId): Beside {
    const known = this.#drawn.get(object);
    const { id, locked } = object;
    const own = this.known(figure, method);
    const traced = own ?? (isDerived(figure.kind) ? (this.#lastOf.get(id) ?? null) : null);
    if (own && isDerived(figure.kind)) this.#lastOf.set(id, own);
    const lines = traced ? polylinesOf(traced.shown) : [];
    const center = traced?.shown.center?.point ?? null;
    const region = object.fill > 0 ? (traced?.shown.fill?.region ?? null) : null;
    const sameLines =
      known?.lines.length === lines.length && lines.every((line, i) => line === known.lines[i]);
    const cut = traced?.shown.cut ?? null;
    const same = sameLines && known?.center === center && known.region === region;
    if (same && known.cut === cut) return known;
    const points = figure.kind === 'points' ? figure.points : [];
    const style = styleOf(object);
    const beside = { id, style, locked, lines, points, center, region, cut };
    this.#drawn.set(object, beside);
    return beside;
  }

  #forgetAllBut(drawing: State['drawing']): void {
    const used = new Set(drawing.objects.map((object) => resolvedFigure(drawing, object)));
    let beyond = this.#traced.size - used.size - mostRemembered;
    for (const figure of this.#traced.keys()) {
      if (beyond <= 0) return;
      if (used.has(figure)) continue;
      this.#traced.delete(figure);
      beyond--;
    }
  }
}

/**
 * Whether the trace of an object computes its fill. A source without a stored side needs the fill
 * even if it shows none, so that a drag of the source keeps the side.
 */
export const asksFill = (drawing: State['drawing'], { id, fill, figure }: DrawnObject) =>
  fill > 0 || (!figure.inside && isSource(drawing, id));

const shownBeside = (drawing: State['drawing']) =>
  othersOf(drawing).filter(({ visible, figure }) => visible && !isEmpty(figure));
