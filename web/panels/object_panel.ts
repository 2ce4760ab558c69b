import type { SurfacePoint } from 'karcher';
import type { Editor } from '../editor/state/editor';
import { type State, selectedObjects } from '../editor/state/state';
import type { Restyled } from '../model/arranging';
import { isDerived } from '../model/derived';
import {
  activeObject,
  type Dash,
  type DrawnObject,
  type FillPattern,
  type FillStyle,
  type LineStyle,
  leastOpacity,
  newObject,
  objectOf,
  surfaceWidths,
  widthRange,
} from '../model/drawing';
import { emptyFigure, type Figure, type FillRule, isEmpty, isRound } from '../model/figure';
import { longestName, shortened } from '../model/names';
import type { Unit } from '../model/units';
import { EditedField } from './edited_field';
import { byId, make, write } from './elements';
import { sentenceOf, showNote } from './messages';
import { NumberField, positiveNumber, wholeNumbers } from './number_field';
import { nameOf, ObjectRows } from './object_rows';
import { showShared } from './shared_settings';
import { onTheme, sceneColors } from './theme';

/** Colors that are distinguishable on light and dark surfaces; null is the theme's color. */
const colors: readonly [string | null, string][] = [
  [null, 'Default color'],
  ['#d9480f', 'Orange'],
  ['#c81e5b', 'Pink'],
  ['#8a3ffc', 'Violet'],
  ['#0b8457', 'Green'],
  ['#0e7c9e', 'Teal'],
  ['#222831', 'Black'],
  ['#f8f9fa', 'White'],
];

/** The opacity of a new fill. */
const firstFill = 0.5;

/** The first spacing of a pattern, in CSS pixels. */
const usualSpacing = 12;

const inSurfaceWidths = (value: number) =>
  Math.min(surfaceWidths.most, Math.max(surfaceWidths.least, value));

const selectedFills = (state: State) => {
  const ids = selectedObjects(state);
  return state.drawing.objects.filter(({ id }) => ids.includes(id)).map(({ fill }) => fill);
};

/** Shows a number that the selected objects share. The field is empty if their numbers differ. */
function showNumber(field: NumberField, shared: number | undefined): void {
  if (shared === undefined) field.showOpen();
  else field.show(shared);
}

/** Converts a color from the form `rgb(…)` to the form `#rrggbb`. */
const hexOf = (color: string) =>
  `#${(color.match(/\d+/g) ?? [])
    .slice(0, 3)
    .map((value) => Number(value).toString(16).padStart(2, '0'))
    .join('')}`;

/** The group whose members are exactly these objects, or null. */
function wholeGroup(objects: readonly DrawnObject[], { drawing }: State): string | null {
  const { group } = objects[0]!;
  const members = drawing.objects.filter((object) => object.group === group);
  const isWhole = objects.every((object) => object.group === group);
  return isWhole && members.length === objects.length ? group : null;
}

/**
 * The group that a name field edits, or null. For a group, the field has the negative id of a
 * member.
 */
const groupNamed = (id: number | null, { drawing }: State) =>
  id !== null && id < 0 ? (objectOf(drawing, -id)?.group ?? null) : null;

const percentOf = (part: number | undefined) =>
  part === undefined ? undefined : Math.round(100 * part);

/**
 * Whether the user can move an object's fill to the other side of its line. Derived objects have no
 * such choice, since they may have several regions.
 */
export const hasOtherSide = ({ fill, figure }: DrawnObject) => fill > 0 && !isDerived(figure.kind);

/** The list of objects, the actions on the selected ones, and their style. */
export class ObjectPanel {
  readonly #rows: ObjectRows;
  readonly #name = byId<HTMLInputElement>('object-name');
  readonly #named: EditedField<string>;
  readonly #dash = byId<HTMLSelectElement>('dash');
  readonly #custom = byId<HTMLInputElement>('color');
  readonly #swatches = colors.map(([color, name]) => this.#makeSwatch(color, name));
  readonly #width: NumberField;
  readonly #widthUnit = byId<HTMLSelectElement>('width-unit');
  readonly #look = byId<HTMLButtonElement>('look');
  readonly #opacity: NumberField;
  readonly #fill: NumberField;
  readonly #fillColor = byId<HTMLInputElement>('fill-color');
  readonly #pattern = byId<HTMLSelectElement>('pattern');
  readonly #spacing: NumberField;
  readonly #otherSide = byId<HTMLButtonElement>('other-side');
  readonly #rule = byId<HTMLSelectElement>('fill-rule');
  readonly #actions: readonly [HTMLButtonElement, (state: State) => boolean][];
  /** The theme's color of lines, in the form that color fields need. */
  #themeColor = '#000000';
  #shown: State | null = null;

