import { make } from '../../panels/elements';
import { lineStyles } from '../figures/lines';
import type { LineId, LineNumbers, Panel } from '../figures/types';
import { formatDeviation, formatDifference, formatMilliseconds } from './format';

interface Column {
  /** The heading over the column. Adjacent columns with the same heading share one cell. */
  ruler: string;
  head: string;
  title: string;
  text(line: LineNumbers): string;
  /** A note on the number, in small letters. */
  note?(line: LineNumbers): string | null;
}

const byReference = 'from the reference';

const deviation: Column = {
  ruler: byReference,
  head: 'median\nh',
  title: 'Median deviation from the reference, in mean edges h; samples that are lost are left out',
  text: (line) => formatDeviation(line.deviation?.median ?? null),
  note: ({ deviation, samples }) =>
    deviation && samples !== null && deviation.samples < samples
      ? `over ${deviation.samples}/${samples}`
      : null,
};

const times: Column[] = [
  {
    ruler: 'time',
    head: 'prepare\nms',
    title: 'Milliseconds for the mesh, once',
    text: ({ prepareMs }) => formatMilliseconds(prepareMs),
  },
  {
    ruler: 'time',
    head: 'trace\nms',
    title: 'Milliseconds for the curve, with its fields',
    text: ({ traceMs }) => formatMilliseconds(traceMs),
  },
];

const ruler: Column[] = [
  {
    ruler: 'by exact paths',
    head: 'residual\nh',
    title:
      'By exact shortest paths, the same for all methods: median of |Σ wᵢ log pᵢ| at up to 33 samples, in mean edges h. At a center of mass it is 0',
    text: ({ ruler }) => formatDeviation(ruler?.residual?.median ?? null),
    note: ({ ruler }) =>
      ruler && ruler.measured < ruler.of ? `over ${ruler.measured}/${ruler.of}` : null,
  },
  {
    ruler: 'by exact paths',
    head: 'energy\nh²',
    title:
      'By exact shortest paths: median of Σ wᵢ d² at these samples minus the reference’s, in squared mean edges. Below 0 it is nearer to the minimum than the reference',
    text: ({ ruler }) => formatDifference(ruler?.energy?.excess ?? null),
  },
];

/** The largest ratio of a sample's step in a drag to the hand's step, and the number of leaps. */
function dragText({ most, leaps }: NonNullable<LineNumbers['drag']>): string {
  const far = most === null ? '–' : `×${most.toFixed(1)}`;
  return leaps === 0 ? far : `${far}, ${leaps} ${leaps === 1 ? 'leap' : 'leaps'}`;
}

const curveColumns: Column[] = [
  ...ruler,
  deviation,
  {
    ruler: byReference,
    head: 'max\nh',
    title: 'Largest deviation from the reference, in mean edges h',
    text: (line) => formatDeviation(line.deviation?.max ?? null),
  },
  {
    ruler: byReference,
    head: 'turning\nrad',
    title:
      'Turning noise: RMS of turning angle minus the reference’s, in radians; “breaks”: where the curve leaps from one sample to the next; “drag”: the farthest that a sample moves in a step of a drag, in steps of the hand',
    text: ({ turningNoise }) => formatDeviation(turningNoise),
    note: ({ breaks, drag }) =>
      [
        breaks ? (breaks === 1 ? '1 break' : `${breaks} breaks`) : '',
        drag ? `drag ${dragText(drag)}` : '',
      ]
        .filter(Boolean)
        .join(', ') || null,
  },
  {
    ruler: '',
    head: 'lost\n',
    title:
      'Samples whose search did not converge to 1e-6 h, and that no bridge replaces; “own”: those that its own authors would not have accepted either',
    text: ({ lost, samples }) => (lost ? `${lost}/${samples}` : lost === 0 ? '0' : '–'),
    note: ({ lost, lostByOwnRule }) =>
      lost && lostByOwnRule !== null && lostByOwnRule !== lost ? `own ${lostByOwnRule}` : null,
  },
  ...times,
];

const centerColumns: Column[] = [
  ...ruler,
  {
    ...deviation,
    head: 'deviation\nh',
    title: 'Distance from the reference, in mean edges h',
  },
  ...times,
];

