import type { SurfacePoint } from 'karcher';
import { type Alignment, alignedParts } from '../editor/engine/aligning';
import { clickSlop } from '../editor/hand/stage_pointer';
import { targetAt } from '../editor/hand/targets';
import type { Editor } from '../editor/state/editor';
import { type State, selectedObjects } from '../editor/state/state';
import { isEmpty } from '../model/figure';
import type { Viewer } from '../viewer/viewer';
import type { Clipboard } from './clipboard';
import { make } from './elements';
import { Menu } from './menu';
import { hasOtherSide } from './object_panel';

/** The time in milliseconds after which a resting finger opens the menu. */
const restMilliseconds = 500;

/**
 * The menu of actions. A right click or a resting finger opens it for a place of the stage. The
 * menu key opens it for the selection.
 */
export class ContextMenu {
  readonly #menu = new Menu('context-menu');
  #press: { pointer: number; x: number; y: number; slop: number; timer: number } | null = null;

  /** `letGo` undoes unfinished gestures on the stage. */
  constructor(
    private readonly editor: Editor,
    private readonly viewer: Viewer,
    private readonly stage: HTMLElement,
    private readonly letGo: () => void,
    private readonly clipboard: Clipboard,
    private readonly align: (how: Alignment) => void,
    private readonly makers: () => readonly Action[],
    /** The actions on the surface. `point` is the surface's point at the menu's place, or null. */
    private readonly ofSurface: (point: SurfacePoint | null) => readonly Action[],
    /** Whether a point lies in the fill of an object. */
    private readonly isFilledAt: (id: number, point: SurfacePoint) => boolean,
  ) {
    // The browser would close the menu when the user lifts the finger that opened it, so the page
    // closes it instead.
    window.addEventListener('pointerdown', ({ target }) => this.#close(target), { capture: true });
    window.addEventListener('blur', () => this.#close(null));
    // The listener is on the window, since the menu has the focus only a moment after it appears.
    const byKey = (event: KeyboardEvent) => {
      if (event.key !== 'Escape' && event.key !== 'Tab') return;
      if (!this.#menu.element.matches(':popover-open')) return;
      event.preventDefault();
      event.stopPropagation();
      this.#close(null);
      stage.focus({ preventScroll: true });
    };
    window.addEventListener('keydown', byKey, { capture: true });
    stage.addEventListener('pointerdown', (event) => this.#down(event), { capture: true });
    window.addEventListener('pointermove', ({ pointerId, clientX, clientY }) => {
      const press = this.#press;
      if (press?.pointer !== pointerId) return;
      if (Math.hypot(clientX - press.x, clientY - press.y) > press.slop) this.#forget();
    });
    window.addEventListener('pointerup', (event) => {
      const press = this.#press;
      this.#forget();
      if (press?.pointer === event.pointerId && event.button === 2) {
        this.#open({ x: press.x, y: press.y, touch: false });
      }
    });
    window.addEventListener('pointercancel', () => this.#forget());
    stage.addEventListener('keydown', (event) => {
      const asked = event.key === 'ContextMenu' || (event.key === 'F10' && event.shiftKey);
      if (!asked) return;
      event.preventDefault();
      const { left, top, width, height } = viewer.box;
      this.#show(left + width / 2, top + height / 2, null);
    });
  }

  #down(event: PointerEvent): void {
    const isSecond = this.#press !== null;
    this.#forget();
    const touch = event.pointerType === 'touch';
    if (isSecond || event.button !== (touch ? 0 : 2)) return;
    const { pointerId: pointer, clientX: x, clientY: y } = event;
    const slop = touch ? clickSlop.touch : clickSlop.mouse;
    const press = { pointer, x, y, slop, timer: 0 };
    this.#press = press;
    if (!touch) return;
    const open = () => {
      if (this.#press !== press) return;
      this.#forget();
      this.letGo();
      this.#open({ x, y, touch });
    };
    // The menu opens one frame later, since a busy page receives the finger's latest moves only
    // then.
    press.timer = window.setTimeout(() => requestAnimationFrame(open), restMilliseconds);
  }

  /** Closes the menu, unless the press is on it. */
  #close(target: EventTarget | null): void {
    const { element } = this.#menu;
    if (!(target instanceof Node && element.contains(target))) element.hidePopover();
  }

  #forget(): void {
    clearTimeout(this.#press?.timer);
    this.#press = null;
  }

  /** Selects the object at a place, unless it is selected already, and shows the actions. */
  #open(place: { x: number; y: number; touch: boolean }): void {
    const { editor } = this;
    const target = targetAt(this.viewer, { ...editor.state, tool: 'select' }, place);
    const { chosen, more, drawing } = editor.state;
    if (target?.type === 'other' && !chosen.includes(target.id)) {
      // If several points of the edited object are selected, they stay selected.
      const isOfPoints = target.id === drawing.active && more.length > 0;
      if (!isOfPoints) editor.activate(target.id);
    }
    const pick = target ? null : this.viewer.pick(place.x, place.y);
    this.#show(place.x, place.y, pick && 'face' in pick.point ? pick.point : null);
  }

  #show(x: number, y: number, point: SurfacePoint | null): void {
    const { element } = this.#menu;
    element.replaceChildren(...this.#actions(point).map((action) => this.#item(action)));
    element.showPopover();
    const { offsetWidth, offsetHeight } = element;
    element.style.left = `${Math.max(8, Math.min(x, innerWidth - offsetWidth - 8))}px`;
    element.style.top = `${Math.max(8, Math.min(y, innerHeight - offsetHeight - 8))}px`;
  }

  #item([name, act]: Action): HTMLButtonElement {
    const item = make('button', name, { type: 'button' });
    item.setAttribute('role', 'menuitem');
    item.addEventListener('click', () => {
      this.#menu.element.hidePopover();
      act();
      this.stage.focus({ preventScroll: true });
    });
    return item;
  }

  #actions(point: SurfacePoint | null): Action[] {
    const { editor } = this;
    const { state } = editor;
    const ids = targetsOf(state);
    const { objects } = state.drawing;
    const grouped = objects.some(({ id, group }) => group !== null && ids.includes(id));
    const alignable = alignedParts(state).length > 0;
    const turnable = objects
      .filter((one) => ids.includes(one.id) && hasOtherSide(one))
      .map(({ id }) => id);
    const isBeside = point !== null && !turnable.some((id) => this.isFilledAt(id, point));
    const [lone] = ids.length === 1 ? ids : [];
    const actions: [boolean, string, () => void][] = [
      [ids.length > 0, 'Cut', () => void this.clipboard.cut()],
      [ids.length > 0, 'Copy', () => void this.clipboard.copy()],
      [true, 'Paste', () => void this.clipboard.paste()],
      [ids.length > 0, 'Duplicate', () => editor.objects.duplicate(ids)],
      [ids.length > 1, 'Group', () => editor.objects.group(ids)],
      [grouped, 'Ungroup', () => editor.objects.ungroup(ids)],
      ...this.makers().map(([name, act]): [boolean, string, () => void] => [true, name, act]),
      // After a click beside the fill, the menu offers to fill the side of the click.
      [
        turnable.length > 0,
        isBeside ? 'Fill this side' : 'Fill the other side',
        () => editor.objects.turnInside(turnable),
      ],
      [alignable, 'Align on a line', () => this.align('nearest')],
      [alignable, 'Space evenly on a line', () => this.align('even')],
      [lone !== undefined, 'Bring to front', () => editor.objects.raise(lone!, objects.length)],
      [lone !== undefined, 'Send to back', () => editor.objects.raise(lone!, -objects.length)],
      [ids.length > 0, 'Hide', () => editor.objects.setProperties(ids, { visible: false })],
      [ids.length > 0, 'Lock', () => editor.objects.setProperties(ids, { locked: true })],
      [ids.length > 0, 'Delete', () => editor.objects.delete(ids)],
      [true, 'Select all', () => editor.chooseAll()],
      ...this.ofSurface(point).map(([name, act]): [boolean, string, () => void] => [
        true,
        name,
        act,
      ]),
      [true, 'Whole surface', () => this.viewer.resetView({ animated: true })],
    ];
    return actions.filter(([isPossible]) => isPossible).map(([, name, act]) => [name, act]);
  }
}

type Action = [name: string, act: () => void];

/** The selected objects that are not empty. */
function targetsOf(state: State): readonly number[] {
  const ids = selectedObjects(state);
  return state.drawing.objects
    .filter(({ id, figure }) => ids.includes(id) && !isEmpty(figure))
    .map(({ id }) => id);
}
