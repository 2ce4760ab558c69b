import { lineStyles } from './lines';
import type { Figure, LineId } from './types';

/** How a line of the paper's method is set up; null of others. */
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

/** A figure's caption, and how the paper's method is set up in it. */
export function captionOf({ caption, panels }: Figure): string {
  const lines = new Set(panels.flatMap((panel) => panel.lines));
  const names = new Map<string, string[]>();
  for (const id of lines) {
    const setUp = setUpOf(id);
    if (setUp) names.set(setUp, [...(names.get(setUp) ?? []), `“${lineStyles[id].label}”`]);
  }
  const told = [...names].map(([setUp, labels]) => `${labels.join(', ')}: ${setUp}.`);
  return [caption, ...told].join(' ');
}
