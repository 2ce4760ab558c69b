import { type CurveEdits, joinable } from '../editor/engine/curve_edits';
import type { View } from '../editor/engine/view';
import type { Editor } from '../editor/state/editor';
import type { State } from '../editor/state/state';
import { isDerived } from '../model/derived';
import { isCurve, isEmpty, isRound, isSpline, type Kind } from '../model/figure';
import { type MethodId, methods } from '../model/methods';
import type { Joint } from '../model/pen';
import { CircleSettings } from './circle_settings';
import { byId, choices, make, write } from './elements';
import { FineSettings } from './fine_settings';
import { Folds } from './folds';
import { kindGroups, kindNames, kindNotes } from './kind_names';
import { PointRows } from './point_rows';
import { SettingsPanel } from './settings_panel';

export interface CurveEvents {
  chooseMethod(id: MethodId): void;
  setJoint(joint: Joint): void;
}

/** The curve's kind, its method, and the list of its control points. */
export class CurvePanel {
  readonly #method = byId<HTMLSelectElement>('method');
  readonly #kindGroup = byId('kind-group');
  readonly #pointsGroup = byId('points-group');
  readonly #rows: PointRows;
  readonly #clear = byId<HTMLButtonElement>('clear');
  readonly #split = byId<HTMLButtonElement>('split');
  readonly #join = byId<HTMLButtonElement>('join');
  readonly #goOn = byId<HTMLButtonElement>('go-on');
  readonly #reverse = byId<HTMLButtonElement>('reverse');
  readonly #kinds: readonly HTMLInputElement[];
  readonly #settings: SettingsPanel;
  readonly #circle: CircleSettings;
  readonly #fine: FineSettings;
  readonly #folds = new Folds();

  constructor(
    private readonly editor: Editor,
    edits: CurveEdits,
    events: CurveEvents,
  ) {
    this.#rows = new PointRows(editor);
    this.#settings = new SettingsPanel(editor, edits, (joint) => events.setJoint(joint));
    this.#circle = new CircleSettings(editor);
    this.#fine = new FineSettings(editor, edits);
    const kinds = kindGroups.flatMap((group) => (group.kinds.length > 1 ? group.kinds : []));
    const setKind = (kind: Kind) => edits.afterwards(() => editor.setKind(kind));
    this.#kinds = choices('kind', kinds, kindNames, setKind, kindNotes);
    for (const { id, label } of methods) this.#method.append(make('option', label, { value: id }));
    this.#method.addEventListener('change', () => {
      events.chooseMethod(this.#method.value as MethodId);
    });
    this.#clear.addEventListener('click', () => this.editor.clear());
    this.#reverse.addEventListener('click', () => edits.reverse());
    this.#split.addEventListener('click', () => edits.chooseSplit());
    this.#goOn.addEventListener('click', () => editor.setTool('insert'));
    this.#join.addEventListener('click', () => edits.chooseJoin());
  }

  show(state: State, view: View): void {
    const { kind } = state.figure;
    // The group stays visible for the freehand tool, since it contains the tolerance of a stroke.
    this.#kindGroup.hidden = state.none && state.tool !== 'freehand';
    this.#pointsGroup.hidden = state.none || isDerived(kind);
    const group = kindGroups.find(({ kinds }) => kinds.includes(kind))!;
    write(byId('kind-title'), group.title);
    this.#showKinds(group.kinds);
    for (const input of this.#kinds) {
      input.checked = input.value === kind;
      input.parentElement!.hidden = !group.kinds.includes(input.value as Kind);
    }
    this.#folds.show(state);
    this.#method.value = state.method;
    const { tool } = state;
    const takesPoints = !isRound(kind) && !isDerived(kind);
    this.#goOn.hidden = tool !== 'select' || !takesPoints || isEmpty(state.figure);
    byId('actions').hidden = !isCurve(kind) && this.#goOn.hidden;
    // These buttons are for splines. The user edits a curve of the pen at its anchors.
    for (const button of [this.#split, this.#reverse]) {
      button.hidden = !isSpline(kind);
      // A disabled button keeps its place, so that no control jumps while the user adds the first
      // points.
      button.disabled = !view.curve;
    }
    this.#split.setAttribute('aria-pressed', `${tool === 'split'}`);
    this.#join.setAttribute('aria-pressed', `${tool === 'join'}`);
    this.#join.hidden = !isSpline(kind) || joinable(state).length === 0;
    this.#clear.hidden = isEmpty(state.figure);
    write(byId('points-title'), pointsTitles[kind] ?? 'Control points');
    this.#rows.show(state, view);
    this.#settings.show(state);
    this.#circle.show(state, view);
    this.#fine.show(state, view);
  }

  /**
   * Shows the choice of kinds. The kinds of splines, which differ by their mathematics, are among
   * the advanced settings.
   */
  #showKinds(kinds: readonly Kind[]): void {
    const row = byId('kind');
    row.hidden = kinds.length < 2;
    const place = byId(kinds.some(isSpline) ? 'kind-advanced' : 'kind-place');
    if (row.parentElement !== place) place.append(row);
  }
}

const pointsTitles: Partial<Record<Kind, string>> = {
  circle: 'Circle',
  ellipse: 'Ellipse',
  center: 'Points and their weights',
  points: 'Points',
  pen: 'Anchors',
};
