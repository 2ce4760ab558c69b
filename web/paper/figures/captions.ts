import { savedReport } from '../claims/saved_report';
import type { Measured } from '../claims/types';
import { lineStyles } from './lines';
import type { Figure, LineId, LineNumbers } from './types';

/** Measurements of a line that a caption can quote. */
const quoted: Record<string, (line: LineNumbers | undefined) => string | undefined> = {
  turn: (line) => (line?.sharpestTurn ? `${line.sharpestTurn.degrees.toFixed(1)}°` : undefined),
  at: (line) => line?.sharpestTurn?.t.toFixed(3),
};

/**
 * The caption with the measurements in place of `{panel/line what}`, so that nobody has to write
 * numbers into the caption.
 */
function filled({ id, caption }: Figure, panels: Measured['panels']): string {
  return caption.replace(/\{(\w+)\/(\w+) (\w+)\}/g, (_, panel, name, what) => {
    const line = panels[`${id}/${panel}`]?.find((one) => one.id === name);
    return quoted[what]!(line) ?? 'an angle that was not measured';
  });
}

/** The settings of a line of the paper's method; null for other lines. */
function setUpOf(id: LineId): string | null {
  const { options } = lineStyles[id];
  if (options?.method !== 'paper') return null;
  const { star = 'wide', seeds = 'heaviest' } = options;
  const form =
    star === 'ring'
      ? 'Eq. 3 as printed, over the faces around a vertex'
      : 'Eq. 3 as in its authors’ program, over the faces around a vertex and those beyond';
  const start =
    seeds === 'authors'
      ? 'searches that start as theirs'
      : 'searches that start at the heaviest points';
  return `${form}, and ${start}`;
}

/**
 * A figure's caption with the settings of the paper's method. Its numbers come from `measured`, by
 * default from the saved report.
 */
export function captionOf(
  figure: Figure,
  measured: Measured['panels'] = savedReport?.panels ?? {},
): string {
  const lines = new Set(figure.panels.flatMap((panel) => panel.lines));
  const names = new Map<string, string[]>();
  for (const id of lines) {
    const setUp = setUpOf(id);
    if (setUp) names.set(setUp, [...(names.get(setUp) ?? []), `“${lineStyles[id].label}”`]);
  }
  const told = [...names].map(([setUp, labels]) => `${labels.join(', ')}: ${setUp}.`);
  return [filled(figure, measured), ...told].join(' ');
}
