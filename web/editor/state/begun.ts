import { apply, type Command } from '../../model/commands';
import { type Drawing, objectOf } from '../../model/drawing';
import { isEmpty, isUnfinished } from '../../model/figure';
import type { State } from './state';

/** Which object was begun and was never more than a few points: once it is let go of it goes. */
export class Begun {
  #id: number | null;

  constructor({ active }: Drawing) {
    this.#id = active;
  }

  is(id: number): boolean {
    return this.#id === id;
  }

  /** It stays however few its points are: something was made of it, or it is of another drawing. */
  keep(): void {
    this.#id = null;
  }

  /** Hears of each state that lasts; `isBack` where a step is taken back, maybe to where the object was begun. */
  follow({ figure, drawing }: State, isBack = false): void {
    const { active } = drawing;
    const goesOn = (isBack || this.is(active)) && isUnfinished(figure);
    this.#id = isEmpty(figure) || goesOn ? active : null;
  }

  /** The command with what takes the object away, where another one is edited then. */
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
