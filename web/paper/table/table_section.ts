import { make } from '../../panels/elements';
import { originWords, type SavedReport } from '../claims/saved';
import { download } from '../view/download';
import { Caption, sectionHead } from '../view/section';
import { TableChart } from './chart';
import { TableClient } from './client';
import { tableCsv } from './csv';
import {
  expectedTriangles,
  publishedNote,
  type TableCell,
  type TableRow,
  tableMethodNames,
  tableMethods,
} from './rows';
import type { TableOptions } from './run';
import { type Measure, measureNames } from './series';
import { TableView } from './table_view';

const sampleChoices = [128, 1024, 4096];
const budgetChoices = [30, 120, 600];
const stages: Record<string, string> = {
  graph: 'building the graph',
  landmarks: 'embedding',
  samples: 'tracing',
};

function select(label: string, choices: readonly [number, string][], chosen: number) {
  const element = make('select');
  for (const [value, text] of choices) {
    element.append(make('option', text, { value: `${value}`, selected: value === chosen }));
  }
  const box = make('label', '', { className: 'choice' });
  box.append(make('span', label), element);
  return { box, value: () => Number(element.value) };
}

/** Table 1 on the page: a worker of its own measures it on request. */
export class TableSection {
  readonly element = make('section', '', { className: 'figure', id: 'table' });
  cells: TableCell[] = [];
  readonly rows: readonly TableRow[];
  readonly #about: { browser: string; build: string };
  /** The origin of the saved numbers, while the table shows them. */
  #savedAbout: { browser: string; build: string } | null = null;
  readonly #view: TableView;
  readonly #chart = new TableChart();
  readonly #samples = select(
    'Samples per segment',
    sampleChoices.map((count) => [count, count.toLocaleString('en')]),
    4096,
  );
  readonly #budget = select(
    'A method gives up after',
    budgetChoices.map((seconds) => [seconds, `${seconds} s`]),
    120,
  );
  readonly #most: { box: HTMLElement; value(): number };
  readonly #run = make('button', 'Run', { type: 'button', className: 'button primary' });
  readonly #save = make('button', 'CSV', { type: 'button', className: 'button', disabled: true });
  readonly #bar = make('progress', '', { max: 1, value: 0, hidden: true });
  readonly #status = make('p', '', { className: 'panel-note' });
  #measure: Measure = 'traceMs';
  /** The cell under measurement, in words. */
  #what = '';
  #client: TableClient | null = null;
  #options: TableOptions | null = null;

  constructor(rows: readonly TableRow[], build: string, report: SavedReport | null) {
    this.rows = rows;
    this.#view = new TableView(rows);
    const sizes = [...new Set(rows.map(({ mesh }) => expectedTriangles(mesh)))].toSorted(
      (a, b) => a - b,
    );
    const upTo = sizes.filter((size) => size >= Math.min(10_000, sizes.at(-1)!));
    this.#most = select(
      'Up to',
      upTo.map((size) => [size, `${size.toLocaleString('en')} triangles`]),
      upTo.find((size) => size > 10_000) ?? upTo.at(-1)!,
    );
    this.#status.setAttribute('role', 'status');
    this.#run.addEventListener('click', () => (this.#client ? this.cancel() : this.start()));
    this.#save.addEventListener('click', () => {
      download('karcher-table-1.csv', 'text/csv', this.csv());
    });
    this.element.append(this.#head(), this.#controls(), this.#card());
    this.#about = { browser: navigator.userAgent, build };
    if (report?.table) this.#showSaved(report, report.table);
  }

  /** Shows the saved measurements until the table has its own. */
  #showSaved(report: SavedReport, { samples, cells }: NonNullable<SavedReport['table']>): void {
    const known = cells.filter(({ row }) => this.rows.some(({ id }) => id === row));
    if (known.length === 0) return;
    this.cells = known;
    this.#options = { rows: this.rows, samples, budgetMs: 1000 * this.#budget.value() };
    this.#savedAbout = { browser: report.machine, build: report.version };
    for (const cell of known) this.#view.set(cell);
    this.#chart.show(known, this.#measure);
    this.#save.disabled = false;
    this.#say(
      `${originWords(report)}, with ${samples.toLocaleString('en')} samples per segment. “Run” measures it on your machine.`,
    );
  }

  /** Whether no measurement is under way. */
  get settled(): boolean {
    return this.#client === null;
  }

  recolor(): void {
    this.#chart.redraw();
  }

  csv(): string {
    const { rows, samples } = this.#options!;
    const about = { ...(this.#savedAbout ?? this.#about), samples };
    return tableCsv(rows, this.cells, about);
  }

  /** Measures these rows, by default all rows up to the chosen size. */
  start(rows = this.#chosen()): void {
    this.cells = [];
    this.#savedAbout = null;
    this.#save.disabled = true;
    this.#view.clear();
    this.#options = {
      rows,
      samples: this.#samples.value(),
      budgetMs: 1000 * this.#budget.value(),
    };
    this.#run.textContent = 'Cancel';
    this.#bar.hidden = false;
    this.#bar.value = 0;
    this.#say('Starting…');
    const total = rows.length * tableMethods.length;
    this.#client = new TableClient(this.#options, {
      row: ({ name }) => this.#say(`${name}: making the mesh`),
      method: (cell) => {
        this.#view.mark(cell);
        this.#what = this.#doing(cell);
        this.#say(`${this.#what}, preparing`);
      },
      progress: (done, stage) => {
        this.#bar.value = (this.cells.length + done) / total;
        this.#say(`${this.#what}, ${stages[stage] ?? stage} (${Math.round(100 * done)} %)`);
      },
      cell: (cell) => {
        this.cells.push(cell);
        this.#view.set(cell);
        this.#bar.value = this.cells.length / total;
        this.#chart.show(this.cells, this.#measure);
        this.#save.disabled = false;
      },
      end: () => this.#stop('Done.'),
    });
    this.#client.run();
  }

  cancel(): void {
    this.#client?.cancel();
    this.#stop('Cancelled.');
  }

  #chosen(): TableRow[] {
    const most = this.#most.value();
    return this.rows.filter(({ mesh }) => expectedTriangles(mesh) <= most);
  }

  #doing({ row, method, triangles }: Omit<TableCell, 'result' | 'segments'>): string {
    const { name } = this.rows.find(({ id }) => id === row)!;
    const size = triangles.toLocaleString('en');
    return `${name}, ${size} triangles: ${tableMethodNames[method]}`;
  }

  #stop(message: string): void {
    this.#client = null;
    this.#view.mark(null);
    this.#run.textContent = 'Run';
    this.#bar.hidden = true;
    this.#say(message);
  }

  #say(text: string): void {
    this.#status.textContent = text;
  }

  #head(): HTMLElement {
    const head = sectionHead(
      'Table 1',
      'Times',
      new Caption(
        'Two-point paths on two tori, with exact distances for the paper’s method and ours; then B-splines, with graph distances of k = 6 for the paper’s method and fast ones for ours, as in the editor. Control points are at vertices. Preprocessing is what a method does once for the mesh. Tracing includes the fields. An update follows a drag of one point by an edge and keeps what does not depend on that point, such as the fields of the others or log maps. All methods run in the same WebAssembly build, one after the other, in one thread. A method that fails says so; a dash marks what was not measured. Below its preparation is the memory that a method holds with its curve, below tracing and updates what the fields take of them. The heat methods keep the log map of each vertex that a search came by; “as used” is what tracing takes where one is computed at each evaluation, as their authors’ library has it, reckoned from the time of those log maps and from how many were asked for. In a line of their own are the residual and the energy by exact paths, as in the figures, up to 60,000 triangles, and the samples that were lost, by our rule and, where it is another number, by that of the method’s own authors. ' +
          publishedNote,
      ).element,
    );
    return head;
  }

  #controls(): HTMLElement {
    const controls = make('div', '', { className: 'table-controls' });
    controls.append(this.#samples.box, this.#most.box, this.#budget.box, this.#run, this.#save);
    const status = make('div', '', { className: 'table-status' });
    status.append(this.#bar, this.#status);
    const box = make('div');
    box.append(controls, status);
    return box;
  }

  #card(): HTMLElement {
    const card = make('div', '', { className: 'panel-card' });
    const choices = make('div', '', { className: 'segments chart-choice' });
    choices.setAttribute('role', 'radiogroup');
    choices.setAttribute('aria-label', 'What the chart shows');
    for (const [measure, name] of Object.entries(measureNames) as [Measure, string][]) {
      const input = make('input', '', { type: 'radio', name: 'measure' });
      input.checked = measure === this.#measure;
      input.addEventListener('change', () => {
        this.#measure = measure;
        this.#chart.show(this.cells, measure);
      });
      const label = make('label');
      label.append(input, make('span', name));
      choices.append(label);
    }
    card.append(this.#view.element, choices, this.#chart.element);
    return card;
  }
}
