import { isEmpty, type Kind } from '../editor/document';
import type { Editor, State } from '../editor/editor';
import { type MethodId, methods } from '../editor/methods';
import type { View } from '../editor/session';
import { byId, make } from './elements';
import { PointRows } from './point_rows';

export interface CurveEvents {
  chooseMethod(id: MethodId): void;
}

/** The curve's kind, how it is computed, and the list of its control points. */
export class CurvePanel {
  readonly #method = byId<HTMLSelectElement>('method');
  readonly #rows: PointRows;
  readonly #clear = byId<HTMLButtonElement>('clear');
  readonly #kinds = [...document.querySelectorAll<HTMLInputElement>('input[name="kind"]')];

  constructor(
    private readonly editor: Editor,
    events: CurveEvents,
  ) {
    this.#rows = new PointRows(editor);
    for (const input of this.#kinds) {
      input.addEventListener('change', () => editor.setKind(input.value as Kind));
    }
    for (const { id, label } of methods) this.#method.append(make('option', label, { value: id }));
    this.#method.addEventListener('change', () => {
      events.chooseMethod(this.#method.value as MethodId);
    });
    this.#clear.addEventListener('click', () => this.editor.clear());
  }

  show(state: State, view: View): void {
    const { kind } = state.document;
    for (const input of this.#kinds) input.checked = input.value === kind;
    this.#method.value = state.method;
    this.#clear.hidden = isEmpty(state.document);
    byId('points-title').textContent = pointsTitles[kind] ?? 'Control points';
    this.#rows.show(state, view);
  }
}

const pointsTitles: Partial<Record<Kind, string>> = {
  circle: 'Circle',
  center: 'Points and their weights',
};
