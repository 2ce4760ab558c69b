import type { MethodResult } from 'karcher/peers';
import { make } from '../../panels/elements';
import { lineStyles } from '../figures/lines';
import { formatBytes, formatDeviation, formatMilliseconds } from '../view/format';
import {
  asUsedMs,
  expectedTriangles,
  segmentsOf,
  type TableCell,
  type TableMethod,
  type TableRow,
  tableMethodNames,
  tableMethods,
} from './rows';

const parts = ['prepareMs', 'traceMs', 'dragMs'] as const;
const partNames = ['prepare', 'trace', 'update'];

/** The small line below a time: a part of this time, or an additional number. */
const details: Record<(typeof parts)[number], (result: MethodResult) => string | null> = {
  prepareMs: ({ memory }) => (memory ? formatBytes(memory) : null),
  traceMs: (result) => {
    const used = asUsedMs(result);
    if (used !== null) return `as used ${formatMilliseconds(used)}`;
    return result.fieldsMs ? `fields ${formatMilliseconds(result.fieldsMs)}` : null;
  },
  dragMs: ({ dragFieldMs }) => (dragFieldMs ? `field ${formatMilliseconds(dragFieldMs)}` : null),
};

/**
 * The measurements by exact paths, like in the figures, and the numbers of samples lost by our rule
 * and by the rule of the method's authors.
 */
function measuresOf({ ruler, lost, lostByOwnRule, samples }: MethodResult): string[] {
  const { residual = null, energy = null } = ruler ?? {};
  const part = ruler && ruler.measured < ruler.of ? ` over ${ruler.measured}/${ruler.of}` : '';
  const own = lostByOwnRule !== null && lostByOwnRule !== lost ? `, own ${lostByOwnRule}` : '';
  return [
    residual ? `residual ${formatDeviation(residual.median)} h${part}` : '',
    energy ? `energy ${formatDeviation(energy.median)} h²` : '',
    lost ? `lost ${lost}/${samples}${own}` : '',
  ].filter(Boolean);
}

/**
 * The table. For each method, a row has three durations in milliseconds; the line below has the
 * accuracy of the method's curve and the number of its lost samples.
 */
export class TableView {
  readonly element = make('div', '', { className: 'timings' });
  readonly #body: HTMLTableSectionElement;
  readonly #rows = new Map<string, HTMLTableRowElement>();
  /** The line of measures below each row, with a cell for each method. */
  readonly #measures = new Map<string, HTMLTableRowElement>();

  constructor(rows: readonly TableRow[]) {
    // The table scrolls sideways in a narrow window, also by keys.
    this.element.tabIndex = 0;
    this.element.role = 'region';
    this.element.ariaLabel = 'Times of all methods';
    const table = make('table');
    const head = table.createTHead();
    const methods = head.insertRow();
    methods.append(make('td'), make('td'), make('td'));
    const heads = head.insertRow();
    heads.append(make('th', 'Curve', { scope: 'col' }));
    for (const text of ['triangles', 'segments']) heads.append(make('th', text));
    for (const method of tableMethods) {
      const name = make('th', tableMethodNames[method], { colSpan: parts.length });
      name.style.setProperty('--color', `var(${lineStyles[method].color})`);
      methods.append(name);
      for (const text of partNames) heads.append(make('th', text));
    }
    this.#body = table.createTBody();
    for (const row of rows) this.#body.append(this.#row(row), this.#measuresRow(row));
    this.element.append(table);
  }

  #row(row: TableRow): HTMLTableRowElement {
    const element = make('tr');
    element.dataset.row = row.id;
    const about = expectedTriangles(row.mesh).toLocaleString('en');
    element.append(make('th', row.name, { scope: 'row' }), make('td', about));
    element.append(make('td', `${segmentsOf(row)}`));
    for (const method of tableMethods) {
      for (const part of parts) {
        const cell = make('td', '', { className: part === parts[0] ? 'first' : '' });
        cell.dataset.method = method;
        element.append(cell);
      }
    }
    this.#rows.set(row.id, element);
    return element;
  }

  #measuresRow({ id }: TableRow): HTMLTableRowElement {
    const element = make('tr', '', { className: 'measures' });
    element.dataset.measures = id;
    element.append(make('td', '', { colSpan: 3 }));
    for (const method of tableMethods) {
      const cell = make('td', '', { colSpan: parts.length, className: 'first' });
      cell.dataset.method = method;
      element.append(cell);
    }
    this.#measures.set(id, element);
    return element;
  }

  #measuresCell(row: string, method: TableMethod): HTMLTableCellElement {
    return this.#measures.get(row)!.cells[1 + tableMethods.indexOf(method)]!;
  }

  #cells(row: string, method: TableMethod): HTMLTableCellElement[] {
    return [...this.#rows.get(row)!.querySelectorAll<HTMLTableCellElement>('td')].filter(
      (cell) => cell.dataset.method === method,
    );
  }

  clear(): void {
    for (const id of this.#rows.keys()) {
      for (const method of tableMethods) {
        this.#fill(id, method, ['', '', '']);
        this.#measuresCell(id, method).replaceChildren();
      }
    }
  }

  /** Marks the cell under measurement. */
  mark(cell: Pick<TableCell, 'row' | 'method' | 'triangles'> | null): void {
    for (const one of this.#body.querySelectorAll('.now')) one.classList.remove('now');
    if (!cell) return;
    const row = this.#rows.get(cell.row)!;
    row.cells[1]!.textContent = cell.triangles.toLocaleString('en');
    for (const one of this.#cells(cell.row, cell.method)) one.classList.add('now');
  }

  set({ row, method, result }: TableCell): void {
    const texts = parts.map((part) => formatMilliseconds(result[part]));
    this.#fill(row, method, texts);
    this.#cells(row, method).forEach((cell, i) => {
      const detail = details[parts[i]!](result);
      if (detail) cell.append(make('small', detail, { className: 'detail' }));
    });
    const measures = measuresOf(result).map((text) => make('small', text));
    this.#measuresCell(row, method).replaceChildren(...measures);
    const { reason } = result;
    const cells = this.#cells(row, method);
    if (!reason) return;
    const note = make('small', reason, { className: result.ok ? 'note' : 'reason', title: reason });
    // The reason stands beside the times measured before the failure.
    const at = result.traceMs === null ? cells[result.prepareMs === null ? 0 : 1]! : cells[2]!;
    if (result.traceMs === null) at.replaceChildren(note);
    else at.append(note);
  }

  #fill(row: string, method: TableMethod, texts: readonly string[]): void {
    this.#cells(row, method).forEach((cell, i) => {
      cell.textContent = texts[i]!;
    });
  }
}
