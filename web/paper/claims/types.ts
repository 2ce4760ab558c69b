import type { LineId, LineNumbers } from '../figures/types';
import type { TableCell } from '../table/rows';
import type { MeshFinding } from './meshes';
import type { Studies } from './studies';

/** The measurements for the claims: numbers only, as a report stores them. */
export interface Measured {
  /** The lines of each panel, by `figure/panel`. */
  panels: Record<string, LineNumbers[]>;
  table: TableCell[];
  studies: Partial<Studies>;
  /** Results on meshes outside the project; null without a folder of them. */
  meshes: MeshFinding[] | null;
  /** The load of the machine; null without a measurement. */
  load: MachineLoad | null;
}

/**
 * The load of a machine during the measurement: the largest number of threads that wanted to run at
 * once, and the number of cores.
 */
export interface MachineLoad {
  most: number;
  cores: number;
}

/** Whether every thread had a core of its own, so that times measure the work. */
const isQuiet = (load: MachineLoad | null): boolean => load !== null && load.most <= load.cores;

/**
 * - `settled here`: this project answers a question that the paper leaves open;
 * - `open`: the verdict depends on times, and the machine was not quiet.
 */
export type Verdict =
  | 'holds'
  | 'does not'
  | 'depends'
  | 'settled here'
  | 'open'
  | 'not measured here';

/** A verdict on a claim by the measurements. */
export interface Finding {
  verdict: Verdict;
  /** The condition on which the verdict depends. */
  on?: string;
  /** The numbers, as a sentence. */
  measured: string;
}

export interface Claim {
  id: string;
  /** The place in the paper. */
  where: string;
  /** The claim in our words. */
  claim: string;
  /** The figure of the page that shows the claim. */
  figure?: string;
  /** Judges the claim. Throws `NotMeasured` if a number that it needs is missing. */
  judge(evidence: Evidence): Finding;
}

/** A claim with its verdict. */
export interface JudgedClaim extends Finding {
  id: string;
  where: string;
  claim: string;
  figure?: string;
}

export class NotMeasured extends Error {}

/** The measurements for the claims. A method throws `NotMeasured` if its number is missing. */
export class Evidence {
  /** Methods that failed, with the reasons: all of their samples count as lost. */
  readonly failed = new Map<string, string>();
  /** Whether a judgement stayed open because the machine was not quiet. */
  heldOpen = false;

  constructor(readonly all: Measured) {}

  /** Whether times may decide: on a busy machine they also measure the machine's other work. */
  timesDecide(): boolean {
    const quiet = isQuiet(this.all.load);
    if (!quiet) this.heldOpen = true;
    return quiet;
  }

  line(panel: string, id: LineId): LineNumbers {
    const line = this.all.panels[panel]?.find((one) => one.id === id);
    if (!line) throw new NotMeasured(`${id} of ${panel}`);
    return line;
  }

  /** A line whose method did not fail. */
  #whole(panel: string, id: LineId): LineNumbers {
    const line = this.line(panel, id);
    if (!line.ok) throw new NotMeasured(`${id} of ${panel}, which failed: ${line.reason}`);
    return line;
  }

  /** The number of samples that a line lost; a failed method loses all samples of the panel. */
  lost(panel: string, id: LineId): { lost: number; own: number; samples: number } {
    const { ok, reason, samples, lost, lostByOwnRule } = this.line(panel, id);
    if (ok) {
      const of = `${id} of ${panel}`;
      return {
        lost: known(lost, `lost samples of ${of}`),
        own: known(lostByOwnRule ?? lost, `lost samples of ${of}`),
        samples: known(samples, `samples of ${of}`),
      };
    }
    this.failed.set(`${id} of ${panel}`, reason ?? 'no reason');
    const asked = samples ?? Math.max(0, ...this.all.panels[panel]!.map((one) => one.samples ?? 0));
    if (asked === 0) throw new NotMeasured(`${id} of ${panel}, which failed: ${reason}`);
    return { lost: asked, own: asked, samples: asked };
  }

  /** Distances from the reference. */
  deviation(panel: string, id: LineId): NonNullable<LineNumbers['deviation']> {
    return known(this.#whole(panel, id).deviation, `the deviation of ${id} of ${panel}`);
  }

  turning(panel: string, id: LineId): number {
    return known(this.#whole(panel, id).turningNoise, `the turning of ${id} of ${panel}`);
  }

  /** The median residual by exact paths. */
  residual(panel: string, id: LineId): number {
    const median = this.#whole(panel, id).ruler?.residual?.median ?? null;
    return known(median, `the residual of ${id} of ${panel}`);
  }

  traceMs(panel: string, id: LineId): number {
    return known(this.#whole(panel, id).traceMs, `the time of ${id} of ${panel}`);
  }

  /** The panels with measurements of all these lines. */
  panelsWith(...ids: LineId[]): string[] {
    const names = Object.keys(this.all.panels).filter((name) =>
      ids.every((id) => this.all.panels[name]!.some((line) => line.id === id)),
    );
    if (names.length === 0) throw new NotMeasured(`panels with ${ids}`);
    return names;
  }

  study<Name extends keyof Studies>(name: Name): Studies[Name] {
    const study = this.all.studies[name];
    if (study === undefined) throw new NotMeasured(`the study ${name}`);
    return study;
  }

  cells(method: TableCell['method']): TableCell[] {
    const cells = this.all.table.filter((cell) => cell.method === method && cell.segments > 1);
    if (cells.length === 0) throw new NotMeasured('Table 1');
    return cells;
  }

  meshes(): MeshFinding[] {
    if (!this.all.meshes) throw new NotMeasured('meshes that the project does not hold');
    return this.all.meshes;
  }
}

function known<Value>(value: Value | null, what: string): Value {
  if (value === null) throw new NotMeasured(what);
  return value;
}
