import type { TableCell } from '../table/rows';
import type { Studies } from './studies';
import type { JudgedClaim, Measured } from './types';

/** Where and when something was measured. */
interface Origin {
  /** The date as YYYY-MM-DD. */
  date: string;
  machine: string;
  version: string;
  /** Digest of the sources that decide the numbers; older reports have none. */
  sources?: string;
  /** The seed of the random numbers of the studies. */
  seed: number;
}

export interface SavedPlots extends Origin, Pick<Studies, 'convergence' | 'roughness'> {}

/** A verdict; it has a date of its own if its numbers were not measured with the report's. */
export interface SavedClaim extends JudgedClaim {
  renewed?: Pick<Origin, 'date' | 'version' | 'sources'>;
}

/** The verdicts that `npm run paper -- --save` saved, with the numbers that they depend on. */
export interface SavedReport extends Origin {
  claims: SavedClaim[];
  /** The numbers of the page's plots; older reports have none. */
  plots?: SavedPlots;
  /** The measurements of the figures' lines, by `figure/panel`. */
  panels?: Measured['panels'];
  /** Table 1 with this many samples a segment. */
  table?: { samples: number; cells: TableCell[] } | null;
  /** Further measurements that the claims are judged by; older reports have none. */
  studies?: Measured['studies'];
  meshes?: Measured['meshes'];
  load?: Measured['load'];
}

/** The code that a page was built from. */
export interface Build {
  /** The version and its commit. */
  version: string;
  sources: string;
}

/**
 * Whether the code has changed since something was measured; without a digest the commit decides.
 */
export function isOlder(
  { version, sources }: Pick<Origin, 'version' | 'sources'>,
  build: Build,
): boolean {
  return sources === undefined ? version !== build.version : sources !== build.sources;
}

/** The place and time of saved numbers, in words. */
export const originWords = ({ date, version, machine }: Origin) =>
  `Measured on ${date} by version ${version} on ${machine}`;

/** The note beside numbers of older code. */
export const olderNote = 'of an older version of the code';