/** A panel's numbers from an earlier measurement, and their origin. */
export interface SavedNumbers {
  lines: readonly LineNumbers[];
  origin: string;
}

/**
 * The legend of a panel, with the numbers of its lines: a checkbox for each line shows or hides it.
 */
export class NumbersTable {
  readonly element = make('div', '', { className: 'numbers' });
  readonly #columns: readonly Column[];
  readonly #rows = new Map<LineId, HTMLTableRowElement>();
  /** The origin of earlier numbers. */
  readonly #saved = make('p', '', { className: 'saved-note', hidden: true });

  constructor(
    panel: Panel,
    private readonly shown: ReadonlySet<LineId>,
    toggle: (id: LineId, shown: boolean) => void,
  ) {
    this.#columns = panel.curve.kind === 'center' ? centerColumns : curveColumns;
    const table = make('table');
    table.style.setProperty('--columns', `${this.#columns.length}`);
    this.#addRulers(table.createTHead().insertRow());
    const head = table.tHead!.insertRow();
    head.append(make('td'));
    for (const { head: text, title } of this.#columns) head.append(make('th', text, { title }));
    const body = table.createTBody();
    for (const id of panel.lines) {
      const row = body.insertRow();
      row.dataset.line = id;
      row.append(this.#label(id, toggle));
      this.#rows.set(id, row);
      this.#fill(row, null);
    }
    this.element.append(table, this.#saved);
  }

  #addRulers(row: HTMLTableRowElement): void {
    row.className = 'rulers';
    row.append(make('td'));
    for (const { ruler: name } of this.#columns) {
      const last = row.lastElementChild as HTMLTableCellElement;
      if (last.textContent === name && name) last.colSpan++;
      else row.append(make(name ? 'th' : 'td', name));
    }
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

  /** Dims the row until its numbers arrive. */
  wait(id: LineId): void {
    const row = this.#rows.get(id)!;
    if (row.dataset.state !== 'saved') row.dataset.state = 'waiting';
  }

  /** Shows measurements from elsewhere until the panel has its own. */
  showSaved(lines: readonly LineNumbers[], origin: string): void {
    for (const line of lines) {
      const row = this.#rows.get(line.id);
      if (!row || !line.ok) continue;
      row.dataset.state = 'saved';
      this.#fill(row, line);
    }
    this.#saved.textContent = `Grey: ${origin}, until it is measured here.`;
    this.#hideSaved();
  }

  /** Removes earlier measurements, which no longer match the panel. */
  dropSaved(): void {
    for (const [id, row] of this.#rows) if (row.dataset.state === 'saved') this.clear(id);
  }

  /** Hides the note on the origin when no earlier numbers remain. */
  #hideSaved(): void {
    this.#saved.hidden = ![...this.#rows.values()].some(({ dataset }) => dataset.state === 'saved');
  }

  /** Removes the numbers of a line. */
  clear(id: LineId): void {
    const row = this.#rows.get(id)!;
    delete row.dataset.state;
    this.#hideSaved();
    this.#fill(row, null);
  }

  set(line: LineNumbers): void {
    const row = this.#rows.get(line.id)!;
    row.dataset.state = line.ok ? 'done' : 'failed';
    this.#hideSaved();
    if (!line.ok) this.#say(row, line.reason ?? '', 'reason');
    else this.#fill(row, line);
  }

  /** Shows a sentence in place of numbers. */
  #say(row: HTMLTableRowElement, text: string, className: string): void {
    this.#replace(row, [make('td', text, { colSpan: this.#columns.length, className })]);
  }

  /** Fills the row; a line that belongs to no method has no numbers. */
  #fill(row: HTMLTableRowElement, line: LineNumbers | null): void {
    const measured = line !== null && (line.deviation !== null || line.traceMs !== null);
    this.#replace(
      row,
      this.#columns.map((column) => {
        const cell = make('td', measured ? column.text(line) : '');
        const note = measured ? column.note?.(line) : null;
        if (note) cell.append(make('small', note));
        return cell;
      }),
    );
  }

  #replace(row: HTMLTableRowElement, cells: readonly HTMLElement[]): void {
    row.replaceChildren(row.firstElementChild!, ...cells);
  }
}
