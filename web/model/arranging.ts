/** Commands on whole objects of a drawing; null if they would change nothing. */
import { apply, type Command } from './commands';
import { isBoolean, isDerived } from './derived';
import {
  activeObject,
  type Drawing,
  type DrawnObject,
  freeId,
  indexOf,
  objectOf,
  type Properties,
  successorOf,
} from './drawing';
import {
  type ControlPoint,
  cleared,
  emptyFigure,
  type Figure,
  isEmpty,
  isRound,
  isSpline,
  type Kind,
} from './figure';
import { longestName, shortened } from './names';
import { withSourceIds } from './sources';

const together = (steps: readonly Command[]): Command | null =>
  steps.length > 0 ? { type: 'steps', steps } : null;

/** Selects another object for editing. If the previous one is empty, it is deleted. */
export function activation(drawing: Drawing, to: number): Command | null {
  const { active } = drawing;
  if (to === active || !objectOf(drawing, to)) return null;
  const activate: Command = { type: 'activate', from: active, to };
  const object = activeObject(drawing);
  if (!isEmpty(object.figure)) return activate;
  const index = indexOf(drawing, active);
  return together([activate, { type: 'delete', index, object }]);
}

/** Puts an object on top of the others and selects it for editing. */
export function onTop(drawing: Drawing, object: DrawnObject): Command {
  const add: Command = { type: 'add', index: drawing.objects.length, object };
  const activate: Command = { type: 'activate', from: drawing.active, to: object.id };
  const before = activeObject(drawing);
  if (!isEmpty(before.figure)) return { type: 'steps', steps: [add, activate] };
  const index = indexOf(drawing, before.id);
  const remove: Command = { type: 'delete', index, object: before };
  return { type: 'steps', steps: [add, activate, remove] };
}

/**
 * An empty, open figure of a kind; the default kind replaces a derived one. The figure keeps the
 * given settings, but has no knots of its own.
 */
function begun(figure: Figure, kind: Kind): Figure {
  const { derived: _, ...bare } = figure;
  return {
    // Nobody draws a derived object by hand, so the new figure has the default kind.
    ...cleared({ ...bare, kind: isDerived(kind) ? emptyFigure.kind : kind }),
    points: [],
    circle: null,
    settings: { ...figure.settings, closed: false, knots: null },
  };
}

/**
 * Ends the edited object: the next drawing on the surface begins a new one. An empty object goes on
 * unless it is hidden or locked.
 */
export function beginning(drawing: Drawing, kind?: Kind): Command | null {
  const { figure, visible, locked } = activeObject(drawing);
  if (isEmpty(figure) && visible && !locked) return null;
  return onTop(drawing, successorOf(drawing, begun(figure, kind ?? figure.kind)));
}

/** Adds a complete curve of the pen as an object of its own, and selects it for editing. */
export function drawnAtOnce(
  drawing: Drawing,
  points: readonly ControlPoint[],
  closed: boolean,
): Command {
  const { settings, ...empty } = begun(activeObject(drawing).figure, 'pen');
  return onTop(
    drawing,
    successorOf(drawing, { ...empty, points, settings: { ...settings, closed } }),
  );
}

/**
 * The family of a kind. Kinds of one family interpret the same points in different ways, so that a
 * figure can change from one kind to another.
 */
function familyOf(kind: Kind): string {
  if (isBoolean(kind)) return 'boolean';
  return isRound(kind) ? 'round' : isSpline(kind) ? 'spline' : kind;
}

/**
 * Changes the kind of the edited object. If the new kind cannot use its points, another object
 * begins.
 */
export function ofKind(drawing: Drawing, to: Kind): Command | null {
  const { id, figure } = activeObject(drawing);
  const { kind: from } = figure;
  if (from === to) return null;
  if (!isEmpty(figure) && familyOf(from) !== familyOf(to)) return beginning(drawing, to);
  return { type: 'figure', id, edit: { type: 'kind', from, to } };
}

/** The ids of objects, together with the ids of derived objects that have no other sources. */
function withOrphans({ objects }: Drawing, ids: readonly number[]): Set<number> {
  const gone = new Set(ids);
  for (let before = -1; gone.size > before; ) {
    before = gone.size;
    for (const { id, figure } of objects) {
      if (isDerived(figure.kind) && figure.derived?.sources.every((source) => gone.has(source))) {
        gone.add(id);
      }
    }
  }
  return gone;
}

/**
 * Removes objects, and derived objects that would lose all of their sources. Other derived objects
 * lose only the removed sources. If the edited object is removed, an empty object of its kind
 * begins.
 */
