import type { Compared, Comparison } from '../editor/engine/comparison';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import type { Gap } from '../model/gap';
import { isMethod, type MethodId, methods } from '../model/methods';
import { byId, write } from './elements';
import { sentenceOf } from './messages';

/** Chooses the method that the edited curve is compared with, and tells how far the two are apart. */
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

  /** What is compared; `method` is chosen, perhaps without an answer yet. */
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
    write(byId('compare-mean'), wordsOf(told, 'mean'));
    write(byId('compare-largest'), wordsOf(told, 'largest'));
    const problem = told?.problem ? sentenceOf(told.problem) : noCurve(told);
    write(byId('compare-problem'), problem);
    byId('compare-numbers').hidden = problem !== '';
  }
}

/** The second curve has a color that the first one has not. */
export const comparedColor = (own: string | null) => (own === '#d9480f' ? '#0e7c9e' : '#d9480f');

const noCurve = (told: Compared | null) =>
  told && !told.polyline && !told.late ? 'There is no curve to compare yet.' : '';

const number = (value: number) =>
  value === 0 ? '0' : value < 1e-4 ? '< 0.0001' : value.toPrecision(2);

function wordsOf(told: Compared | null, which: keyof Gap): string {
  if (!told?.inEdges) return '…';
  const edges = `${number(told.inEdges[which])} edges`;
  return told.ofLength ? `${edges} · ${number(100 * told.ofLength[which])} %` : edges;
}
