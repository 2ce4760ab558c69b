import type { CurveOptions, PointLike } from 'karcher';

/** How one curve becomes another: an edit that keeps most of its work, or a new curve. */
export type Change =
  | { type: 'none' }
  | { type: 'move'; index: number; point: PointLike }
  | { type: 'insert'; index: number; point: PointLike }
  | { type: 'remove'; index: number }
  | { type: 'kind' }
  | { type: 'new' };

const settings = ['method', 'solver', 'rings', 'samples'] as const;

/** The smallest edit that makes `from` into `to`. */
export function changeBetween(from: CurveOptions, to: CurveOptions): Change {
  if (settings.some((name) => from[name] !== to[name])) return { type: 'new' };
  const [a, b] = [from.points, to.points];
  const shortest = Math.min(a.length, b.length);
  let first = 0;
  while (first < shortest && same(a[first]!, b[first]!)) first++;
  let last = 0;
  while (last < shortest - first && same(a.at(-1 - last)!, b.at(-1 - last)!)) last++;
  const [removed, added] = [a.length - first - last, b.length - first - last];
  if (from.kind !== to.kind) return { type: removed + added === 0 ? 'kind' : 'new' };
  if (removed === 0 && added === 0) return { type: 'none' };
  if (removed === 1 && added === 1) return { type: 'move', index: first, point: b[first]! };
  if (removed === 0 && added === 1) return { type: 'insert', index: first, point: b[first]! };
  if (removed === 1 && added === 0) return { type: 'remove', index: first };
  return { type: 'new' };
}

function same(a: PointLike, b: PointLike): boolean {
  if ('vertex' in a || 'vertex' in b) {
    return 'vertex' in a && 'vertex' in b && a.vertex === b.vertex;
  }
  return a.face === b.face && a.bary.every((weight, corner) => weight === b.bary[corner]);
}
