import { byId } from './elements';

/** A menu, which usually has a button that opens it; the arrow keys move from item to item. */
export class Menu {
  readonly element: HTMLElement;
  readonly #button: HTMLElement | null;

  /** `opening` runs before the menu appears. */
  constructor(id: string, button = '', opening: () => void = () => {}) {
    this.element = byId(id);
    this.#button = button ? byId(button) : null;
    this.element.addEventListener('beforetoggle', (event) => {
      if (event.newState === 'open') opening();
    });
    this.element.addEventListener('toggle', (event) => {
      const open = event.newState === 'open';
      this.#button?.setAttribute('aria-expanded', `${open}`);
      if (open) this.items.find((item) => !item.disabled)?.focus();
    });
    this.element.addEventListener('keydown', (event) => this.#key(event));
  }

  get items(): HTMLButtonElement[] {
    return [...this.element.querySelectorAll<HTMLButtonElement>('[role^="menuitem"]')];
  }

  #key(event: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const items = this.items.filter((item) => !item.disabled);
    const at = items.indexOf(document.activeElement as HTMLButtonElement);
    items[(at + step + items.length) % items.length]?.focus();
  }
}
