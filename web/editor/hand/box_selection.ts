import { isRound } from '../../model/figure';
import type { Viewer } from '../../viewer/viewer';
import type { Editor } from '../state/editor';
import type { Hold, Place } from './stage_pointer';

/** The largest distance from a line, in CSS pixels, at which a click means the line. */
const reach = 7;

/**
 * Selects objects while Shift is down: a click adds an object to the selection or removes it, and a
 * drag selects all objects in a box.
 */
export class BoxSelection {
  readonly #box = document.createElement('div');

  constructor(
    private readonly editor: Editor,
    private readonly viewer: Viewer,
    stage: HTMLElement,
  ) {
    this.#box.className = 'selection-box';
    this.#box.hidden = true;
    stage.append(this.#box);
  }

  take(press: Place): Hold | null {
    if (!press.shift) return null;
    return {
      drag: (place) => this.#show(press, place),
      release: (place, dragged) => {
        this.#box.hidden = true;
        if (dragged) this.#chooseWithin(press, place);
        else this.#toggleAt(press);
      },
      cancel: () => {
        this.#box.hidden = true;
      },
    };
  }

  #show(from: Place, to: Place): void {
    const { left, top, width, height } = rectangle(from, to);
    const { box } = this.viewer;
    this.#box.hidden = false;
    this.#box.style.translate = `${left - box.left}px ${top - box.top}px`;
    this.#box.style.width = `${width}px`;
    this.#box.style.height = `${height}px`;
  }

  #chooseWithin(from: Place, to: Place): void {
    const { left, top, width, height } = rectangle(from, to);
    const { active } = this.editor.state.drawing;
    const { others, edited } = this.viewer.objectsIn(left, top, width, height);
    const points = this.#pointsIn(left, top, width, height);
    if (others.length === 0 && points.length > 0) {
      this.editor.selectPoints(points);
      return;
    }
    this.editor.choose(edited ? [...others, active] : others);
  }

  /**
   * The indices of the edited object's visible points in the box. The list is empty if the box
   * contains all points, since the box then selects the object as a whole.
   */
  #pointsIn(left: number, top: number, width: number, height: number): number[] {
    const { surface, box } = this.viewer;
    const { figure } = this.editor.state;
    if (!surface || !this.editor.isOpen || isRound(figure.kind)) return [];
    const numbers = [...figure.points.keys()].filter((i) => {
      const { x, y, hidden } = this.viewer.project(surface.position(figure.points[i]!));
      const [dx, dy] = [x + box.left - left, y + box.top - top];
      return !hidden && dx >= 0 && dx <= width && dy >= 0 && dy <= height;
    });
    return numbers.length < figure.points.length ? numbers : [];
  }

  #toggleAt({ x, y }: Place): void {
    const lines = this.viewer.linesAt(x, y);
    const other = lines.object(reach);
    if (other !== null) this.editor.toggle(other);
    else if (lines.own(reach)) this.editor.toggle(this.editor.state.drawing.active);
  }
}

const rectangle = (from: Place, to: Place) => ({
  left: Math.min(to.x, from.x),
  top: Math.min(to.y, from.y),
  width: Math.abs(to.x - from.x),
  height: Math.abs(to.y - from.y),
});
