import type { FileCurve, WrittenFormat } from '../formats/index.js';
import type { Mesh } from '../mesh.js';
import type { Arguments } from './arguments.js';
import { UsageError } from './errors.js';
import type { Pieces } from './output.js';

/** Results as files of curves: rows of CSV, lines or tubes, with the mesh on request. */

/**
 * The function that writes curves in the chosen format, after a check of its options; null for
 * JSON, which is no drawing.
 */
export function drawnFormat(
  args: Arguments,
): ((mesh: Mesh, curves: FileCurve[]) => Promise<Pieces>) | null {
  const format = args.choice<WrittenFormat | 'json' | 'csv'>('format');
  if (format === 'json' || format === 'csv') {
    args.refuse(['surface', 'tube'], `with --format ${format}`);
    if (format === 'json') return null;
  }
  const radius = args.given('tube') ? args.number('tube') : undefined;
  if (format === 'stl' && radius === undefined) {
    throw new UsageError(`--format stl needs --tube RADIUS: STL has no lines`);
  }
  const withSurface = args.given('surface');
  return async (mesh, curves) => {
    const { curvesCsv, meshFile } = await import('../formats/index.js');
    const named = curves.map((curve, i) => ({
      name: curves.length > 1 ? `${args.command} ${i + 1}` : args.command,
      ...curve,
      radius,
    }));
    if (format === 'csv') return [curvesCsv(named, mesh)];
    const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
    const shown = withSurface ? surface : { positions: [], triangles: [] };
    return [meshFile({ ...shown, curves: named }, format)];
  };
}
