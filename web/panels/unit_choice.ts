import { meshLabel } from '../model/meshes';
import { recall, remember } from '../model/storage';
import { guessUnit, isUnit, type Unit, units } from '../model/units';
import { byId, make } from './elements';

const names: Record<Unit, string> = {
  '': 'none',
  mm: 'millimeters',
  cm: 'centimeters',
  m: 'meters',
  in: 'inches',
};

/** The unit of the surface's lengths: guessed, until it is chosen; the browser keeps it for the surface. */
export class UnitChoice {
  readonly #select = byId<HTMLSelectElement>('unit');
  #key = '';

  constructor(private readonly changed: (unit: Unit) => void) {
    this.#select.append(...units.map((unit) => make('option', names[unit], { value: unit })));
    this.#select.addEventListener('change', () => {
      remember(`unit.${this.#key}`, this.#select.value);
      changed(this.#select.value as Unit);
    });
  }

  /** Shows the unit of a surface, by its key. */
  show(key: string): void {
    if (key === this.#key) return;
    this.#key = key;
    const chosen = recall(`unit.${key}`);
    const unit = isUnit(chosen) ? chosen : guessUnit(meshLabel(key));
    this.#select.value = unit;
    this.changed(unit);
  }
}
