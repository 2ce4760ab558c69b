import { LineChart } from '../view/line_chart';
import { lineColor } from '../view/theme_colors';
import { type TableCell, tableMethodNames, tableMethods } from './rows';
import { type Measure, seriesOf } from './series';

/** A chart of milliseconds against triangles, both on logarithmic scales. */
export class TableChart {
  readonly #chart = new LineChart({
    x: {
      label: 'Triangles',
      log: true,
      tick: (value) => (value >= 1000 ? `${value / 1000}k` : `${value}`),
      exact: (value) => value.toLocaleString('en'),
    },
    y: {
      label: 'Time',
      log: true,
      tick: (value) => (value >= 1000 ? `${(value / 1000).toLocaleString('en')} s` : `${value} ms`),
      exact: (value) => `${value.toFixed(1)} ms`,
    },
  });

  get element(): HTMLElement {
    return this.#chart.element;
  }

  show(cells: readonly TableCell[], measure: Measure): void {
    this.#chart.show(() => {
      const [x, ...series] = seriesOf(cells, measure);
      const lines = tableMethods.map((method, i) => ({
        label: tableMethodNames[method],
        color: lineColor(method),
        values: series[i] as (number | null)[],
      }));
      return { x: x as number[], lines };
    });
  }

  redraw(): void {
    this.#chart.redraw();
  }
}
