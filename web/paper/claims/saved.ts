import type { Studies } from './studies';
import type { JudgedClaim } from './types';

/** Where and when something was measured. */
interface Origin {
  /** YYYY-MM-DD. */
  date: string;
  machine: string;
  version: string;
  /** Of the random numbers of its studies. */
  seed: number;
}

export interface SavedPlots extends Origin, Pick<Studies, 'convergence' | 'roughness'> {}

/** The verdicts that `npm run paper -- --save` kept, with what they depend on. */
export interface SavedReport extends Origin {
  claims: JudgedClaim[];
  /** What the page plots; reports from before there were plots have none. */
  plots?: SavedPlots;
}
