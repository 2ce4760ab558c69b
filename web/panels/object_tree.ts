/** The rows of the list of objects, the topmost first: objects, and groups above their members. */
import type { DrawnObject } from '../model/drawing';

export type ListedRow =
  | { type: 'object'; object: DrawnObject }
  /** `members` are all members of the group, and `here` those that lie together at this place. */
  | {
      type: 'group';
      group: string;
      members: readonly DrawnObject[];
      here: readonly DrawnObject[];
      isOpen: boolean;
    };

/** The rows of objects in their order, the topmost first. */
export function rowsOf(objects: readonly DrawnObject[], folded: ReadonlySet<string>): ListedRow[] {
  const rows: ListedRow[] = [];
  for (let i = 0; i < objects.length; ) {
    const { group } = objects[i]!;
    let end = i + 1;
    while (group !== null && objects[end]?.group === group) end++;
    const here = objects.slice(i, end);
    const isOpen = group === null || !folded.has(group);
    if (group !== null) {
      const members = objects.filter((object) => object.group === group);
      rows.push({ type: 'group', group, members, here, isOpen });
    }
    if (isOpen) rows.push(...here.map((object): ListedRow => ({ type: 'object', object })));
    i = end;
  }
  return rows;
}

/** A single object, or adjacent members of a group. `ids` begins with the topmost one. */
interface Unit {
  group: string | null;
  ids: number[];
}

/** Units that can change places with each other. */
export function unitsOf(rows: readonly ListedRow[]): Unit[] {
  return rows.flatMap((row): Unit[] => {
    if (row.type === 'group') return [{ group: row.group, ids: row.here.map(({ id }) => id) }];
    return row.object.group === null ? [{ group: null, ids: [row.object.id] }] : [];
  });
}

/**
 * Moves a row to the place of another one. Returns the ids in their new order, and the moved
 * object's new group. An object that is dropped among the members of a group joins the group.
 * Directly below its own group, the object stays in the group; elsewhere it leaves the group. A
 * group must be folded when its row moves, and `moved` is then one of its members.
 */
export function rowsAfter(
  rows: readonly ListedRow[],
  from: number,
  to: number,
): { ids: number[]; moved: number; group: string | null } {
  const row = rows[from]!;
  const left = rows.toSpliced(from, 1);
  const place = row.type === 'group' ? besideGroups(left, to) : to;
  const ids = left
    .toSpliced(place, 0, row)
    .flatMap((one) =>
      one.type === 'object' ? [one.object.id] : one.isOpen ? [] : one.here.map(({ id }) => id),
    );
  if (row.type === 'group') return { ids, moved: row.here[0]!.id, group: row.group };
  const [above, below] = [left[place - 1], left[place]];
  const isIn = (other: ListedRow | undefined, group: string | null) =>
    other !== undefined && group !== null && groupOf(other) === group;
  const own = row.object.group;
  const joins = below?.type === 'object' ? groupOf(below) : null;
  const stays = isIn(above, own) && (above!.type === 'object' || isOpenGroup(above!));
  const group = isIn(above, joins) ? joins : stays ? own : null;
  return { ids, moved: row.object.id, group };
}

const groupOf = (row: ListedRow) => (row.type === 'group' ? row.group : row.object.group);

const isOpenGroup = (row: ListedRow) => row.type === 'group' && row.isOpen;

/** The first place, from `place` downwards, that does not lie between members of a group. */
function besideGroups(rows: readonly ListedRow[], place: number): number {
  let beside = place;
  for (;;) {
    const [above, below] = [rows[beside - 1], rows[beside]];
    const splits = above && below?.type === 'object' && groupOf(below) !== null;
    if (!splits || groupOf(above) !== groupOf(below)) return beside;
    beside++;
  }
}
