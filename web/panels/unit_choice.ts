import { keyOfFile, meshLabel } from '../model/meshes';
import { nameFor, recall, recallFor, remember } from '../model/storage';
import { guessUnit, isUnit, type Unit } from '../model/units';
import { byId, fill } from './elements';

const names: Record<Unit, string> = {
  '': 'none',
  mm: 'millimeters',
  cm: 'centimeters',
  m: 'meters',
  in: 'inches',
};

/** The unit of a surface, by its key: the kept choice, or else a guess. */
export function unitOf(key: string): Unit {
  // Earlier versions kept the choice by the whole key, with its options for reading.
  const chosen = recallFor('unit', keyOfFile(key)) ?? recall(`unit.${key}`);
  return isUnit(chosen) ? chosen : guessUnit(meshLabel(key));
}

/** Keeps the unit of a surface, whose file has one unit with all options for reading. */
export const keepUnit = (key: string, unit: Unit) =>
  remember(nameFor('unit', keyOfFile(key)), unit);

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
      const unit = this.#select.value as Unit;
      keepUnit(this.#key, unit);
      changed(unit);
    });
  }

  /** Shows the unit of the surface with a key. */
  show(key: string): void {
    if (key === this.#key) return;
    this.#key = key;
    const unit = unitOf(key);
    this.#select.value = unit;
    this.changed(unit);
  }
}
