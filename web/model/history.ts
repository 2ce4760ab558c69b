/** The history of a drawing. A selection is not a step; it is undone and redone with the step that follows it. */
import { type Command, invert, joined } from './commands';

export interface History {
  /** The commands that were done, the newest last. */
  done: Command[];
  /** The undone steps; the last one is redone first. */
  undone: Command[];
  /** Commands since the newest step that made another object the edited one; they join the next step. */
  activated: Command[];
}

/** The largest number of steps that can be undone. */
const longestHistory = 1000;

export const historyOf = (): History => ({ done: [], undone: [], activated: [] });

/** Records a step; undone steps can no longer be redone. */
export function record(history: History, command: Command): void {
  history.done.push(joined([...history.activated, command]));
  history.activated = [];
  history.undone = [];
  if (history.done.length > longestHistory) history.done.shift();
}

/** Records that another object is edited: undone steps can still be redone. */
export function recordActivation({ activated }: History, command: Command): void {
  const last = activated.at(-1);
  if (last?.type !== 'activate' || command.type !== 'activate') {
    activated.push(command);
    return;
  }
  // Merges activations: from the first object to the last.
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

/** Redoes the step that was undone last; returns the command that does it. */
export function stepForth(history: History): Command | null {
  const command = history.undone.pop();
  if (!command) return null;
  const back = history.activated.toReversed().map(invert);
  history.activated = [];
  history.done.push(command);
  return joined([...back, command]);
}
