import type { State } from '../editor/state/state';
import { recall, remember } from '../model/storage';
import { byId, write } from './elements';

/** The tolerance between a stroke and its curve, in CSS pixels; the browser keeps it. */
export class FreehandSettings {
  readonly #field = byId('freehand-settings');
  readonly #tolerance = byId<HTMLInputElement>('freehand-tolerance');

  constructor(changed: (tolerance: number) => void) {
    const { min, max } = this.#tolerance;
    const kept = Number(recall('freehand'));
    if (kept >= Number(min) && kept <= Number(max)) this.#tolerance.value = `${kept}`;
    const take = () => {
      const { value } = this.#tolerance;
      write(byId('freehand-pixels'), `${value} px`);
      changed(Number(value));
    };
    this.#tolerance.addEventListener('input', take);
    this.#tolerance.addEventListener('change', () => remember('freehand', this.#tolerance.value));
    take();
  }

  show({ tool }: State): void {
    this.#field.hidden = tool !== 'freehand';
  }
}
