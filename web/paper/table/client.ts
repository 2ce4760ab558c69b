import { WorkerClient, type WorkerLike } from 'karcher/own-worker';
import { type MethodResult, nothingMeasured } from 'karcher/peers';
import {
  expectedTriangles,
  segmentsOf,
  type TableCell,
  type TableMethod,
  type TableRow,
  tableMethods,
} from './rows';
import type { TableEvents, TableOptions } from './run';

/** The events of a table's measurement; `end` comes last, unless the client cancels it. */
export interface ClientEvents extends TableEvents {
  end(): void;
}

type Place = Omit<TableCell, 'result'>;

/**
 * The time by which a method may exceed its budget. A method itself can stop only between two
 * steps.
 */
const graceMs = 2000;

const failed = (reason: string): MethodResult => ({ ...nothingMeasured, reason });

const startWorker = () => new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });

/**
 * Measures a table in a worker. A worker may fail, for example because memory runs out, or stay too
 * long in a step. If so, the cell shows the reason, and a new worker measures the next cell.
 */
export class TableClient {
  readonly #left: { row: TableRow; methods: TableMethod[] }[];
  #worker: WorkerClient | null = null;
  /** The cell under measurement. */
  #place: Place | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly options: TableOptions,
    private readonly events: ClientEvents,
    private readonly start: () => WorkerLike = startWorker,
  ) {
    this.#left = options.rows.map((row) => ({ row, methods: [...tableMethods] }));
  }

  run(): void {
    this.#next();
  }

  /** Ends the measurement at once, even within a step. */
  cancel(): void {
    this.#left.length = 0;
    this.#stop();
  }

  #next(): void {
    while (this.#left[0]?.methods.length === 0) this.#left.shift();
    const [job] = this.#left;
    if (!job) {
      this.#stop();
      this.events.end();
      return;
    }
    this.#worker ??= new WorkerClient(this.start());
    const worker = this.#worker;
    const { samples, budgetMs } = this.options;
    const request: TableOptions = { rows: [job.row], methods: job.methods, samples, budgetMs };
    worker.call('run', [request, this.#heard(worker)]).then(
      () => {
        if (worker !== this.#worker) return;
        this.#left.shift();
        this.#next();
      },
      (error) => {
        if (worker === this.#worker) this.#fail(error.message);
      },
    );
  }

  /** Handles the events of a worker, until another replaces it. */
  #heard(worker: WorkerClient): TableEvents {
    const { row, method, progress } = this.events;
    const heard = <Args extends unknown[]>(hear: (...args: Args) => void) => {
      return (...args: Args) => {
        if (worker === this.#worker) hear(...args);
      };
    };
    return {
      row: heard(row),
      method: heard((place) => {
        this.#place = place;
        this.#timer = setTimeout(() => {
          this.#fail(`stopped after ${Math.round(this.options.budgetMs / 1000)} s`);
        }, this.options.budgetMs + graceMs);
        method(place);
      }),
      progress: heard(progress),
      cell: heard((cell) => this.#take(cell)),
    };
  }

  #take(cell: TableCell): void {
    clearTimeout(this.#timer);
    this.#place = null;
    const [job] = this.#left;
    job!.methods = job!.methods.filter((method) => method !== cell.method);
    this.events.cell(cell);
  }

  /**
   * Marks the cell under measurement as failed. If no cell is under measurement, for example
   * because the row's mesh could not be made, marks all remaining cells of the row.
   */
  #fail(reason: string): void {
    const place = this.#place;
    this.#stop();
    const { row, methods } = this.#left[0]!;
    const triangles = expectedTriangles(row.mesh);
    const places: Place[] = place
      ? [place]
      : methods.map((method) => ({
          row: row.id,
          method,
          triangles,
          segments: segmentsOf(row),
        }));
    for (const one of places) this.#take({ ...one, result: failed(reason) });
    this.#next();
  }

  #stop(): void {
    clearTimeout(this.#timer);
    const worker = this.#worker;
    this.#worker = null;
    worker?.dispose();
    this.#place = null;
  }
}
