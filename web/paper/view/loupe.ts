import { make } from '../../panels/elements';
import { type Dot, showDots } from './panel_markers';
import type { PanelView } from './panel_view';

/**
 * The factor by which the loupe enlarges distances. Lines keep their width, so that lines near to
 * each other separate.
 */
const times = 8;

interface Place {
  x: number;
  y: number;
}

/**
 * An enlarged view around a place of a panel: it follows the mouse and the finger, and moves by
 * keys.
 */
export class Loupe {
  readonly button = make('button', 'Loupe', {
    className: 'link',
    type: 'button',
    title: 'Shows the curves larger where they cover each other',
  });
  readonly #element = make('div', '', { className: 'loupe', tabIndex: 0 });
  readonly #canvas = make('canvas');
  readonly #dots = make('div', '', { className: 'markers' });
  readonly #target = make('i', '', { className: 'loupe-target' });
  #at: Place = { x: 0, y: 0 };

  constructor(
    private readonly stage: HTMLElement,
    private readonly view: PanelView,
    /** `dots` returns the dots to show, and `first` the place where the loupe begins. */
    private readonly events: { dots(): Dot[]; first(): Place },
  ) {
    this.button.setAttribute('aria-pressed', 'false');
    this.#element.role = 'application';
    this.#element.ariaLabel = 'Loupe: the arrow keys move it';
    this.#canvas.setAttribute('aria-hidden', 'true');
    this.#element.append(this.#canvas, this.#dots);
    this.button.addEventListener('click', () => this.#show(!this.#shown));
    for (const type of ['pointermove', 'pointerdown'] as const) {
      stage.addEventListener(type, (event) => this.#follow(event));
    }
    this.#element.addEventListener('keydown', (event) => this.#key(event));
    view.onFrame(() => this.#draw());
  }

  get #shown(): boolean {
    return this.#element.isConnected;
  }

  #show(shown: boolean): void {
    if (shown) this.stage.append(this.#target, this.#element);
    else for (const element of [this.#target, this.#element]) element.remove();
    this.button.setAttribute('aria-pressed', `${shown}`);
    if (shown) this.#move(this.events.first());
  }

  #follow(event: PointerEvent): void {
    if (!this.#shown || event.target === this.#element) return;
    const box = this.stage.getBoundingClientRect();
    this.#move({ x: event.clientX - box.left, y: event.clientY - box.top });
  }

  #key(event: KeyboardEvent): void {
    if (event.key === 'Escape') {
      this.#show(false);
      this.button.focus();
      return;
    }
    const step = event.shiftKey ? 20 : 4;
    const by = {
      ArrowLeft: [-step, 0],
      ArrowRight: [step, 0],
      ArrowUp: [0, -step],
      ArrowDown: [0, step],
    }[event.key];
    if (!by) return;
    event.preventDefault();
    this.#move({ x: this.#at.x + by[0]!, y: this.#at.y + by[1]! });
  }

  #move({ x, y }: Place): void {
    const { clientWidth, clientHeight } = this.stage;
    const within = (value: number, most: number) => Math.min(most, Math.max(0, value));
    this.#at = { x: within(x, clientWidth), y: within(y, clientHeight) };
    this.view.requestFrame();
  }

  #draw(): void {
    if (!this.#shown) return;
    const { x, y } = this.#at;
    this.#target.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    // The loupe lies in a corner away from the place.
    const { clientWidth, clientHeight } = this.stage;
    this.#element.classList.toggle('left', x > clientWidth / 2 && y < clientHeight / 2);
    const { clientWidth: width, clientHeight: height } = this.#element;
    this.view.drawAround(this.#at, times, this.#canvas, width, height);
    showDots(this.#dots, this.view, this.events.dots(), (dot) => ({
      x: times * (dot.x - x) + width / 2,
      y: times * (dot.y - y) + height / 2,
    }));
  }
}
