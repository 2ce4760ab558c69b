import { polylinesOf } from '../editor/engine/compute';
import type { View } from '../editor/engine/view';
import type { State } from '../editor/state/state';
import { activeObject } from '../model/drawing';
import type { CombFacts, CombLayer } from '../viewer/comb_layer';
import type { Surface } from '../viewer/surface';
import type { Viewer } from '../viewer/viewer';
import { formatCount, make, write } from './elements';
import { Legend } from './legend';
import { nameOf } from './object_rows';

/**
 * The curvature comb of the edited curve, with its scale and its largest curvature; initially off.
 */
export class CombLegend {
  readonly #legend: Legend;
  readonly #scale = make('input', '', {
    ...{ id: 'comb-scale', type: 'range', min: '-3', max: '3', step: '0.25', value: '0' },
    title: 'How long the teeth are',
  });
  readonly #factor = make('output', '', { id: 'comb-factor' });
  #on = false;
  /**
   * The lines whose comb is visible. While they stay the same, neither the comb nor its scale
   * changes.
   */
  #shown: { lines: readonly Float32Array[]; object: number; surface: Surface | null } | null = null;

  constructor(
    private readonly viewer: Viewer,
    private readonly layer: CombLayer,
    private readonly now: () => { state: State; view: View; meanEdge: number },
  ) {
    const field = make('label', '', { className: 'field grow' });
    field.append(make('span', 'Teeth', { className: 'field-name' }), this.#scale, this.#factor);
    this.#factor.htmlFor.add(this.#scale.id);
    this.#legend = new Legend(
      {
        ...{ id: 'comb', item: 'comb', title: 'Curvature' },
        ...{ hides: 'Hide the curvature', key: 'U' },
      },
      [field],
      () => this.toggle(),
    );
    this.#scale.addEventListener('input', () => this.#setScale());
    this.#setScale();
  }

  toggle(): void {
    this.#on = !this.#on;
    this.#legend.shown = this.#on;
    this.show();
  }

  /** Shows the comb of the edited curve. */
  show(): void {
    const { state, view, meanEdge } = this.now();
    const lines = this.#on ? polylinesOf(view) : [];
    const { surface } = this.viewer;
    const object = state.drawing.active;
    const before = this.#shown;
    const same =
      before?.object === object && before.surface === surface && sameLines(before.lines, lines);
    if (!this.#on && !before) return;
    if (this.#on && same) return;
    this.#shown = this.#on ? { lines, object, surface } : null;
    const keepScale = state.dragging && before?.object === object;
    const facts = this.layer.show(surface, lines, meanEdge, { keepScale });
    this.viewer.requestFrame();
    this.#legend.tell(`Curvature of ${nameOf(activeObject(state.drawing))}`, wordsOf(facts));
  }

  #setScale(): void {
    const factor = 2 ** Number(this.#scale.value);
    const words = `${Number(factor.toPrecision(3))} ×`;
    write(this.#factor, words);
    this.#scale.setAttribute('aria-valuetext', words);
    this.layer.factor = factor;
    this.viewer.requestFrame();
  }
}

const sameLines = (a: readonly Float32Array[], b: readonly Float32Array[]) =>
  a.length === b.length && a.every((line, i) => line === b[i]);

function wordsOf({ greatest, corners }: CombFacts): string {
  if (greatest === null) {
    return corners > 0
      ? 'The curve has corners too near to each other.'
      : 'There is no curve here: select one.';
  }
  const radius = greatest > 0 ? ` (radius ${(1 / greatest).toPrecision(3)})` : '';
  const without = corners > 0 ? ` No teeth at ${formatCount(corners, 'corner')}.` : '';
  return `Greatest ${greatest.toPrecision(4)} per unit${radius}.${without}`;
}
