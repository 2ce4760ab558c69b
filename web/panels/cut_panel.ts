import type { SurfacePoint } from 'karcher';
import type { WrittenFormat } from 'karcher/formats';
import type { ShownPart } from '../editor/engine/cut';
import type { View } from '../editor/engine/view';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import { remaking } from '../model/combining';
import { lies, withChoice } from '../model/parts';
import { formatArea, formatLength, formatVolume, type Unit } from '../model/units';
import { download } from './download';
import { byId, formatCount, make, write } from './elements';
import { sentenceOf, showError } from './messages';
import { NumberField } from './number_field';
import { eye } from './object_rows';

/** Colors for the parts, distinguishable on light and dark surfaces. */
const partColors = ['#2f9e8f', '#d9480f', '#8a3ffc', '#c81e5b', '#0b8457', '#b58900'];

export const partColor = (index: number) => partColors[index % partColors.length]!;

/** The largest number of parts in the list. */
const mostListed = 50;

const bin =
  '<svg viewBox="0 0 20 20" aria-hidden="true"><path d="M4 5.500h12M8 5.500v-2h4v2M5.500 5.500l.8 11h7.400l.8-11M8.500 8.500v5M11.500 8.500v5" /></svg>';
const save =
  '<svg viewBox="0 0 20 20" aria-hidden="true"><path d="M10 3v9M6.500 8.500 10 12l3.500-3.500M3.500 13v2.500a1.500 1.500 0 0 0 1.500 1.500h10a1.500 1.500 0 0 0 1.500-1.500V13" /></svg>';

const pick =
  '<svg viewBox="0 0 20 20" aria-hidden="true"><path d="M3 10h10M9.500 6l4 4-4 4M12 3h3.500A1.500 1.500 0 0 1 17 4.500v11a1.500 1.500 0 0 1-1.500 1.500H12" /></svg>';

const types: Record<WrittenFormat, string> = {
  stl: 'model/stl',
  ply: 'application/octet-stream',
  obj: 'model/obj',
  glb: 'model/gltf-binary',
};

/** The parts of a cut surface: their visibility, their thickness, and their files. */
export class CutPanel {
  readonly #group = byId('cut-settings');
  readonly #list = byId('parts');
  readonly #format = byId<HTMLSelectElement>('part-format');
  readonly #curves = byId<HTMLInputElement>('part-curves');
  readonly #thickness: NumberField;
  #parts: readonly ShownPart[] = [];
  #unit: Unit = '';