export function deletion(drawing: Drawing, wanted: readonly number[]): Command | null {
  if (!drawing.objects.some(({ id }) => wanted.includes(id))) return null;
  const all = withOrphans(drawing, wanted);
  const ids = [...all];
  const gone = drawing.objects.filter(({ id }) => all.has(id));
  const steps = drawing.objects.flatMap((object): Command[] => {
    const { id, figure: from } = object;
    if (all.has(id) || !from.derived?.sources.some((source) => all.has(source))) return [];
    const to = withSourceIds(object, (source) => (all.has(source) ? undefined : source)).figure;
    return [{ type: 'figure', id, edit: { type: 'replace', from, to } }];
  });
  const { active } = drawing;
  let { objects } = steps.reduce(apply, drawing);
  if (ids.includes(active)) {
    const { figure } = activeObject(drawing);
    const object = successorOf(drawing, begun(figure, figure.kind));
    steps.push({ type: 'add', index: objects.length, object });
    steps.push({ type: 'activate', from: active, to: object.id });
    objects = [...objects, object];
  }
  for (const object of gone) {
    const index = objects.indexOf(object);
    steps.push({ type: 'delete', index, object });
    objects = objects.toSpliced(index, 1);
  }
  return together(steps);
}

/** Puts objects on top, as new ones, and selects the last for editing. Also returns their ids. */
export function addition(
  drawing: Drawing,
  added: readonly DrawnObject[],
): { command: Command; ids: number[] } | null {
  if (added.length === 0) return null;
  const first = freeId(drawing);
  const groups = freshGroups(drawing, added);
  const fresh = new Map(added.map(({ id }, i) => [id, first + i]));
  const objects = added.map((object, i) => ({
    ...withSourceIds(object, (id) => fresh.get(id) ?? (objectOf(drawing, id) && id)),
    id: first + i,
    group: object.group === null ? null : groups.get(object.group)!,
  }));
  const steps: Command[] = objects.map((object, i) => ({
    ...{ type: 'add', index: drawing.objects.length + i },
    object,
  }));
  const last = first + objects.length - 1;
  steps.push({ type: 'activate', from: drawing.active, to: last });
  const before = activeObject(drawing);
  if (isEmpty(before.figure)) {
    steps.push({ type: 'delete', index: indexOf(drawing, before.id), object: before });
  }
  return { command: { type: 'steps', steps }, ids: objects.map(({ id }) => id) };
}

/** For each group of the added objects, a name that no group of the drawing has. */
function freshGroups(drawing: Drawing, added: readonly DrawnObject[]): Map<string, string> {
  const taken = new Set(drawing.objects.map(({ group }) => group));
  const fresh = new Map<string, string>();
  for (const { group } of added) {
    if (group === null || fresh.has(group)) continue;
    const name = freeName(group, taken);
    taken.add(name);
    fresh.set(group, name);
  }
  return fresh;
}

/**
 * The name or, if another object or group has it, the name with the first number that makes it
 * unique.
 */
function freeName(name: string, taken: ReadonlySet<string | null>): string {
  if (!taken.has(name)) return name;
  const stem = name.replace(/ \d+$/, '');
  for (let number = 2; ; number++) {
    const end = ` ${number}`;
    const next = `${shortened(stem, longestName - end.length)}${end}`;
    if (!taken.has(next)) return next;
  }
}

/** Copies of objects, above the originals, with names of their own. */
export function duplication(drawing: Drawing, ids: readonly number[]) {
  const copied = drawing.objects.filter(({ id, figure }) => ids.includes(id) && !isEmpty(figure));
  const taken = new Set(drawing.objects.map(({ name }) => name));
  const named = copied.map((object) => {
    if (!object.name) return object;
    const name = freeName(object.name, taken);
    taken.add(name);
    return { ...object, name };
  });
  return addition(drawing, named);
}

/**
 * The lowest place in the run of group members that contains a place; without a group, the place
 * itself.
 */
function footOfGroup({ objects }: Drawing, place: number): number {
  const { group } = objects[place]!;
  let foot = place;
  while (group !== null && objects[foot - 1]?.group === group) foot--;
  return foot;
}

/**
 * Copies of objects, each below its original or the original's group. They stay in place when the
 * originals move.
 */
export function leavingCopies(drawing: Drawing, ids: readonly number[]): Command | null {
  const copied = drawing.objects.filter(({ id, figure }) => ids.includes(id) && !isEmpty(figure));
  const groups = freshGroups(drawing, copied);
  const taken = new Set(drawing.objects.map(({ name }) => name));
  const first = freeId(drawing);
  const copyOf = new Map(copied.map(({ id }, i) => [id, first + i]));
  const steps = copied.map((object, i): Command => {
    const name = object.name && freeName(object.name, taken);
    taken.add(name);
    const group = object.group === null ? null : groups.get(object.group)!;
    const index = footOfGroup(drawing, indexOf(drawing, object.id)) + i;
    const own = withSourceIds(object, (id) => copyOf.get(id) ?? id);
    return { type: 'add', index, object: { ...own, id: first + i, name, group } };
  });
  return together(steps);
}

