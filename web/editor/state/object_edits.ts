import {
  addition,
  arranging,
  deletion,
  duplication,
  grouping,
  groupNaming,
  type Restyled,
  reordering,
  restyling,
} from '../../model/arranging';
import { type Command, joined } from '../../model/commands';
import { isDerived } from '../../model/derived';
import { type DrawnObject, lookOf, objectOf } from '../../model/drawing';
import { type Figure, type FillRule, type Inside, isEmpty, opposite } from '../../model/figure';
import type { Begun } from './begun';
import { type CurveTool, type Selection, type State, selectedObjects } from './state';

/** The parts of the editor that edits of whole objects need. */
interface Editing {
  readonly state: State;
  readonly begun: Pick<Begun, 'keep'>;
  perform(command: Command | null, part?: PartOfStep): void;
  interrupt(): void;
  setTool(tool: CurveTool): void;
  rest(): void;
  onRefusal(sentence: string): void;
  insideOf(figure: Figure): Inside | null;
}

/** The selection after a step. */
export interface PartOfStep {
  selection?: Selection;
  chosen?: readonly number[];
  none?: boolean;
}

/**
 * Edits of whole objects, each one step of the history. They apply to the selection unless the
 * caller names objects.
 */
export class ObjectEdits {
  readonly #editor: Editing;

  constructor(editor: Editing) {
    this.#editor = editor;
  }

  /** Deletes objects, except empty and locked ones. */
  delete(wanted: readonly number[] = selectedObjects(this.#editor.state)): void {
    this.#editor.interrupt();
    const { objects } = this.#editor.state.drawing;
    const ids = wanted.filter((id) => {
      const object = objectOf(this.#editor.state.drawing, id);
      return object && !isEmpty(object.figure);
    });
    const free = ids.filter((id) => objects.some((one) => one.id === id && !one.locked));
    if (free.length < ids.length)
      this.#editor.onRefusal('What is locked is not deleted. Unlock it first.');
    this.#editor.perform(deletion(this.#editor.state.drawing, free), {
      selection: null,
      chosen: [],
    });
  }

  duplicate(ids: readonly number[] = selectedObjects(this.#editor.state)): void {
    this.#editor.interrupt();
    this.#perform(duplication(this.#editor.state.drawing, ids), ids);
  }

  /** Adds copies of objects, with new ids; `of` are the ids of the originals in the drawing. */
  add(objects: readonly DrawnObject[], of: readonly number[] = []): void {
    this.#editor.interrupt();
    this.#perform(addition(this.#editor.state.drawing, objects), of);
  }

  #perform(made: ReturnType<typeof addition>, of: readonly number[]): void {
    // The begun object may lose the selection, since it is a source now.
    if (made && of.includes(this.#editor.state.drawing.active)) this.#editor.begun.keep();
    if (made) this.#editor.perform(made.command, { selection: null, chosen: made.ids });
  }

  group(ids: readonly number[] = this.#editor.state.chosen): void {
    this.#editor.interrupt();
    this.#editor.perform(grouping(this.#editor.state.drawing, ids));
  }

  ungroup(ids: readonly number[] = selectedObjects(this.#editor.state)): void {
    this.setProperties(ids, { group: null });
  }

  setProperties(ids: readonly number[], to: Restyled): void {
    this.#editor.interrupt();
    const { none } = this.#editor.state;
    this.#editor.perform(restyling(this.#editor.state.drawing, ids, to), { none });
  }

  /** Waits for a click on an object, to give its look to the selected objects; or stops waiting. */
  toggleLook(): void {
    if (this.#editor.state.tool === 'look') this.#editor.rest();
    else if (selectedObjects(this.#editor.state).length > 0) this.#editor.setTool('look');
  }

  /** Applies the look of another object to the selected ones. */
  takeLook(id: number): void {
    const object = objectOf(this.#editor.state.drawing, id);
    if (object) this.setProperties(selectedObjects(this.#editor.state), lookOf(object));
    this.#editor.rest();
  }

  /** Moves an object up in the order by a number of places. */
  raise(id: number, steps: number): void {
    this.#editor.interrupt();
    this.#editor.perform(reordering(this.#editor.state.drawing, id, steps));
  }

  /**
   * Arranges objects in an order that begins with the lowest one, and moves one of them into a
   * group or out of its group.
   */
  arrange(ids: readonly number[], joins: { id: number; group: string | null }): void {
    this.#editor.interrupt();
    this.#editor.perform(arranging(this.#editor.state.drawing, ids, joins));
  }

  renameGroup(group: string, name: string): void {
    this.#editor.interrupt();
    this.#editor.perform(groupNaming(this.#editor.state.drawing, group, name));
  }

  /** Swaps the inside and the outside of these objects' closed lines. */
  turnInside(ids: readonly number[]): void {
    this.#editor.interrupt();
    const { objects } = this.#editor.state.drawing;
    const steps = objects.flatMap(({ id, figure, locked }): Command[] => {
      const from = figure.inside;
      const now = ids.includes(id) && !locked ? this.#editor.insideOf(figure) : null;
      if (!now) return [];
      return [{ type: 'figure', id, edit: { type: 'inside', from, to: opposite(now) } }];
    });
    if (steps.length > 0) this.#editor.perform(joined(steps));
  }

  /**
   * The edit that stores the side that an object's figure encloses; null if it has a side already,
   * or encloses no region.
   */
  insideKept({ id, figure }: DrawnObject): Command | null {
    const to = figure.inside ? null : this.#editor.insideOf(figure);
    return to && { type: 'figure', id, edit: { type: 'inside', from: undefined, to } };
  }

  /** Sets the rule that decides which regions the self-crossing lines of these objects enclose. */
  setRule(ids: readonly number[], to: FillRule): void {
    this.#editor.interrupt();
    const { objects } = this.#editor.state.drawing;
    const steps = objects.flatMap(({ id, figure, locked }): Command[] => {
      const from = figure.rule ?? 'evenOdd';
      const stays = !ids.includes(id) || locked || from === to || isDerived(figure.kind);
      return stays ? [] : [{ type: 'figure', id, edit: { type: 'rule', from, to } }];
    });
    if (steps.length > 0) this.#editor.perform(joined(steps));
  }
}