  /**
   * `fileOf` returns a part's file, with or without the curves on the part. `title` is the
   * surface's name. `workOn` makes a part the surface.
   */
  constructor(
    private readonly editor: Editor,
    private readonly fileOf: (
      part: ShownPart,
      format: WrittenFormat,
      withCurves: boolean,
    ) => Promise<Uint8Array>,
    private readonly title: () => string,
    private readonly workOn: (part: ShownPart, name: string) => void,
  ) {
    this.#format.append(
      ...Object.keys(types).map((format) =>
        make('option', format.toUpperCase(), { value: format }),
      ),
    );
    this.#format.addEventListener('change', () => this.#showCurves());
    this.#showCurves();
    byId('save-parts').addEventListener('click', () => void this.#saveAll());
    this.#thickness = new NumberField(
      byId<HTMLInputElement>('thickness'),
      (thickness) => this.#remake({ thickness }),
      {
        read: (text) => {
          const value = Number(text.trim().replace(',', '.'));
          return text.trim() !== '' && Number.isFinite(value) && value >= 0 ? value : null;
        },
        write: (value) => `${Number(value.toPrecision(4))}`,
      },
    );
  }

  showUnit(unit: Unit): void {
    this.#unit = unit;
    write(byId('thickness-unit'), unit);
    this.#showParts();
  }

  show({ figure, none }: State, { cut }: View): void {
    const isShown = figure.kind === 'cut' && !none;
    this.#group.hidden = !isShown;
    if (!isShown) return;
    this.#thickness.show(figure.derived?.thickness ?? 0);
    const parts = cut?.parts ?? [];
    const same = parts.length === this.#parts.length && parts.every((p, i) => p === this.#parts[i]);
    if (same) return;
    this.#parts = parts;
    this.#showParts();
  }

  /**
   * The actions on the part at a point; none if the part is not kept, or while the panel is hidden.
   */
  actionsAt(point: SurfacePoint | null): readonly [name: string, act: () => void][] {
    if (!point || this.#group.hidden) return [];
    const i = this.#parts.findIndex((part) => part.state === 'kept' && lies(point, part));
    const name = `Part ${i + 1}`;
    return i < 0 ? [] : [[`Work on ${name}`, () => this.workOn(this.#parts[i]!, name)]];
  }

  #showParts(): void {
    const parts = this.#parts;
    const focused = [...this.#list.querySelectorAll('button')].indexOf(
      document.activeElement as HTMLButtonElement,
    );
    const rows = parts.slice(0, mostListed).map((part, i) => this.#rowOf(part, i));
    this.#list.replaceChildren(...rows);
    this.#list.querySelectorAll('button')[focused]?.focus();
    const left = parts.length - mostListed;
    const notes = parts.flatMap(({ thick }, i) =>
      thick?.most
        ? `Part ${i + 1} allows a thickness of ${formatLength(thick.most, this.#unit)}: beyond that its shell runs into itself.`
        : [],
    );
    if (left > 0) notes.unshift(`and ${formatCount(left, 'smaller part')}`);
    write(byId('cut-note'), notes.slice(0, 3).join(' '));
    byId<HTMLButtonElement>('save-parts').disabled = this.#saved.length === 0;
  }

  #rowOf(part: ShownPart, i: number): HTMLLIElement {
    const row = make('li');
    const name = `Part ${i + 1}`;
    const { area, closed, volume } = part.thick ?? part;
    const solid = closed && volume !== null ? formatVolume(volume, this.#unit) : 'open';
    row.classList.toggle('hidden-object', part.state === 'hidden');
    row.classList.toggle('deleted-part', part.state === 'deleted');
    const main = make('div', '', { className: 'object' });
    const dot = make('i');
    dot.style.background = partColor(i);
    const facts = `${formatArea(area, this.#unit)} · ${solid}`;
    main.append(dot, make('span', name), make('small', facts));
    main.title = `Area ${facts}; ${formatCount((part.thick ?? part).triangles.length / 3, 'triangle')}, ${closed ? 'closed: it can be printed' : 'open: give it a thickness to print it'}`;
    const button = (className: string, label: string, icon: string, act: () => void) => {
      const made = make('button', '', { type: 'button', className, title: label });
      made.setAttribute('aria-label', `${label} ${name}`);
      made.innerHTML = icon;
      made.addEventListener('click', act);
      return made;
    };
    const toggle = (
      className: string,
      label: string,
      icon: string,
      state: 'hidden' | 'deleted',
    ) => {
      const made = button(className, label, icon, () =>
        this.#choose(part, part.state === state ? 'kept' : state),
      );
      const on = part.state === state;
      made.setAttribute('aria-pressed', `${state === 'hidden' ? !on : on}`);
      return made;
    };
    row.append(
      main,
      toggle('eye', 'Show or hide', eye, 'hidden'),
      toggle('part-bin', part.state === 'deleted' ? 'Bring back' : 'Delete', bin, 'deleted'),
      button('part-save', 'Save', save, () => void this.#save(part, name)),
      button('part-work', 'Work on', pick, () => this.workOn(part, name)),
    );
    return row;
  }

  /** Disables the choice of curves for STL files, which have no lines. */
  #showCurves(): void {
    const isStl = this.#format.value === 'stl';
    this.#curves.disabled = isStl;
    const why = isStl ? 'STL has no lines' : 'The curves that lie on each part';
    this.#curves.closest('label')!.title = why;
  }

  #choose(part: ShownPart, state: ShownPart['state']): void {
    const { parts = [] } = this.editor.state.figure.derived ?? {};
    this.#remake({ parts: withChoice(parts, part, state) });
  }

  #remake(part: Parameters<typeof remaking>[1]): void {
    const { editor } = this;
    editor.interrupt();
    if (!editor.refuses()) editor.perform(remaking(editor.state.drawing, part));
  }

  /** The parts to save: all except deleted ones. */
  get #saved(): { part: ShownPart; name: string }[] {
    return this.#parts.flatMap((part, i) =>
      part.state === 'deleted' ? [] : { part, name: `Part ${i + 1}` },
    );
  }

  async #saveAll(): Promise<void> {
    for (const { part, name } of this.#saved) await this.#save(part, name);
  }

  async #save(part: ShownPart, name: string): Promise<void> {
    const format = this.#format.value as WrittenFormat;
    const title = `${name} of ${this.title()}`;
    try {
      const withCurves = this.#curves.checked && !this.#curves.disabled;
      const bytes = await this.fileOf(part, format, withCurves);
      download(title, new Blob([bytes as BlobPart], { type: types[format] }), format);
    } catch (error) {
      showError(`${name} was not saved. ${sentenceOf(error)}`);
    }
  }
}
