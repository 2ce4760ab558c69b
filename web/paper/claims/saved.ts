import type { TableCell } from '../table/rows';
import type { Studies } from './studies';
import type { JudgedClaim, Measured } from './types';

/** Where and when something was measured. */
interface Origin {
  /** YYYY-MM-DD. */
  date: string;
  machine: string;
  version: string;
  /** Digest of the sources that decide the numbers; reports from before it was saved have none. */
  sources?: string;
  /** Of the random numbers of its studies. */
  seed: number;
}

export interface SavedPlots extends Origin, Pick<Studies, 'convergence' | 'roughness'> {}

/** A verdict; one whose numbers are of another day than the report's says of which. */
export interface SavedClaim extends JudgedClaim {
  renewed?: Pick<Origin, 'date' | 'version' | 'sources'>;
}

/** The verdicts that `npm run paper -- --save` kept, with what they depend on. */
export interface SavedReport extends Origin {
  claims: SavedClaim[];
  /** What the page plots; reports from before there were plots have none. */
  plots?: SavedPlots;
  /** What the figures' lines were measured to be, by `figure/panel`. */
  panels?: Measured['panels'];
  /** Table 1 with so many samples a segment. */
  table?: { samples: number; cells: TableCell[] } | null;
  /** What the claims are judged by besides; reports from before it was kept have none. */
  studies?: Measured['studies'];
  meshes?: Measured['meshes'];
  load?: Measured['load'];
}

/** The code that a page was built from. */
export interface Build {
  /** The version and the commit. */
  version: string;
  sources: string;
}

/** Whether the code has changed since something was measured; without a digest the commit tells. */
export function isOlder(
  { version, sources }: Pick<Origin, 'version' | 'sources'>,
  build: Build,
): boolean {
  return sources === undefined ? version !== build.version : sources !== build.sources;
}

/** When and where saved numbers were measured. */
export const originWords = ({ date, version, machine }: Origin) =>
  `Measured on ${date} by version ${version} on ${machine}`;

/** What is said of it. */
export const olderNote = 'of an older version of the code';
