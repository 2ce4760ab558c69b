import type { SurfacePoint } from 'karcher';
import type { View } from '../editor/engine/view';
import type { Editor } from '../editor/state/editor';
import type { Selection, State } from '../editor/state/state';
import { type CircleHandle, handleNames, isCircleHandle } from '../model/circle';
import {
  type ControlPoint,
  type Figure,
  isRound,
  isSpline,
  type Kind,
  type ParameterName,
  parameterOf,
  parameterRange,
  withParameter,
} from '../model/figure';
import { jointOf } from '../model/pen';
import { byId, formatInteger, make, write } from './elements';

const names: Record<ParameterName, string> = { weight: 'Weight', beta: 'Beta' };
/** The number of steps of a slider. */
const steps = 64;

/**
 * Converts a value to a position of the slider, whose scale is logarithmic: from 1/16 to 16, with 1
 * in the middle.
 */
const toSlider = (value: number) =>
  Math.round(((Math.log2(value) - Math.log2(parameterRange.least)) / span) * steps);
const fromSlider = (position: number) =>
  Number((parameterRange.least * 2 ** ((position / steps) * span)).toPrecision(4));
const span = Math.log2(parameterRange.most / parameterRange.least);

/** The list of placed points, each with a slider for its weight or beta. */
export class PointRows {
  readonly #list = byId('points');

  constructor(private readonly editor: Editor) {}

  show({ figure, selection, more }: State, view: View): void {
    const rows = rowsOf(figure, view);
    if (rows.length === 0) {
      this.#list.replaceChildren(make('li', 'None yet', { className: 'none' }));
      return;
    }
    while (this.#list.childElementCount > rows.length) this.#list.lastElementChild!.remove();
    this.#list.querySelector('.none')?.remove();
    for (const [i, row] of rows.entries()) {
      const element = this.#list.children[i] ?? this.#list.appendChild(this.#makeRow(i));
      showRow(element as HTMLElement, row, [selection, ...more]);
      const [up, down] = element.querySelectorAll<HTMLButtonElement>('.move');
      for (const button of [up!, down!]) button.hidden = !isSpline(figure.kind);
      up!.disabled = i === 0;
      down!.disabled = i === rows.length - 1;
    }
  }

  #makeRow(index: number): HTMLLIElement {
    const row = make('li');
    const button = make('button', '', { type: 'button' });
    button.append(make('b'), make('span'));
    button.addEventListener('click', ({ shiftKey, ctrlKey, metaKey }) => {
      const which = button.dataset.which!;
      if (isCircleHandle(which)) this.editor.select(which);
      else if (shiftKey || ctrlKey || metaKey) this.#toggle(Number(which));
      else this.editor.select(Number(which));
    });
    row.append(
      button,
      makeSlider(this.editor, () => index),
      this.#makeMove(index, -1),
      this.#makeMove(index, 1),
    );
    return row;
  }

  /** Adds a point to the selection, or removes it. */
  #toggle(index: number): void {
    const { selection, more } = this.editor.state;
    const selected = typeof selection === 'number' ? [...more, selection] : [];
    const others = selected.filter((one) => one !== index);
    this.editor.selectPoints(selected.includes(index) ? others : [...others, index]);
  }

  /** A button that moves a point one place forwards or back. */
  #makeMove(index: number, step: -1 | 1): HTMLButtonElement {
    const [name, keys, path] =
      step < 0
        ? ['up', 'Alt ↑', 'm5.5 11.5 4.5-4.5 4.5 4.5']
        : ['down', 'Alt ↓', 'm5.5 8.5 4.5 4.5 4.5-4.5'];
    const button = make('button', '', {
      type: 'button',
      className: 'move',
      title: `Move ${name} in order (${keys})`,
    });
    button.setAttribute('aria-label', `Move point ${index + 1} ${name} in order`);
    button.innerHTML = `<svg viewBox="0 0 20 20" aria-hidden="true"><path d="${path}" /></svg>`;
    button.addEventListener('click', () => {
      this.editor.select(index);
      this.editor.moveInOrder(step);
      // The focus follows the moved point.
      const row = this.#list.children[index + step];
      row?.querySelector<HTMLButtonElement>(`.move:nth-of-type(${step < 0 ? 2 : 3})`)?.focus();
    });
    return button;
  }
}

