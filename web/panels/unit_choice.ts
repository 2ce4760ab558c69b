import { meshLabel } from '../model/meshes';
import { recall, remember } from '../model/storage';
import { guessUnit, isUnit, type Unit } from '../model/units';
import { byId, fill } from './elements';

const names: Record<Unit, string> = {
  '': 'none',
  mm: 'millimeters',
  cm: 'centimeters',
  m: 'meters',
  in: 'inches',
};

/**
 * The unit of the surface's lengths: a guess until the user chooses. The browser keeps the choice
 * for the surface.
 */
export class UnitChoice {
  readonly #select = byId<HTMLSelectElement>('unit');
  #key = '';

  constructor(private readonly changed: (unit: Unit) => void) {
    fill(this.#select, names);
    this.#select.addEventListener('change', () => {
      remember(`unit.${this.#key}`, this.#select.value);
      changed(this.#select.value as Unit);
    });
  }

  /** Shows the unit of the surface with a key. */
  show(key: string): void {
    if (key === this.#key) return;
    this.#key = key;
    const chosen = recall(`unit.${key}`);
    const unit = isUnit(chosen) ? chosen : guessUnit(meshLabel(key));
    this.#select.value = unit;
    this.changed(unit);
  }
}
