import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { lineColor } from '../view/theme_colors';
import { type TableCell, tableMethodNames, tableMethods } from './rows';
import { type Measure, seriesOf } from './series';

const ticks = (value: number) =>
  value >= 1000 ? `${(value / 1000).toLocaleString('en')} s` : `${value} ms`;
const counts = (value: number) => (value >= 1000 ? `${value / 1000}k` : `${value}`);

/** Milliseconds against triangles, both on logarithmic scales. */
export class TableChart {
  readonly element = document.createElement('div');
  #plot: uPlot | null = null;
  #cells: readonly TableCell[] = [];
  #measure: Measure = 'traceMs';

  constructor() {
    this.element.className = 'chart';
    new ResizeObserver(() => this.#resize()).observe(this.element);
  }

  show(cells: readonly TableCell[], measure: Measure): void {
    this.#cells = cells;
    this.#measure = measure;
    this.redraw();
  }

  /** Anew, as for another theme. */
  redraw(): void {
    this.#plot?.destroy();
    this.#plot = null;
    const data = seriesOf(this.#cells, this.#measure);
    if (data[0]!.length === 0 || this.element.clientWidth === 0) return;
    this.#plot = new uPlot(this.#options(), data, this.element);
  }

  #options(): uPlot.Options {
    const style = getComputedStyle(this.element);
    const [ink, line] = ['--ink-soft', '--line'].map((name) => resolved(this.element, name));
    const axis = {
      stroke: ink!,
      font: `12px ${style.fontFamily}`,
      grid: { stroke: line!, width: 1 },
      ticks: { stroke: line!, width: 1 },
    };
    return {
      width: this.element.clientWidth,
      height: 320,
      scales: { x: { time: false, distr: 3 }, y: { distr: 3 } },
      axes: [
        { ...axis, values: (_, values) => values.map((v) => (v === null ? '' : counts(v))) },
        {
          ...axis,
          size: 64,
          values: (_, values) => values.map((v) => (v === null ? '' : ticks(v))),
        },
      ],
      series: [
        {
          label: 'Triangles',
          value: (_, value) => (value === null ? '–' : value.toLocaleString('en')),
        },
        ...tableMethods.map((method) => ({
          label: tableMethodNames[method],
          stroke: lineColor(method),
          width: 2,
          spanGaps: false,
          points: { show: true, size: 7 },
          value: (_: uPlot, value: number | null) =>
            value === null ? '–' : `${value.toFixed(1)} ms`,
        })),
      ],
    };
  }

  #resize(): void {
    const { clientWidth: width } = this.element;
    if (width === 0) return;
    if (this.#plot) this.#plot.setSize({ width, height: 320 });
    else this.redraw();
  }
}

function resolved(element: HTMLElement, name: string): string {
  const probe = element.appendChild(document.createElement('i'));
  probe.style.color = `var(${name})`;
  const { color } = getComputedStyle(probe);
  probe.remove();
  return color;
}
