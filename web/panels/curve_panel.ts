import type { SurfacePoint } from 'karcher';
import { type CurveDocument, isEmpty, type Kind } from '../editor/document';
import type { Editor, Selection, State } from '../editor/editor';
import { type MethodId, methods } from '../editor/methods';
import type { View } from '../editor/session';
import { byId, formatInteger, make } from './elements';

export interface CurveEvents {
  chooseMethod(id: MethodId): void;
}

/** The curve's kind, how it is computed, and the list of its control points. */
export class CurvePanel {
  readonly #method = byId<HTMLSelectElement>('method');
  readonly #points = byId('points');
  readonly #clear = byId<HTMLButtonElement>('clear');
  readonly #kinds = [...document.querySelectorAll<HTMLInputElement>('input[name="kind"]')];

  constructor(
    private readonly editor: Editor,
    events: CurveEvents,
  ) {
    for (const input of this.#kinds) {
      input.addEventListener('change', () => editor.setKind(input.value as Kind));
    }
    for (const { id, label } of methods) this.#method.append(make('option', label, { value: id }));
    this.#method.addEventListener('change', () => {
      events.chooseMethod(this.#method.value as MethodId);
    });
    this.#clear.addEventListener('click', () => editor.clear());
  }

  show(state: State, view: View): void {
    const { kind } = state.document;
    for (const input of this.#kinds) input.checked = input.value === kind;
    this.#method.value = state.method;
    this.#clear.hidden = isEmpty(state.document);
    byId('points-title').textContent = kind === 'circle' ? 'Circle' : 'Control points';
    this.#showRows(rowsOf(state.document, view), state.selection);
  }

  #showRows(rows: readonly Row[], selection: Selection): void {
    if (rows.length === 0) {
      this.#points.replaceChildren(make('li', 'None yet', { className: 'none' }));
      return;
    }
    while (this.#points.childElementCount > rows.length) this.#points.lastElementChild!.remove();
    this.#points.querySelector('.none')?.remove();
    for (const [i, { which, name, value }] of rows.entries()) {
      const row = this.#points.children[i] ?? this.#points.appendChild(this.#makeRow());
      const button = row.firstElementChild as HTMLButtonElement;
      button.dataset.which = `${which}`;
      button.firstElementChild!.textContent = name;
      button.lastElementChild!.textContent = value;
      button.setAttribute('aria-pressed', `${which === selection}`);
    }
  }

  #makeRow(): HTMLLIElement {
    const row = make('li');
    const button = make('button', '', { type: 'button' });
    button.append(make('b'), make('span'));
    button.addEventListener('click', () => {
      const which = button.dataset.which!;
      this.editor.select(which === 'center' || which === 'rim' ? which : Number(which));
    });
    row.append(button);
    return row;
  }
}

interface Row {
  which: NonNullable<Selection>;
  name: string;
  value: string;
}

function rowsOf({ kind, points, circle }: CurveDocument, view: View): Row[] {
  const place = ({ face }: SurfacePoint) => `on face ${formatInteger(face)}`;
  if (kind !== 'circle') {
    return points.map((point, i) => ({ which: i, name: `${i + 1}`, value: place(point) }));
  }
  if (!circle) return [];
  const radius = view.circle?.radius.toPrecision(4) ?? '';
  return [
    { which: 'center', name: 'Center', value: place(circle.center) },
    { which: 'rim', name: 'Radius', value: radius },
  ];
}
