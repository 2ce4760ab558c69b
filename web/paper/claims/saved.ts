import type { TableCell } from '../table/rows';
import type { Studies } from './studies';
import type { JudgedClaim, Measured } from './types';

/** The place and time of a measurement. */
interface Origin {
  /** The date as YYYY-MM-DD. */
  date: string;
  machine: string;
  version: string;
  /** The digest of the sources that decide the numbers; older reports have none. */
  sources?: string;
  /** The seed of the random numbers of the studies. */
  seed: number;
}

export interface SavedPlots extends Origin, Pick<Studies, 'convergence' | 'roughness'> {}

/** A verdict. It has a date of its own if its numbers are newer than the report's. */
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
  /** Table 1, measured with this number of samples a segment. */
  table?: { samples: number; cells: TableCell[] } | null;
  /** Further measurements for the claims; older reports have none. */
  studies?: Measured['studies'];
  meshes?: Measured['meshes'];
  load?: Measured['load'];
}

/** The code of a page. */
export interface Build {
  /** The version with its commit. */
  version: string;
  sources: string;
}

/** Whether the code has changed since a measurement; without a digest the commit decides. */
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
