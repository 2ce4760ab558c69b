import { make } from '../../panels/elements';
import { lineStyles } from '../figures/lines';
import type { LineId, LineResult, Panel } from '../figures/types';
import { formatDeviation, formatMilliseconds } from './format';

interface Column {
  head: string;
  title: string;
  text(line: LineResult): string;
}

const deviation: Column = {
  head: 'median\nh',
  title: 'Median deviation from the reference, in mean edges h',
  text: (line) => formatDeviation(line.deviation?.median ?? null),
};

const times: Column[] = [
  {
    head: 'prepare\nms',
    title: 'Milliseconds for the mesh, once',
    text: ({ prepareMs }) => formatMilliseconds(prepareMs),
  },
  {
    head: 'trace\nms',
    title: 'Milliseconds for the curve, with its fields',
    text: ({ traceMs }) => formatMilliseconds(traceMs),
  },
];

const curveColumns: Column[] = [
  deviation,
  {
    head: 'max\nh',
    title: 'Largest deviation from the reference, in mean edges h',
    text: (line) => formatDeviation(line.deviation?.max ?? null),
  },
  {
    head: 'turning\nrad',
    title: 'Turning noise: RMS of turning angle minus the reference’s, in radians',
    text: ({ turningNoise }) => formatDeviation(turningNoise),
  },
  {
    head: 'lost\n',
    title: 'Samples that did not converge',
    text: ({ lost, samples }) => (lost ? `${lost}/${samples}` : lost === 0 ? '0' : '–'),
  },
  ...times,
];

const centerColumns: Column[] = [
  { ...deviation, head: 'deviation\nh', title: 'Distance from the reference, in mean edges h' },
  ...times,
];

const residualTitle =
  'Median length of the weighted sum of the exact shortest paths’ log vectors, which is 0 at a center of mass. Deviations smaller than this tell nothing';

/** The legend of a panel, with the numbers of its lines: a box each shows it or not. */
export class NumbersTable {
  readonly element = make('div', '', { className: 'numbers' });
  readonly #columns: readonly Column[];
  readonly #rows = new Map<LineId, HTMLTableRowElement>();

  constructor(
    panel: Panel,
    private readonly shown: ReadonlySet<LineId>,
    toggle: (id: LineId, shown: boolean) => void,
  ) {
    this.#columns = panel.curve.kind === 'center' ? centerColumns : curveColumns;
    const table = make('table');
    table.style.setProperty('--columns', `${this.#columns.length}`);
    const head = table.createTHead().insertRow();
    head.append(make('th', ''));
    for (const { head: text, title } of this.#columns) head.append(make('th', text, { title }));
    const body = table.createTBody();
    for (const id of panel.lines) {
      const row = body.insertRow();
      row.dataset.line = id;
      row.append(this.#label(id, toggle));
      this.#rows.set(id, row);
      this.#fill(row, null);
    }
    this.element.append(table);
  }

  #label(id: LineId, toggle: (id: LineId, shown: boolean) => void): HTMLElement {
    const { label, color } = lineStyles[id];
    const box = make('input', '', { type: 'checkbox', checked: this.shown.has(id) });
    box.addEventListener('change', () => toggle(id, box.checked));
    const swatch = make('i', '', { className: 'swatch' });
    swatch.style.setProperty('--color', `var(${color})`);
    const text = make('label');
    text.append(box, swatch, make('span', label));
    const cell = make('th');
    cell.scope = 'row';
    cell.append(text);
    return cell;
  }

  /** Dims the row until its numbers are there. */
  wait(id: LineId): void {
    this.#rows.get(id)!.dataset.state = 'waiting';
  }

  /** Nothing is known of the line. */
  clear(id: LineId): void {
    const row = this.#rows.get(id)!;
    delete row.dataset.state;
    this.#fill(row, null);
  }

  set(line: LineResult): void {
    const row = this.#rows.get(line.id)!;
    row.dataset.state = line.ok ? 'done' : 'failed';
    if (!line.ok) this.#say(row, line.reason ?? '', 'reason');
    else if (line.residual !== null) {
      const note = `its own residual: ${formatDeviation(line.residual)} h`;
      this.#say(row, note, 'note').title = residualTitle;
    } else this.#fill(row, line);
  }

  /** A sentence in place of numbers. */
  #say(row: HTMLTableRowElement, text: string, className: string): HTMLElement {
    const cell = make('td', text, { colSpan: this.#columns.length, className });
    this.#replace(row, [cell]);
    return cell;
  }

  /** A line that is no method's has no numbers. */
  #fill(row: HTMLTableRowElement, line: LineResult | null): void {
    const measured = line !== null && (line.deviation !== null || line.traceMs !== null);
    this.#replace(
      row,
      this.#columns.map((column) => make('td', measured ? column.text(line) : '')),
    );
  }

  #replace(row: HTMLTableRowElement, cells: readonly HTMLElement[]): void {
    row.replaceChildren(row.firstElementChild!, ...cells);
  }
}
