import { recall, remember } from '../model/storage';
import { byId } from './elements';

/** The button of the magnet, which snaps places to targets; the browser keeps the choice. */
export class SnapToggle {
  readonly #button = byId<HTMLButtonElement>('snap');
  #on = recall('snap') === 'on';

  constructor(private readonly changed: (on: boolean) => void) {
    this.#button.addEventListener('click', () => this.toggle());
    this.#show();
  }

  toggle(): void {
    this.#on = !this.#on;
    remember('snap', this.#on ? 'on' : 'off');
    this.#show();
  }

  #show(): void {
    this.#button.setAttribute('aria-pressed', `${this.#on}`);
    this.#button.dataset.tip = `Snapping is ${this.#on ? 'on' : 'off'} (G)`;
    this.changed(this.#on);
  }
}
