import { loadPeers, type MethodResult } from 'karcher/peers';
import type { MeshFinding } from './claims/meshes';
import type { JudgedClaim, Measured } from './claims/types';
import { captionOf } from './figures/captions';
import { lineStyles } from './figures/lines';
import { panelTitle } from './figures/titles';
import type { Figure, LineResult } from './figures/types';
import { uniquenessWords } from './lab/center';
import { Lab } from './lab/lab';
import {
  asUsedMs,
  publishedNote,
  type TableCell,
  type TableRow,
  tableMethodNames,
} from './table/rows';
import { runTable } from './table/run';

const figure = (value: number | null, digits: number) =>
  value === null ? '–' : value === 0 ? '0' : value.toPrecision(digits);

/** The cells of a line in a table: the line's numbers, or the reason why it failed. */
export function cells(line: LineResult): string[] {
  if (!line.ok) return [`failed: ${line.reason}`, ...heads.slice(2).map(() => '')];
  const { drag } = line;
  const { deviation, samples, lost, lostByOwnRule, ruler } = line;
  const part = (count: number, of: number) => (count < of ? ` over ${count} of ${of}` : '');
  return [
    figure(ruler?.residual?.median ?? null, 3) + (ruler ? part(ruler.measured, ruler.of) : ''),
    figure(ruler?.energy?.excess ?? null, 2),
    figure(deviation?.median ?? null, 3) +
      (deviation && samples !== null ? part(deviation.samples, samples) : ''),
    figure(deviation?.max ?? null, 3),
    figure(line.turningNoise, 3),
    lost === null ? '–' : `${lost} of ${samples}`,
    lostByOwnRule === null ? '–' : `${lostByOwnRule}`,
    line.breaks === null ? '–' : `${line.breaks}`,
    line.sharpestTurn
      ? `${line.sharpestTurn.degrees.toFixed(1)} at ${line.sharpestTurn.t.toFixed(3)}`
      : '–',
    drag ? `${drag.leaps} of ${drag.steps}, ×${drag.most?.toFixed(1) ?? '–'}` : '–',
    figure(line.prepareMs, 3),
    figure(line.traceMs, 3),
  ];
}

/**
 * The residual and the energy by exact paths, and the number of measured samples if some were lost.
 */
function ruled({ ruler }: MethodResult): [string, string] {
  const residual = figure(ruler?.residual?.median ?? null, 3);
  const over = ruler && ruler.measured < ruler.of ? ` over ${ruler.measured} of ${ruler.of}` : '';
  return [residual + over, figure(ruler?.energy?.median ?? null, 3)];
}

const markdownTable = (rows: readonly string[][]) =>
  [rows[0]!, rows[0]!.map(() => '---'), ...rows.slice(1)]
    .map((row) => `| ${row.join(' | ')} |`)
    .join('\n');

/**
 * The heads of a table: first the measurements by exact paths, which treat all methods alike, then
 * the deviation from a reference, and further numbers.
 */
const heads = [
  ...[
    '',
    'residual h',
    'energy − reference’s h²',
    'median h',
    'max h',
    'turning noise',
    'lost',
    'lost by own rule',
    'breaks',
  ],
  'sharpest turn, degrees, at t',
  'leaps under a drag',
  ...['prepare ms', 'trace ms'],
];

/** Figures about leaps in a drag; in other figures this measurement would take too long. */
const draggedFigures: ReadonlySet<string> = new Set(['far']);

/** A figure's report: its numbers, as Markdown and as data. */
export interface FiguresReport {
  text: string;
  panels: Measured['panels'];
}

/** Computes every figure and writes its numbers as Markdown. */
export async function report(
  figures: readonly Figure[],
  tell: (what: string) => void = () => {},
): Promise<FiguresReport> {
  const lab = new Lab(await loadPeers());
  const parts: string[] = [];
  const panels: Measured['panels'] = {};
  for (const figure of figures) {
    const { id, name, title, points, panels: ofFigure } = figure;
    const caption = parts.push(`## ${name}: ${title}`, '') - 1;
    for (const panel of ofFigure) {
      const title = panelTitle(panel, panel.curve);
      tell(`${name}, ${title}`);
      const { info } = await lab.mesh(panel.mesh);
      const lines = await lab.lines(panel, points[panel.points]!);
      if (draggedFigures.has(id)) {
        await lab.drag(panel, points[panel.points]!, panel.lines, (one, drag) => {
          lines.find((line) => line.id === one)!.drag = drag;
        });
      }
      const rows = [heads, ...lines.map((line) => [lineStyles[line.id].label, ...cells(line)])];
      parts.push(
        `### ${title}, ${info.triangles.toLocaleString('en')} triangles`,
        markdownTable(rows),
      );
      const { curve, mesh } = panel;
      if (curve.kind === 'center') {
        const center = await lab.center(mesh, points[panel.points]!, curve.weights);
        parts.push(uniquenessWords(center));
      }
      panels[`${id}/${panel.id}`] = lines.map(
        ({ polylines: _, status: __, marker: ___, ...numbers }) => numbers,
      );
    }
    parts[caption] = captionOf(figure, panels);
  }
  return { text: `${parts.join('\n\n')}\n`, panels };
}

