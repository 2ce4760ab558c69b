import { make } from '../../panels/elements';
import { originWords, type SavedReport } from '../claims/saved';
import { captionOf } from '../figures/captions';
import type { Figure, LineNumbers, Vector } from '../figures/types';
import { FigurePanel, type PanelContext } from './figure_panel';
import type { SavedNumbers } from './numbers_table';
import { Caption, sectionHead, whenNear } from './section';

/** The report's numbers for a panel. */
function savedOf(report: SavedReport, key: string): SavedNumbers | null {
  const lines = report.panels?.[key];
  return lines ? { lines, origin: originWords(report) } : null;
}

/** A figure on the page. Its panels begin to compute when it comes near the window. */
export class FigureSection {
  readonly element: HTMLElement;
  readonly #panels: FigurePanel[];
  readonly #points: Record<string, Vector[]>;
  readonly #shared: { key: string; panel: FigurePanel }[] = [];
  #started = false;
  #moved = false;
  readonly #figure: Figure;

  constructor(
    context: PanelContext,
    figure: Figure,
    measured: () => void,
    saved: SavedReport | null,
  ) {
    this.#figure = figure;
    this.#points = structuredClone(figure.points);
    this.element = make('section', '', { className: 'figure', id: figure.id });
    const head = sectionHead(figure.name, figure.title);
    const grid = make('div', '', { className: 'panels' });
    grid.dataset.count = `${figure.panels.length}`;
    this.#panels = figure.panels.map((panel) => {
      const key = panel.points;
      const made = new FigurePanel(
        context,
        panel,
        this.#points[key]!,
        { move: (index, place) => this.#move(key, index, place), measured },
        saved && savedOf(saved, `${figure.id}/${panel.id}`),
      );
      this.#shared.push({ key, panel: made });
      grid.append(made.element);
      return made;
    });
    this.element.append(head, new Caption(captionOf(figure)).element, grid);
    whenNear(this.element, () => this.start());
  }

  /** Whether all panels are up to date. */
  get settled(): boolean {
    return this.#panels.every((panel) => panel.settled);
  }

  /** The measurements of the figure by panel; empty once the reader has moved a point. */
  measured(): Record<string, LineNumbers[]> {
    const entries = this.#figure.panels.flatMap(({ id }, i) => {
      const lines = this.#moved ? null : this.#panels[i]!.measured();
      return lines ? [[`${this.#figure.id}/${id}`, lines] as const] : [];
    });
    return Object.fromEntries(entries);
  }

  get panels(): readonly FigurePanel[] {
    return this.#panels;
  }

  start(): void {
    if (this.#started) return;
    this.#started = true;
    for (const panel of this.#panels) panel.start();
  }

  recolor(): void {
    for (const panel of this.#panels) panel.recolor();
  }

  #move(key: string, index: number, place: Vector): void {
    this.#moved = true;
    const points = this.#points[key]!.with(index, place);
    this.#points[key] = points;
    for (const { key: other, panel } of this.#shared) if (other === key) panel.setPoints(points);
  }
}
