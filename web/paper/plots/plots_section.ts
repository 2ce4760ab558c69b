import { WorkerClient } from 'karcher/own-worker';
import { make } from '../../panels/elements';
import { build } from '../claims/build';
import { type ConvergencePoint, convergenceSizes, plottedMethods } from '../claims/convergence';
import { noises, type RoughnessPoint } from '../claims/roughness';
import { isOlder, olderNote, type SavedPlots } from '../claims/saved';
import { lineStyles } from '../figures/lines';
import { type ChartAxis, LineChart } from '../view/line_chart';
import { Caption, sectionHead } from '../view/section';
import { lineColor } from '../view/theme_colors';
import { convergencePlot, orderOf, type Plot, roughnessPlot } from './plots';

const short = (value: number) => `${Number(value.toPrecision(2))}`;
const edge: ChartAxis = {
  label: 'Mean edge',
  log: true,
  tick: short,
  exact: (value) => value.toPrecision(3),
};
const error: ChartAxis = { ...edge, label: 'Error', tick: (value) => value.toExponential(0) };
const noise: ChartAxis = { ...edge, label: 'Noise, mean edges', log: false };
const residual: ChartAxis = { ...edge, label: 'Residual, mean edges' };

const oneDigit = (value: number) =>
  (Math.abs(value) < 0.05 ? '0' : value.toFixed(1)).replace('-', '−');

/** The sizes of the plots' meshes. */
export interface PlotSizes {
  convergence: readonly number[];
  roughness: number;
}

const usualSizes: PlotSizes = { convergence: convergenceSizes, roughness: 5_000 };

/** Shows the errors of every method on ever finer meshes, and on ever rougher meshes. */
export class PlotsSection {
  readonly element = make('section', '', { className: 'figure', id: 'plots' });
  readonly #cards = {
    sphere: card('Sphere', edge, error),
    torus: card('Torus', edge, error),
    rough: card('Rough torus', noise, residual),
  };
  readonly #from = make('p', '', { className: 'panel-note' });
  readonly #run = make('button', 'Measure here', { type: 'button', className: 'button primary' });
  readonly #bar = make('progress', '', { max: 1, value: 0, hidden: true });
  readonly #sizes: PlotSizes;
  #convergence: readonly ConvergencePoint[];
  #roughness: readonly RoughnessPoint[];
  #worker: WorkerClient | null = null;

  constructor(report: SavedPlots | null, sizes: PlotSizes = usualSizes) {
    this.#sizes = sizes;
    this.#convergence = report?.convergence ?? [];
    this.#roughness = report?.roughness ?? [];
    const head = sectionHead('Beyond the paper', 'Finer and rougher meshes');
    const caption = new Caption(
      'B-splines of four points on a sphere and on a torus whose every point is known in closed form, against the edges of the mesh: root mean square distances of the samples from the true curve, lost ones left out. On the sphere logarithms are known; on the torus the points lie on one circle round the tube, which is a geodesic. b/Surf’s curve is another one, so its distance does not go to zero; no number is shown where no sample was found. Last is the residual by exact paths of the gallery’s B-spline on a torus of 5,000 triangles whose vertices were moved by seeded noise of that height.',
    );
    const grid = make('div', '', { className: 'panels plots' });
    for (const { element } of Object.values(this.#cards)) grid.append(element);
    const controls = make('div', '', { className: 'table-status' });
    this.#from.setAttribute('role', 'status');
    this.#bar.setAttribute('aria-label', 'How much is measured');
    controls.append(this.#run, this.#bar, this.#from);
    this.element.append(head, caption.element, controls, grid);
    this.#from.textContent = report
      ? `Measured on ${report.date} by version ${report.version} with seed ${report.seed} on ${report.machine}${isOlder(report, build) ? `, ${olderNote}` : ''}.`
      : 'Nothing is measured yet.';
    this.#run.addEventListener('click', () => (this.#worker ? this.cancel() : this.start()));
    this.#show();
  }

  get settled(): boolean {
    return this.#worker === null;
  }

  get measured() {
    return { convergence: this.#convergence, roughness: this.#roughness };
  }

  recolor(): void {
    for (const { chart } of Object.values(this.#cards)) chart.redraw();
  }

  /** Measures everything in this browser, in a minute or two. */
  start(): void {
    const worker = new WorkerClient(
      new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }),
    );
    this.#worker = worker;
    this.#convergence = [];
    this.#roughness = [];
    this.#show();
    this.#run.textContent = 'Cancel';
    this.#bar.hidden = false;
    this.#bar.value = 0;
    this.#from.textContent = 'Measuring…';
    const all = plottedMethods.length * (2 * this.#sizes.convergence.length + noises.length);
    const heard = () => worker === this.#worker;
    const shown = () => {
      this.#bar.value = (this.#convergence.length + this.#roughness.length) / all;
      this.#show();
    };
    const work = async () => {
      const { convergence, roughness } = this.#sizes;
      await worker.call('convergence', [
        convergence,
        (points: ConvergencePoint[]) => {
          if (!heard()) return;
          this.#convergence = points;
          shown();
        },
      ]);
      await worker.call('roughness', [
        roughness,
        (points: RoughnessPoint[]) => {
          if (!heard()) return;
          this.#roughness = points;
          shown();
        },
      ]);
    };
    work().then(
      () => heard() && this.#stop('Measured in your browser.'),
      (failure) => heard() && this.#stop(failure instanceof Error ? failure.message : `${failure}`),
    );
  }

  cancel(): void {
    this.#stop('Cancelled.');
  }

  #stop(message: string): void {
    const worker = this.#worker;
    this.#worker = null;
    worker?.dispose();
    this.#run.textContent = 'Measure here';
    this.#bar.hidden = true;
    this.#from.textContent = message;
  }

  #show(): void {
    const { sphere, torus, rough } = this.#cards;
    sphere.show(convergencePlot(this.#convergence, 'sphere'), true);
    torus.show(convergencePlot(this.#convergence, 'torus'), true);
    rough.show(roughnessPlot(this.#roughness), false);
  }
}

/** A chart with its heading, and the orders of convergence if its axes are logarithmic. */
function card(title: string, x: ChartAxis, y: ChartAxis) {
  const element = make('article', '', { className: 'panel-card' });
  const chart = new LineChart({ x, y });
  const orders = make('p', '', { className: 'panel-note' });
  const head = make('header', '', { className: 'panel-head' });
  head.append(make('h3', title));
  element.append(head, chart.element, orders);
  return {
    element,
    chart,
    show(plot: Plot, withOrders: boolean) {
      chart.show(() => ({
        x: plot.x,
        lines: plot.lines.map(({ method, values }) => ({
          label: lineStyles[method].label,
          color: lineColor(method),
          dashed: method === 'karcherExact',
          values,
        })),
      }));
      const told = plot.lines.flatMap(({ method, values }) => {
        const order = withOrders ? orderOf(plot, values) : null;
        return order === null ? [] : [`${lineStyles[method].label} ${oneDigit(order)}`];
      });
      orders.textContent = told.length > 0 ? `Order of convergence: ${told.join(', ')}.` : '';
    },
  };
}
