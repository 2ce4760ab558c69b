import { apply, type Command } from '../../model/commands';
import { type Drawing, objectOf } from '../../model/drawing';
import { isEmpty, isUnfinished } from '../../model/figure';
import type { State } from './state';

/** Remembers a new object with too few points, which is removed if it loses the selection. */
export class Begun {
  #id: number | null;

  /** A listener for the removal of an object, which whoever carries it out calls. */
  onRemoval: () => void = () => {};

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
   * Updates which object counts as begun. The caller calls it with each new lasting state. After an
   * undo (`isBack`), an unfinished edited object counts as begun again.
   */
  follow({ figure, drawing }: State, isBack = false): void {
    const { active } = drawing;
    const goesOn = (isBack || this.is(active)) && isUnfinished(figure);
    this.#id = isEmpty(figure) || goesOn ? active : null;
  }

  /**
   * The command together with the removal of the begun object, if another object is edited
   * afterwards. If the begun object is finished, locked or a source, the result is the command
   * alone.
   */
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
