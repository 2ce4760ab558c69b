import { Color } from 'three';
import { formatCount, make } from '../../panels/elements';
import { Handles } from '../../viewer/handles';
import { type CarriedSide, carriedMiddle, carriedSides } from '../figures/carried';
import { smallerMesh } from '../figures/small';
import type { LineResult, Vector } from '../figures/types';
import type { Carried } from '../lab/carry';
import { emptyLine } from '../lab/empty_line';
import type { PanelContext } from './figure_panel';
import { formatMilliseconds } from './format';
import { PanelView } from './panel_view';
import { Caption, sectionHead, whenNear } from './section';
import { lineColor, surfaceFront } from './theme_colors';

type Side = 'source' | 'target';
const sides: readonly Side[] = ['source', 'target'];

interface SideView {
  element: HTMLElement;
  view: PanelView;
  handles: Handles;
}

const keySteps: Record<string, [number, number]> = {
  ArrowLeft: [-6, 0],
  ArrowRight: [6, 0],
  ArrowUp: [0, -6],
  ArrowDown: [0, 6],
};

/** A live figure: control points carry a drawing from one mesh to another. */
export class CarriedSection {
  readonly element = make('section', '', { className: 'figure', id: 'carried' });
  readonly #note = make('p', '', { className: 'panel-note' });
  readonly #context: PanelContext;
  readonly #specs: Record<Side, CarriedSide>;
  readonly #views: Record<Side, SideView>;
  readonly #corners: HTMLInputElement;
  #points: Record<Side, Vector[]>;
  #shown: Carried | null = null;
  #started = false;
  /** Whether a request is under way. Its answer matches the current points unless `#stale`. */
  #busy = false;
  #stale = false;

  constructor(context: PanelContext, detail = 1) {
    this.#context = context;
    const smaller = (side: CarriedSide) => ({ ...side, mesh: smallerMesh(side.mesh, detail) });
    const { source, target } = carriedSides;
    this.#specs = { source: smaller(source), target: smaller(target) };
    this.#points = { source: source.points, target: target.points };
    const head = sectionHead('Section 6', 'A drawing carried to another surface');
    const caption = new Caption(
      'The paper leaves open the inverse problem: weights for which a given point is the center of mass of others. Here each point of the drawing on the left has such weights of the control points, the nearest to equal ones, and on the right lies the center of mass of its weights. Of three control points there are only these weights. Drag the control points of either side: on the left the drawing stays and its weights change, on the right it follows. The paper has no such figure.',
    );
    this.#views = { source: this.#side('source'), target: this.#side('target') };
    const grid = make('div', '', { className: 'panels' });
    grid.dataset.count = '2';
    grid.append(...sides.map((side) => this.#views[side].element));
    this.#corners = make('input', '', { type: 'checkbox' });
    this.#corners.addEventListener('change', () => this.#renew());
    const choice = make('label', '', { className: 'check' });
    choice.append(this.#corners, make('span', 'Only three control points'));
    const controls = make('div', '', { className: 'table-status' });
    this.#note.setAttribute('role', 'status');
    controls.append(choice, this.#note);
    this.element.append(head, caption.element, controls, grid);
    whenNear(this.element, () => this.start());
  }

  /** Whether the drawing matches the current points. */
  get settled(): boolean {
    return this.#shown !== null && !this.#busy;
  }

  get shown(): Carried | null {
    return this.#shown;
  }

  async start(): Promise<void> {
    if (this.#started) return;
    this.#started = true;
    this.#note.textContent = 'Making the meshes…';
    try {
      for (const side of sides) {
        const mesh = await this.#context.client.mesh(this.#specs[side].mesh);
        this.#views[side].view.showSurface(await this.#context.geometry.make(mesh));
      }
      this.recolor();
      this.#renew();
    } catch (error) {
      this.#note.textContent = error instanceof Error ? error.message : `${error}`;
    }
  }

  recolor(): void {
    for (const side of sides) {
      const { view } = this.#views[side];
      view.surfaceColor = new Color(surfaceFront());
      view.recolor('drawing', look());
      view.requestFrame();
    }
  }

  #side(side: Side): SideView {
    const { title, mesh, from } = this.#specs[side];
    const element = make('article', '', { className: 'panel-card' });
    element.dataset.panel = side;
    const head = make('header', '', { className: 'panel-head' });
    head.append(make('h3', title));
    const stage = make('div', '', { className: 'panel-stage' });
    const canvas = make('canvas');
    canvas.setAttribute('aria-hidden', 'true');
    const layer = make('div', '', { className: 'handles' });
    stage.append(canvas, layer);
    element.append(head, stage);
    const view = new PanelView(this.#context.renderer, stage, canvas, {
      id: side,
      title,
      mesh,
      points: side,
      curve: { kind: 'bspline' },
      lines: [],
      samples: 0,
      view: { from },
    });
    const move = (id: string, x: number, y: number) => {
      const place = view.pick(x, y);
      if (!place) return;
      this.#points = { ...this.#points, [side]: this.#points[side].with(Number(id), place) };
      this.#showPoints(side, this.#points[side]);
      this.#renew();
    };
    const handles = new Handles(view, layer, {
      grab: () => {},
      drag: move,
      release: () => {},
      focus: () => {},
      key: (id, event) => {
        const step = keySteps[event.key];
        const at = handles.place(id);
        if (!step || !at) return;
        event.preventDefault();
        move(id, at.x + step[0], at.y + step[1]);
      },
    });
    return { element, view, handles };
  }

  #count(): number {
    return this.#corners.checked ? 3 : 4;
  }

  #showPoints(side: Side, places: readonly Vector[]): void {
    const { view, handles } = this.#views[side];
    handles.show(
      places.slice(0, this.#count()).map((place, i) => ({
        id: `${i}`,
        position: view.toScene(place),
        label: `Control point ${i + 1}, ${this.#specs[side].title.toLowerCase()}`,
        tag: `${i + 1}`,
        look: 'point',
        selected: false,
      })),
    );
  }

  /**
   * Requests the drawing for the current points. If a request is under way, this one follows it.
   */
  #renew(): void {
    this.#stale = true;
    if (this.#busy) return;
    void this.#work();
  }

  async #work(): Promise<void> {
    this.#busy = true;
    try {
      while (this.#stale) {
        this.#stale = false;
        const count = this.#count();
        const carried = await this.#context.client.carry({
          source: this.#specs.source.mesh,
          target: this.#specs.target.mesh,
          middle: carriedMiddle,
          points: {
            source: this.#points.source.slice(0, count),
            target: this.#points.target.slice(0, count),
          },
        });
        this.#shown = carried;
        this.#show(carried);
      }
    } catch (error) {
      this.#note.textContent = error instanceof Error ? error.message : `${error}`;
    } finally {
      this.#busy = false;
    }
  }

  #show(carried: Carried): void {
    for (const side of sides) {
      if (!this.#stale) this.#showPoints(side, carried.places[side]);
      const line: LineResult = { ...emptyLine('karcher'), polylines: carried[side] };
      this.#views[side].view.showLine('drawing', line, look(), 2);
    }
    const { points, carried: count, negative, reason, milliseconds } = carried;
    const missing = points - count;
    const parts = [
      `${formatCount(count, 'point')} carried in ${formatMilliseconds(milliseconds)} ms`,
      negative > 0 ? `${negative} outside the control points’ hull have a weight below 0` : '',
      missing > 0 ? `${missing} are missing: ${reason}` : '',
    ];
    this.#note.textContent = `${parts.filter(Boolean).join('; ')}.`;
  }
}

const look = () => ({ color: new Color(lineColor('karcher')), width: 3, opaque: false });
