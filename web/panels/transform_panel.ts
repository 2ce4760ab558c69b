import {
  type MirrorIn,
  type MirrorTool,
  toggleMirror,
  toggleTransform,
} from '../editor/hand/mirror_tool';
import type { Size } from '../editor/hand/transform_frame';
import type { Numbers } from '../editor/hand/transform_gestures';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import { isEmpty } from '../model/figure';
import type { Unit } from '../model/units';
import { byId } from './elements';
import { NumberField } from './number_field';

const format = (least: number) => ({
  read(text: string): number | null {
    const value = Number(text.trim().replace(',', '.'));
    return text.trim() !== '' && Number.isFinite(value) && value >= least ? value : null;
  },
  write: (value: number) => `${value}`,
});

/**
 * The least visible difference between the two sides of a symmetric surface, relative to the
 * surface's diagonal.
 */
const least = 1e-4;

/**
 * Numbers that move, turn and scale the selection, each in one step. The selection keeps its
 * proportion, like in a drag of the frame's corners: a typed width also changes the height.
 */
export class TransformPanel {
  readonly #panel = byId('transform');
  readonly #transform = byId<HTMLButtonElement>('tool-transform');
  readonly #mirror = byId<HTMLButtonElement>('mirror');
  readonly #copies = byId<HTMLInputElement>('mirror-copies');
  readonly #fields: readonly (readonly [NumberField, number])[];
  readonly #width: NumberField;
  readonly #height: NumberField;

  constructor(editor: Editor, place: (numbers: Numbers) => void, mirror: MirrorTool) {
    this.#transform.addEventListener('click', () => toggleTransform(editor));
    this.#mirror.addEventListener('click', () => toggleMirror(editor));
    const field = (id: string, none: number, take: (value: number) => Numbers, least = -1e9) => {
      const input = byId<HTMLInputElement>(id);
      return [new NumberField(input, (value) => place(take(value)), format(least)), none] as const;
    };
    this.#fields = [
      field('move-x', 0, (x) => ({ x })),
      field('move-y', 0, (y) => ({ y })),
      field('turn', 0, (degrees) => ({ angle: (degrees * Math.PI) / 180 })),
      field('scale', 100, (percent) => ({ scale: percent / 100 }), 1),
    ];
    const side = (id: string, take: (value: number) => Numbers) =>
      new NumberField(byId<HTMLInputElement>(id), (value) => place(take(value)));
    this.#width = side('size-width', (width) => ({ width }));
    this.#height = side('size-height', (height) => ({ height }));
    this.#copies.addEventListener('change', () => {
      mirror.copies = this.#copies.checked;
    });
    const what = byId<HTMLSelectElement>('mirror-in');
    what.addEventListener('change', () => {
      mirror.in = what.value as MirrorIn;
    });
    byId('mirror-now').addEventListener('click', () => void mirror.mirrorInSymmetry());
  }

  /**
   * Shows the size of the frame's contents. The field of a side without extent is disabled, since
   * no scale gives the side a length.
   */
  showSize(size: Size | null): void {
    const { width = 0, height = 0 } = size ?? {};
    // Both sides are rounded to the decimals of the longer one, so that a line gets no width from
    // rounding errors.
    const last = 10 ** (Math.floor(Math.log10(Math.max(width, height))) - 3);
    const rounded = (side: number) => last * Math.round(side / last) || null;
    this.#width.show(rounded(width));
    this.#height.show(rounded(height));
  }

  showUnit(unit: Unit): void {
    byId('size-unit').textContent = unit;
  }

  /** Shows how much the surface's two sides differ, if the mirror is a plane of symmetry. */
  showMirror({ apart }: MirrorTool): void {
    byId('mirror-symmetric').hidden = apart === null;
    byId('mirror-apart').textContent =
      apart === null || apart < least ? '' : `Sides differ by ${(100 * apart).toFixed(2)} %`;
  }

  show({ tool, chosen, none, figure }: State): void {
    this.#mirror.setAttribute('aria-pressed', `${tool === 'mirror'}`);
    this.#transform.setAttribute('aria-pressed', `${tool === 'transform'}`);
    this.#transform.disabled =
      chosen.length === 0 && (none || isEmpty(figure)) && tool !== 'transform';
    this.#mirror.disabled = chosen.length === 0 && (none || isEmpty(figure));
    this.#panel.hidden = tool !== 'transform';
    byId('mirror-settings').hidden = tool !== 'mirror';
    for (const [field, none] of this.#fields) field.show(chosen.length > 0 ? none : null);
  }
}
