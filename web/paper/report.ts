import { loadPeers } from 'karcher/peers';
import { lineStyles } from './figures/lines';
import { panelTitle } from './figures/titles';
import type { Figure, LineResult } from './figures/types';
import { Lab } from './lab/lab';
import { type TableRow, tableMethodNames } from './table/rows';
import { runTable } from './table/run';

const figure = (value: number | null, digits: number) =>
  value === null ? '–' : value === 0 ? '0' : value.toPrecision(digits);

/** The numbers of a line as cells of a table; a line that failed has its reason. */
export function cells(line: LineResult): string[] {
  if (!line.ok) return [`failed: ${line.reason}`, '', '', '', '', ''];
  if (line.residual !== null) {
    return [`its own residual: ${figure(line.residual, 3)}`, '', '', '', '', ''];
  }
  return [
    figure(line.deviation?.median ?? null, 3),
    figure(line.deviation?.max ?? null, 3),
    figure(line.turningNoise, 3),
    line.lost === null ? '–' : `${line.lost} of ${line.samples}`,
    figure(line.prepareMs, 3),
    figure(line.traceMs, 3),
  ];
}

const markdownTable = (rows: readonly string[][]) =>
  [rows[0]!, rows[0]!.map(() => '---'), ...rows.slice(1)]
    .map((row) => `| ${row.join(' | ')} |`)
    .join('\n');

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
      const title = panelTitle(panel, panel.curve);
      tell(`${name}, ${title}`);
      const { info } = await lab.mesh(panel.mesh);
      const lines = await lab.lines(panel, points[panel.points]!);
      const rows = [heads, ...lines.map((line) => [lineStyles[line.id].label, ...cells(line)])];
      parts.push(
        `### ${title}, ${info.triangles.toLocaleString('en')} triangles`,
        markdownTable(rows),
      );
    }
  }
  return `${parts.join('\n\n')}\n`;
}

/** Measures Table 1 in these rows and writes it as Markdown. */
export async function tableReport(
  options: { rows: readonly TableRow[]; samples: number; budgetMs: number },
  tell: (what: string) => void = () => {},
): Promise<string> {
  const rows: string[][] = [
    ['curve', 'triangles', 'segments', 'method', 'prepare ms', 'trace ms', 'update ms', 'lost'],
  ];
  await runTable(await loadPeers(), options, {
    row: () => {},
    progress: () => {},
    method: ({ row, method }) => tell(`Table 1, ${row}: ${tableMethodNames[method]}`),
    cell: ({ row, method, triangles, segments, result }) => {
      const { name } = options.rows.find(({ id }) => id === row)!;
      const times = [result.prepareMs, result.traceMs, result.dragMs];
      rows.push([
        ...[name, triangles.toLocaleString('en'), `${segments}`, tableMethodNames[method]],
        ...times.map((time) => figure(time, 3)),
        result.reason ?? `${result.lost} of ${result.samples}`,
      ]);
    },
  });
  const about = `${options.samples} samples a segment; a method gives up after ${options.budgetMs / 1000} s.`;
  return `## Table 1\n\n${about}\n\n${markdownTable(rows)}\n`;
}
