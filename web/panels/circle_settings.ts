import type { View } from '../editor/engine/view';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import { handleNames, withRadius } from '../model/circle';
import { type CircleType, fewestArcs, isRound } from '../model/figure';
import { byId, fill, write } from './elements';
import { NumberField } from './number_field';

const typeNames: Record<CircleType, string> = {
  arcs: 'Rational arcs',
  linear: 'Linear isoline',
  exact: 'Exact isoline',
};

const typeNotes: Record<CircleType, string> = {
  arcs: 'Smooth arcs, joined, as many as keep to the radius or a number of yours.',
  linear: 'Straight in each triangle: distances are interpolated between its corners.',
  exact: 'Exactly the points at the radius: circular arcs in each triangle.',
};

const ellipseNote = 'Smooth arcs, joined. The handle Along also turns the ellipse.';

/**
 * A sentence about the visible circle's deviation from its radius; empty if the deviation is
 * unknown.
 */
function deviationOf({ curve }: View): string {
  if (typeof curve?.deviation !== 'number') return '';
  const percent = 100 * curve.deviation;
  const most = percent < 0.01 ? 'less than 0.01' : `at most ${percent.toPrecision(2)}`;
  return ` It is ${most} percent off.`;
}

/** The panel's settings of circles and ellipses: their construction and their radii. */
export class CircleSettings {
  readonly #group = byId('circle-settings');
  readonly #type = byId<HTMLSelectElement>('circle-type');
  readonly #arcs = byId<HTMLInputElement>('arcs');
  readonly #radius: NumberField;
  readonly #across: NumberField;
  #view: View | null = null;

  constructor(editor: Editor) {
    fill(this.#type, typeNames);
    this.#type.addEventListener('change', () =>
      editor.setCircleForm({ type: this.#type.value as CircleType }),
    );
    this.#arcs.addEventListener('input', () => {
      const from = editor.state.base.circleForm;
      const arcs = this.#arcs.valueAsNumber;
      const to = { ...from, arcs: arcs < fewestArcs ? ('auto' as const) : arcs };
      editor.preview({ type: 'circleForm', from, to });
    });
    this.#arcs.addEventListener('change', () => editor.commitDrag());
    const makeField = (id: string, handle: 'rim' | 'across') =>
      new NumberField(byId<HTMLInputElement>(id), (value) => {
        const { circle: from } = editor.state.figure;
        const drawn = this.#view?.circle;
        if (!from || !drawn) return;
        editor.run({ type: 'circle', from, to: withRadius(from, drawn, handle, value) }, handle);
      });
    this.#radius = makeField('radius', 'rim');
    this.#across = makeField('across', 'across');
  }

  show({ figure }: State, view: View): void {
    this.#view = view;
    const { kind, circle, circleForm } = figure;
    const { type, arcs } = circleForm;
    this.#group.hidden = !isRound(kind);
    if (!isRound(kind)) return;
    const isEllipse = kind === 'ellipse';
    this.#type.closest('label')!.hidden = isEllipse;
    this.#type.value = type;
    write(byId('radius-name'), handleNames(kind).rim);
    byId('across').closest('label')!.hidden = !isEllipse;
    this.#arcs.closest('label')!.hidden = !isEllipse && type !== 'arcs';
    const fitting = arcs === 'auto';
    this.#arcs.value = `${fitting ? fewestArcs - 1 : arcs}`;
    this.#arcs.ariaValueText = fitting ? 'automatic' : `${arcs}`;
    write(byId('arcs-count'), fitting ? 'auto' : `${arcs}`);
    this.#radius.show(circle && (view.circle?.radius ?? null));
    this.#across.show(circle && (view.circle?.across?.radius ?? null));
    write(byId('circle-note'), isEllipse ? ellipseNote : typeNotes[type] + deviationOf(view));
  }
}
