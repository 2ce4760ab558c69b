import type { Compared, Comparison } from '../editor/engine/comparison';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import type { Gap } from '../model/gap';
import { isMethod, type MethodId, methods } from '../model/methods';
import { byId, formatInteger, write } from './elements';
import { sentenceOf } from './messages';

/**
 * Offers a second method for the edited curve, and shows the gap between the curves of both
 * methods.
 */
export class ComparisonPanel {
  readonly #choice = byId<HTMLSelectElement>('compare');
  readonly #box = byId('comparison');
  #offered: MethodId | null = null;

  constructor(editor: Editor, comparison: Comparison) {
    this.#choice.addEventListener('change', () => {
      const { value } = this.#choice;
      comparison.choose(isMethod(value) ? value : null, editor.state);
    });
    byId('compare-off').addEventListener('click', () => {
      comparison.choose(null, editor.state);
      this.#choice.focus();
    });
  }

  /** Shows the comparison with the chosen method. `told` is null before the first answer. */
  show({ method: own, drawing }: State, method: MethodId | null, told: Compared | null): void {
    if (own !== this.#offered) {
      this.#offered = own;
      const others = methods.filter(({ id }) => id !== own);
      this.#choice.replaceChildren(
        new Option('nothing', ''),
        ...others.map(({ id, label }) => new Option(label, id)),
      );
    }
    this.#choice.value = method ?? '';
    this.#box.hidden = method === null;
    if (method === null) return;
    const label = (id: MethodId) => methods.find((one) => one.id === id)!.label;
    write(byId('compare-own'), label(own));
    write(byId('compare-other'), label(method));
    const active = drawing.objects.find(({ id }) => id === drawing.active);
    this.#box.style.setProperty('--own', active?.color ?? 'var(--curve)');
    this.#box.style.setProperty('--other', comparedColor(active?.color ?? null));
    this.#box.classList.toggle('late', told?.late ?? true);
    for (const which of ['mean', 'largest'] as const) {
      write(byId(`compare-${which}`), wordsOf(told?.inEdges, which));
      write(byId(`compare-${which}-part`), wordsOf(told?.ofLength, which, 100));
    }
    const problem = told?.problem ? sentenceOf(told.problem) : noCurve(told);
    write(byId('compare-problem'), problem);
    byId('compare-numbers').hidden = problem !== '';
  }
}

/** The color of the second curve. It differs from the first curve's color. */
export const comparedColor = (own: string | null) => (own === '#d9480f' ? '#0e7c9e' : '#d9480f');

const noCurve = (told: Compared | null) =>
  told && !told.polyline && !told.late ? 'There is no curve to compare yet.' : '';

/** A number with two digits, short enough for the panel's columns. */
function short(value: number): string {
  if (value === 0) return '0';
  if (value < 1e-4) return '< 0.0001';
  return value < 100 ? value.toPrecision(2) : formatInteger(Math.round(value));
}

/** A gap as text, in a unit: dots during the measurement, and empty if the gap is unknown. */
function wordsOf(gap: Gap | null | undefined, which: keyof Gap, scale = 1): string {
  if (gap === undefined) return '…';
  return gap ? short(scale * gap[which]) : '';
}
