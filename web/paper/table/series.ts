import type { AlignedData } from 'uplot';
import { type TableCell, type TableMethod, tableMethods } from './rows';

export type Measure = 'prepareMs' | 'traceMs' | 'dragMs';

export const measureNames: Record<Measure, string> = {
  prepareMs: 'Preprocessing',
  traceMs: 'Tracing',
  dragMs: 'Update',
};

/**
 * The times of B-splines for each number of triangles. Paths between two points are left out, since
 * they are a different task.
 */
export function seriesOf(cells: readonly TableCell[], measure: Measure): AlignedData {
  const splines = cells.filter(({ segments }) => segments > 1);
  const triangles = [...new Set(splines.map((cell) => cell.triangles))].toSorted((a, b) => a - b);
  const value = (method: TableMethod, count: number) => {
    const cell = splines.find((one) => one.method === method && one.triangles === count);
    // The time until a method failed is not the time of a curve.
    const counts = measure === 'prepareMs' || cell?.result.ok;
    const milliseconds = counts ? (cell?.result[measure] ?? null) : null;
    // A clock shows zero for times below its resolution, and a logarithmic scale has no zero.
    return milliseconds ? milliseconds : null;
  };
  return [
    triangles,
    ...tableMethods.map((method) => triangles.map((count) => value(method, count))),
  ] as AlignedData;
}
