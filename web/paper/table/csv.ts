import { madeKey } from '../../model/meshes';
import { asUsedMs, type TableCell, type TableRow, tableMethodNames } from './rows';

const heads = [
  ...['browser', 'build', 'row', 'mesh', 'triangles', 'segments', 'samples per segment', 'method'],
  ...['ok', 'reason', 'prepare ms', 'trace ms', 'fields ms', 'trace ms as used'],
  ...['update ms', 'field ms of update', 'bytes', 'samples', 'lost'],
  ...['lost by own rule', 'residual h', 'energy h2'],
];

/** Rounds milliseconds to six digits, to remove the digits that come from rounding errors. */
const time = (value: number | null) => value && Number(value.toPrecision(6));

/** A field, with quotation marks only where CSV needs them. */
const field = (value: string | number | boolean | null) => {
  const text = value === null ? '' : `${value}`;
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

/** The table as CSV, a line for each cell; missing values are empty. */
export function tableCsv(
  rows: readonly TableRow[],
  cells: readonly TableCell[],
  { browser, build, samples }: { browser: string; build: string; samples: number },
): string {
  const lines = cells.map(({ row: id, method, triangles, segments, result }) => {
    const row = rows.find((one) => one.id === id)!;
    return [
      ...[browser, build, row.name, madeKey(row.mesh), triangles, segments, samples],
      ...[
        tableMethodNames[method],
        result.ok,
        result.reason,
        time(result.prepareMs),
        time(result.traceMs),
      ],
      ...[time(result.fieldsMs), time(asUsedMs(result)), time(result.dragMs)],
      ...[
        time(result.dragFieldMs),
        result.memory,
        result.samples,
        result.lost,
        result.lostByOwnRule,
      ],
      ...[result.ruler?.residual?.median ?? null, result.ruler?.energy?.median ?? null],
    ];
  });
  return [heads, ...lines].map((line) => `${line.map(field).join(',')}\n`).join('');
}