/** Measures these rows of Table 1 and writes them as Markdown. */
export async function tableReport(
  options: { rows: readonly TableRow[]; samples: number; budgetMs: number },
  tell: (what: string) => void = () => {},
): Promise<{ text: string; cells: TableCell[] }> {
  const rows: string[][] = [
    [
      ...['curve', 'triangles', 'segments', 'method', 'prepare ms', 'MB', 'trace ms', 'fields ms'],
      ...[
        'trace ms, a log map each',
        'update ms',
        'field ms',
        'lost',
        'lost by own rule',
        'residual h',
        'energy h²',
      ],
    ],
  ];
  const cells: TableCell[] = [];
  await runTable(await loadPeers(), options, {
    row: () => {},
    progress: () => {},
    method: ({ row, method }) => tell(`Table 1, ${row}: ${tableMethodNames[method]}`),
    cell: (cell) => {
      cells.push(cell);
      const { row, method, triangles, segments, result } = cell;
      const { name } = options.rows.find(({ id }) => id === row)!;
      const times = [
        ...[result.prepareMs, result.memory && result.memory / 1e6, result.traceMs],
        ...[result.fieldsMs, asUsedMs(result), result.dragMs, result.dragFieldMs],
      ];
      rows.push([
        ...[name, triangles.toLocaleString('en'), `${segments}`, tableMethodNames[method]],
        ...times.map((time) => figure(time, 3)),
        result.reason ?? `${result.lost} of ${result.samples}`,
        result.lostByOwnRule === null ? '–' : `${result.lostByOwnRule}`,
        ...ruled(result),
      ]);
    },
  });
  const about = `${options.samples} samples a segment; a method gives up after ${options.budgetMs / 1000} s. A log map each: as the heat methods’ library has it, which computes one at each evaluation; reckoned from the time of those computed and from how many were asked for. Residuals and energies are by exact paths at 33 samples. MB: what a method holds with its curve, the mesh apart. ${publishedNote}`;
  return { text: `## Table 1\n\n${about}\n\n${markdownTable(rows)}\n`, cells };
}

/** The claims and their verdicts as Markdown. */
export function claimsReport(claims: readonly JudgedClaim[]): string {
  const rows = claims.map(({ where, claim, measured, verdict, on }) => [
    where,
    claim,
    measured,
    on ? `${verdict}: ${on}` : verdict,
  ]);
  const heads = ['where', 'the paper says', 'measured', 'verdict'];
  return `## Claims\n\n${markdownTable([heads, ...rows])}\n`;
}

/** The results of each method on a folder's meshes, as Markdown. */
export function meshesReport(meshes: readonly MeshFinding[]): string {
  const heads = [
    'mesh',
    'triangles',
    'method',
    'prepare ms',
    'trace ms',
    'lost',
    'lost by own rule',
  ];
  const rows = meshes.flatMap(({ name, triangles, methods }) =>
    methods.map(({ method, result }) => [
      ...[name, triangles.toLocaleString('en'), method],
      ...[figure(result.prepareMs, 3), figure(result.traceMs, 3)],
      result.reason ?? `${result.lost} of ${result.samples}`,
      result.lostByOwnRule === null ? '–' : `${result.lostByOwnRule}`,
      ...[figure(result.deviation?.median ?? null, 3), figure(result.turningNoise, 3)],
      `${result.breaks ?? '–'}`,
      ...ruled(result),
    ]),
  );
  const all = [...heads, 'median h', 'turning noise', 'breaks', 'residual h', 'energy h²'];
  return `## Meshes of a folder\n\n${markdownTable([all, ...rows])}\n`;
}
