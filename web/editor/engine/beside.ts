import type { SurfacePoint } from 'karcher';
import { type DrawnObject, type LineStyle, othersOf } from '../../model/drawing';
import { type Figure, isEmpty } from '../../model/figure';
import { type MethodId, methodOptions, type Quality } from '../../model/methods';
import type { Region } from '../../model/traced';
import type { EngineClient } from '../../worker/client';
import {
  compute,
  messageOf,
  noFill,
  nothing,
  polylinesOf,
  qualityShown,
  type Shown,
} from './compute';
import type { State } from '../state/editor';

/** An object that lies beside the edited one, as it is drawn. */
export interface Beside {
  id: number;
  style: LineStyle;
  locked: boolean;
  /** None while it is not traced. */
  lines: readonly Float32Array[];
  /** Points that are drawn themselves. */
  points: readonly SurfacePoint[];
  /** A center of mass. */
  center: SurfacePoint | null;
  /** What its lines enclose, where that is painted. */
  region: Region | null;
}

/** What the engine made of a figure by a method, and how good it is. */
interface Traced {
  method: MethodId;
  shown: Shown;
  quality: Quality | null;
}

/** How many figures are remembered beyond those of the drawing: of steps that are taken back. */
export const mostRemembered = 64;

/**
 * What the engine made of figures. A figure is a value, so what was traced of it holds for as long as
 * the figure itself is used, by whichever object, and after a step is taken back.
 */
export class BesideObjects {
  readonly #traced = new Map<Figure, Traced>();
  readonly #drawn = new WeakMap<DrawnObject, Beside>();
  #last: readonly Beside[] = [];

  clear(): void {
    this.#traced.clear();
    this.#last = [];
  }

  /**
   * What was made of a figure: it may be seen again, beside another one or edited. The oldest that no
   * object of the drawing has any more are forgotten.
   */
  keep(figure: Figure, traced: Traced, { objects }: State['drawing']): void {
    this.#traced.delete(figure);
    this.#traced.set(figure, traced);
    this.#forgetAllBut(objects);
  }

  /** What was made of a figure by a method. */
  known(figure: Figure, method: MethodId, { fill = 0 } = {}): Traced | null {
    const traced = this.#traced.get(figure);
    if (traced?.method !== method) return null;
    return fill > 0 && !traced.shown.fill ? null : traced;
  }

  /** What lies beside the edited object; the very same list where nothing of it has changed. */
  of({ drawing, method }: State): readonly Beside[] {
    const next = shownBeside(drawing).map((object) => this.#besideOf(object, method));
    const same = next.length === this.#last.length && next.every((one, i) => one === this.#last[i]);
    if (!same) this.#last = next;
    return this.#last;
  }

  /** Traces one that is missing; false when there is none. */
  async trace(client: EngineClient, { drawing, method }: State): Promise<boolean> {
    const missing = shownBeside(drawing).find(
      (object) => !this.known(object.figure, method, object),
    );
    if (!missing) return false;
    const { id, figure } = missing;
    const fill = missing.fill > 0;
    const shown = await compute(client, figure, methodOptions(method), { object: id, fill }).catch(
      (error) => ({ ...nothing, problem: messageOf(error), fill: fill ? noFill : null }),
    );
    if (client.closed) return false;
    this.keep(figure, { method, shown, quality: qualityShown(shown, method) }, drawing);
    return true;
  }

  #besideOf(object: DrawnObject, method: MethodId): Beside {
    const known = this.#drawn.get(object);
    const { id, figure, locked, color, width, dash } = object;
    const traced = this.known(figure, method);
    const lines = traced ? polylinesOf(traced.shown) : [];
    const center = traced?.shown.center?.point ?? null;
    const region = object.fill > 0 ? (traced?.shown.fill?.region ?? null) : null;
    const sameLines =
      known?.lines.length === lines.length && lines.every((line, i) => line === known.lines[i]);
    if (known && sameLines && known.center === center && known.region === region) return known;
    const points = figure.kind === 'points' ? figure.points : [];
    const beside = { id, style: { color, width, dash }, locked, lines, points, center, region };
    this.#drawn.set(object, beside);
    return beside;
  }

  #forgetAllBut(objects: readonly DrawnObject[]): void {
    const used = new Set(objects.map(({ figure }) => figure));
    let beyond = this.#traced.size - used.size - mostRemembered;
    for (const figure of this.#traced.keys()) {
      if (beyond <= 0) return;
      if (used.has(figure)) continue;
      this.#traced.delete(figure);
      beyond--;
    }
  }
}

const shownBeside = (drawing: State['drawing']) =>
  othersOf(drawing).filter(({ visible, figure }) => visible && !isEmpty(figure));
