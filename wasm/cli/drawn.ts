import type { FileCurve, WrittenFormat } from '../formats/index.js';
import type { Mesh } from '../mesh.js';
import type { Arguments } from './arguments.js';
import { UsageError } from './errors.js';
import { type Pieces, triples } from './output.js';

/** Results as files of curves: rows of CSV, lines or tubes, with the mesh where that is wanted. */

/** Checks the options of a format; null for JSON, which is no drawing. */
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
    if (format === 'obj' && !withSurface && radius === undefined) {
      return polylinesAsObj(curves.map(({ path }) => path.polyline({ bits: 64 })));
    }
    const { curvesCsv, meshFile } = await import('../formats/index.js');
    const named = curves.map((curve, i) => ({
      name: curves.length > 1 ? `${args.command} ${i + 1}` : args.command,
      ...curve,
      radius,
    }));
    const surface = { positions: mesh.positions(), triangles: mesh.triangles() };
    if (format === 'csv') return [curvesCsv(named, surface)];
    const shown = withSurface ? surface : { positions: [], triangles: [] };
    return [meshFile({ ...shown, curves: named }, format)];
  };
}

/** Polylines as an OBJ file, in pieces: the vertices of each, and an `l` line. */
export function* polylinesAsObj(polylines: readonly Float64Array[]): Generator<string> {
  for (const polyline of polylines) {
    for (const position of triples(polyline)) yield `v ${position.join(' ')}\n`;
  }
  let vertex = 1;
  for (const { length } of polylines) {
    yield 'l';
    for (let i = 0; i < length; i += 3) yield ` ${vertex++}`;
    yield '\n';
  }
}