/** A slider for a control point's weight or beta; a double click sets it to 1. */
export function makeSlider(editor: Editor, index: () => number): HTMLInputElement {
  const slider = make('input', '', { type: 'range', min: '0', max: `${steps}`, step: '1' });
  const preview = (value: number) => {
    const name = parameterOf(editor.state.base.kind);
    const from = editor.state.base.points[index()];
    if (!name || !from) return;
    const to = withParameter(from, name, value);
    editor.preview({ type: 'change', index: index(), from, to });
  };
  slider.addEventListener('pointerdown', () => editor.select(index()));
  slider.addEventListener('input', () => preview(fromSlider(slider.valueAsNumber)));
  slider.addEventListener('change', () => editor.commitDrag());
  slider.addEventListener('dblclick', () => {
    preview(1);
    editor.commitDrag();
  });
  return slider;
}

/** Shows a control point's weight or beta on a slider. */
export function showOnSlider(
  slider: HTMLInputElement,
  index: number,
  point: ControlPoint,
  name: ParameterName,
): void {
  const value = point[name] ?? 1;
  slider.value = `${toSlider(value)}`;
  slider.setAttribute('aria-label', `${names[name]} of point ${index + 1}`);
  slider.setAttribute('aria-valuetext', `${value}`);
}

interface Row {
  which: NonNullable<Selection>;
  name: string;
  value: string;
  /** The face that contains the point, for interested users. */
  place: string;
  slider: { point: ControlPoint; name: ParameterName } | null;
}

function showRow(
  element: HTMLElement,
  { which, name, value, place, slider }: Row,
  selected: readonly Selection[],
) {
  const [button, input] = [...element.children] as [HTMLButtonElement, HTMLInputElement];
  button.dataset.which = `${which}`;
  write(button.firstElementChild!, name);
  write(button.lastElementChild!, value);
  button.title = place;
  button.setAttribute('aria-pressed', `${selected.includes(which)}`);
  input.hidden = slider === null;
  if (slider) showOnSlider(input, Number(which), slider.point, slider.name);
}

function rowsOf({ kind, points, circle }: Figure, view: View): Row[] {
  const placeOf = ({ face }: SurfacePoint) => `On face ${formatInteger(face)}`;
  if (isRound(kind)) {
    if (!circle) return [];
    const row = (which: CircleHandle, name: string, value: string, place = ''): Row => ({
      ...{ which, name, value, place, slider: null },
    });
    const length = (radius: number | undefined) => radius?.toPrecision(4) ?? '';
    const names = handleNames(kind);
    const rows = [
      row('center', names.center, '', placeOf(circle.center)),
      row('rim', names.rim, length(view.circle?.radius)),
    ];
    if (kind === 'ellipse') {
      rows.push(row('across', names.across, length(view.circle?.across?.radius)));
    }
    return rows;
  }
  const name = parameterOf(kind);
  const total = points.reduce((sum, { weight = 1 }) => sum + weight, 0);
  return points.map((point, i) => ({
    which: i,
    name: kind === 'points' || kind === 'polyline' ? `Point ${i + 1}` : `${i + 1}`,
    value: numbersOf(kind, point, total),
    place: placeOf(point),
    slider: name && { point, name },
  }));
}

/**
 * A point's weight or beta as text, or an anchor's joint in words; empty for a kind that has
 * neither.
 */
function numbersOf(kind: Kind, point: ControlPoint, total: number): string {
  const name = parameterOf(kind);
  if (name) return numberOf(point, name, kind === 'center' ? total : null);
  return kind === 'pen' ? jointOf(point.tangents) : '';
}

/** A point's weight or beta as text; with a total, its share of the total in percent. */
function numberOf(point: ControlPoint, name: ParameterName, total: number | null): string {
  const value = point[name] ?? 1;
  if (total !== null) return `${((100 * value) / total).toFixed(1)} %`;
  return value.toPrecision(3);
}
