import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import type { Drawing, DrawnObject } from '../model/drawing';
import { isEmpty } from '../model/figure';
import { byId, formatInteger, make, write } from './elements';
import { kindNames } from './kind_names';
import { ListDrag } from './list_drag';
import { type ListedRow, rowsAfter, rowsOf, unitsOf } from './object_tree';

export const eye =
  '<svg viewBox="0 0 20 20" aria-hidden="true"><path d="M2.500 10S5.200 5 10 5s7.500 5 7.500 5-2.700 5-7.500 5-7.500-5-7.500-5z" /><circle cx="10" cy="10" r="2.200" /><path class="off" d="m4 16 12-12" /></svg>';
const lock =
  '<svg viewBox="0 0 20 20" aria-hidden="true"><rect x="5" y="9" width="10" height="7" rx="1.500" /><path class="on" d="M7 9V7a3 3 0 0 1 6 0v2" /><path class="off" d="M7 9V6a3 3 0 0 1 5.600-1.500" /></svg>';
const chevron =
  '<svg viewBox="0 0 20 20" aria-hidden="true"><path d="m7 5.500 5 4.500-5 4.500" /></svg>';

/** The page's name for an unnamed object. */
export const nameOf = ({ id, name, figure }: DrawnObject) =>
  name || `${kindNames[figure.kind]} ${id}`;

type Toggled = 'visible' | 'locked';

/**
 * The list of objects, the topmost first. Each group has a row of its own above its members. This
 * row folds the group.
 */
export class ObjectRows {
  readonly #list = byId('objects');
  readonly #folded = new Set<string>();
  readonly #drag: ListDrag;
  #drawing: Drawing | null = null;
  #rows: ListedRow[] = [];
  /** The group that is folded only during its drag, or null. */
  #carried: string | null = null;

