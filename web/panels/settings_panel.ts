import type { Parametrization } from 'karcher';
import type { CurveEdits } from '../editor/engine/curve_edits';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import { type CurveSettings, isCurve } from '../model/figure';
import { type Joint, jointOf } from '../model/pen';
import { byId, make } from './elements';
import { sharedSettings, showShared } from './shared_settings';

const degrees = ['1, linear', '2, quadratic', '3, cubic', '4, quartic', '5, quintic'];

/** The settings of a kind of curve besides its points: closed or open, degree, knots. */
export class SettingsPanel {
  readonly #group = byId('settings');
  readonly #closed = byId<HTMLInputElement>('closed');
  readonly #clamped = byId<HTMLInputElement>('clamped');
  readonly #degree = byId<HTMLSelectElement>('degree');
  readonly #spacing = byId<HTMLSelectElement>('spacing');
  readonly #joint = byId<HTMLSelectElement>('joint');

  constructor(
    private readonly editor: Editor,
    edits: CurveEdits,
    setJoint: (joint: Joint) => void,
  ) {
    for (const [i, label] of degrees.entries()) {
      this.#degree.append(make('option', label, { value: `${i + 1}` }));
    }
    this.#closed.addEventListener('change', () => edits.setClosed(this.#closed.checked));
    this.#clamped.addEventListener('change', () =>
      this.#set({ clamped: this.#clamped.checked, knots: null }),
    );
    // The user's knots fit only one degree, so another degree removes them.
    this.#degree.addEventListener('change', () =>
      this.#set({ degree: Number(this.#degree.value), knots: null }),
    );
    this.#joint.addEventListener('change', () => {
      setJoint(this.#joint.value as Joint);
      this.show(editor.state);
    });
    this.#spacing.addEventListener('change', () =>
      this.#set({ parametrization: this.#spacing.value as Parametrization }),
    );
  }

  show(state: State): void {
    const { figure, selection } = state;
    const { kind, settings, points } = figure;
    const anchor = points[typeof selection === 'number' ? selection : 0];
    this.#joint.value = jointOf(anchor?.tangents);
    this.#group.hidden = !isCurve(kind);
    const shared = sharedSettings(state);
    showShared(this.#closed, shared('closed'));
    const clamped = shared('clamped');
    showShared(this.#clamped, clamped && !settings.knots);
    showShared(this.#degree, shared('degree'));
    showShared(this.#spacing, shared('parametrization'));
    const uses: [HTMLElement, boolean][] = [
      [this.#clamped, kind === 'bspline' && !settings.closed],
      [this.#degree, kind === 'bspline'],
      [this.#spacing, kind === 'catmullrom'],
      [this.#joint, kind === 'pen'],
    ];
    for (const [element, used] of uses)
      element.closest<HTMLElement>('.field, .check')!.hidden = !used;
  }

  #set(part: Partial<CurveSettings>): void {
    this.editor.setSettings(part);
  }
}