/** The properties that objects get: the same for all, or those that the function returns. */
export type Restyled = Partial<Properties> | ((object: DrawnObject) => Partial<Properties>);

/** Gives objects properties. */
export function restyling(drawing: Drawing, ids: readonly number[], to: Restyled): Command | null {
  const steps = drawing.objects.flatMap((object): Command[] => {
    if (!ids.includes(object.id)) return [];
    const wanted = typeof to === 'function' ? to(object) : to;
    const names = Object.keys(wanted) as (keyof Properties)[];
    if (names.every((name) => object[name] === wanted[name])) return [];
    const from = Object.fromEntries(names.map((name) => [name, object[name]]));
    return [{ type: 'properties', id: object.id, from, to: wanted }];
  });
  return together(steps);
}

/**
 * Moves an object up in the order by a number of places, or down by a negative number. Members of a
 * group stay together: a member moves only within its group, and other objects move past the whole
 * group.
 */
export function reordering(drawing: Drawing, id: number, steps: number): Command | null {
  const from = indexOf(drawing, id);
  if (from < 0 || steps === 0) return null;
  const { group } = drawing.objects[from]!;
  const left = drawing.objects.toSpliced(from, 1);
  // The only member of a group moves like an object without a group.
  const isMember = group !== null && left.some((other) => other.group === group);
  const groupAt = (place: number) => left[place]?.group ?? null;
  const mayLie = (place: number) => {
    const [below, above] = [groupAt(place - 1), groupAt(place)];
    if (isMember) return below === group || above === group;
    return below === null || below !== above;
  };
  const toward = Math.sign(steps);
  let to = Math.min(Math.max(from + steps, 0), left.length);
  if (isMember) while (to !== from && !mayLie(to)) to -= toward;
  else while (to > 0 && to < left.length && !mayLie(to)) to += toward;
  return to === from ? null : { type: 'order', from, to };
}

/** Puts the objects with these ids into this order, from the lowest. Other objects lie on top. */
export function ordering(drawing: Drawing, ids: readonly number[]): Command | null {
  const steps: Command[] = [];
  let { objects } = drawing;
  for (const [to, id] of ids.entries()) {
    const from = objects.findIndex((object) => object.id === id);
    if (from < 0 || from === to) continue;
    steps.push({ type: 'order', from, to });
    objects = objects.toSpliced(from, 1).toSpliced(to, 0, objects[from]!);
  }
  return together(steps);
}

/** Puts objects into an order, and moves one of them into a group or out of its group. */
export function arranging(
  drawing: Drawing,
  ids: readonly number[],
  { id, group }: { id: number; group: string | null },
): Command | null {
  const moved = ordering(drawing, ids);
  const joined = restyling(drawing, [id], { group });
  return together([moved, joined].filter((step) => step !== null));
}

/** Renames a group. No other group may have the new name. */
export function groupNaming(drawing: Drawing, from: string, name: string): Command | null {
  const members = drawing.objects.filter(({ group }) => group === from);
  const others = new Set(drawing.objects.map(({ group }) => group));
  others.delete(from);
  const wanted = shortened(name.trim(), longestName);
  if (!wanted) return null;
  const ids = members.map(({ id }) => id);
  return restyling(drawing, ids, { group: freeName(wanted, others) });
}

/** Groups objects. In the order, they move directly below the topmost of the objects. */
export function grouping(drawing: Drawing, ids: readonly number[]): Command | null {
  const members = drawing.objects.filter(({ id }) => ids.includes(id));
  if (members.length < 2) return null;
  const name = freeName('Group 1', new Set(drawing.objects.map(({ group }) => group)));
  const steps: Command[] = [];
  let { objects } = drawing;
  // From the top down, each member moves directly below the one before.
  for (let i = members.length - 2; i >= 0; i--) {
    const object = members[i]!;
    const from = objects.indexOf(object);
    const left = objects.toSpliced(from, 1);
    const to = left.indexOf(members[i + 1]!);
    if (to !== from) steps.push({ type: 'order', from, to });
    objects = left.toSpliced(to, 0, object);
  }
  for (const { id, group } of members) {
    steps.push({ type: 'properties', id, from: { group }, to: { group: name } });
  }
  return together(steps);
}

/** The ids of these objects and of all other members of their groups. */
export function withGroups({ objects }: Drawing, ids: readonly number[]): number[] {
  const groups = new Set(
    objects.flatMap(({ id, group }) => (ids.includes(id) && group !== null ? [group] : [])),
  );
  return objects.flatMap(({ id, group }) =>
    ids.includes(id) || (group !== null && groups.has(group)) ? [id] : [],
  );
}