  /** `rename` opens the field for the selection's name. */
  constructor(
    private readonly editor: Editor,
    private readonly rename: () => void,
  ) {
    this.#drag = new ListDrag(this.#list, {
      began: (row) => this.#carry(row.dataset.group),
      moved: (from, to) => this.#moved(from, to),
      ended: () => this.#carry(undefined),
    });
  }

  show(state: State): void {
    const { drawing, chosen } = state;
    // The places of a drag are those in the drawing that it began with.
    if (drawing !== this.#drawing) {
      this.#drawing = drawing;
      this.#drag.letGo();
    }
    // The list omits empty objects, so that no row appears while the user only tries a tool.
    const objects = drawing.objects.filter(({ figure }) => !isEmpty(figure)).toReversed();
    const active = state.none ? null : drawing.active;
    this.#rows = rowsOf(objects, this.#folded);
    while (this.#list.childElementCount > this.#rows.length) this.#list.lastElementChild!.remove();
    for (const [i, row] of this.#rows.entries()) {
      const before = this.#list.children[i] as HTMLElement | undefined;
      const isAlike = before && (before.dataset.group !== undefined) === (row.type === 'group');
      const element = isAlike ? before : row.type === 'group' ? this.#makeGroup() : this.#makeRow();
      if (!before) this.#list.append(element);
      else if (!isAlike) before.replaceWith(element);
      if (row.type === 'group') this.#showGroup(element, row.group, row.members, chosen);
      else {
        const { object } = row;
        this.#showRow(element, object, object.id === active, chosen.includes(object.id));
      }
    }
  }

  #showRow(row: HTMLElement, object: DrawnObject, isActive: boolean, isChosen: boolean): void {
    const { id, visible, locked, color, group } = object;
    const [main, see, hold] = [...row.children] as HTMLButtonElement[];
    const name = nameOf(object);
    row.dataset.id = `${id}`;
    row.classList.toggle('hidden-object', !visible);
    row.classList.toggle('grouped', group !== null);
    main!.setAttribute('aria-pressed', `${isChosen}`);
    if (isActive) main!.setAttribute('aria-current', 'true');
    else main!.removeAttribute('aria-current');
    const [dot, words] = [...main!.children] as HTMLElement[];
    dot!.style.background = color ?? '';
    write(words!, name);
    showToggles(see!, hold!, name, visible, locked);
  }

  #showGroup(
    row: HTMLElement,
    group: string,
    members: readonly DrawnObject[],
    chosen: readonly number[],
  ): void {
    const [fold, main, see, hold] = [...row.children] as HTMLButtonElement[];
    const visible = members.some((one) => one.visible);
    row.dataset.group = group;
    row.classList.toggle('hidden-object', !visible);
    fold!.setAttribute('aria-expanded', `${!this.#folded.has(group)}`);
    fold!.setAttribute('aria-label', `Members of ${group}`);
    main!.setAttribute('aria-pressed', `${members.every(({ id }) => chosen.includes(id))}`);
    const [words, count] = [...main!.children] as HTMLElement[];
    write(words!, group);
    write(count!, formatInteger(members.length));
    showToggles(
      see!,
      hold!,
      group,
      visible,
      members.every((one) => one.locked),
    );
  }

  #makeRow(): HTMLLIElement {
    const row = make('li');
    const id = () => Number(row.dataset.id);
    const main = make('button', '', { type: 'button', className: 'object' });
    main.append(make('i'), make('span'));
    main.title = 'Drag, or press Alt ↑ or ↓, to move it in the order';
    main.addEventListener('keydown', (event) => this.#key(event, id()));
    main.addEventListener('click', ({ shiftKey, ctrlKey, metaKey }) => {
      if (shiftKey || ctrlKey || metaKey) this.editor.toggle(id());
      else this.editor.activate(id());
    });
    main.addEventListener('dblclick', () => this.rename());
    row.append(main, ...this.#makeToggles(() => [id()]));
    return row;
  }

  #makeGroup(): HTMLLIElement {
    const row = make('li', '', { className: 'group-row' });
    row.dataset.group = '';
    const group = () => row.dataset.group!;
    const fold = make('button', '', { type: 'button', className: 'fold' });
    fold.title = 'Show or fold the members';
    fold.innerHTML = chevron;
    fold.addEventListener('click', () => this.#fold(group()));
    const main = make('button', '', { type: 'button', className: 'group-name' });
    main.append(make('span'), make('small'));
    main.title =
      'Selects all members; double-click to rename. Drag, or press Alt ↑ or ↓, to move them';
    main.addEventListener('click', ({ shiftKey, ctrlKey, metaKey }) => {
      const [first] = this.#membersOf(group());
      if (shiftKey || ctrlKey || metaKey) this.editor.toggle(first!);
      else this.editor.activate(first!);
    });
    main.addEventListener('dblclick', () => this.rename());
    main.addEventListener('keydown', (event) => this.#keyOfGroup(event, group()));
    row.append(fold, main, ...this.#makeToggles(() => this.#membersOf(group())));
    return row;
  }

  /** The buttons for visibility and lock, and the grip for a finger. */
  #makeToggles(ids: () => readonly number[]): HTMLElement[] {
    const toggle = (className: string, title: string, icon: string, name: Toggled) => {
      const button = make('button', '', { type: 'button', className, title });
      button.innerHTML = icon;
      button.addEventListener('click', () => {
        const to = button.getAttribute('aria-pressed') !== 'true';
        this.editor.objects.setProperties(ids(), { [name]: to });
      });
      return button;
    };
    return [
      toggle('eye', 'Show or hide', eye, 'visible'),
      toggle('lock', 'Lock or unlock', lock, 'locked'),
      make('span', '', { className: 'row-grip' }),
    ];
  }

  #membersOf(group: string): number[] {
    const { objects } = this.editor.state.drawing;
    return objects.filter((object) => object.group === group).map(({ id }) => id);
  }

  #fold(group: string): void {
    if (!this.#folded.delete(group)) this.#folded.add(group);
    this.show(this.editor.state);
  }

  /**
   * Folds an open group while its row is dragged, so that its members move along. Without a group,
   * unfolds the group that was dragged.
   */
  #carry(group: string | undefined): void {
    if (this.#carried !== null) this.#fold(this.#carried);
    const places = this.#rows.filter((row) => row.type === 'group' && row.group === group);
    const [place] = places.length === 1 ? places : [];
    this.#carried = place?.type === 'group' && place.isOpen ? place.group : null;
    if (this.#carried !== null) this.#fold(this.#carried);
  }

  #moved(from: number, to: number): void {
    const { ids, moved, group } = rowsAfter(this.#rows, from, to);
    this.editor.objects.arrange(ids.toReversed(), { id: moved, group });
  }

  /** Moves an object in the order by keys. The object's row keeps the focus. */
  #key(event: KeyboardEvent, id: number): void {
    const step = stepOf(event);
    if (!step) return;
    this.editor.objects.raise(id, step);
    this.#list.querySelector<HTMLElement>(`[data-id="${id}"] .object`)?.focus();
  }

  /** Moves a group past the next object or group, by keys. */
  #keyOfGroup(event: KeyboardEvent, group: string): void {
    const step = stepOf(event);
    if (!step) return;
    const units = unitsOf(this.#rows);
    const from = units.findIndex((unit) => unit.group === group);
    const to = from - step;
    if (to < 0 || to >= units.length) return;
    const [unit] = units.splice(from, 1);
    units.splice(to, 0, unit!);
    const ids = units.flatMap((one) => one.ids);
    this.editor.objects.arrange(ids.toReversed(), { id: unit!.ids[0]!, group });
    const rows = [...this.#list.querySelectorAll<HTMLElement>('[data-group]')];
    rows
      .find((row) => row.dataset.group === group)
      ?.querySelector<HTMLElement>('.group-name')
      ?.focus();
  }
}

/** The number of places by which a key moves a row up; 0 for other keys. */
function stepOf(event: KeyboardEvent): number {
  const step = (event.altKey && { ArrowUp: 1, ArrowDown: -1 }[event.key]) || 0;
  if (step === 0) return 0;
  event.preventDefault();
  event.stopPropagation();
  return step;
}

function showToggles(
  see: HTMLElement,
  hold: HTMLElement,
  name: string,
  visible: boolean,
  locked: boolean,
): void {
  see.setAttribute('aria-pressed', `${visible}`);
  see.setAttribute('aria-label', `Show ${name}`);
  hold.setAttribute('aria-pressed', `${locked}`);
  hold.setAttribute('aria-label', `Lock ${name}`);
}
