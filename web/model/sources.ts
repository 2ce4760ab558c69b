/** The sources of objects: other objects of their drawing, by their ids. */
import { isBoolean, isDerived } from './derived';
import { type Drawing, type DrawnObject, objectOf } from './drawing';
import { type Enclosing, enclosingOf, type Figure, isCurve, isRound, type Operand } from './figure';

const sourcesOf = ({ figure }: DrawnObject) =>
  isDerived(figure.kind) ? (figure.derived?.sources ?? []) : [];

const resolved = new WeakMap<Figure, Figure>();

/**
 * The figure of an object with the figures of its sources, to any depth. The result is the same
 * value as before as long as all of these figures are unchanged. It omits missing sources, cuts,
 * and objects that would be their own sources.
 */
export function resolvedFigure(drawing: Drawing, object: DrawnObject): Figure {
  if (!isDerived(object.figure.kind)) return object.figure;
  const done = new Map<number, Figure | null>();
  const resolve = (one: DrawnObject): Figure => {
    const { figure } = one;
    if (!isDerived(figure.kind)) return figure;
    done.set(one.id, null);
    const operands = sourcesOf(one).flatMap((id): Operand[] => {
      const source = objectOf(drawing, id);
      if (!source || source.figure.kind === 'cut') return [];
      const known = done.get(id);
      if (known === null) return [];
      return [{ id, figure: known ?? resolve(source) }];
    });
    const before = resolved.get(figure);
    const same =
      before?.operands?.length === operands.length &&
      operands.every(({ id, figure: own }, i) => {
        const other = before.operands![i]!;
        return other.id === id && other.figure === own;
      });
    const next = same ? before! : { ...figure, operands };
    resolved.set(figure, next);
    done.set(one.id, next);
    return next;
  };
  return resolve(object);
}

/** Whether all lines of a figure are closed. Its `operands` must be resolved. */
export function isLoop({ kind, settings, derived, operands = [] }: Figure): boolean {
  if (kind === 'offset') return derived?.offset?.side === 'both' || areLoops(operands);
  return isRound(kind) || isBoolean(kind) || (isCurve(kind) && settings.closed);
}

export const areLoops = (operands: readonly Operand[]): boolean =>
  operands.every(({ figure }) => isLoop(figure));

/**
 * The side and the rule by which a figure's lines enclose a region. The region of a derived figure
 * lies on the left of its lines, even if the other side is smaller. The figure's `operands` must be
 * resolved.
 */
export const enclosedBy = (figure: Figure): Enclosing =>
  isDerived(figure.kind) && isLoop(figure) ? { inside: 'left' } : enclosingOf(figure);

/** The side and the rule by which the lines of several figures together enclose a region. */
export const enclosedTogether = (operands: readonly Operand[]): Enclosing =>
  operands.length === 1 ? enclosedBy(operands[0]!.figure) : {};

/** The ids of these objects and of all their sources, to any depth, without missing objects. */
export function withSources(drawing: Drawing, ids: readonly number[]): number[] {
  const all = new Set(ids);
  for (const id of all) {
    const object = objectOf(drawing, id);
    for (const source of object ? sourcesOf(object) : []) all.add(source);
  }
  return [...all].filter((id) => objectOf(drawing, id));
}

/** Whether an object is a source of other objects. */
export const isSource = ({ objects }: Drawing, id: number) =>
  objects.some((object) => sourcesOf(object).includes(id));

/** The object with new ids of its sources. It loses the sources without a new id. */
export function withSourceIds(
  object: DrawnObject,
  idOf: (id: number) => number | undefined,
): DrawnObject {
  const { figure } = object;
  if (!figure.derived) return object;
  const sources = figure.derived.sources.map(idOf).filter((id) => id !== undefined);
  return { ...object, figure: { ...figure, derived: { ...figure.derived, sources } } };
}
