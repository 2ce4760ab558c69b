import type { CurveEdits } from '../editor/engine/curve_edits';
import { toggleMirror, toggleTransform } from '../editor/hand/mirror_tool';
import type { Editor } from '../editor/state/editor';
import { isResting, selectedObjects } from '../editor/state/state';
import { isCurve, isEmpty, type Kind, kinds } from '../model/figure';
import { placesOf } from '../model/moving';
import type { Viewer } from '../viewer/viewer';
import { byId } from './elements';
import { showNote } from './messages';
import { onTheme, sceneColors } from './theme';
import type { ToolRail } from './tool_list';
import type { ViewMenu } from './view_menu';

export interface ToolEvents {
  removeSelected(): void;
  /**
   * An address that opens the drawing again. If `complete`, the address also works in other
   * browsers. If `short`, every program accepts the address.
   */
  link(): { address: string; complete: boolean; short: boolean };
  saveJson(): void;
  toggleSnapping(): void;
  toggleDistances(): void;
  toggleComb(): void;
}

/** The toolbar, the global keys, the help and the theme. */
export class Tools {
  readonly #undo = byId<HTMLButtonElement>('undo');
  readonly #redo = byId<HTMLButtonElement>('redo');
  readonly #help = byId<HTMLDialogElement>('help-dialog');

  constructor(
    private readonly editor: Editor,
    private readonly viewer: Viewer,
    private readonly edits: CurveEdits,
    private readonly events: ToolEvents,
    private readonly rail: ToolRail,
    private readonly viewMenu: ViewMenu,
  ) {
    this.#undo.addEventListener('click', () => edits.undo());
    this.#redo.addEventListener('click', () => edits.redo());
    byId('share').addEventListener('click', () => this.#share());
    byId('help').addEventListener('click', () => this.#help.showModal());
    this.#help.addEventListener('click', (event) => {
      if (event.target === this.#help) this.#help.close();
    });
    onTheme(() => {
      viewer.colors = sceneColors();
    });
    document.addEventListener('keydown', (event) => this.#key(event));
    editor.subscribe(() => this.#showHistory());
    this.#showHistory();
  }

  #showHistory(): void {
    this.#undo.disabled = !this.editor.canUndo;
    this.#redo.disabled = !this.editor.canRedo;
  }

  #escape(): void {
    const { editor } = this;
    if (editor.state.dragging) editor.cancelDrag();
    else if (editor.state.tool === 'transform') editor.setTool('select');
    else if (!isResting(editor.state.tool)) editor.rest();
    else if (editor.state.selection !== null) editor.select(null);
    else editor.letGo();
  }

  /** Zooms to the selection, or to everything if nothing is selected. */
  #zoomToSelection(): void {
    const { viewer } = this;
    const { state } = this.editor;
    const ids = selectedObjects(state);
    const figures = state.drawing.objects.flatMap(({ id, figure }) =>
      ids.includes(id) && !isEmpty(figure) ? [figure] : [],
    );
    // The view must also contain the circle's place opposite its rim point.
    const around = figures.flatMap(({ circle }) => {
      const { surface } = viewer;
      if (!circle || !surface || !('face' in circle.rim)) return [];
      const center = surface.position(circle.center);
      return [center.clone().multiplyScalar(2).sub(surface.position(circle.rim))];
    });
    if (figures.length === 0) viewer.resetView({ animated: true });
    else viewer.zoomTo(figures.flatMap(placesOf), around);
  }

  #toggleClosed(): void {
    const { figure, none } = this.editor.state;
    const { kind, settings } = figure;
    if (isCurve(kind) && !none) this.edits.setClosed(!settings.closed);
  }

  #setKind(kind: Kind): void {
    this.edits.afterwards(() => this.editor.setKind(kind));
  }

  async #share(): Promise<void> {
    const { address, complete, short } = this.events.link();
    if (!short) {
      showNote('This drawing is too large for a link. Save it as JSON to pass it on.');
      return;
    }
    try {
      await navigator.clipboard.writeText(address);
      showNote(
        complete
          ? 'Link copied.'
          : 'Link copied. It opens only in this browser, which keeps the file.',
      );
    } catch {
      showNote('The browser did not allow copying the link; it is in the address bar.');
    }
  }

  #key(event: KeyboardEvent): void {
    const covered = document.querySelector('dialog[open], :popover-open');
    if (covered || event.defaultPrevented) return;
    const element = event.target instanceof HTMLElement ? event.target : null;
    if (event.altKey) {
      const steps = { ArrowUp: -1, ArrowDown: 1 }[event.key];
      if (!steps || element?.matches('select') || typeof this.editor.state.selection !== 'number')
        return;
      event.preventDefault();
      this.editor.moveInOrder(steps);
      return;
    }
    const key = event.key.toLowerCase();
    // A field with unfinished text receives all keys, including those that undo and redo.
    if (element?.matches('[data-edited]')) return;
    const typing =
      element?.closest('select, input[type="text"], textarea') ??
      (key === 'home' && element?.closest('input'));
    if (event.ctrlKey || event.metaKey) {
      if (key === 'z' && event.shiftKey) this.edits.redo();
      else if (key === 'z') this.edits.undo();
      else if (key === 'y') this.edits.redo();
      else if (key === 's') this.events.saveJson();
      else if (typing) return;
      else if (key === 'a') this.editor.chooseAll();
      else if (key === 'd') this.editor.objects.duplicate();
      else if (key === 'g' && event.shiftKey) this.editor.objects.ungroup();
      else if (key === 'g') this.editor.objects.group();
      else return;
      event.preventDefault();
      return;
    }
    if (typing) return;
    // If a button or a row has the focus, Enter presses it.
    if (key === 'enter' && !element?.closest('button, a, summary, input')) {
      event.preventDefault();
      this.edits.afterwards(() => this.editor.begin());
      return;
    }
    // The position of the key counts, since with Shift a digit's key types another character.
    if (event.shiftKey && (event.code === 'Digit1' || event.code === 'Digit2')) {
      event.preventDefault();
      if (event.code === 'Digit1') this.viewer.resetView({ animated: true });
      else this.#zoomToSelection();
      return;
    }
    const kind = /^\d$/.test(key) ? kinds[(Number(key) + 9) % 10] : undefined;
    const action = kind ? () => this.#setKind(kind) : this.#actions[key];
    if (action) action();
    else if (!this.rail.key(key)) return;
    event.preventDefault();
  }

  readonly #actions: Record<string, () => void> = {
    delete: () => this.events.removeSelected(),
    backspace: () => this.events.removeSelected(),
    escape: () => this.#escape(),
    n: () => this.edits.afterwards(() => this.editor.begin()),
    r: () => this.viewer.resetView({ animated: true }),
    home: () => this.viewer.resetView({ animated: true }),
    g: () => this.events.toggleSnapping(),
    t: () => this.viewMenu.toggleEdges(),
    h: () => this.viewMenu.toggleHidden(),
    d: () => this.events.toggleDistances(),
    u: () => this.events.toggleComb(),
    c: () => this.#toggleClosed(),
    s: () => this.edits.chooseSplit(),
    j: () => this.edits.chooseJoin(),
    k: () => toggleTransform(this.editor),
    i: () => toggleMirror(this.editor),
    l: () => this.editor.objects.toggleLook(),
    '?': () => this.#help.showModal(),
  };
}
