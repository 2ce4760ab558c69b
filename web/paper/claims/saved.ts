import type { JudgedClaim } from './types';

/** The verdicts that `npm run paper -- --save` kept, with what they depend on. */
export interface SavedReport {
  /** YYYY-MM-DD. */
  date: string;
  machine: string;
  version: string;
  /** Of the random numbers of its studies. */
  seed: number;
  claims: JudgedClaim[];
}
