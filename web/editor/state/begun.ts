import { apply, type Command } from '../../model/commands';
import { type Drawing, objectOf } from '../../model/drawing';
import { isEmpty, isUnfinished } from '../../model/figure';
import type { State } from './state';

/** Remembers a new object with only a few points. If it loses the selection, it is removed. */
export class Begun {
  #id: number | null;

  constructor({ active }: Drawing) {
    this.#id = active;
  }

  is(id: number): boolean {
    return this.#id === id;
  }

  /** Keeps the object even with few points: it is a source now, or belongs to another drawing. */
  keep(): void {
    this.#id = null;
  }

  /**
   * Follows each lasting state. After an undo, `isBack`, the state may have the begun object again.
   */
  follow({ figure, drawing }: State, isBack = false): void {
    const { active } = drawing;
    const goesOn = (isBack || this.is(active)) && isUnfinished(figure);
    this.#id = isEmpty(figure) || goesOn ? active : null;
  }

  /** The command, with the removal of the object if another one is edited afterwards. */
  gone(command: Command, base: Drawing): Command {
    const begun = this.#id === null ? undefined : objectOf(base, this.#id);
    if (!begun || begun.locked || !isUnfinished(begun.figure)) return command;
    const after = apply(base, command);
    const index = after.objects.indexOf(begun);
    const isUsed = after.objects.some(({ figure }) => figure.derived?.sources.includes(begun.id));
    if (after.active === begun.id || index < 0 || isUsed) return command;
    return { type: 'steps', steps: [command, { type: 'delete', index, object: begun }] };
  }
}
