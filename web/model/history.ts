/** The history of a drawing. A selection is no step; it belongs to the step that follows it. */
import { type Command, invert, joined } from './commands';

export interface History {
  /** The steps of the present drawing, the newest last. */
  done: Command[];
  /** The undone steps; redo takes the last one first. */
  undone: Command[];
  /** Selections for editing since the newest step; they join the next step. */
  activated: Command[];
}

/** The largest number of steps to undo. */
const longestHistory = 1000;

export const historyOf = (): History => ({ done: [], undone: [], activated: [] });

/** Records a step. Undone steps are then lost. */
export function record(history: History, command: Command): void {
  history.done.push(joined([...history.activated, command]));
  history.activated = [];
  history.undone = [];
  if (history.done.length > longestHistory) history.done.shift();
}

/** Records a selection for editing. Undone steps stay. */
export function recordActivation({ activated }: History, command: Command): void {
  const last = activated.at(-1);
  if (last?.type !== 'activate' || command.type !== 'activate') {
    activated.push(command);
    return;
  }
  // Consecutive selections merge into one, from the first object to the last.
  activated.pop();
  if (last.from !== command.to) activated.push({ ...command, from: last.from });
}

/** Undoes the newest step and the selections since; returns the command that does it. */
export function stepBack(history: History): Command | null {
  const command = history.done.pop();
  if (!command) return null;
  const whole = joined([command, ...history.activated]);
  history.activated = [];
  history.undone.push(whole);
  return invert(whole);
}

/** Redoes the last undone step; returns the command that does it. */
export function stepForth(history: History): Command | null {
  const command = history.undone.pop();
  if (!command) return null;
  const back = history.activated.toReversed().map(invert);
  history.activated = [];
  history.done.push(command);
  return joined([...back, command]);
}
