import type { CurveLevels } from 'karcher';
import type { CurveEdits } from '../editor/engine/curve_edits';
import type { View } from '../editor/engine/view';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import {
  defaultSettings,
  isCurve,
  marksRange,
  samplesRange,
  toleranceRange,
} from '../model/figure';
import { settingFields } from '../model/link_fields';
import { mayHaveLevels } from '../model/splines';
import { byId, write } from './elements';
import { sentenceOf } from './messages';
import { NumberField, positiveNumber, wholeNumbers } from './number_field';
import { sharedSettings, showShared } from './shared_settings';

/** The tolerance that the field shows first, relative to the surface's size. */
const firstTolerance = 1e-4;

/** The fine settings of a curve: its samples, the marks along it, a B-spline's knots. */
export class FineSettings {
  readonly #group = byId('fine-settings');
  readonly #sampling = byId<HTMLSelectElement>('sampling');
  readonly #levels = byId<HTMLSelectElement>('levels');
  readonly #samples: NumberField;
  readonly #tolerance: NumberField;
  readonly #marks: NumberField;
  readonly #knots: KnotsField;

  constructor(editor: Editor, edits: CurveEdits) {
    this.#sampling.addEventListener('change', () => {
      const byTolerance = this.#sampling.value === 'tolerance';
      editor.setSettings({ tolerance: byTolerance ? firstTolerance : null });
    });
    this.#levels.addEventListener('change', () => {
      const levels = settingFields.levels.read(this.#levels.value);
      if (levels !== null) editor.setSettings({ levels });
    });
    this.#samples = new NumberField(
      byId<HTMLInputElement>('samples'),
      (samples) => editor.setSettings({ samples }),
      wholeNumbers(samplesRange),
    );
    this.#tolerance = new NumberField(
      byId<HTMLInputElement>('tolerance'),
      (tolerance) => editor.setSettings({ tolerance }),
      {
        read(text) {
          const value = positiveNumber(text);
          const { least, most } = toleranceRange;
          return value && Math.min(most, Math.max(least, value));
        },
        write: (value) => `${value}`,
      },
    );
    this.#marks = new NumberField(
      byId<HTMLInputElement>('marks'),
      (marks) => editor.setSettings({ marks: marks < marksRange.least ? 0 : marks }),
      wholeNumbers({ least: 0, most: marksRange.most }),
    );
    this.#knots = new KnotsField(editor, edits);
  }

  show(state: State, { curve }: View): void {
    const { kind, settings } = state.figure;
    const shared = sharedSettings(state);
    this.#group.hidden = !isCurve(kind);
    const withKnots = kind === 'bspline';
    byId('levels-field').hidden = !mayHaveLevels(kind);
    this.#showLevels(shared('levels'));
    const tolerance = shared('tolerance');
    const byTolerance = tolerance === undefined ? undefined : tolerance !== null;
    showShared(
      this.#sampling,
      byTolerance === undefined ? undefined : byTolerance ? 'tolerance' : 'number',
    );
    byId('samples').hidden = byTolerance !== false;
    byId('tolerance').hidden = byTolerance !== true;
    showNumber(this.#samples, shared('samples'));
    this.#tolerance.show(tolerance ?? defaultSettings.tolerance);
    showNumber(this.#marks, shared('marks'));
    const knots = settings.knots ?? Array.from(curve?.knots ?? []);
    // Several curves do not share a list of knots.
    this.#knots.show(withKnots && state.chosen.length < 2 ? knots : null);
  }

  #showLevels(levels: CurveLevels | undefined): void {
    const isOffered = [...this.#levels.options].some(({ value }) => value === `${levels}`);
    // A link may have a number that the menu does not offer.
    if (!isOffered && levels !== undefined) {
      this.#levels.append(new Option(`${levels} levels`, `${levels}`));
    }
    showShared(this.#levels, levels);
  }
}

function showNumber(field: NumberField, value: number | undefined): void {
  if (value === undefined) field.showOpen();
  else field.show(value);
}

/** A knot rounded for display. If the user does not change the text, the exact knot stays. */
const shown = (knot: number) => `${Number(knot.toPrecision(6))}`;

/**
 * A B-spline's knots as a list, which takes effect on Enter or when the field loses the focus. An
 * empty list removes the curve's own knots. An invalid list stays in the field, with a sentence
 * about the fault; Escape restores the previous list.
 */
class KnotsField {
  readonly #text = byId<HTMLTextAreaElement>('knots');
  readonly #problem = byId('knots-problem');
  #knots: readonly number[] = [];

  constructor(
    private readonly editor: Editor,
    private readonly edits: CurveEdits,
  ) {
    this.#text.addEventListener('input', () => {
      this.#text.dataset.edited = '';
    });
    this.#text.addEventListener('change', () => this.#take());
    this.#text.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== 'Escape') return;
      event.preventDefault();
      if (event.key === 'Enter') void this.#take();
      else this.#restore();
    });
  }

  /** Shows knots; null hides the field. */
  show(knots: readonly number[] | null): void {
    byId('knots-field').hidden = !knots;
    if (!knots) this.#restore();
    this.#knots = knots ?? [];
    this.#text.disabled = this.#knots.length === 0;
    if (!('edited' in this.#text.dataset)) this.#restore();
  }

  get #whole(): string {
    return this.#knots.map(shown).join(', ');
  }

  async #take(): Promise<void> {
    if (!('edited' in this.#text.dataset)) return;
    const words = this.#text.value.split(/[\s,;]+/).filter((word) => word !== '');
    if (words.join(', ') === this.#whole) {
      this.#restore();
      return;
    }
    if (words.length === 0) {
      this.#restore();
      this.editor.setSettings({ knots: null });
      return;
    }
    const known = new Map(this.#knots.map((knot) => [shown(knot), knot]));
    const numbers = words.map((word) => known.get(word) ?? Number(word));
    const wrong = words.find((_, i) => !Number.isFinite(numbers[i]));
    const problem = wrong ? `'${wrong}' is not a number` : await this.edits.setKnots(numbers);
    if (problem) this.#tell(sentenceOf(problem));
    else this.#restore();
  }

  #tell(problem: string): void {
    write(this.#problem, problem);
    this.#problem.hidden = problem === '';
    this.#text.setAttribute('aria-invalid', `${problem !== ''}`);
    if (problem) this.#problem.scrollIntoView({ block: 'nearest' });
  }

  #restore(): void {
    delete this.#text.dataset.edited;
    this.#tell('');
    if (this.#text.value !== this.#whole) this.#text.value = this.#whole;
  }
}
