/**
 * Commands that derive objects from others, or change a derivation; null if they would change
 * nothing.
 */
import { onTop } from './arranging';
import { type Command, joined } from './commands';
import { type BooleanKind, type Derived, type DerivedKind, isBoolean, isDerived } from './derived';
import { activeObject, type Drawing, type DrawnObject, freeId, lookOf, newObject } from './drawing';
import { emptyFigure, type Figure, isCurve, isEmpty, pointsNeeded } from './figure';

/** Whether other objects can be derived from an object, once it has all its points. */
const mayHaveLines = ({ figure }: DrawnObject) =>
  !isEmpty(figure) && !['center', 'points', 'cut'].includes(figure.kind);

const hasLines = (object: DrawnObject) => {
  const { figure } = object;
  const few = isCurve(figure.kind) && figure.points.length < pointsNeeded(figure);
  return mayHaveLines(object) && !few;
};

/**
 * Whether other objects can be derived from these, now or once they have all their points. The page
 * offers the commands from the first point on.
 */
export const willCombine = ({ objects }: Drawing, ids: readonly number[]): boolean =>
  objects.some((object) => ids.includes(object.id) && mayHaveLines(object));

/** The given objects that can be combined, in the drawing's order. */
export const combinable = ({ objects }: Drawing, ids: readonly number[]): DrawnObject[] =>
  objects.filter((object) => ids.includes(object.id) && hasLines(object));

/** An object derived from others, in the style of the topmost of these. */
function made(
  drawing: Drawing,
  sources: readonly DrawnObject[],
  kind: DerivedKind,
  how: Omit<Derived, 'sources'>,
): Command {
  const look = lookOf(sources.at(-1)!);
  const derived: Derived = { sources: sources.map(({ id }) => id), ...how };
  const figure: Figure = { ...emptyFigure, kind, derived };
  const fill = isBoolean(kind) ? look.fill : 0;
  return onTop(drawing, newObject(freeId(drawing), figure, { ...look, fill }));
}

/** The faint style of operands, which lets the result stand out. */
const outlined = { width: 1.5, onSurface: false, dash: 'dashed', fill: 0 } as const;

export function combining(
  drawing: Drawing,
  ids: readonly number[],
  kind: BooleanKind,
): Command | null {
  const sources = combinable(drawing, ids);
  if (sources.length < 2) return null;
  const plain = sources.map(({ id, width, onSurface, dash, fill }): Command => {
    const from = { width, onSurface, dash, fill };
    return { type: 'properties', id, from, to: outlined };
  });
  return joined([...plain, made(drawing, sources, kind, {})]);
}

/** Adds lines at a distance from objects, on the objects' outer side if they have one. */
export function offsetting(
  drawing: Drawing,
  ids: readonly number[],
  distance: number,
): Command | null {
  const sources = combinable(drawing, ids);
  if (sources.length === 0) return null;
  return made(drawing, sources, 'offset', { offset: { distance, side: 'outwards' } });
}

/** Adds a cut of the surface along objects. */
export function cutting(drawing: Drawing, ids: readonly number[]): Command | null {
  const sources = combinable(drawing, ids);
  if (sources.length === 0) return null;
  return made(drawing, sources, 'cut', { parts: [], thickness: 0 });
}

/** Changes the derivation of the edited object. */
export function remaking(
  drawing: Drawing,
  part: Omit<Partial<Derived>, 'sources'>,
): Command | null {
  const { id, figure: from } = activeObject(drawing);
  if (!isDerived(from.kind) || !from.derived) return null;
  const derived = { ...from.derived, ...part };
  if (JSON.stringify(derived) === JSON.stringify(from.derived)) return null;
  return { type: 'figure', id, edit: { type: 'replace', from, to: { ...from, derived } } };
}

/** Puts other objects in the place of one that is a source of others. */
export const inherited = (
  { objects }: Drawing,
  removed: number,
  heirs: readonly number[],
): Command[] =>
  objects.flatMap(({ id, figure: from }): Command[] => {
    if (!isDerived(from.kind) || !from.derived?.sources.includes(removed)) return [];
    const sources = from.derived.sources.flatMap((one) => (one === removed ? heirs : [one]));
    const derived = { ...from.derived, sources: [...new Set(sources)] };
    const edit = { type: 'replace', from, to: { ...from, derived } } as const;
    return [{ type: 'figure', id, edit }];
  });

/** Replaces the edited object by objects with the same shape but without sources. */
export function expanding(drawing: Drawing, figures: readonly Figure[]): Command | null {
  const object = activeObject(drawing);
  const index = drawing.objects.indexOf(object);
  if (figures.length === 0) return null;
  const first = freeId(drawing);
  const added = figures.map((figure, i) => ({ ...object, id: first + i, figure }));
  return joined([
    ...added.map((one, i): Command => ({ type: 'add', index: index + 1 + i, object: one })),
    ...inherited(
      drawing,
      object.id,
      added.map(({ id }) => id),
    ),
    { type: 'activate', from: object.id, to: added.at(-1)!.id },
    { type: 'delete', index, object },
  ]);
}
