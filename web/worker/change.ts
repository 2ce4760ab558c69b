import type { CurveOptions, PointLike } from 'karcher';

/** How one curve becomes another: an edit that keeps most of its work, or a new curve. */
export type Change =
  | { type: 'none' }
  | { type: 'move'; index: number; point: PointLike }
  | { type: 'insert'; index: number; point: PointLike }
  | { type: 'remove'; index: number }
  | { type: 'reorder'; from: number; to: number }
  | { type: 'kind' }
  | { type: 'closed' }
  | { type: 'weight' | 'beta'; index: number; value: number }
  | { type: 'new' };

/** With another value of these there is nothing to keep. */
const settings = ['method', 'solver', 'rings', 'samples', 'tolerance', 'levels'] as const;

/** The smallest edit that makes `from` into `to`. */
export function changeBetween(from: CurveOptions, to: CurveOptions): Change {
  if (settings.some((name) => from[name] !== to[name])) return { type: 'new' };
  const kind = from.kind !== to.kind;
  // A curve keeps what another kind has no use for: only what is as always is known to be there.
  if (kind ? !isPlain(from) || !isPlain(to) : shapeOf(from) !== shapeOf(to)) return { type: 'new' };
  const points = pointChange(from.points, to.points);
  const closed = (from.closed ?? false) !== (to.closed ?? false);
  // Of knots of one's own a curve keeps what it can when points come and go: that is not known here.
  const keepsKnots = !closed && ['none', 'move', 'reorder'].includes(points.type);
  if (hasOwnKnots(from) && !keepsKnots) return { type: 'new' };
  const changes = [points, numberChange(from, to, points)].filter(({ type }) => type !== 'none');
  if (changes.length + Number(kind) + Number(closed) > 1) return { type: 'new' };
  if (closed) return hasClampedKnots(from) ? { type: 'new' } : { type: 'closed' };
  return kind ? { type: 'kind' } : (changes[0] ?? { type: 'none' });
}

const hasOwnKnots = ({ knots }: CurveOptions) => knots !== undefined && typeof knots !== 'string';
const hasClampedKnots = ({ knots }: CurveOptions) => knots === 'clamped';

const shapeOf = ({
  degree = 3,
  knots = 'uniform',
  parametrization = 'centripetal',
}: CurveOptions) =>
  `${degree} ${typeof knots === 'string' ? knots : Array.from(knots)} ${parametrization}`;

const isPlain = (options: CurveOptions) =>
  !options.weights && !options.betas && shapeOf(options) === '3 uniform centripetal';

function pointChange(a: readonly PointLike[], b: readonly PointLike[]): Change {
  const shortest = Math.min(a.length, b.length);
  let first = 0;
  while (first < shortest && same(a[first]!, b[first]!)) first++;
  let last = 0;
  while (last < shortest - first && same(a.at(-1 - last)!, b.at(-1 - last)!)) last++;
  const [removed, added] = [a.length - first - last, b.length - first - last];
  if (removed === 0 && added === 0) return { type: 'none' };
  if (removed === 1 && added === 1) return { type: 'move', index: first, point: b[first]! };
  if (removed === 0 && added === 1) return { type: 'insert', index: first, point: b[first]! };
  if (removed === 1 && added === 0) return { type: 'remove', index: first };
  return removed === added ? reorderBetween(a, b, first, first + removed - 1) : { type: 'new' };
}

/** One point that went from one end of a part to the other, between which all moved up by one. */
function reorderBetween(
  a: readonly PointLike[],
  b: readonly PointLike[],
  first: number,
  last: number,
): Change {
  for (const [from, to] of [
    [first, last],
    [last, first],
  ] as const) {
    const moved = withEntryMoved(a, from, to);
    if (moved.every((point, i) => same(point, b[i]!))) return { type: 'reorder', from, to };
  }
  return { type: 'new' };
}

const withEntryMoved = <Entry>(entries: readonly Entry[], from: number, to: number) =>
  entries.toSpliced(from, 1).toSpliced(to, 0, entries[from]!);

/** How the weights and betas change beside a change of the points, which they go along with. */
function numberChange(from: CurveOptions, to: CurveOptions, points: Change): Change {
  const changes = (['weights', 'betas'] as const).flatMap((name): Change[] => {
    let before = filled(from[name], from.points.length);
    if (points.type === 'reorder') before = withEntryMoved(before, points.from, points.to);
    if (points.type === 'insert') before.splice(points.index, 0, 1);
    if (points.type === 'remove') before.splice(points.index, 1);
    const after = filled(to[name], to.points.length);
    if (before.length !== after.length) return [];
    const type = name === 'weights' ? 'weight' : 'beta';
    return after.flatMap((value, index) =>
      value === before[index] ? [] : [{ type, index, value } as const],
    );
  });
  return changes.length > 1 ? { type: 'new' } : (changes[0] ?? { type: 'none' });
}

const filled = (numbers: ArrayLike<number> | undefined, count: number) =>
  numbers ? Array.from(numbers) : new Array<number>(count).fill(1);

function same(a: PointLike, b: PointLike): boolean {
  if ('vertex' in a || 'vertex' in b) {
    return 'vertex' in a && 'vertex' in b && a.vertex === b.vertex;
  }
  return a.face === b.face && a.bary.every((weight, corner) => weight === b.bary[corner]);
}
