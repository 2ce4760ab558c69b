import type { SavedReport } from './saved';

/** The saved report, if this checkout has one; a page works without it. */
const found = import.meta.glob<SavedReport>('../../../docs/paper-report.json', {
  eager: true,
  import: 'default',
});
export const savedReport: SavedReport | null = Object.values(found)[0] ?? null;
