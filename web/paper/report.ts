import { loadPeers } from 'karcher/peers';
import { lineStyles } from './figures/lines';
import type { Figure, LineResult } from './figures/types';
import { Lab } from './lab/lab';

const figure = (value: number | null, digits: number) =>
  value === null ? '–' : value === 0 ? '0' : value.toPrecision(digits);

/** The numbers of a line as cells of a table; a line that failed has its reason. */
export function cells(line: LineResult): string[] {
  if (!line.ok) return [`failed: ${line.reason}`, '', '', '', '', ''];
  return [
    figure(line.deviation?.median ?? null, 3),
    figure(line.deviation?.max ?? null, 3),
    figure(line.turningNoise, 3),
    line.lost === null ? '–' : `${line.lost} of ${line.samples}`,
    figure(line.prepareMs, 3),
    figure(line.traceMs, 3),
  ];
}

const heads = ['', 'median h', 'max h', 'turning noise', 'lost', 'prepare ms', 'trace ms'];

/** Computes every figure and writes its numbers as Markdown. */
export async function report(
  figures: readonly Figure[],
  tell: (what: string) => void = () => {},
): Promise<string> {
  const lab = new Lab(await loadPeers());
  const parts: string[] = [];
  for (const { name, title, caption, points, panels } of figures) {
    parts.push(`## ${name}: ${title}`, caption);
    for (const panel of panels) {
      tell(`${name}, ${panel.title}`);
      const { info } = await lab.mesh(panel.mesh);
      const lines = await lab.lines(panel, points[panel.points]!);
      const rows = [
        heads,
        heads.map(() => '---'),
        ...lines.map((line) => [lineStyles[line.id].label, ...cells(line)]),
      ];
      parts.push(
        `### ${panel.title}, ${info.triangles.toLocaleString('en')} triangles`,
        rows.map((row) => `| ${row.join(' | ')} |`).join('\n'),
      );
    }
  }
  return `${parts.join('\n\n')}\n`;
}
