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

/** How many steps can be taken back. */
const longestHistory = 1000;

export const historyOf = (): History => ({ done: [], undone: [], activated: [] });

/** A step was done: what was taken back is gone. */
export function record(history: History, command: Command): void {
  history.done.push(joined([...history.activated, command]));
  history.activated = [];
  history.undone = [];
  if (history.done.length > longestHistory) history.done.shift();
}

/** Another object is edited: what was taken back can still be done again. */
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

/** Takes the newest step back, with what was selected since; the command that does it. */
export function stepBack(history: History): Command | null {
  const command = history.done.pop();
  if (!command) return null;
  const whole = joined([command, ...history.activated]);
  history.activated = [];
  history.undone.push(whole);
  return invert(whole);
}

/** Does the step that was taken back last again; the command that does it. */
export function stepForth(history: History): Command | null {
  const command = history.undone.pop();
  if (!command) return null;
  const back = history.activated.toReversed().map(invert);
  history.activated = [];
  history.done.push(command);
  return joined([...back, command]);
}
