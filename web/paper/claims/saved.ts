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

/** A verdict; one whose numbers are of another day than the report's says of which. */
export interface SavedClaim extends JudgedClaim {
  renewed?: Pick<Origin, 'date' | 'version'>;
}

/** The verdicts that `npm run paper -- --save` kept, with what they depend on. */
export interface SavedReport extends Origin {
  claims: SavedClaim[];
  /** What the page plots; reports from before there were plots have none. */
  plots?: SavedPlots;
}
