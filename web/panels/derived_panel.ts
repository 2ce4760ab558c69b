import type { Expansion } from '../editor/engine/expansion';
import type { Editor } from '../editor/state/editor';
import { type State, selectedObjects } from '../editor/state/state';
import {
  combinable,
  combining,
  cutting,
  offsetting,
  remaking,
  willCombine,
} from '../model/combining';
import type { Command } from '../model/commands';
import {
  booleans,
  type CornerShape,
  cornerShapes,
  type DerivedKind,
  isBoolean,
  type Offset,
  type OffsetSide,
  offsetSides,
  plainOffset,
} from '../model/derived';
import { activeObject, objectOf } from '../model/drawing';
import { originsText, originText } from '../model/origins';
import { areLoops, resolvedFigure } from '../model/sources';
import type { Unit } from '../model/units';
import { byId, choices, make, write } from './elements';
import { kindNames, kindNotes } from './kind_names';
import { NumberField, positiveNumber } from './number_field';
import { nameOf } from './object_rows';

/** The first distance of an offset, relative to the surface's diagonal. */
const firstDistance = 0.02;

const sideNames: Record<OffsetSide, string> = {
  outwards: 'Outwards',
  inwards: 'Inwards',
  both: 'Both sides',
};

const cornerNames: Record<CornerShape, string> = {
  round: 'Round',
  miter: 'Mitred',
  bevel: 'Bevelled',
};

const atLeastZero = {
  read: (text: string) => (Number(text.trim() || NaN) === 0 ? 0 : positiveNumber(text)),
  write: (value: number) => `${Number(value.toPrecision(4))}`,
};

/** The buttons that derive objects from others, and the settings of derived objects. */
export class DerivedPanel {
  readonly #makers: readonly HTMLButtonElement[];
  readonly #actions: readonly [name: string, act: () => void][];
  readonly #distance: NumberField;
  readonly #end: NumberField;
  readonly #input = byId<HTMLInputElement>('offset-distance');
  readonly #sides: readonly HTMLInputElement[];
  readonly #corners: readonly HTMLInputElement[];

  /** `diagonal` is the surface's diagonal. */
  constructor(
    private readonly editor: Editor,
    expansion: Expansion,
    private readonly diagonal: () => number,
  ) {
    const kindsMade: readonly DerivedKind[] = ['offset', 'cut', ...booleans];
    this.#actions = kindsMade.map((kind) => {
      if (kind === 'offset') return ['Offset', () => this.offset()];
      if (kind === 'cut') return ['Cut', () => this.#make(cutting)];
      return [kindNames[kind], () => this.#make(combining, kind)];
    });
    this.#makers = this.#actions.map(([name, act], i) => {
      const title = kindNotes[kindsMade[i]!];
      const button = make('button', name, { type: 'button', className: 'button small', title });
      button.addEventListener('click', act);
      return button;
    });
    byId('makers').append(...this.#makers);
    this.#distance = new NumberField(this.#input, (distance) => this.#remakeOffset({ distance }));
    this.#end = new NumberField(
      byId<HTMLInputElement>('offset-end'),
      (end) => this.#remakeOffset({ end }),
      atLeastZero,
    );
    this.#sides = choices('offset-side', offsetSides, sideNames, (side) =>
      this.#remakeOffset({ side }),
    );
    this.#corners = choices('offset-corners', cornerShapes, cornerNames, (corners) =>
      this.#remakeOffset({ corners }),
    );
    byId('expand').addEventListener('click', () => void expansion.expand());
  }

  /**
   * The names of the objects that can be derived from the selection, with the commands for them.
   */
  get possible(): readonly [name: string, act: () => void][] {
    if (byId('makers-group').hidden) return [];
    return this.#actions.flatMap(([name, act], i) => {
      const { hidden, disabled } = this.#makers[i]!;
      // In a menu the single word 'Cut' would mean the clipboard.
      return hidden || disabled ? [] : [[name === 'Cut' ? 'Cut the surface' : name, act]];
    });
  }

  /** Adds an offset of the selection, and lets the user type its distance. */
  offset(): void {
    const power = 10 ** Math.floor(Math.log10(firstDistance * this.diagonal()));
    const rounded = Math.round((firstDistance * this.diagonal()) / power) * power;
    this.#make(offsetting, Number(rounded.toPrecision(1)));
    this.#input.select();
  }

  showUnit(unit: Unit): void {
    write(byId('offset-unit'), unit);
  }

  show(state: State): void {
    const { drawing, figure, none, dragging } = state;
    if (dragging) return;
    const count = combinable(drawing, selectedObjects(state)).length;
    // The buttons appear with the first point, so that nothing jumps when further points follow.
    byId('makers-group').hidden = !willCombine(drawing, selectedObjects(state));
    for (const [i, button] of this.#makers.entries()) {
      button.hidden = count < 2 && i >= 2;
      button.disabled = count === 0;
    }
    const { offset, sources } = (!none && figure.derived) || {};
    byId('derived-settings').hidden = !sources;
    this.#showOrigins(state);
    byId('expand').hidden = figure.kind === 'cut';
    byId('offset-settings').hidden = !offset;
    this.#distance.show(offset?.distance ?? null);
    this.#end.show(offset?.end ?? offset?.distance ?? null);
    for (const input of this.#sides) input.checked = input.value === offset?.side;
    for (const input of this.#corners) {
      input.checked = input.value === (offset?.corners ?? 'round');
      input.disabled = offset?.end !== undefined && input.value !== 'round';
      input.parentElement!.title = input.disabled ? 'With two distances corners are round' : '';
    }
    const objects = sources?.flatMap((id) => objectOf(drawing, id) ?? []);
    const { operands = [] } = resolvedFigure(drawing, activeObject(drawing));
    write(byId('offset-end-name'), areLoops(operands) ? 'Halfway' : 'At the end');
    const names = objects?.map(nameOf);
    const of = isBoolean(figure.kind) ? 'Of' : figure.kind === 'cut' ? 'Along' : 'From';
    write(byId('derived-sources'), `${of} ${names?.join(', ') || 'nothing any more'}`);
  }

  /** Shows the origin of the selected piece, or else the origins of all pieces of the curve. */
  #showOrigins({ figure, none, selection }: State): void {
    const piece = typeof selection === 'number' ? figure.points[selection]?.origin : undefined;
    const all = none ? '' : originsText(figure);
    const words = all && piece ? `The piece after this anchor: ${originText(piece)}` : all;
    byId('origins').hidden = words === '';
    write(byId('origins'), words.replace(/^f/, 'F'));
  }

  #make<More extends unknown[]>(
    command: (drawing: State['drawing'], ids: readonly number[], ...more: More) => Command | null,
    ...more: More
  ): void {
    const { editor } = this;
    editor.interrupt();
    const { state } = editor;
    editor.setTool('select');
    editor.perform(command(state.drawing, selectedObjects(state), ...more), {
      ...{ selection: null, chosen: [], none: false },
    });
  }

  #remakeOffset(part: Partial<Offset>): void {
    const { editor } = this;
    editor.interrupt();
    const { offset } = editor.state.figure.derived ?? {};
    if (!offset || editor.refuses()) return;
    const made = plainOffset({ ...offset, ...part });
    editor.perform(remaking(editor.state.drawing, { offset: made }));
  }
}