  constructor(
    private readonly editor: Editor,
    /** Begins another object. */
    begin: () => void,
    /** The length of a pixel at an object, in the surface's unit. */
    reachOf: (object: DrawnObject) => number,
    /** The centroid of an object's fill; null if it has none. */
    centroidOf: (id: number) => Promise<SurfacePoint | null>,
  ) {
    byId('new-object').addEventListener('click', () => begin());
    this.#rows = new ObjectRows(editor, () => this.#name.select());
    onTheme(() => {
      this.#themeColor = hexOf(sceneColors().curve);
      const state = this.#shown;
      this.#shown = null;
      if (state) this.show(state);
    });
    const set = (to: Restyled) => editor.objects.setProperties(this.#targets, to);
    this.#name.maxLength = longestName;
    const rename = (name: string, id: number | null) => {
      const group = groupNamed(id, editor.state);
      if (group !== null) editor.objects.renameGroup(group, name);
      else if (id !== null) editor.objects.setProperties([id], { name });
    };
    this.#named = new EditedField(this.#name, rename, {
      read: (text) => text,
      write: (name) => name,
    });
    this.#name.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.#name.blur();
    });
    this.#custom.addEventListener('change', () => set({ color: this.#custom.value }));
    this.#dash.addEventListener('change', () => set({ dash: this.#dash.value as Dash }));
    this.#fill = new NumberField(
      byId<HTMLInputElement>('fill'),
      (percent) => set({ fill: percent / 100 }),
      wholeNumbers({ least: 0, most: 100 }),
    );
    this.#fillColor.addEventListener('change', () => {
      const fillColor = this.#fillColor.value;
      const none = selectedFills(editor.state).every((fill) => fill === 0);
      // If nothing is filled yet, the choice of a fill's color also makes the fill visible.
      set(none ? { fillColor, fill: firstFill } : { fillColor });
    });
    this.#pattern.addEventListener('change', () => {
      const pattern = this.#pattern.value as FillPattern;
      const none = selectedFills(editor.state).every((fill) => fill === 0);
      const spacingOf = (object: DrawnObject) =>
        object.spacing ?? Number((usualSpacing * reachOf(object)).toPrecision(2));
      set((object) => ({
        pattern,
        spacing: pattern === 'solid' ? null : inSurfaceWidths(spacingOf(object)),
        ...(none && pattern !== 'solid' && { fill: firstFill }),
      }));
    });
    this.#spacing = new NumberField(
      byId<HTMLInputElement>('pattern-spacing'),
      (spacing) => set({ spacing }),
      {
        read: (text) => {
          const value = positiveNumber(text);
          return value && inSurfaceWidths(value);
        },
        write: (value) => `${value}`,
      },
    );
    this.#otherSide.addEventListener('click', () => editor.objects.turnInside(this.#targets));
    this.#rule.addEventListener('change', () =>
      editor.objects.setRule(this.#targets, this.#rule.value as FillRule),
    );
    byId('centroid').addEventListener('click', () => void this.#markCentroids(centroidOf));
    this.#width = new NumberField(
      byId<HTMLInputElement>('width'),
      (width) => set({ width, onSurface: this.#isOnSurface }),
      {
        read: (text) => {
          const value = positiveNumber(text);
          const { least, most } = this.#isOnSurface ? surfaceWidths : widthRange;
          return value && Math.min(most, Math.max(least, value));
        },
        write: (value) => `${value}`,
      },
    );
    this.#widthUnit.addEventListener('change', () => {
      const onSurface = this.#isOnSurface;
      const { least, most } = onSurface ? surfaceWidths : widthRange;
      // Converts each width to the other unit, so that the lines look the same.
      set((object) => {
        if (object.onSurface === onSurface) return {};
        const reach = reachOf(object);
        const width = Number((object.width * (onSurface ? reach : 1 / reach)).toPrecision(2));
        return { onSurface, width: Math.min(most, Math.max(least, width)) };
      });
    });
    this.#look.addEventListener('click', () => editor.objects.toggleLook());
    this.#opacity = new NumberField(
      byId<HTMLInputElement>('opacity'),
      (percent) => set({ opacity: percent / 100 }),
      wholeNumbers({ least: 100 * leastOpacity, most: 100 }),
    );
    const isDrawn = ({ drawing }: State) => !isEmpty(activeObject(drawing).figure);
    const some = (state: State) => state.chosen.length > 0 || (!state.none && isDrawn(state));
    const lone = (state: State) => state.chosen.length < 2 && !state.none && isDrawn(state);
    const place = ({ drawing }: State) =>
      drawing.objects.findIndex(({ id }) => id === drawing.active);
    const action = (
      id: string,
      act: () => void,
      isPossible: (state: State) => boolean,
    ): [HTMLButtonElement, (state: State) => boolean] => {
      const button = byId<HTMLButtonElement>(id);
      button.addEventListener('click', act);
      return [button, isPossible];
    };
    this.#actions = [
      action('duplicate', () => editor.objects.duplicate(this.#targets), some),
      action('delete-object', () => editor.objects.delete(this.#targets), some),
      action(
        'raise',
        () => editor.objects.raise(editor.state.drawing.active, 1),
        (state) => lone(state) && place(state) < state.drawing.objects.length - 1,
      ),
      action(
        'lower',
        () => editor.objects.raise(editor.state.drawing.active, -1),
        (state) => lone(state) && place(state) > 0,
      ),
      action(
        'group',
        () => editor.objects.group(),
        ({ chosen }) => chosen.length > 1,
      ),
      action(
        'ungroup',
        () => editor.objects.ungroup(this.#targets),
        ({ chosen, drawing }) =>
          drawing.objects.some(({ id, group }) => group !== null && chosen.includes(id)),
      ),
    ];
  }

  show(state: State): void {
    const before = this.#shown;
    this.#shown = state;
    // A drag does not change the panel.
    if (before?.dragging && state.dragging) return;
    const same =
      before?.drawing === state.drawing &&
      before.chosen === state.chosen &&
      before.none === state.none;
    if (before && same) return;
    this.#rows.show(state);
    const active = activeObject(state.drawing);
    const ids = selectedObjects(state);
    const selected = state.drawing.objects.filter(({ id }) => ids.includes(id));
    this.#showStyle(selected.length > 0 ? selected : [active], selected.length);
    const title = selected.length > 1 ? `${selected.length} objects` : nameOf(active);
    write(byId('sheet-title'), selected.length === 0 ? 'Nothing selected' : title);
    for (const [button, isPossible] of this.#actions) button.disabled = !isPossible(state);
    byId<HTMLButtonElement>('new-object').disabled = isEmpty(activeObject(state.drawing).figure);
  }

  /** Shows the surface's unit as an option for the unit of widths. */
  showUnit(unit: Unit): void {
    this.#widthUnit.options[this.#widthUnit.options.length - 1]!.text = unit || 'units';
  }

  get #isOnSurface(): boolean {
    return this.#widthUnit.value === 'surface';
  }

  /** The objects that the panel changes. */
  get #targets(): readonly number[] {
    return selectedObjects(this.editor.state);
  }

  /** Adds a point at the centroid of each selected fill. */
  async #markCentroids(centroidOf: (id: number) => Promise<SurfacePoint | null>): Promise<void> {
    const { state } = this.editor;
    const filled = state.drawing.objects.filter(
      ({ id, fill }) => fill > 0 && this.#targets.includes(id),
    );
    try {
      const made: DrawnObject[] = [];
      for (const object of filled) {
        const point = await centroidOf(object.id);
        if (!point) continue;
        const figure: Figure = { ...emptyFigure, kind: 'points', points: [point] };
        const name = shortened(`Centroid of ${nameOf(object)}`, longestName);
        made.push(newObject(0, figure, { name, color: object.color }));
      }
      if (this.editor.state.drawing !== state.drawing) return;
      if (made.length > 0) this.editor.objects.add(made);
    } catch (error) {
      showNote(`The centroid was not found. ${sentenceOf(error)}`);
    }
  }

  /** Shows the properties that the selected objects share, and leaves the other fields empty. */
  #showStyle(objects: readonly DrawnObject[], selected: number): void {
    const last = objects.at(-1)!;
    const common = <Key extends keyof (LineStyle & FillStyle)>(key: Key) =>
      objects.every((object) => object[key] === last[key]) ? last[key] : undefined;
    const { id, name } = last;
    const group = selected > 1 ? wholeGroup(objects, this.editor.state) : null;
    if (group !== null) this.#named.show(group, -id);
    else this.#named.show(selected === 1 ? name : '', selected === 1 ? id : null);
    this.#name.placeholder =
      selected > 1
        ? `${selected} objects`
        : selected === 0
          ? 'Nothing selected'
          : nameOf({ ...last, name: '' });
    this.#name.disabled = selected !== 1 && group === null;
    const onSurface = common('onSurface');
    const widthUnit = onSurface ? 'surface' : 'pixels';
    showShared(this.#widthUnit, onSurface === undefined ? undefined : widthUnit);
    showNumber(this.#width, onSurface === undefined ? undefined : common('width'));
    showNumber(this.#opacity, percentOf(common('opacity')));
    showNumber(this.#fill, percentOf(common('fill')));
    const fillColor = common('fillColor') ?? common('color');
    if (fillColor !== undefined) this.#fillColor.value = fillColor ?? this.#themeColor;
    const pattern = common('pattern');
    showShared(this.#pattern, pattern);
    byId('pattern-spacing').hidden = objects.some((object) => object.pattern === 'solid');
    showNumber(this.#spacing, common('spacing') ?? undefined);
    showShared(this.#dash, common('dash'));
    // A cut has neither a line nor a fill.
    const isCut = objects.every(({ figure }) => figure.kind === 'cut');
    for (const id of ['line-style', 'line-opacity', 'fill-line', 'pattern-line']) {
      byId(id).hidden = isCut;
    }
    this.#showRule(
      objects.filter((object) => object.fill > 0 && object.figure.kind !== 'cut'),
      selected,
    );
    const color = selected > 0 ? common('color') : undefined;
    for (const swatch of this.#swatches) {
      const isShown = color !== undefined && (swatch.dataset.color || null) === color;
      swatch.setAttribute('aria-pressed', `${isShown}`);
    }
    const isOwn = color !== undefined && colors.every(([one]) => one !== color);
    this.#custom.classList.toggle('chosen', isOwn);
    if (color !== undefined) this.#custom.value = color ?? this.#themeColor;
    const inputs = ['width', 'opacity', 'fill', 'pattern-spacing'].map((id) =>
      byId<HTMLInputElement>(id),
    );
    const lists = [this.#widthUnit, this.#dash, this.#fillColor, this.#pattern];
    this.#look.setAttribute('aria-pressed', `${this.editor.state.tool === 'look'}`);
    const controls = [...this.#swatches, this.#custom, this.#look, ...lists, ...inputs];
    for (const control of controls) control.disabled = selected === 0;
    this.#otherSide.disabled = selected === 0 || !objects.some(hasOtherSide);
  }

  /**
   * Shows the fill rule of the objects that have one of their own. Derived objects have the rule of
   * their sources, and round objects do not cross themselves.
   */
  #showRule(filled: readonly DrawnObject[], selected: number): void {
    const own = filled.filter(({ figure: { kind } }) => !isDerived(kind) && !isRound(kind));
    const rules = new Set(own.map(({ figure }) => figure.rule ?? 'evenOdd'));
    const [rule, ...others] = rules;
    byId('rule-line').hidden = filled.length === 0 || selected === 0;
    showShared(this.#rule, others.length > 0 ? undefined : (rule ?? 'evenOdd'));
    this.#rule.disabled = own.length === 0;
    this.#rule.title =
      own.length > 0
        ? 'Even-odd: every second area from the outside; nonzero: every area that the line goes round'
        : filled.some(({ figure }) => isDerived(figure.kind))
          ? 'What it is made of has the rule'
          : 'Its line does not cross itself';
  }

  #makeSwatch(color: string | null, title: string): HTMLButtonElement {
    const swatch = make('button', '', { type: 'button', className: 'swatch', title });
    swatch.setAttribute('aria-label', title);
    swatch.dataset.color = color ?? '';
    swatch.style.backgroundColor = color ?? '';
    swatch.addEventListener('click', () =>
      this.editor.objects.setProperties(this.#targets, { color }),
    );
    byId('swatches').append(swatch);
    return swatch;
  }
}
