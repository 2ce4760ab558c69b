import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

export interface ChartLine {
  label: string;
  /** The resolved color, since a canvas knows no custom properties. */
  color: string;
  /** Whether the line is dashed, since another line has the same color. */
  dashed?: boolean;
  /** A value for each place on the x axis; null is a gap. */
  values: readonly (number | null)[];
}

export interface ChartAxis {
  label: string;
  /** Whether the scale is logarithmic and excludes zero. */
  log: boolean;
  tick(value: number): string;
  /** The text of a value in the legend. */
  exact(value: number): string;
}

export interface ChartContent {
  x: readonly number[];
  lines: readonly ChartLine[];
}

const height = 320;
/** The factor by which a logarithmic axis exceeds its values at either end. */
const roomAtEnds = 1.08;

/** A chart of lines over an axis, as wide as its element. */
export class LineChart {
  readonly element = document.createElement('div');
  readonly #axes: { x: ChartAxis; y: ChartAxis };
  #plot: uPlot | null = null;
  #content: () => ChartContent = () => ({ x: [], lines: [] });

  constructor(axes: { x: ChartAxis; y: ChartAxis }) {
    this.#axes = axes;
    this.element.className = 'chart';
    new ResizeObserver(() => this.#resize()).observe(this.element);
  }

  /** Draws the chart. If the colors change, it calls `content` again. */
  show(content: () => ChartContent): void {
    this.#content = content;
    this.redraw();
  }

  /** Draws the chart anew, for example for another theme. */
  redraw(): void {
    this.#plot?.destroy();
    this.#plot = null;
    const { x, lines } = this.#content();
    if (x.length === 0 || this.element.clientWidth === 0) return;
    const data = [[...x], ...lines.map(({ values }) => [...values])] as uPlot.AlignedData;
    this.#plot = new uPlot(this.#options(lines), data, this.element);
  }

  #options(lines: readonly ChartLine[]): uPlot.Options {
    const { x, y } = this.#axes;
    const style = getComputedStyle(this.element);
    const [ink, line] = ['--ink-soft', '--line'].map((name) => resolved(this.element, name));
    const axis = ({ label, tick }: ChartAxis): uPlot.Axis => ({
      stroke: ink!,
      font: `12px ${style.fontFamily}`,
      label,
      labelFont: `12px ${style.fontFamily}`,
      labelSize: 22,
      grid: { stroke: line!, width: 1 },
      ticks: { stroke: line!, width: 1 },
      values: (_, values) => values.map((v) => (v === null ? '' : tick(v))),
    });
    const legend = (exact: ChartAxis['exact']) => (_: uPlot, value: number | null) =>
      value === null ? '–' : exact(value);
    const scale = ({ log }: ChartAxis) => ({ time: false, distr: log ? 3 : 1 }) as const;
    return {
      width: this.element.clientWidth,
      height,
      // Whole decades would leave most of a short axis empty.
      scales: { x: { ...scale(x), ...(x.log && { range: around }) }, y: scale(y) },
      axes: [
        { ...axis(x), ...(x.log && { filter: onlyRound }) },
        { ...axis(y), size: 64 },
      ],
      series: [
        { label: x.label, value: legend(x.exact) },
        ...lines.map(({ label, color, dashed }) => ({
          label,
          stroke: color,
          width: 2,
          ...(dashed && { dash: [6, 4] }),
          spanGaps: false,
          points: { show: true, size: 7 },
          value: legend(y.exact),
        })),
      ],
    };
  }

  #resize(): void {
    const { clientWidth: width } = this.element;
    if (width === 0) return;
    if (this.#plot) this.#plot.setSize({ width, height });
    else this.redraw();
  }
}

/** The range of a logarithmic axis: the range of its values, with a little room at either end. */
const around = (_: uPlot, least: number, most: number): uPlot.Range.MinMax => [
  least / roomAtEnds,
  most * roomAtEnds,
];

/** The labels of a logarithmic axis. In each decade, only the marks at 1, 2 and 5 have numbers. */
const onlyRound = (_: uPlot, splits: number[]): (number | null)[] =>
  splits.map((value) => ('125'.includes(value.toExponential()[0]!) ? value : null));

function resolved(element: HTMLElement, name: string): string {
  const probe = element.appendChild(document.createElement('i'));
  probe.style.color = `var(${name})`;
  const { color } = getComputedStyle(probe);
  probe.remove();
  return color;
}
